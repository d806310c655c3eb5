// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkShadowedScenePass_h
#define vtkShadowedScenePass_h

#include "InterlumeLightModule.h" // for the export macro
#include "vtkInterlumeReport.h"   // for GetReport()
#include "vtkNew.h"               // for the report
#include "vtkOpenGLRenderPass.h"

#include <memory> // for what is kept from picture to picture
#include <string> // for shaders
#include <vector> // for volumes

class vtkInformationIntegerKey;
class vtkVolume;

namespace interlume
{
class Error;
class SceneRenderer;
class SliceRenderer;
class VolumeImage;
}

/**
 * @class   vtkShadowedScenePass
 * @brief   draws a renderer's actors and sliced volumes under the same lights
 *
 * Surfaces cast shadows on surfaces and in volumes, and volumes on surfaces and on each other (C.
 * Zhang, dissertation, Ohio State 2006, 2.5.1), for actors and for volumes of
 * vtkShadowedSliceMapper whose Shadows is on. Each light that casts shadows gets a depth map of all
 * opaque actors that are visible props of the renderer, inside its view or not. VTK then draws
 * everything as it does by itself, and where its shaders have the colour I of a light, they have I
 * (1 - ShadowAttenuation (1 - V T)), V being the share of the light that other surfaces let
 * through, and T what volumes do. So every vtkOpenGLPolyDataMapper works, with its properties,
 * textures, normals, vertex colours, clipping planes, physically based and flat shading, glyphs of
 * vtkOpenGLGlyph3DMapper included, and where no shadow falls it looks as before.
 *
 *     vtkNew<vtkShadowedScenePass> pass;
 *     renderer->SetPass(pass);
 *
 * **Depth maps** are drawn again only where lights or actors have changed. V is the share of the
 * four texels around a place, weighted as for bilinear interpolation, that are not nearer to the
 * light; edges of shadows are so within half a texel. Instead of a bias that grows with the angle,
 * the plane of the fragment's own triangle is compared, texel by texel; it is moved by DepthBias
 * texels towards the light, for what is bent within a texel.
 *
 * **Volumes** are sliced ahead of the actors, behind whose depth nothing of them is drawn. Their
 * samples compare the light with the depth maps too. T is found for the surface that each pixel
 * shows: a place before the volume in the direction of light, or beside it, has all of the light;
 * one within it has what the light's buffer holds when its slices have come there, times exp(-tau
 * l) for the rest of the slab; one behind it what comes through all slices. Against closed forms a
 * wall of any place in homogeneous smoke is off by 0.0005 in the mean and by 0.002 for 95 % of its
 * pixels; the edge of a volume's shadow is as wide as a texel of the light's buffer. With eight
 * samples a pixel, a pixel at an edge takes T where a surface around shows the same depth.
 *
 * **Several volumes** are drawn in one set of slices, whether they overlap or stand apart. In each
 * slab one volume after the other is drawn into the picture, with the light that is left there, and
 * then takes from that light: between slabs extinctions add up exactly, for eye and light. Within a
 * slab the volume is first that the light meets first, where a plane along a face parts their
 * boxes; volumes that overlap take turns from slab to slab, so that errors of the first order in
 * the slab's optical depth cancel. Two boxes apart, overlapping or one in the other are off by
 * 0.0005 or less in the mean at the automatic spacing, two volumes of two colours at the same place
 * by 0.0006 at an optical depth of 0.2 a slab, by 0.0037 at 0.8; two halves of a volume are the
 * whole within 0.0003 at each pixel. The picture does not depend on the order of adding volumes,
 * but where two have the same bounds. Each has its own samples, transfer functions, cropping and
 * clipping, blocks that are passed over, TransmissionColor and SurfaceGradient. What is shared is
 * of one kind:
 * - SliceSpacing: the finest that one of them asks for, or has automatically, in all of them;
 * - LightBufferSize: automatic where one is, for the finest voxels and around all volumes, and at
 * least the largest that is set; else the largest;
 * - MaximumNumberOfShadows and NumberOfLightSamples the largest, ImageSampleDistance the smallest,
 * AutoAdjustSampleDistances where all have it on, BILINEAR_LIGHT where one has it;
 * - SoftShadowMethod: SAMPLE_LAYERS where one has it, else ACCUMULATED_CONVOLUTION where one does;
 * - light has three channels where one has a TransmissionColor;
 * - MaximumTextureMemory: the smallest that is set, for all of them together.
 *
 * Each mapper's report has the numbers of the whole picture, with its own blocks, textures and
 * features. Volumes are drawn one by one, one over the other in the renderer's order, and cast
 * shadows on surfaces alone, where all together would take more than eight times the slices that
 * they have by themselves, beyond MaximumTextureMemory, or where one mapper has several volumes;
 * the report gives the reason (SeparateVolumesReason). So is a volume whose Shadows is off. One
 * with an error is left out. Volumes of other mappers, also of vtkImplicitFlowVolumeMapper, neither
 * cast shadows on surfaces nor receive theirs.
 *
 * **Lights** are those of vtkShadowedSliceMapper: switched on and with a ShadowAttenuation above 0.
 * Actors cast no shadows of headlights, since the eye would not see them. A positional light
 * outside of the actors has one map, and so has one with a cone of 75 degrees or less; amid the
 * actors it has six, which show nothing nearer to it than a thousandth of the farthest actor.
 *
 * **Images of lights** fall on actors as in volumes, opaque or translucent and with or without
 * shadows: the light's colour in VTK's shaders is multiplied by the colour of a
 * vtkProjectiveLight's screen, vtkProjectiveLight::GetScreenColor, where the fragment's ray passes
 * it, and by vtkAreaLight::GetEmitterColor. A light whose image has an error shines on actors as
 * VTK sees it.
 *
 * **Translucent actors** leave 1 - opacity of each light behind them, as the eye sees what is
 * behind them, on surfaces and in volumes: what comes through is grey, whatever their colour. Each
 * light that casts shadows gets maps of their layers beside its depth map. Where there are volumes
 * too, the pass draws both in order: the layers of translucent actors that the eye sees cut each
 * pixel's line of sight into segments, and the volumes' picture is drawn once for each of them, cut
 * where the layers are. A layer is shaded by VTK with the light that shadows and volumes leave
 * there, so that properties, textures, colours of points and clipping planes count. An actor may so
 * be before, in, behind or across smoke; against a double-precision reference its pixels are within
 * 0.002 but for those at edges. Their edges have one sample a pixel, and depth peeling of the
 * renderer changes nothing. Without volumes VTK draws them as ever, and they cast and receive
 * shadows. Several surfaces in one plane count as VTK draws them. Beyond MaximumNumberOfLayers they
 * are drawn with the last layer. A layer before or in a volume costs more than a further picture of
 * the volume: in software smoke of 64^3 in a picture of 400^2 takes 2.7 times as long with one pane
 * over a third of it, and 4 times with two. Of an area light they leave what they leave of its
 * centre.
 *
 * **What does not take part**: translucent actors whose mapper is not one of polygons or glyphs, or
 * whose fragment shader of their own lacks VTK's parts for depth peeling, cast no shadow and are
 * drawn before volumes; they are named in a warning, once. With UseDepthPeelingForVolumes and depth
 * peeling all translucent actors are drawn before volumes. Lines and points cast and receive
 * shadows as wide as they are in texels of the map. Actors that face the camera, as vtkFollower,
 * are in the maps as they face the eye's camera. An actor whose mapper does not ask render passes
 * for its shaders, or has a fragment shader of its own without VTK's parts for light, is drawn
 * without shadows and named in a warning, once. Where PreserveDepthBuffer is on, actors of other
 * renderers occlude as ever, but cast no shadows.
 *
 * **Area lights** (vtkAreaLight) have soft shadows of surfaces by a depth map for each of
 * NumberOfLightSamples samples of the emitter (six for each where some of the light is amid the
 * actors): V = sum_c w_c V_c, with the weight w_c of a sample, coloured where the emitter has an
 * image, and V_c the share that the map of the sample lets through, compared as above from the
 * sample's own place. On surfaces of which some samples are hidden each is compared at four places
 * over the part of the emitter that it stands for, as far apart as the mean gap to what casts the
 * shadow makes them: so the penumbra has no steps to be seen but the faint outermost one, of one
 * sample, and its width, L dZ / Z, at each distance. With 16 samples that is within 2 % for dZ / Z
 * from 0.05 to 5 under square and round, near and far lights, tilted or not, and light is off by at
 * most 0.03 under a square and 0.05 under a round one; a square that is turned by 30 degrees from
 * the edge has 5 % less, and 0.06 where its corner begins. 64 samples are 0.008 off, 256 0.003.
 * Maps of samples have half of DepthMapResolution up to 16 samples, a third up to 81, a quarter
 * beyond, and no more than 8192 columns and rows together. Volumes cast soft shadows by their
 * mapper's SoftShadowMethod. With SAMPLE_LAYERS a surface behind the volume sees each sample's
 * layer from that sample, so that the penumbra widens with the distance from the volume, and
 * through the surfaces that hide the sample: a volume has at least as many layers as the pass
 * samples where surfaces cast shadows, and where its mapper asks for more, what both leave is
 * multiplied; with ACCUMULATED_CONVOLUTION it stays as wide as where the light leaves the volume.
 * SAMPLED_LIGHTS is drawn as SAMPLE_LAYERS. Where a light is too close for layers, shadows of
 * volumes are hard, from its centre. Where no light that casts shadows has an extent, nothing of
 * this is in shaders, maps and report.
 *
 * **Meshes** may be open, turned inside out, without thickness or cut by the eye's or a clipping
 * plane: the nearest depth that the light sees casts the shadow, whichever side of which face it
 * is. The source instead slices surfaces too and fills the cuts of closed solids by the stencil
 * buffer, so that a slice shows solid matter; a mesh that is not closed has no inside there. A map
 * of depths needs no such caps, and so there is no warning for open meshes: what is behind the
 * first face, as the inside of an open shell, is in its shadow.
 *
 * **Actors that are left out** of casting or of receiving say so by a key among their property keys
 * (vtkProp::SetPropertyKeys), as SetCastsShadows and SetReceivesShadows set it. One that casts none
 * is in no map of any light and has no layer in it, so that it shadows neither surfaces nor
 * volumes; it hides what is behind it from the eye as ever. One that receives none has all of each
 * light, with its image; in smoke it is as bright as before it. Keys of an assembly or of a prop
 * with levels of detail are those of its parts.
 *
 * **A scene without actors** and with fewer than two volumes, without lights that cast shadows, or
 * a selection by vtkHardwareSelector, is drawn as if the pass was not there: same picture, no map,
 * no pass. So are volumes without opaque actors beside opaque props of other kinds, as
 * vtkImageSlice. Images of lights and the order of translucent actors and volumes are there without
 * shadows too.
 *
 * Without DelegatePass the pass does all that the renderer does without a pass: camera, lights,
 * opaque, translucent, volumes, overlay, with the renderer's own settings of depth peeling, FXAA
 * and others. DelegatePass is what draws instead, as a vtkRenderStepsPass, or a vtkSequencePass
 * where this pass is itself the delegate of a vtkCameraPass.
 *
 * **Time**: in software, a million triangles around a bonsai of 256^3 take 1.2 times what VTK takes
 * for the volume alone and the actors twice, before smoke of 128^3 1.4 times, where the light
 * stays; `interlume-bench mixed` measures it.
 *
 * Errors (vtkErrorMacro; drawn without shadows then): OpenGL older than 3.2; depth maps that do not
 * fit into the graphics card's memory.
 *
 * @sa vtkShadowedSliceMapper vtkShadowMapPass
 */
