// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkImplicitFlowVolumeMapper_h
#define vtkImplicitFlowVolumeMapper_h

#include "InterlumeFlowTextureModule.h" // for the export macro
#include "vtkImageData.h"               // for textures
#include "vtkInterlumeReport.h"         // for GetReport()
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h" // for the gate
#include "vtkSmartPointer.h"
#include "vtkVolumeMapper.h"

#include <map>    // for textures by id
#include <memory> // for what is kept from picture to picture
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
 * @brief   draws an implicit flow field as a volume of what is painted on its termination surfaces
 *
 * Each voxel knows the surface its streamline ends on, the place (u,v) there, and the time it takes
 * to come there (C. Zhang, dissertation, Ohio State 2006, section 4.6). A place x of the volume has
 * the colour and opacity
 *   P(x) = inflow texture of the surface at (u(x), v(x)),
 * so that paint on a surface is carried through the flow, and another image, colour or gate is
 * another picture without any advection.
 *
 * **Input**: vtkImageData with the point arrays that vtkImplicitFlowField writes: `FlowStatus`,
 * `TerminationId`, `TerminationUV` (2 components) and `AdvectionTime`, of any types of numbers; of
 * its further arrays `TerminationSide` and the field array `TerminationSurfaces`, which tells which
 * of u and v are periodic with period 1, are read where they are there. Two points along each axis
 * at least. Grids that are no images have to be sampled, by SAMPLES_OF_IMAGE of that filter.
 *
 * **Interpolation.** u, v and time are interpolated trilinearly among the corners of a cell that
 * have the same status and surface, those that have most weight at the place: weights of the others
 * are dropped, and what is left is normalised. Over a periodic seam places are taken from one side.
 * Where a streamline comes round to its surface again, and time jumps from 0 to a whole turn,
 * corners of both kinds are told apart by `TerminationSide`, if the shorter times are less than
 * half the longest. So nothing is mixed at borders; they are off by up to half a cell. Elsewhere
 * the error is that of trilinear interpolation, of second order in the distance of voxels: off
 * by 3.6 times less, and more, for half that distance, in a field of rotation.
 *
 * **Opacity** is that in one ScalarOpacityUnitDistance of the vtkVolumeProperty: a piece of a line
 * of sight of length l has 1 - (1 - alpha)^(l / unit distance). Lines of sight are walked from
 * front to back in pieces of SampleDistance, without jitter, until 0.9999 of opacity.
 *
 * **Sharp paint.** What a sample stands for, a piece of the ray as wide as a pixel, is mapped to
 * (u,v) by the derivatives of the interpolation within its cell, never by those between pixels or
 * voxels of different surfaces. The longest of its three axes is split into so many samples that
 * each has one texel, and the others choose the texture's level of detail. So paint that is
 * stretched or seen at a grazing angle is blurred along the one direction only that has too many
 * texels.
 *
 * **Colours** are those of the textures. With the property's Shade on and a ShadingArray they are
 * lit by the renderer's lights (directional or positional, without cones and fall-off), with the
 * property's coefficients: as surfaces towards lower values of an array of one component, or, by
 * an array of three, as lines along its direction (D. Stalling, M. Zoeckler, H.-C. Hege, "Fast
 * display of illuminated field lines", 1997). Where the gradient or the vector is zero, light is
 * scattered evenly.
 *
 * **Shadows.** With Shadows on, a light that is switched on and has a ShadowAttenuation above 0
 * loses on its way through the volume what the paint there takes, as in vtkShadowedSliceMapper,
 * by which the picture is drawn then: in slices, with one buffer for each light. A piece of a ray
 * of length l lets exp(-tau l) of light and sight through, tau = -ln(1 - alpha) /
 * ScalarOpacityUnitDistance, so that both routes have the same opacity. Paint of colour c is seen
 * as
 *   C = c (ka Ia + sum kd I T D) + sum ks I T S,
 * D and S the diffuse and specular share by ShadingArray, as above, or 1 and 0 without one or
 * without Shade; ka, kd, ks the property's coefficients, I the lights with cone, fall-off and
 * screen, T the transmittance from there and Ia their ambient colours, white where all are black.
 * All lights of that mapper are lights here, soft shadows of a vtkAreaLight too. The light on slabs
 * of paint that cast shadows on each other, three and five voxels thick and of opacities that jump
 * at their sides, is off by 0.0071 of 1 or less in the mean, by 0.0034 with slices an eighth of a
 * voxel apart and buffers of 256 columns; on smooth paint by 0.0004 and 0.0002. Soft light of a
 * square emitter is off by 0.006, and by 0.011 where the emitter is half as wide as it is far. On
 * sharp edges of dense paint the columns of a light's buffer show as faint stripes, which a larger
 * LightBufferSize thins. Surfaces neither cast shadows in the volume nor receive its own:
 * vtkShadowedScenePass does not know this mapper.
 *
 * Cropping and clipping planes cut exactly along the ray, whatever the direction matrix of the
 * image is. Opaque props occlude by depth. Translucent polygons are behind the volume wherever they
 * are, and UseDepthPeelingForVolumes is warned of once. Selection (vtkHardwareSelector) finds the
 * volume as a whole. The only BlendMode is composite.
 *
 * Samples with a place or time that is not finite count as having reached no surface, those with no
 * finite value of another array as having the value 0; both are counted and warned of once for each
 * input.
 *
 * Errors (vtkErrorMacro, once for each state of the input and the mapper; nothing is drawn): an
 * input that is no image, arrays that are missing or of the wrong shape, images of the wrong type
 * or with too many dimensions, no texture units or texture memory left, textures over the graphics
 * card's limits, a blend mode that is not supported; with shadows those of vtkShadowedSliceMapper.
 *
 * @sa vtkShadowedSliceMapper
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

  /// The id that stands for all surfaces without a texture of their own.
  static constexpr int ALL = -1;

  ///@{
  /**
   * The image that is painted on the surface of an id, or on ALL others: point scalars of unsigned
   * char, unsigned short (0 to 255 and to 65535), float or double (0 to 1), grey, grey and alpha,
   * RGB or RGBA, any two axes; u goes from the first column's middle, 0, to the last one's, 1, v
   * along the other axis, as in vtkInflowMapping. Without alpha paint is opaque. Null removes it.
   * Default none. Valid ids: ALL, 0 and above; others are an error and change nothing.
   */
  void SetInflowTexture(int id, vtkImageData* image);
  void RemoveAllInflowTextures();
  /// Returns what was set for the id itself; null where nothing was.
  vtkImageData* GetInflowTexture(int id) const;
  /// Returns all images that are set, by id.
  const std::map<int, vtkSmartPointer<vtkImageData>>& GetInflowTextures() const
  {
    return this->InflowTextures;
  }
  int GetNumberOfInflowTextures() const { return static_cast<int>(this->InflowTextures.size()); }
  ///@}

  ///@{
  /**
   * Red, green, blue and opacity of surfaces without a texture, 0 to 1. Default 0.8, 0.8, 0.8,
   * 0.05. Valid: finite; clamped to 0 to 1 when drawn.
   */
  vtkSetVector4Macro(DefaultColor, double);
  vtkGetVector4Macro(DefaultColor, double);
  ///@}

  ///@{
  /**
   * A second image, of the types above, which is repeated: of two dimensions over (u,v), or of
   * three over (u,v) and the time since the paint was put in; DetailScale is the number of
   * repetitions in one unit of u, of v and of time. DETAIL_MODULATE: colours and opacities are
   * multiplied; DETAIL_OVER: the detail lies over the inflow's paint; DETAIL_ADD: they are added,
   * up to 1. Default none, DETAIL_MODULATE, 1, 1, 1. Valid: see DetailModes, clamped; any finite
   * numbers.
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
   * How much paint is put in as time goes on, 0 to 1, by which opacity is multiplied: where time
   * is t, what was put in at TimePhase - t / TimePeriod is seen. With TimeGateRepeat the function
   * is taken from 0 to 1 and repeated; else beyond its own range its ends go on. TimeGateTarget
   * tells which texture is gated; where a detail that modulates is gated by 0, there is no detail.
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
   * The unit of the gate's time, in units of AdvectionTime, and the time now in such units: as it
   * grows, dye moves downstream, with the gate and with a detail of three dimensions. Default 1, 0.
   * Valid: 1e-30 and above; finite.
   */
  vtkSetClampMacro(TimePeriod, double, 1e-30, VTK_DOUBLE_MAX);
  vtkGetMacro(TimePeriod, double);
  vtkSetMacro(TimePhase, double);
  vtkGetMacro(TimePhase, double);
  ///@}

  ///@{
  /**
   * The point array of one component whose value, by the scalar opacity function of the property,
   * multiplies opacity; the function is sampled at 1024 places of the array's range. Default empty:
   * none.
   */
  void SetOpacityArray(const char* name);
  const char* GetOpacityArray() const { return this->OpacityArray.c_str(); }
  ///@}

  ///@{
  /**
   * The point array, of one component or of three, by whose gradient or direction paint is shaded
   * where the property's Shade is on. Default empty: none.
   */
  void SetShadingArray(const char* name);
  const char* GetShadingArray() const { return this->ShadingArray.c_str(); }
  ///@}

  ///@{
  /**
   * Whether lights cast shadows in the volume, where one asks for them; see the description of the
   * class. Off, or without such a light, nothing of shadows is drawn, kept or in the shaders.
   * Default off.
   */
  vtkSetMacro(Shadows, bool);
  vtkGetMacro(Shadows, bool);
  vtkBooleanMacro(Shadows, bool);
  ///@}

  ///@{
  /**
   * The number of columns and rows of the buffer of each light that casts shadows. 0, the default:
   * twice as many as the volume has voxels across, seen from the light, or as many for a light
   * within it; shadows of paint that is finer than voxels want more. Valid: 0, and 16 to 8192, up
   * to what the graphics card can do.
   */
  void SetLightBufferSize(int size);
  vtkGetMacro(LightBufferSize, int);
  ///@}

  ///@{
  /**
   * Whether textures are filtered by what a sample stands for; else they are looked up at one place
   * each, and letters alias where they are small. Default on.
   */
  vtkSetMacro(PaintFilter, bool);
  vtkGetMacro(PaintFilter, bool);
  vtkBooleanMacro(PaintFilter, bool);
  ///@}

  ///@{
  /**
   * The largest number of places of a texture that are looked up for one sample. Default 8. Valid:
   * 1 to 64.
   */
  vtkSetClampMacro(MaximumPaintSamples, int, 1, 64);
  vtkGetMacro(MaximumPaintSamples, int);
  ///@}

  ///@{
  /**
   * The distance of samples along a line of sight, in world units, or that of slices with shadows.
   * 0, the default: half the smallest distance of voxels, and with shadows a quarter of it. Valid:
   * 0 and above. A line has no more than 60,000 / (MaximumPaintSamples + 5) samples; the report has
   * the distance in use.
   */
  vtkSetClampMacro(SampleDistance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SampleDistance, double);
  ///@}

  ///@{
  /**
   * The number of pixels of the viewport for each pixel of the picture, along an edge; the picture
   * is interpolated between its pixels. Default 1. Valid: 0.25 to 100.
   */
  vtkSetClampMacro(ImageSampleDistance, double, 0.25, 100.0);
  vtkGetMacro(ImageSampleDistance, double);
  ///@}

  ///@{
  /**
   * The largest number of bytes that textures of one picture may take; more is an error. Default 0:
   * what the graphics card gives. Valid: 0 and above.
   */
  vtkSetClampMacro(MaximumTextureMemory, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(MaximumTextureMemory, vtkIdType);
  ///@}

  /**
   * Returns the report of the last image:
   * - `Surfaces`, `SurfacesWithoutTexture`: surfaces that samples reached, and those of them drawn
   *   in DefaultColor;
   * - `NonFiniteSamples`: samples with a coordinate, time or value that is not finite;
   * - `EmptyCells`: cells with no corner that reached a surface;
   * - `SampleDistance`: the distance of samples along a line of sight in world units;
   * - `TextureBytes`: the bytes of textures, limited by MaximumTextureMemory;
   * - `ShadowedLights`, `Slices`, `LightBufferBytes`: with shadows, the numbers of lights that cast
   *   them and of slices, and the bytes of light buffers;
   * - `Seconds`: seconds of this image.
   */
  vtkInterlumeReport* GetReport() { return this->Report; }

  /**
   * WARNING: for the renderer only.
   */
  void Render(vtkRenderer* renderer, vtkVolume* volume) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  /// Returns the time of the last change, of the images and the gate too.
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
  bool PaintFilter = true;
  int MaximumPaintSamples = 8;
  double SampleDistance = 0.0;
  double ImageSampleDistance = 1.0;
  vtkIdType MaximumTextureMemory = 0;
  vtkNew<vtkInterlumeReport> Report;
  std::string ErrorText;
  vtkMTimeType ErrorTime = 0;
  vtkMTimeType WarningTime = 0;
  std::unique_ptr<interlume::PeelingDeferral> Peels;
  std::unique_ptr<interlume::FlowVolumeRenderer> Renderer;
};

#endif
