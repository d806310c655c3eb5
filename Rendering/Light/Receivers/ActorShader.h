// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ActorShader_h
#define interlume_ActorShader_h

#include <array>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

class vtkRenderer;
class vtkShaderProgram;
class vtkTextureObject;

namespace interlume
{

class LightTransmittance;
class PaneMaps;
class SceneCasters;
class SceneFields;
class SceneScreens;
struct LightSource;

/**
 * @class   ActorShader
 * @brief   makes the fragment shaders of VTK's mappers ask which share of each light comes through
 *
 * VTK's shaders have `lightColorN` for the light N that is switched on, in all kinds of shading;
 * each use of it becomes `(lightColorN * sceneLightN)`. What volumes scatter on and on is added to
 * the sum of diffuse light, in physically based shading to the irradiance of an environment.
 */
class ActorShader
{
public:
  /**
   * Puts the sources together. Returns whether they are others than before.
   */
  bool Update(vtkRenderer* renderer, const std::vector<LightSource>& lights,
    const SceneCasters& casters, const LightTransmittance& transmittance, const PaneMaps& panes,
    const SceneScreens& screens, const SceneFields& fields);
  /// What is drawn next: surfaces of these depths, which \a transmittance is for, in the
  /// renderer's viewport or, not \a isOnScreen, in a framebuffer of its size.
  void SetSurfaces(
    const LightTransmittance& transmittance, vtkTextureObject* depth, bool isOnScreen);
  /// Takes all away. Returns whether there was something.
  bool Clear();

  /// Marks where the sources go, in a shader without VTK's parts.
  static void Mark(std::string& fragmentShader);
  /// Puts the sources in, or those of lights' images alone where a surface receives no shadows.
  /// Returns false where light falls in a shader that has no place for them.
  bool Replace(std::string& fragmentShader, bool isReceiver) const;

  /// Sets the uniforms; the textures are active where not \a isOfDepths. \a placeholder is active
  /// otherwise.
  void SetUniforms(
    vtkShaderProgram* program, bool isOpaque, bool isOfDepths, vtkTextureObject* placeholder) const;

private:
  struct Light
  {
    /// What surfaces leave of it, a call; empty where they cast no shadows of it.
    std::string Share;
    int Tile = -1;
    float Strength = 1.0F;
    /// The factor of its image, as source; empty without.
    std::string Screen;
    /// What translucent surfaces leave of it, as source; empty where that is all.
    std::string Panes;
  };

  /// What is put into a shader: the numbers of lights in it, and sources.
  struct Parts
  {
    std::vector<int> Numbers;
    std::string Declarations;
    std::string Implementation;
  };

  std::vector<Light> Lights;
  Parts Shadowed;
  Parts Images;
  const SceneCasters* Casters = nullptr;
  const LightTransmittance* Transmittance = nullptr;
  const PaneMaps* Panes = nullptr;
  const SceneScreens* Screens = nullptr;
  const SceneFields* Fields = nullptr;
  vtkTextureObject* Depth = nullptr;
  glm::dmat4 WorldFromView{ 0.0 };
  std::array<float, 4> Viewport{};
  bool IsOnScreen = true;
};

}

#endif
