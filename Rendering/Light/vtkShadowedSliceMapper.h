// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkShadowedSliceMapper_h
#define vtkShadowedSliceMapper_h

#include "InterlumeLightModule.h" // for the export macro
#include "vtkInterlumeDeprecation.h"
#include "vtkInterlumeReport.h"       // for GetReport()
#include "vtkNew.h"                   // for the report
#include "vtkShadowedSliceSettings.h" // for the settings
#include "vtkVolumeMapper.h"

#include <memory> // for the image
#include <string> // for errors

class vtkColorTransferFunction;
class vtkDataArray;
class vtkImageData;
class vtkLight;
class vtkPiecewiseFunction;
class vtkSliceMedium;

namespace interlume
{
class Error;
class PeelingDeferral;
class VolumeImage;
}

/**
 * @class   vtkShadowedSliceMapper
 * @brief   render a volume in half-angle slices, with the shadows of every light
 *
 * The volume is sliced perpendicular to the half vector between the view and light directions, so
 * the slices can be drawn in one order for both the camera and the light (C. Zhang, dissertation,
 * Ohio State 2006, 2.3). Each light has a two-dimensional buffer, which stores the transmittance
 * from the light to the current slice. Each slice is drawn into the frame, lit through the buffers,
 * and then into each buffer. See Documentation/methods/shadowed-slices.md for the method, shading
 * and accuracy, and Documentation/measurements.md for times.
 *
 * **Input**: vtkImageData with point or cell scalars of any type. Select the array with ScalarMode,
 * ArrayName or ArrayId, as in other volume mappers. The scalars have
 * - one component: color and opacity functions of the scalar;
 * - two to four independent components: functions and a weight for each component. Extinctions are
 *   added, and colors are weighted by extinction;
 * - two dependent components: color by the first, opacity by the second;
 * - four dependent components: RGB (unsigned char 0 to 255, other types 0 to 1), and the opacity
 *   function of the fourth component.
 *
 * Three dependent components are an error. Voxels with NaN or infinite values are transparent and
 * reported once by a warning. Transfer functions are applied after interpolation. The gradient
 * opacity function works as in vtkGPUVolumeRayCastMapper.
 *
 * **Lights**: all lights of the renderer, including vtkProjectiveLight and vtkAreaLight. A light
 * casts shadows if Shadows is on and its ShadowAttenuation is above 0. Its color is then multiplied
 * by 1 - ShadowAttenuation (1 - transmittance). A vtkAreaLight casts soft shadows, computed by the
 * SoftShadowMethod; see Documentation/methods/soft-shadows.md. A positional light inside or very
 * close to the volume needs two sweeps through the slices.
 *
 * **Shading**: with Shade on, the medium is shaded with the volume property's ambient, diffuse and
 * specular coefficients and with normals from the scalar gradient. Where the gradient is zero, the
 * medium scatters light isotropically. Solids look darker with shadows, because the surface itself
 * attenuates the light; use brighter lights. With ScatteringMode on, the albedo and the phase
 * function replace the material coefficients and Shade; see Documentation/methods/scattering.md.
 * Light that casts no shadows is then scattered only once.
 *
 * **Other props**: opaque props hide the volume behind them. In a vtkShadowedScenePass, opaque
 * actors cast shadows in the volume and receive its shadows, volumes of several mappers shadow each
 * other, and translucent actors are drawn in depth order. Without the pass, the volume is drawn
 * over all translucent polygons, and UseDepthPeelingForVolumes is ignored with a warning. Hardware
 * selection returns the volume where the medium is visible in front of opaque props.
 *
 * **Cropping and clipping planes** remove the medium exactly along each ray; the removed parts cast
 * no shadows. The camera's near and far planes do not affect the light. The only BlendMode is
 * composite.
 *
 * **Errors** are reported by vtkErrorMacro. They are: no scalars, an unsupported blend mode or
 * number of components, a volume larger than the graphics card's 3D textures, or textures that
 * exceed its memory or MaximumTextureMemory. The image rendered for the previous frame remains
 * visible. If a light has an invalid image, an error is reported and only this light is skipped.
 *
 * @sa vtkAreaLight vtkProjectiveLight vtkShadowedScenePass vtkShadowedSliceSettings
 */
