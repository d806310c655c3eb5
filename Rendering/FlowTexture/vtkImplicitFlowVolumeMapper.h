// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkImplicitFlowVolumeMapper_h
#define vtkImplicitFlowVolumeMapper_h

#include "InterlumeFlowTextureModule.h" // for the export macro
#include "vtkInterlumeDeprecation.h"
#include "vtkImageData.h"       // for textures
#include "vtkInterlumeReport.h" // for GetReport()
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h" // for the gate
#include "vtkSmartPointer.h"
#include "vtkVolumeMapper.h"

#include <map>    // for textures by id
#include <memory> // for the renderer
#include <string> // for array names

namespace interlume
{
class Error;
class PeelingDeferral;
class FlowVolumeRenderer;
struct FlowVolumeRenderReport;
}

/**
 * @class   vtkImplicitFlowVolumeMapper
 * @brief   render an implicit flow field as a volume, colored by textures of termination surfaces
 *
 * Each voxel of an implicit flow field stores the surface where its streamline ends, the surface
 * coordinates (u,v) of the end, and the advection time. The color and opacity at a point are looked
 * up in the surface's *inflow texture* at (u,v). A texture on a surface thus appears to be carried
 * by the flow. Changing a texture, a color or the time gate requires no advection (C. Zhang,
 * dissertation, Ohio State 2006, section 4.6).
 *
 * **Input**: a vtkImageData with at least two points along each axis and the point arrays of
 * vtkImplicitFlowField: `FlowStatus`, `TerminationId`, `TerminationUV` (2 components) and
 * `AdvectionTime`. The point array `TerminationSide` and the field array `TerminationSurfaces`
 * (which of u and v are periodic) are optional. For other grids, use SAMPLES_OF_IMAGE of
 * vtkImplicitFlowField.
 *
 * **Interpolation.** u, v and time are interpolated trilinearly between corners of a cell that
 * reached the same surface. At borders between the regions of different surfaces, only the group of
 * corners with the largest weight is used. Borders are accurate to half a cell.
 *
 * **Opacity** refers to the ScalarOpacityUnitDistance of the vtkVolumeProperty. View rays are
 * sampled front to back at SampleDistance, without jitter.
 *
 * **Texture filtering.** The footprint of a sample, a segment of the view ray as wide as a pixel,
 * is mapped to (u,v) and filtered anisotropically, see TextureFilter.
 *
 * **Shading.** If the property's Shade is on and ShadingArray is set, colors are lit by the
 * renderer's lights and the property's coefficients. With a one-component array, samples are shaded
 * like isosurfaces whose normals point to lower values. With a three-component array, they are
 * shaded like lines along the vectors. If the gradient or vector is zero, shading is isotropic.
 * Without Shadows, lights are directional or positional, without cones and attenuation.
 *
 * **Shadows.** With Shadows on, and a light with ShadowAttenuation above 0, the volume is drawn in
 * slices by vtkShadowedSliceMapper. It supports the lights of that mapper, including vtkAreaLight.
 * Surfaces neither cast shadows into the volume nor receive its shadows, not even in a
 * vtkShadowedScenePass.
 *
 * Cropping and clipping planes are exact, for any direction matrix of the image. Opaque props hide
 * the parts of the volume behind them. Translucent polygons are always drawn behind the volume, and
 * UseDepthPeelingForVolumes triggers one warning. vtkHardwareSelector selects the whole volume. The
 * only BlendMode is composite.
 *
 * Samples whose coordinates or time are not finite are treated as not having reached a surface.
 * Non-finite values of other arrays are treated as 0. Both trigger one warning per input.
 *
 * Errors are reported by vtkErrorMacro, once for each state of the input and the mapper. The volume
 * is not drawn if
 * - the input is not an image, or an array is missing or has a wrong number of components;
 * - a texture image has the wrong type or too many dimensions;
 * - the textures exceed the GPU's texture units, texture size or memory, or MaximumTextureMemory;
 * - the blend mode is not composite;
 * - vtkShadowedSliceMapper reports an error (with shadows).
 *
 * See Documentation/methods/textured-flow.md for the method, and Documentation/measurements.md for
 * accuracy and speed.
 *
 * @sa vtkImplicitFlowField vtkInflowMapping vtkShadowedSliceMapper
 */