class INTERLUMELIGHT_EXPORT vtkShadowedScenePass : public vtkOpenGLRenderPass
{
public:
  static vtkShadowedScenePass* New();
  vtkTypeMacro(vtkShadowedScenePass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * What draws the scene. Default null: all that the renderer draws without a pass.
   */
  virtual void SetDelegatePass(vtkRenderPass* pass);
  vtkGetObjectMacro(DelegatePass, vtkRenderPass);
  ///@}

  ///@{
  /**
   * Whether there are shadows. Off, everything is drawn as if the pass was not there. Default on.
   */
  vtkSetMacro(Shadows, bool);
  vtkGetMacro(Shadows, bool);
  vtkBooleanMacro(Shadows, bool);
  ///@}

  ///@{
  /**
   * The largest number of lights that cast shadows, the brightest ones. Default 16. Valid: 0 to 16.
   */
  vtkSetClampMacro(MaximumNumberOfShadows, int, 0, 16);
  vtkGetMacro(MaximumNumberOfShadows, int);
  ///@}

  ///@{
  /**
   * The number of columns and rows of each depth map. Default 1024. Valid: 16 to 8192; what does
   * not fit into one texture for all maps is made smaller, and the report has what is in use.
   */
  vtkSetClampMacro(DepthMapResolution, int, 16, 8192);
  vtkGetMacro(DepthMapResolution, int);
  ///@}

  ///@{
  /**
   * How far surfaces are moved towards the light where they are compared with its depth map, in
   * widths of the map's texels. Less than what is too little shows as specks on bent surfaces,
   * more lets light through where surfaces touch. Default 1. Valid: 0 to 100.
   */
  vtkSetClampMacro(DepthBias, double, 0.0, 100.0);
  vtkGetMacro(DepthBias, double);
  ///@}

  ///@{
  /**
   * The number of samples of each vtkAreaLight, each of which has a depth map of its own. A shadow
   * has so many steps where its penumbra is wide. With 1 shadows of surfaces are hard, from the
   * light's centre. Default 16, which volumes take too; 8 would leave the penumbra of a round light
   * 7 % too narrow. Valid: 1 to 256.
   */
  vtkSetClampMacro(NumberOfLightSamples, int, 1, 256);
  vtkGetMacro(NumberOfLightSamples, int);
  ///@}

  ///@{
  /**
   * The largest number of layers of translucent surfaces along a ray of the eye or of a light. What
   * lies behind the last one is drawn with it, in any order. For each layer that the eye sees the
   * volumes are drawn once more. Default 16. Valid: 1 to 64.
   */
  vtkSetClampMacro(MaximumNumberOfLayers, int, 1, 64);
  vtkGetMacro(MaximumNumberOfLayers, int);
  ///@}

  ///@{
  /**
   * Keys of a prop's property keys: whether its surfaces cast shadows, and whether they receive
   * them. Both do where a prop has no such key, and with any value but 0.
   */
  static vtkInformationIntegerKey* CASTS_SHADOWS();
  static vtkInformationIntegerKey* RECEIVES_SHADOWS();
  ///@}

  ///@{
  /**
   * Sets and returns these keys of a prop, of which a null one casts and receives nothing. On is
   * the default, and removes the key.
   */
  static void SetCastsShadows(vtkProp* prop, bool casts);
  static bool GetCastsShadows(vtkProp* prop);
  static void SetReceivesShadows(vtkProp* prop, bool receives);
  static bool GetReceivesShadows(vtkProp* prop);
  ///@}

  /**
   * Returns the report of the last image:
   * - ShadowCasters: opaque actors that cast shadows; Lights: lights that cast shadows of them
   * - Volumes: volumes of the scene
   * - VolumesInSharedSlices: volumes that cast shadows on each other
   * - SeparateVolumesReason: the error if volumes are rendered one by one, otherwise empty
   * - DepthMapResolution, SampleMapResolution: columns and rows of each depth map, of lights
   *   without extent and of samples of area lights
   * - DepthMapBytes, SampleMapBytes: bytes of these maps
   * - CameraLayers: layers of translucent actors between which volumes are rendered
   */
  vtkInterlumeReport* GetReport() { return this->Report; }

  /**
   * WARNING: the following are for VTK only.
   */
  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* vertices = nullptr) override;
  vtkMTimeType GetShaderStageMTime() override;

protected:
  vtkShadowedScenePass();
  ~vtkShadowedScenePass() override;

private:
  vtkShadowedScenePass(const vtkShadowedScenePass&) = delete;
  void operator=(const vtkShadowedScenePass&) = delete;

  /// Draws what the renderer draws without a pass, or the delegate.
  void DrawAll(const vtkRenderState* state);
  interlume::Error DrawShadows(vtkRenderer* renderer);
  /// Renders all volumes for the scene as it is, together if that is possible, and lays the images
  /// over the framebuffer that is bound.
  void DrawVolumes(vtkRenderer* renderer);
  interlume::Error DrawTogether(vtkRenderer* renderer);
  void ShowVolumes(vtkRenderer* renderer);
  void FindVolumes(vtkRenderer* renderer);
  void WarnOfUnreached();

  vtkRenderPass* DelegatePass = nullptr;
  bool Shadows = true;
  int MaximumNumberOfShadows = 16;
  int DepthMapResolution = 1024;
  double DepthBias = 1.0;
  int NumberOfLightSamples = 16;
  int MaximumNumberOfLayers = 16;
  vtkNew<vtkInterlumeReport> Report;
  std::unique_ptr<interlume::SceneRenderer> Renderer;
  /// The renderer of volumes in shared slices.
  std::shared_ptr<interlume::SliceRenderer> Together;
  /// The volumes of the scene that is being drawn, and their images.
  std::vector<vtkVolume*> Volumes;
  std::vector<interlume::VolumeImage*> Images;
};

#endif
