// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SceneScreens_h
#define interlume_SceneScreens_h

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
 * @class   SceneScreens
 * @brief   the colours of lights with images, for the fragment shaders of VTK's mappers
 *
 * VTK sees a vtkProjectiveLight without its screen and a vtkAreaLight without its emitter's image.
 * The colour of such a light is multiplied by what vtkShadowedSliceMapper multiplies it by: that of
 * the screen where the light's ray passes it, or the mean colour of the emitter.
 */
class SceneScreens
{
public:
  SceneScreens();
  ~SceneScreens();

  /// Finds the lights that have images or screens, among those of a frame, which are in \a space.
  void Gather(const std::vector<LightSource>& lights, const UnitSpace& space);
  bool IsEmpty() const { return this->Images.empty(); }
  int GetNumber() const { return static_cast<int>(this->Images.size()); }

  /// Makes the textures that are new or have changed.
  void Upload(vtkOpenGLRenderWindow* window);
  /// The textures that shaders read.
  const std::vector<vtkTextureObject*>& GetTextures() const { return this->Textures; }

  /// Returns what a shader has to declare.
  std::string GetDeclarations() const;
  /// Returns the factor of a light's colour in a shader that has the place `vertexVC` in view
  /// coordinates, as " * ..."; empty where there is none.
  std::string GetFactor(vtkLight* light) const;

  /// Sets the uniforms. \a placeholder is active instead of the textures, which are where it is
  /// null.
  void SetUniforms(vtkShaderProgram* program, const glm::dmat4& worldFromView,
    vtkTextureObject* placeholder) const;

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  /// What one light's colour is multiplied by: a screen or, without, a colour.
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