class INTERLUMEFLOWTEXTURE_EXPORT vtkImplicitFlowVolumeMapper : public vtkVolumeMapper
{
public:
  static vtkImplicitFlowVolumeMapper* New();
  vtkTypeMacro(vtkImplicitFlowVolumeMapper, vtkVolumeMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum DetailModes
  {
    DETAIL_MODULATE = 0,
    DETAIL_OVER = 1,
    DETAIL_ADD = 2
  };

  enum TimeGateTargets
  {
    GATE_INFLOW = 0,
    GATE_DETAIL = 1,
    GATE_BOTH = 2
  };

  /// Pass this instead of an id to set the texture of all surfaces that have no texture of their
  /// own.
  static constexpr int ALL = -1;

  ///@{
  /**
   * Set/Get the inflow texture of a surface id, or ALL for all other surfaces. An image has active
   * point scalars with 1 (gray), 2 (gray and alpha), 3 (RGB) or 4 (RGBA) components, and at most
   * two axes with more than one point. The scalars are unsigned char (0 to 255), unsigned short (0
   * to 65535), float or double (0 to 1). Without alpha, the texture is opaque. u runs along the
   * first axis, from 0 at the center of the first texel to 1 at the center of the last, v along the
   * second axis, as in vtkInflowMapping. Null removes the texture. Default none. Valid ids: ALL, 0
   * and above; other ids are an error and are ignored.
   */
  void SetInflowTexture(int id, vtkImageData* image);
  void RemoveAllInflowTextures();
  /// Returns the image set for this id, or null.
  vtkImageData* GetInflowTexture(int id) const;
  /// Returns all images by id.
  const std::map<int, vtkSmartPointer<vtkImageData>>& GetInflowTextures() const
  {
    return this->InflowTextures;
  }
  int GetNumberOfInflowTextures() const { return static_cast<int>(this->InflowTextures.size()); }
  ///@}

  ///@{
  /**
   * Set/Get the color (red, green, blue) and opacity of surfaces without a texture. Default 0.8,
   * 0.8, 0.8, 0.05. Valid: finite; clamped to [0, 1] for rendering.
   */
  vtkSetVector4Macro(DefaultColor, double);
  vtkGetVector4Macro(DefaultColor, double);
  ///@}

  ///@{
  /**
   * Set/Get a second, repeating texture. A two-dimensional image is mapped to (u,v), a
   * three-dimensional image to (u,v) and the time since inflow. It needs scalars like those of
   * an inflow texture. DetailScale is the number of repetitions per unit of u, v and time.
   * DETAIL_MODULATE multiplies colors and opacities, DETAIL_OVER composites the detail over the
   * inflow texture, DETAIL_ADD adds the two and clamps to 1. Default none, DETAIL_MODULATE,
   * (1, 1, 1). Valid: see DetailModes, clamped; finite scales.
   */
  void SetDetailTexture(vtkImageData* image);
  vtkImageData* GetDetailTexture() const { return this->DetailTexture; }
  vtkSetClampMacro(DetailMode, int, DETAIL_MODULATE, DETAIL_ADD);
  vtkGetMacro(DetailMode, int);
  void SetDetailModeToModulate() { this->SetDetailMode(DETAIL_MODULATE); }
  void SetDetailModeToOver() { this->SetDetailMode(DETAIL_OVER); }
  void SetDetailModeToAdd() { this->SetDetailMode(DETAIL_ADD); }
  vtkSetVector3Macro(DetailScale, double);
  vtkGetVector3Macro(DetailScale, double);
  ///@}

  ///@{
  /**
   * Set/Get a time gate: a function of the inflow time whose value, 0 to 1, multiplies the opacity.
   * At a sample with advection time t it is evaluated at TimePhase - t / TimePeriod. With
   * TimeGateRepeat on, its values on [0, 1] repeat, otherwise it is constant outside its range.
   * TimeGateTarget selects the gated texture. Where the gate is 0, a modulating detail texture has
   * no effect.
   * Default none, GATE_INFLOW, on. Valid: see TimeGateTargets; clamped.
   */
  void SetTimeGate(vtkPiecewiseFunction* function);
  vtkPiecewiseFunction* GetTimeGate() const { return this->TimeGate; }
  vtkSetClampMacro(TimeGateTarget, int, GATE_INFLOW, GATE_BOTH);
  vtkGetMacro(TimeGateTarget, int);
  void SetTimeGateTargetToInflow() { this->SetTimeGateTarget(GATE_INFLOW); }
  void SetTimeGateTargetToDetail() { this->SetTimeGateTarget(GATE_DETAIL); }
  void SetTimeGateTargetToBoth() { this->SetTimeGateTarget(GATE_BOTH); }
  vtkSetMacro(TimeGateRepeat, bool);
  vtkGetMacro(TimeGateRepeat, bool);
  vtkBooleanMacro(TimeGateRepeat, bool);
  ///@}

  ///@{
  /**
   * Set/Get the period of the time gate, in units of AdvectionTime, and the current time in
   * periods. Increasing the phase moves the time gate and a three-dimensional detail texture
   * downstream. Default: period 1, phase 0. Valid: period 1e-30 and above; phase finite.
   */
  vtkSetClampMacro(TimePeriod, double, 1e-30, VTK_DOUBLE_MAX);
  vtkGetMacro(TimePeriod, double);
  vtkSetMacro(TimePhase, double);
  vtkGetMacro(TimePhase, double);
  ///@}

  ///@{
  /**
   * Set/Get a one-component point array. Its value, mapped by the property's scalar opacity
   * function, multiplies the opacity. The function is sampled at 1024 points of the array's range.
   * Default empty: opacity is not multiplied.
   */
  void SetOpacityArray(const char* name);
  const char* GetOpacityArray() const { return this->OpacityArray.c_str(); }
  ///@}

  ///@{
  /**
   * Set/Get a point array for shading, used if the property's Shade is on: one component to shade
   * by the gradient, three to shade by the direction. Default empty: no shading.
   */
  void SetShadingArray(const char* name);
  const char* GetShadingArray() const { return this->ShadingArray.c_str(); }
  ///@}

  ///@{
  /**
   * If on, lights with ShadowAttenuation above 0 cast shadows in the volume. If off, or without
   * such a light, no light buffers are allocated and the shaders contain no shadow code. Default
   * off.
   */
  vtkSetMacro(Shadows, bool);
  vtkGetMacro(Shadows, bool);
  vtkBooleanMacro(Shadows, bool);
  ///@}

  ///@{
  /**
   * Set/Get the number of columns and rows of each light buffer. 0, the default, uses twice the
   * number of voxels across the volume as seen from the light, or just this number of voxels for a
   * light in or near the volume. Use a larger size if a texture casts shadows that are finer than
   * voxels. Valid: 0, or 16 to 8192, limited by the GPU; clamped.
   */
  void SetLightBufferSize(int size);
  vtkGetMacro(LightBufferSize, int);
  ///@}

  ///@{
  /**
   * If on, textures are filtered over the footprint of each sample. If off, each sample uses a
   * single texture lookup, and fine detail aliases. Default on.
   */
  vtkSetMacro(TextureFilter, bool);
  vtkGetMacro(TextureFilter, bool);
  vtkBooleanMacro(TextureFilter, bool);
  interlumeDeprecatedBooleanMacro(PaintFilter, TextureFilter);
  ///@}

  ///@{
  /**
   * Set/Get the maximum number of texture lookups per sample. More lookups keep obliquely viewed
   * or stretched textures sharper. Default 8. Valid: 1 to 64; clamped.
   */
  vtkSetClampMacro(MaximumTextureSamples, int, 1, 64);
  vtkGetMacro(MaximumTextureSamples, int);
  interlumeDeprecatedMacro(MaximumPaintSamples, MaximumTextureSamples, int);
  ///@}

  ///@{
  /**
   * Set/Get the distance between samples along a view ray or, with shadows, between slices, in
   * world units. 0, the default, uses half the smallest voxel spacing, or a quarter with shadows.
   * A ray has at most 60,000 / (MaximumTextureSamples + 5) samples; the report contains the
   * distance in use. Valid: 0 and above; clamped.
   */
  vtkSetClampMacro(SampleDistance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SampleDistance, double);
  ///@}

  ///@{
  /**
   * Set/Get the number of viewport pixels per rendered pixel, in x and in y. The rendered image is
   * interpolated to the viewport. Default 1. Valid: 0.25 to 100; clamped.
   */
  vtkSetClampMacro(ImageSampleDistance, double, 0.25, 100.0);
  vtkGetMacro(ImageSampleDistance, double);
  ///@}

  ///@{
  /**
   * If on, a frame that takes more than 0.2 s is refined by consecutive renderings: the first one
   * uses coarser pixels, samples and light buffers and takes about 0.2 s, and the last one draws
   * the same image as with this setting off. Render the window again while GetRefinementPending()
   * returns true. A change of the scene restarts with the first image. If nothing has changed, the
   * last image is shown again. Default off: each rendering draws the final image.
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
   * Set/Get the maximum size of the textures of one frame, in bytes. Exceeding it is an error.
   * Default 0: no limit other than GPU memory. Valid: 0 and above; clamped.
   */
  vtkSetClampMacro(MaximumTextureMemory, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(MaximumTextureMemory, vtkIdType);
  ///@}

  /**
   * Returns the report of the last frame:
   * - `Surfaces`, `SurfacesWithoutTexture`: number of surfaces that samples reached, and number of
   *   these surfaces drawn in DefaultColor;
   * - `NonFiniteSamples`: number of samples with a coordinate, time or value that is not finite;
   * - `EmptyCells`: number of cells without a corner that reached a surface;
   * - `SampleDistance`: distance between samples along a view ray, in world units;
   * - `TextureBytes`: size of the textures in bytes, limited by MaximumTextureMemory;
   * - `ShadowedLights`, `Slices`, `LightBufferBytes`: with shadows, number of lights that cast
   *   shadows, number of slices, and size of the light buffers in bytes;
   * - `Seconds`: time for this frame in seconds.
   */
  vtkInterlumeReport* GetReport() { return this->Report; }

  /**
   * For internal use by the renderer.
   */
  void Render(vtkRenderer* renderer, vtkVolume* volume) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  /// Returns the modification time, including images and the time gate.
  vtkMTimeType GetMTime() override;

protected:
  vtkImplicitFlowVolumeMapper();
  ~vtkImplicitFlowVolumeMapper() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

private:
  vtkImplicitFlowVolumeMapper(const vtkImplicitFlowVolumeMapper&) = delete;
  void operator=(const vtkImplicitFlowVolumeMapper&) = delete;

  interlume::Error Draw(
    vtkRenderer* renderer, vtkVolume* volume, interlume::FlowVolumeRenderReport& report);
  void SetName(std::string& member, const char* name);

  std::map<int, vtkSmartPointer<vtkImageData>> InflowTextures;
  double DefaultColor[4] = { 0.8, 0.8, 0.8, 0.05 };
  vtkSmartPointer<vtkImageData> DetailTexture;
  int DetailMode = DETAIL_MODULATE;
  double DetailScale[3] = { 1.0, 1.0, 1.0 };
  vtkSmartPointer<vtkPiecewiseFunction> TimeGate;
  int TimeGateTarget = GATE_INFLOW;
  bool TimeGateRepeat = true;
  double TimePeriod = 1.0;
  double TimePhase = 0.0;
  std::string OpacityArray;
  std::string ShadingArray;
  bool Shadows = false;
  int LightBufferSize = 0;
  bool TextureFilter = true;
  int MaximumTextureSamples = 8;
  double SampleDistance = 0.0;
  double ImageSampleDistance = 1.0;
  bool ProgressiveRendering = false;
  vtkIdType MaximumTextureMemory = 0;
  vtkNew<vtkInterlumeReport> Report;
  std::string ErrorText;
  vtkMTimeType ErrorTime = 0;
  vtkMTimeType WarningTime = 0;
  std::unique_ptr<interlume::PeelingDeferral> Peels;
  std::unique_ptr<interlume::FlowVolumeRenderer> Renderer;
};

#endif
