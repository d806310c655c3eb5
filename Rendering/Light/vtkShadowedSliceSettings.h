// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkShadowedSliceSettings_h
#define vtkShadowedSliceSettings_h

#include "vtkColorTransferFunction.h" // for the smart pointer
#include "vtkPiecewiseFunction.h"     // for the smart pointer
#include "vtkSmartPointer.h"          // for the functions
#include "vtkType.h"                  // for vtkIdType

/**
 * @class   vtkShadowedSliceSettings
 * @brief   settings of vtkShadowedSliceMapper, with their defaults and modes
 *
 * The mapper inherits from this struct, so VTK's setter macros work and all settings can be copied
 * at once. Each setting is documented at its setter in the mapper. The mapper's superclasses store
 * the blend mode, cropping and clipping planes.
 *
 * @sa vtkShadowedSliceMapper
 */
struct vtkShadowedSliceSettings
{
  /**
   * Modes of lookup in light buffers.
   */
  enum LightLookups
  {
    NEAREST_LOOKUP = 0,
    BILINEAR_LOOKUP = 1,
    /// Deprecated names.
    NEAREST_LIGHT = NEAREST_LOOKUP,
    BILINEAR_LIGHT = BILINEAR_LOOKUP
  };

  /**
   * Methods for the soft shadows of a vtkAreaLight.
   */
  enum SoftShadowMethods
  {
    /// One buffer, blurred from slice to slice (C. Zhang, dissertation, 2.4).
    ACCUMULATED_CONVOLUTION = 0,
    /// One layer of transmittance for each sample of the emitter, all updated in one light pass.
    SAMPLE_LAYERS = 1,
    /// Each sample of the emitter is a separate light.
    SAMPLED_LIGHTS = 2
  };

  /**
   * Modes of scattering toward the camera.
   */
  enum ScatteringModes
  {
    /// No scattering: the volume property's material coefficients determine reflection.
    NO_SCATTERING = 0,
    /// Light is scattered once, with an albedo and a phase function.
    SINGLE_SCATTERING = 1,
    /// Multiple scattering, forward only (C. Zhang, dissertation, 2.6).
    FORWARD_SCATTERING = 2,
    /// Multiple scattering in all directions.
    FULL_SCATTERING = 3
  };

  /**
   * Phase functions.
   */
  enum PhaseFunctions
  {
    ISOTROPIC_PHASE = 0,
    HENYEY_GREENSTEIN_PHASE = 1,
    TABLE_PHASE = 2
  };

  bool Shadows = true;
  int MaximumNumberOfShadowLights = 16;
  double SliceSpacing = 0.0;
  int LightBufferSize = 0;
  int LightLookup = BILINEAR_LOOKUP;
  double ImageSampleDistance = 1.0;
  bool AutoAdjustSampleDistances = true;
  bool ProgressiveRendering = false;
  double SurfaceGradient = 0.0;
  bool TwoSidedLighting = false;
  int SoftShadowMethod = SAMPLE_LAYERS;
  int NumberOfLightSamples = 8;
  vtkSmartPointer<vtkColorTransferFunction> TransmissionColor;
  vtkIdType MaximumTextureMemory = 0;
  int ScatteringMode = NO_SCATTERING;
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
