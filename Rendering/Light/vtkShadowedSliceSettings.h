// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkShadowedSliceSettings_h
#define vtkShadowedSliceSettings_h

#include "vtkColorTransferFunction.h" // for the smart pointer
#include "vtkPiecewiseFunction.h"     // for the smart pointer
#include "vtkSmartPointer.h"          // for functions
#include "vtkType.h"                  // for bytes

/**
 * @class   vtkShadowedSliceSettings
 * @brief   what vtkShadowedSliceMapper can be told, with its defaults and its modes
 *
 * The mapper is made of them, so that VTK's macros for setters serve them, and hands them on as a
 * whole. Each is documented at its setter there; blend mode, cropping and clipping planes are kept
 * by the mapper's superclasses.
 *
 * @sa vtkShadowedSliceMapper
 */
struct vtkShadowedSliceSettings
{
  /**
   * The ways to look up the light's buffer.
   */
  enum LightLookups
  {
    NEAREST_LIGHT = 0,
    BILINEAR_LIGHT = 1
  };

  /**
   * The ways to find the soft shadows of a vtkAreaLight.
   */
  enum SoftShadowMethods
  {
    /// One buffer, smeared as it goes through the slices (C. Zhang, dissertation, 2.4).
    ACCUMULATED_CONVOLUTION = 0,
    /// One layer of transmittance for each sample of the emitter, all of one light pass.
    SAMPLE_LAYERS = 1,
    /// Each sample of the emitter as a light of its own.
    SAMPLED_LIGHTS = 2
  };

  /**
   * The ways in which light is scattered on its way to the eye.
   */
  enum ScatteringModes
  {
    /// Light is reflected by material coefficients.
    NO_SCATTERING = 0,
    /// Light is scattered once, by albedo and phase function.
    SINGLE_SCATTERING = 1,
    /// Light is scattered on and on, away from its source (C. Zhang, dissertation, 2.6).
    FORWARD_SCATTERING = 2,
    /// Light is scattered on and on in all directions.
    FULL_SCATTERING = 3
  };

  /**
   * The distributions of scattered light over the angle to where it came from.
   */
  enum PhaseFunctions
  {
    ISOTROPIC_PHASE = 0,
    HENYEY_GREENSTEIN_PHASE = 1,
    TABLE_PHASE = 2
  };

  bool Shadows = true;
  int MaximumNumberOfShadows = 16;
  double SliceSpacing = 0.0;
  int LightBufferSize = 0;
  int LightLookup = BILINEAR_LIGHT;
  double ImageSampleDistance = 1.0;
  bool AutoAdjustSampleDistances = true;
  double SurfaceGradient = 0.0;
  bool TwoSidedLighting = false;
  int SoftShadowMethod = SAMPLE_LAYERS;
  int NumberOfLightSamples = 8;
  vtkSmartPointer<vtkColorTransferFunction> TransmissionColor;
  vtkIdType MaximumTextureMemory = 0;
  int MultipleScattering = NO_SCATTERING;
  vtkSmartPointer<vtkColorTransferFunction> ScatteringAlbedo;
  int PhaseFunction = ISOTROPIC_PHASE;
  double Anisotropy = 0.0;
  vtkSmartPointer<vtkPiecewiseFunction> PhaseTable;
  double ForwardSpread = 0.0;
  int BackwardLayers = 0;
  int ScatteringGridSize = 0;
  double ScatteringBrightness = 1.0;
};

#endif
