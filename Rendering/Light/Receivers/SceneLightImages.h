// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SceneLightImages_h
#define interlume_SceneLightImages_h

#include "Lights/LightSource.h"
#include "Lights/ScreenTextures.h"

#include <string>
#include <vector>

class vtkLight;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace interlume
{

class UnitSpace;

/**
 * @class   SceneLightImages
 * @brief   colors of lights with images, for the fragment shaders of VTK's mappers
 *
 * VTK ignores the screen of a vtkProjectiveLight and the emitter image of a vtkAreaLight. This
 * class multiplies the color of such a light by the same factor as vtkShadowedSliceMapper: the
 * color of the screen where the light's ray intersects it, or the mean color of the emitter.
 */
class SceneLightImages
{
public:
  SceneLightImages();
  ~SceneLightImages();

  /// Finds the lights with images or screens. \a lights are given in \a space. The color of
  /// \a skipped lights, which are invalid, is multiplied by 0.
  void Gather(const std::vector<LightSource>& lights, const std::vector<vtkLight*>& skipped,
    const UnitSpace& space);
  bool IsEmpty() const { return this->Images.empty(); }
  int GetNumber() const { return static_cast<int>(this->Images.size()); }

  /// Creates or updates the textures.
  void Upload(vtkOpenGLRenderWindow* window);
  /// Returns the textures that the shaders read.
  const std::vector<vtkTextureObject*>& GetTextures() const { return this->Textures; }

  /// Returns the declarations that the shaders require.
  std::string GetDeclarations() const;
  /// Returns the GLSL factor of a light's color, in the form " * ...", for a shader with the
  /// position `vertexVC` in view coordinates. Returns an empty string if there is no factor.
  std::string GetFactor(vtkLight* light) const;

  /// Sets the uniforms. If \a placeholder is not null, it is used instead of all textures.
  /// Otherwise the textures must be active.
  void SetUniforms(vtkShaderProgram* program, const glm::dmat4& worldFromView,
    vtkTextureObject* placeholder) const;

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  /// Factor of a light's color: a screen or, if there is no screen, a constant color.
  struct Image
  {
    LightSource Source;
    glm::dmat4 ScreenFromWorld{ 1.0 };
    glm::dvec3 Color{ 1.0, 1.0, 1.0 };
    vtkTextureObject* Texture = nullptr;
  };

  std::vector<Image> Images;
  std::vector<vtkTextureObject*> Textures;
  ScreenTextures Screens;
};

}

#endif
