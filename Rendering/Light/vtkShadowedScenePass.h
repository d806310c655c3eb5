// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkShadowedScenePass_h
#define vtkShadowedScenePass_h

#include "InterlumeLightModule.h" // for the export macro
#include "vtkInterlumeDeprecation.h"
#include "vtkInterlumeReport.h" // for GetReport()
#include "vtkNew.h"             // for the report
#include "vtkOpenGLRenderPass.h"

#include <memory> // for the renderers
#include <string> // for shader sources
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
 * @brief   render actors and sliced volumes with shared lights and shadows
 *
 * Surfaces cast shadows on surfaces and in volumes; volumes cast shadows on surfaces and on each
 * other (C. Zhang, dissertation, Ohio State 2006, 2.5). Volumes take part if their mapper is a
 * vtkShadowedSliceMapper with Shadows on. See Documentation/methods/scenes.md for the method and
 * its accuracy, and Documentation/measurements.md for times.
 *
 *     vtkNew<vtkShadowedScenePass> pass;
 *     renderer->SetPass(pass);
 *
 * **Actors** are drawn by VTK's shaders, where each light's color is multiplied by 1 -
 * ShadowAttenuation (1 - V T). V is the fraction of the light that other surfaces transmit,
 * computed from shadow maps. T is the transmittance of the volumes. All visible opaque actors cast
 * shadows, whether they are in view or not. Meshes may be open, inside out or infinitely thin.
 * Properties, textures, normals, vertex colors, clipping planes, PBR and flat shading, and glyphs
 * of vtkOpenGLGlyph3DMapper work as usual. SetCastsShadows and SetReceivesShadows exclude actors;
 * SetCastsShadowsWhenInvisible includes invisible ones.
 *
 * **Lights** are all lights that are switched on, as in vtkShadowedSliceMapper. Lights with a
 * ShadowAttenuation above 0 cast shadows, but headlights cast none on actors. Images of
 * vtkProjectiveLight and colors of vtkAreaLight also apply to actors, with or without shadows. A
 * light with invalid values or an invalid image lights nothing. A vtkAreaLight casts soft shadows,
 * computed from NumberOfLightSamples shadow maps; see Documentation/methods/soft-shadows.md.
 *
 * **Volumes** share one set of slices, whether they overlap or not. The settings of their mappers
 * are combined as follows:
 * - SliceSpacing: the smallest; LightBufferSize: at least the largest;
 * - MaximumNumberOfShadowLights, NumberOfLightSamples: the largest;
 * - ImageSampleDistance: the smallest; MaximumTextureMemory: the smallest nonzero value;
 * - AutoAdjustSampleDistances: on if it is on for all volumes;
 * - BILINEAR_LOOKUP, and three channels for a TransmissionColor, if one volume uses them;
 * - SoftShadowMethod: SAMPLE_LAYERS if one volume uses it, then ACCUMULATED_CONVOLUTION.
 *
 * Volumes are rendered one by one instead if rendering them together would need more than eight
 * times as many slices or exceed MaximumTextureMemory, or if a mapper draws several volumes. The
 * report then contains the SeparateVolumesReason. Such volumes cast shadows on surfaces, but not on
 * each other. A volume with an error is skipped. Multiple scattering is computed jointly for
 * volumes in shared slices; see Documentation/methods/scattering.md.
 *
 * **Translucent actors** transmit the fraction 1 - opacity of each light in all color channels,
 * regardless of their color. With volumes in the scene, they are drawn in depth order between
 * segments of the volumes, with up to MaximumNumberOfLayers layers per pixel, and the renderer's
 * depth peeling settings are ignored. The volumes are rendered once more for each layer that the
 * camera sees. If the renderer's UseDepthPeeling and UseDepthPeelingForVolumes are on, all
 * translucent actors are drawn before the volumes instead.
 *
 * **Limitations**: volumes of other mappers neither cast nor receive shadows. An actor is drawn
 * without shadows, with a warning, if its mapper ignores render passes or its fragment shader lacks
 * VTK's lighting code. A translucent actor casts no shadow, with a warning, if its mapper is not a
 * polygon or glyph mapper or its shader lacks VTK's depth peeling code. Actors in other renderers
 * cast no shadows. If there are no shadows or light images to compute, or during hardware
 * selection, the scene is drawn as if the pass did not exist.
 *
 * **Errors** are reported by vtkErrorMacro, and the scene is then drawn without shadows. They occur
 * if OpenGL is older than 3.2 or if shadow maps exceed the graphics card's memory.
 *
 * @sa vtkShadowedSliceMapper vtkAreaLight vtkShadowMapPass
 */