class INTERLUMELIGHT_EXPORT vtkShadowedSliceMapper
  : public vtkVolumeMapper
  , private vtkShadowedSliceSettings
{
public:
  static vtkShadowedSliceMapper* New();
  vtkTypeMacro(vtkShadowedSliceMapper, vtkVolumeMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Modes of vtkShadowedSliceSettings.
   */
  using vtkShadowedSliceSettings::ACCUMULATED_CONVOLUTION;
  using vtkShadowedSliceSettings::BILINEAR_LIGHT; // deprecated
  using vtkShadowedSliceSettings::BILINEAR_LOOKUP;
  using vtkShadowedSliceSettings::FORWARD_SCATTERING;
  using vtkShadowedSliceSettings::FULL_SCATTERING;
  using vtkShadowedSliceSettings::HENYEY_GREENSTEIN_PHASE;
  using vtkShadowedSliceSettings::ISOTROPIC_PHASE;
  using vtkShadowedSliceSettings::LightLookups;
  using vtkShadowedSliceSettings::NEAREST_LIGHT; // deprecated
  using vtkShadowedSliceSettings::NEAREST_LOOKUP;
  using vtkShadowedSliceSettings::NO_SCATTERING;
  using vtkShadowedSliceSettings::PhaseFunctions;
  using vtkShadowedSliceSettings::SAMPLE_LAYERS;
  using vtkShadowedSliceSettings::SAMPLED_LIGHTS;
  using vtkShadowedSliceSettings::ScatteringModes;
  using vtkShadowedSliceSettings::SINGLE_SCATTERING;
  using vtkShadowedSliceSettings::SoftShadowMethods;
  using vtkShadowedSliceSettings::TABLE_PHASE;
  ///@}

  ///@{
  /**
   * Turn shadows on or off. If off, no light buffers are allocated and the shaders contain no
   * shadow code. Default on.
   */
  vtkSetMacro(Shadows, bool);
  vtkGetMacro(Shadows, bool);
  vtkBooleanMacro(Shadows, bool);
  ///@}

  ///@{
  /**
   * Set the maximum number of lights that cast shadows, brightest first. The remaining lights cast
   * no shadows. A vtkLightKit has five lights, but usually only the key light needs shadows.
   * Default 16. Valid: 0 to 16.
   */
  vtkSetClampMacro(MaximumNumberOfShadowLights, int, 0, 16);
  vtkGetMacro(MaximumNumberOfShadowLights, int);
  interlumeDeprecatedMacro(MaximumNumberOfShadows, MaximumNumberOfShadowLights, int);
  ///@}

  ///@{
  /**
   * Set the slice spacing in world units. With 0, the default, it is the larger of two lengths:
   * half the length of a voxel along the slice normal, and half its length along the view
   * direction, projected onto the normal. At most 65,536 slices are drawn; the spacing is increased
   * if necessary. The report contains the spacing in use. Valid: 0 and above.
   */
  vtkSetClampMacro(SliceSpacing, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SliceSpacing, double);
  ///@}

  ///@{
  /**
   * Set the number of columns and rows of each light's buffer. With 0, the default, it is the
   * number of voxels across the volume as seen from the light, clamped to [64, 2048]. An axis along
   * which the volume is thinner than 1/2048 of the buffer is not counted. For hard shadows in a
   * dense medium, the buffer is up to 1.5 times as large if the frame has enough pixels. Steep
   * opacity ramps under oblique light need two to three times the number of voxels. Valid: 0, and
   * 16 to 8192, limited by the graphics card.
   */
  void SetLightBufferSize(int size);
  vtkGetMacro(LightBufferSize, int);
  ///@}

  ///@{
  /**
   * Set nearest or bilinear lookup in the light buffers. Default BILINEAR_LOOKUP. Valid: see
   * LightLookups; clamped.
   */
  vtkSetClampMacro(LightLookup, int, NEAREST_LOOKUP, BILINEAR_LOOKUP);
  vtkGetMacro(LightLookup, int);
  void SetLightLookupToNearest() { this->SetLightLookup(NEAREST_LOOKUP); }
  void SetLightLookupToBilinear() { this->SetLightLookup(BILINEAR_LOOKUP); }
  ///@}

  ///@{
  /**
   * Set the size of a pixel of the volume's rendered image, in viewport pixels. The image is
   * interpolated to the viewport, but not across the edges of opaque surfaces. Surfaces narrower
   * than a pixel of the image may be missed. Default 1. Valid: 0.25 to 100.
   */
  vtkSetClampMacro(ImageSampleDistance, double, 0.25, 100.0);
  vtkGetMacro(ImageSampleDistance, double);
  ///@}

  ///@{
  /**
   * Turn on or off the use of coarser slices and pixels, by at most a factor of 8, if the renderer
   * allocates less time than the last frame took, as during interaction. Only automatic values
   * change; SliceSpacing is kept if it is set. Default on.
   */
  vtkSetMacro(AutoAdjustSampleDistances, bool);
  vtkGetMacro(AutoAdjustSampleDistances, bool);
  vtkBooleanMacro(AutoAdjustSampleDistances, bool);
  ///@}

  ///@{
  /**
   * If on, a frame that takes more than 0.2 s is refined by consecutive renderings: the first one
   * draws coarser slices, pixels, light buffers and light samples within about 0.2 s, and the last
   * one the same image as with this setting off. Render the window again while
   * GetRefinementPending() returns true. A change of the scene restarts with the first image. If
   * nothing has changed, the last image is shown again. Multiple scattering is always computed in
   * full, and frames of a vtkShadowedScenePass are not refined. Default off: each rendering draws
   * the final image.
   */
  void SetProgressiveRendering(bool isProgressive)
  {
    // The final image is the same, so the mapper is not modified.
    this->ProgressiveRendering = isProgressive;
  }
  vtkGetMacro(ProgressiveRendering, bool);
  vtkBooleanMacro(ProgressiveRendering, bool);
  ///@}

  /**
   * Returns true if ProgressiveRendering is on and the last frame was not final, or was aborted.
   */
  bool GetRefinementPending() const;

  ///@{
  /**
   * Set the minimum scalar change between neighboring voxels at which the medium is shaded as a
   * surface, as a fraction of the scalar range. Below it, shading changes linearly toward isotropic
   * scattering: at zero change the factor N.L is 1 and the specular part is 0. Use a few hundredths
   * for noisy data, or for smoke and surfaces in one volume. Default 0: every nonzero gradient is a
   * surface. Valid: 0 to 1.
   */
  vtkSetClampMacro(SurfaceGradient, double, 0.0, 1.0);
  vtkGetMacro(SurfaceGradient, double);
  ///@}

  ///@{
  /**
   * Turn two-sided lighting on or off. If on, normals are flipped toward each light, as other
   * volume mappers do with vtkRenderer::TwoSidedLighting. If off, a medium whose values increase
   * toward the camera is dark, for example where the volume ends inside the medium. Default off.
   */
  vtkSetMacro(TwoSidedLighting, bool);
  vtkGetMacro(TwoSidedLighting, bool);
  vtkBooleanMacro(TwoSidedLighting, bool);
  ///@}

  ///@{
  /**
   * Set the method for the soft shadows of vtkAreaLight:
   * - ACCUMULATED_CONVOLUTION blurs one buffer from slice to slice. It ignores the emitter's shape
   *   and image, and penumbras shrink as slices and buffers are refined.
   * - SAMPLE_LAYERS stores one layer of transmittance for each light sample. It converges as
   *   samples, buffers and slices are refined.
   * - SAMPLED_LIGHTS renders each sample as a separate light. It is slow and serves as a reference.
   *   In a vtkShadowedScenePass, it has the same effect as SAMPLE_LAYERS.
   *
   * A light inside the volume, or too close or too large for soft shadows, casts hard shadows from
   * its center, except with SAMPLED_LIGHTS. The report counts such lights. See
   * Documentation/methods/soft-shadows.md. Default SAMPLE_LAYERS. Valid: see SoftShadowMethods;
   * clamped.
   */
  vtkSetClampMacro(SoftShadowMethod, int, ACCUMULATED_CONVOLUTION, SAMPLED_LIGHTS);
  vtkGetMacro(SoftShadowMethod, int);
  void SetSoftShadowMethodToAccumulatedConvolution()
  {
    this->SetSoftShadowMethod(ACCUMULATED_CONVOLUTION);
  }
  void SetSoftShadowMethodToSampleLayers() { this->SetSoftShadowMethod(SAMPLE_LAYERS); }
  void SetSoftShadowMethodToSampledLights() { this->SetSoftShadowMethod(SAMPLED_LIGHTS); }
  ///@}

  ///@{
  /**
   * Set the number of samples of each vtkAreaLight for SAMPLE_LAYERS and SAMPLED_LIGHTS. Wide
   * penumbras of sharp edges need 16 to 24 samples, since fewer are visible as steps. In a
   * vtkShadowedScenePass where surfaces cast the light's shadows, at least the pass's
   * NumberOfLightSamples is used. Default 8. Valid: 1 to 1024.
   */
  vtkSetClampMacro(NumberOfLightSamples, int, 1, 1024);
  vtkGetMacro(NumberOfLightSamples, int);
  ///@}

  ///@{
  /**
   * Set the color of the light that the medium transmits, as a function of the scalar. Channel k of
   * a light is attenuated with the extinction tau (1 - color_k): white transmits all light, black
   * none. Light buffers then have three channels instead of one. Used only for volumes with one
   * component or two dependent components. Default null: black.
   */
  void SetTransmissionColor(vtkColorTransferFunction* function);
  vtkColorTransferFunction* GetTransmissionColor() const { return this->TransmissionColor; }
  ///@}

  ///@{
  /**
   * Set how light is scattered toward the camera: not at all, once, many times, each time by less
   * than a right angle (forward), or many times in all directions (full). See
   * Documentation/methods/scattering.md. Default NO_SCATTERING. Valid: see ScatteringModes;
   * clamped.
   */
  vtkSetClampMacro(ScatteringMode, int, NO_SCATTERING, FULL_SCATTERING);
  vtkGetMacro(ScatteringMode, int);
  void SetScatteringModeToOff() { this->SetScatteringMode(NO_SCATTERING); }
  void SetScatteringModeToSingle() { this->SetScatteringMode(SINGLE_SCATTERING); }
  void SetScatteringModeToForward() { this->SetScatteringMode(FORWARD_SCATTERING); }
  void SetScatteringModeToFull() { this->SetScatteringMode(FULL_SCATTERING); }
  interlumeDeprecatedMacro(MultipleScattering, ScatteringMode, int);
  VTK_DEPRECATION("Use SetScatteringModeToOff.") void SetMultipleScatteringToOff()
  {
    this->SetScatteringModeToOff();
  }
  VTK_DEPRECATION("Use SetScatteringModeToSingle.")
  void SetMultipleScatteringToSingle() { this->SetScatteringModeToSingle(); }
  VTK_DEPRECATION("Use SetScatteringModeToForward.")
  void SetMultipleScatteringToForward() { this->SetScatteringModeToForward(); }
  VTK_DEPRECATION("Use SetScatteringModeToFull.")
  void SetMultipleScatteringToFull() { this->SetScatteringModeToFull(); }
  ///@}

  ///@{
  /**
   * Set the single-scattering albedo in red, green and blue, as a function of the scalar. The
   * medium absorbs the light that it does not scatter. Values are clamped to 0 to 1. Used only if
   * ScatteringMode is on, for volumes with one component or two dependent components. Default null:
   * the colors of the volume property.
   */
  void SetScatteringAlbedo(vtkColorTransferFunction* function);
  vtkColorTransferFunction* GetScatteringAlbedo() const { return this->ScatteringAlbedo; }
  ///@}

  ///@{
  /**
   * Set the phase function: isotropic, Henyey-Greenstein with Anisotropy, or PhaseTable. Used only
   * if ScatteringMode is on. Default ISOTROPIC_PHASE. Valid: see PhaseFunctions; clamped.
   */
  vtkSetClampMacro(PhaseFunction, int, ISOTROPIC_PHASE, TABLE_PHASE);
  vtkGetMacro(PhaseFunction, int);
  void SetPhaseFunctionToIsotropic() { this->SetPhaseFunction(ISOTROPIC_PHASE); }
  void SetPhaseFunctionToHenyeyGreenstein() { this->SetPhaseFunction(HENYEY_GREENSTEIN_PHASE); }
  void SetPhaseFunctionToTable() { this->SetPhaseFunction(TABLE_PHASE); }
  ///@}

  ///@{
  /**
   * Set the mean cosine g of HENYEY_GREENSTEIN_PHASE, (1 - g^2) / (4 pi (1 + g^2 - 2 g cos)^1.5).
   * Positive values scatter light forward, as in clouds and tissue; negative values scatter it
   * backward. Default 0: isotropic. Valid: -0.999 to 0.999.
   */
  vtkSetClampMacro(Anisotropy, double, -0.999, 0.999);
  vtkGetMacro(Anisotropy, double);
  ///@}

  ///@{
  /**
   * Set the phase function for TABLE_PHASE as a function of the cosine of the scattering angle,
   * from -1 (backscattered light) to 1 (forward-scattered light). It is sampled at 4096 cosines and
   * scaled so that its integral over the sphere is 1. Negative values, non-finite values and a
   * function that is 0 everywhere are errors. Default null: isotropic.
   */
  void SetPhaseTable(vtkPiecewiseFunction* function);
  vtkPiecewiseFunction* GetPhaseTable() const { return this->PhaseTable; }
  ///@}

  ///@{
  /**
   * Set the variance that FORWARD_SCATTERING adds to the angle of light about each of two
   * perpendicular axes, in square radians per unit of scattering optical depth. It does not depend
   * on the slice spacing or the cell size. With 0, the default, it is computed from the forward
   * half of the phase function: half of the mean squared sine. Valid: 0 and above.
   */
  vtkSetClampMacro(ForwardSpread, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(ForwardSpread, double);
  ///@}

  ///@{
  /**
   * Set the exposure factor for scattered light that reaches the camera. Light on surfaces is not
   * affected. With 1, the default, a thick white medium is up to four times as bright as a light of
   * color 1. With 0.25, it is as bright as a white wall that faces the light. Valid: 0 and above.
   */
  vtkSetClampMacro(ScatteringBrightness, double, 0.0, VTK_FLOAT_MAX);
  vtkGetMacro(ScatteringBrightness, double);
  ///@}

  ///@{
  /**
   * Set the number of cell layers behind a point, away from the light, whose backscattered light
   * FULL_SCATTERING includes. (C. Zhang, dissertation, 2.6, uses three slices.) With 0, the
   * default, all layers are included. Valid: 0 and above.
   */
  vtkSetClampMacro(BackwardLayers, int, 0, VTK_INT_MAX);
  vtkGetMacro(BackwardLayers, int);
  ///@}

  ///@{
  /**
   * Set the number of cells, along the volume's longest edge, of the grid on which
   * FORWARD_SCATTERING and FULL_SCATTERING compute scattered light. With 0, the default, it is 32,
   * or the number of voxels along that edge if that is smaller. Valid: 0, and 4 to 128.
   */
  void SetScatteringGridSize(int size);
  vtkGetMacro(ScatteringGridSize, int);
  ///@}

  ///@{
  /**
   * Set the maximum size of all textures and buffers of a frame, in bytes. Exceeding it is an
   * error. Default 0: only the graphics card limits the size. With a limit, software OpenGL uses
   * no texture of gradients, which makes shading slower. Valid: 0 and above.
   */
  vtkSetClampMacro(MaximumTextureMemory, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(MaximumTextureMemory, vtkIdType);
  ///@}

  /**
   * For internal use: set a medium that is evaluated by custom shader functions instead of the
   * scalars. Default null.
   */
  void SetMedium(vtkSliceMedium* medium);
  VTK_DEPRECATION("Use SetMedium.")
  void SetMatter(vtkSliceMedium* medium) { this->SetMedium(medium); }

  /**
   * Returns the report of the last frame:
   * - ShadowedLights: number of lights that cast shadows in the volume
   * - AreaLightsWithHardShadows: number of area lights too close or too large for soft shadows
   * - Slices: number of slices in all sweeps
   * - SliceSpacing: slice spacing in world units
   * - LightBufferSize: number of columns and rows of the largest light buffer
   * - ImageSampleDistance: size of a pixel of the volume's rendered image, in viewport pixels
   * - NonFiniteVoxels: number of voxels with NaN or infinity, which are transparent
   * - TextureBytes: bytes of the textures of the volume and its functions
   * - ScatteringSeconds: duration of the last computation of multiply scattered light
   * - Seconds: rendering time of the frame
   */
  vtkInterlumeReport* GetReport() { return this->Report; }

  /**
   * Read a light's buffer of the last frame: the transmittance of the entire volume along each ray
   * of the light. \a image receives floating-point scalars with one or three components. Its field
   * data array `BufferFromWorld` has the 16 elements, in row-major order, of the matrix from world
   * coordinates to texture coordinates, which range from 0 to 1 after division by the fourth
   * coordinate. Returns false if the light casts no shadows, or if it is inside or very close to
   * the volume, since such a light has no planar buffer.
   */
  bool ReadLightBuffer(vtkRenderer* renderer, vtkLight* light, vtkImageData* image);

  /**
   * For internal use by vtkShadowedScenePass: begin rendering the volume for a frame. If the pass
   * has drawn the volume before Render is called, Render only shows it.
   */
  interlume::VolumeImage& UpdateImage(vtkRenderer* renderer, vtkVolume* volume);

  /**
   * WARNING: for use by vtkRenderer only.
   */
  void Render(vtkRenderer* renderer, vtkVolume* volume) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  vtkMTimeType GetMTime() override;

protected:
  vtkShadowedSliceMapper();
  ~vtkShadowedSliceMapper() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

private:
  vtkShadowedSliceMapper(const vtkShadowedSliceMapper&) = delete;
  void operator=(const vtkShadowedSliceMapper&) = delete;

  interlume::Error FindScalars(vtkImageData* image, vtkDataArray*& scalars, bool& isOfCells);
  void ReportErrors();

  vtkNew<vtkInterlumeReport> Report;
  vtkMTimeType ErrorTime = 0;
  std::string ErrorText;
  vtkMTimeType WarningTime = 0;
  vtkSmartPointer<vtkSliceMedium> Medium;
  std::unique_ptr<interlume::PeelingDeferral> Peels;
  std::unique_ptr<interlume::VolumeImage> Image;
};

#endif
