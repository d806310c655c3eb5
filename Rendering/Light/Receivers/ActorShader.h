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
class TranslucentShadowMaps;
class SceneOccluders;
class SceneScatteredLight;
class SceneLightImages;
struct LightSource;

/**
 * @class   ActorShader
 * @brief   inserts shadows and light images into the fragment shaders of VTK's mappers
 *
 * In all shading models, VTK's shaders use `lightColorN` for the N-th light that is switched on.
 * Each use is replaced with `(lightColorN * sceneLightN)`. Light from multiple scattering in
 * volumes is added to the diffuse light or, in physically based shading, to the diffuse reflection
 * of the environment.
 */
class ActorShader
{
public:
  /**
   * Assembles the GLSL code to insert. Returns true if it has changed.
   */
  bool Update(vtkRenderer* renderer, const std::vector<LightSource>& lights,
    const SceneOccluders& occluders, const LightTransmittance& transmittance,
    const TranslucentShadowMaps& translucentMaps, const SceneLightImages& screens,
    const SceneScatteredLight& fields);
  /// Sets the textures for the surfaces drawn next: their \a depth, and the \a transmittance of the
  /// volumes between each light and the surfaces. The surfaces are drawn in the renderer's viewport
  /// or, if \a isOnScreen is false, in a framebuffer of its size.
  void SetSurfaceTextures(
    const LightTransmittance& transmittance, vtkTextureObject* depth, bool isOnScreen);
  /// Removes all GLSL code to insert. Returns true if there was any.
  bool Clear();

  /// Marks where Replace inserts the GLSL code. Call this before VTK replaces its tags.
  static void Mark(std::string& fragmentShader);
  /// Replaces the markers with the GLSL code. If \a isReceiver is false, inserts only the code for
  /// light images. Returns false if the shader uses lights but has no markers.
  bool Replace(std::string& fragmentShader, bool isReceiver) const;

  /// Sets the uniforms. If \a isDepthOnly is true, only depths are drawn, and \a placeholder must
  /// be active. Otherwise the textures must be active.
  void SetUniforms(vtkShaderProgram* program, bool isOpaque, bool isDepthOnly,
    vtkTextureObject* placeholder) const;

private:
  struct Light
  {
    /// GLSL call for the fraction of the light that opaque surfaces do not block. Empty if they
    /// block none.
    std::string OpaqueCall;
    int Tile = -1;
    float Strength = 1.0F;
    /// GLSL factor for the light's image. Empty if there is no image.
    std::string Screen;
    /// GLSL call for the transmittance of translucent surfaces. Empty if it is always 1.
    std::string TranslucentCall;
  };

  /// GLSL code for a shader, and numbers of the lights that it modifies (N in `lightColorN`).
  struct Parts
  {
    std::vector<int> Numbers;
    std::string Declarations;
    std::string Implementation;
  };

  std::vector<Light> Lights;
  Parts Shadowed;
  Parts Images;
  const SceneOccluders* Occluders = nullptr;
  const LightTransmittance* Transmittance = nullptr;
  const TranslucentShadowMaps* TranslucentMaps = nullptr;
  const SceneLightImages* Screens = nullptr;
  const SceneScatteredLight* Fields = nullptr;
  vtkTextureObject* Depth = nullptr;
  glm::dmat4 WorldFromView{ 0.0 };
  std::array<float, 4> Viewport{};
  bool IsOnScreen = true;
};

}

#endif