class INTERLUMELIGHT_EXPORT vtkShadowedScenePass : public vtkOpenGLRenderPass
{
public:
  static vtkShadowedScenePass* New();
  vtkTypeMacro(vtkShadowedScenePass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set the pass that draws the scene, for example a vtkRenderStepsPass, or a vtkSequencePass if
   * the vtkShadowedScenePass is itself the delegate of a vtkCameraPass. Default null: draw
   * everything that the renderer draws without a pass, with the renderer's own settings.
   */
  virtual void SetDelegatePass(vtkRenderPass* pass);
  vtkGetObjectMacro(DelegatePass, vtkRenderPass);
  ///@}

  ///@{
  /**
   * Turn shadows on or off. If off, everything is drawn as if the pass did not exist. Default on.
   */
  vtkSetMacro(Shadows, bool);
  vtkGetMacro(Shadows, bool);
  vtkBooleanMacro(Shadows, bool);
  ///@}

  ///@{
  /**
   * Set the maximum number of lights that cast shadows, brightest first. Default 16. Valid: 0 to
   * 16.
   */
  vtkSetClampMacro(MaximumNumberOfShadowLights, int, 0, 16);
  vtkGetMacro(MaximumNumberOfShadowLights, int);
  interlumeDeprecatedMacro(MaximumNumberOfShadows, MaximumNumberOfShadowLights, int);
  ///@}

  ///@{
  /**
   * Set the number of columns and rows of each shadow map. It is reduced if the maps of all
   * lights do not fit into one texture; the report contains the value in use. Default 1024.
   * Valid: 16 to 8192.
   */
  vtkSetClampMacro(DepthMapResolution, int, 16, 8192);
  vtkGetMacro(DepthMapResolution, int);
  ///@}

  ///@{
  /**
   * Set the bias that moves a surface toward the light before comparison with the shadow map, in
   * texels of the map. Too small a value causes specks on curved surfaces; a larger value brightens
   * shadows where surfaces touch. Default 1. Valid: 0 to 100.
   */
  vtkSetClampMacro(DepthBias, double, 0.0, 100.0);
  vtkGetMacro(DepthBias, double);
  ///@}

  ///@{
  /**
   * Set the number of samples of each vtkAreaLight. Each sample has its own shadow map, and volumes
   * use at least as many samples. Too few samples are visible as steps in wide penumbras and make
   * them too narrow. With 1, surfaces cast hard shadows from the light's center. Default 16. Valid:
   * 1 to 256.
   */
  vtkSetClampMacro(NumberOfLightSamples, int, 1, 256);
  vtkGetMacro(NumberOfLightSamples, int);
  ///@}

  ///@{
  /**
   * Set the maximum number of layers of translucent surfaces along a ray from the camera or a
   * light. Surfaces behind the last layer are drawn with it, unsorted. Default 16. Valid: 1 to 64.
   */
  vtkSetClampMacro(MaximumNumberOfLayers, int, 1, 64);
  vtkGetMacro(MaximumNumberOfLayers, int);
  ///@}

  ///@{
  /**
   * Keys for vtkProp::SetPropertyKeys that control whether the prop's surfaces cast and receive
   * shadows. They do unless CASTS_SHADOWS or RECEIVES_SHADOWS, respectively, is 0. Surfaces of an
   * invisible prop cast shadows only if CASTS_SHADOWS_WHEN_INVISIBLE is not 0. Keys of an assembly
   * or a level-of-detail prop apply to its parts.
   */
  static vtkInformationIntegerKey* CASTS_SHADOWS();
  static vtkInformationIntegerKey* RECEIVES_SHADOWS();
  static vtkInformationIntegerKey* CASTS_SHADOWS_WHEN_INVISIBLE();
  ///@}

  ///@{
  /**
   * Set or get the CASTS_SHADOWS and RECEIVES_SHADOWS keys of a prop. Setting true, the default,
   * removes the key. For a null prop, the getters return false.
   * - A prop that does not cast shadows is in no shadow map, so it shadows neither surfaces nor
   *   volumes.
   * - A prop that does not receive shadows gets the full light of each light source, including its
   *   image.
   */
  static void SetCastsShadows(vtkProp* prop, bool casts);
  static bool GetCastsShadows(vtkProp* prop);
  static void SetReceivesShadows(vtkProp* prop, bool receives);
  static bool GetReceivesShadows(vtkProp* prop);
  ///@}

  ///@{
  /**
   * Set or get the CASTS_SHADOWS_WHEN_INVISIBLE key of an actor or assembly. Setting false, the
   * default, removes the key. An actor with this key and VisibilityOff() casts shadows on surfaces
   * and in volumes without being drawn, for example a screen with holes that shapes beams of light.
   * For a null prop, the getter returns false.
   */
  static void SetCastsShadowsWhenInvisible(vtkProp* prop, bool casts);
  static bool GetCastsShadowsWhenInvisible(vtkProp* prop);
  ///@}

  /**
   * Returns the report of the last frame:
   * - ShadowCasters: number of opaque actors that cast shadows
   * - Lights: number of lights that cast shadows of actors
   * - Volumes: number of volumes in the scene
   * - VolumesInSharedSlices: number of volumes that cast shadows on each other
   * - SeparateVolumesReason: the reason if volumes are rendered one by one, otherwise empty
   * - DepthMapResolution, SampleMapResolution: number of columns and rows of the shadow map of each
   *   point or directional light, and of each sample of an area light
   * - DepthMapBytes, SampleMapBytes: total bytes of these maps
   * - CameraLayers: number of layers of translucent actors between which volumes are rendered
   */
  vtkInterlumeReport* GetReport() { return this->Report; }

  /**
   * WARNING: the following methods are for use by VTK only.
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

  /// Draws everything that the renderer draws without a pass, or calls the delegate.
  void DrawAll(const vtkRenderState* state);
  interlume::Error DrawShadows(vtkRenderer* renderer);
  /// Renders all volumes of the current scene, in shared slices if possible. ShowVolumes composites
  /// their images over the bound framebuffer.
  void DrawVolumes(vtkRenderer* renderer);
  interlume::Error DrawTogether(vtkRenderer* renderer);
  void ShowVolumes(vtkRenderer* renderer);
  void FindVolumes(vtkRenderer* renderer);
  void WarnAboutUnsupportedActors();

  vtkRenderPass* DelegatePass = nullptr;
  bool Shadows = true;
  int MaximumNumberOfShadowLights = 16;
  int DepthMapResolution = 1024;
  double DepthBias = 1.0;
  int NumberOfLightSamples = 16;
  int MaximumNumberOfLayers = 16;
  vtkNew<vtkInterlumeReport> Report;
  std::unique_ptr<interlume::SceneRenderer> Renderer;
  /// Renderer of volumes in shared slices.
  std::shared_ptr<interlume::SliceRenderer> Together;
  /// Volumes of the current scene, and their images.
  std::vector<vtkVolume*> Volumes;
  std::vector<interlume::VolumeImage*> Images;
};

#endif
