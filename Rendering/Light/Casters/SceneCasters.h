// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SceneCasters_h
#define interlume_SceneCasters_h

#include "Casters/CasterMaps.h"
#include "Casters/CasterViews.h"
#include "Casters/EmitterViews.h"
#include "Common/Error.h"
#include "Space/UnitSpace.h"

#include "vtkTimeStamp.h"

#include <string>
#include <utility>
#include <vector>

class vtkLight;
class vtkProp;
class vtkRenderer;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace interlume
{

struct SceneReport;

/**
 * @class   SceneCasters
 * @brief   what the opaque surfaces of a scene leave of its lights, with an extent or without
 *
 * Lights without extent have their maps in one texture, samples of area lights in another one.
 * Where there are no area lights nothing of them is in the shaders.
 */
class SceneCasters
{
public:
  /// Finds the views of lights that surfaces cast shadows of. \a samples are those of an area
  /// light.
  void Fit(const std::vector<LightSource>& lights, const UnitSpace& space,
    const std::vector<CasterView::Box>& casters, int resolution, int samples);
  void Clear();
  bool HasViews() const;
  /// The number of samples of each area light that has maps of them; 0 where none has.
  int GetLightSamples() const { return this->Emitters.GetSamples().empty() ? 0 : this->Samples; }
  /// When maps were drawn last: another time where they have changed.
  vtkMTimeType GetDrawTime() const { return this->DrawTime.GetMTime(); }

  /// Draws the maps. \a bias is the setting DepthBias of vtkShadowedScenePass. Returns an
  /// error if there is no memory for them.
  Error Draw(vtkRenderer* renderer, const std::vector<vtkProp*>& props, int resolution, double bias,
    SceneReport& report);

  /// The features and the source of a shader that calls what GetShare returns.
  std::string GetFeatures() const;
  std::string GetSource() const;
  /// Returns the call, without spaces, for the share of a light, a float or a vec3, that comes to
  /// a place on a plane; empty where surfaces cast no shadows of it.
  std::string GetShare(vtkLight* light, const std::string& place, const std::string& plane) const;
  /// Returns the same for a sample of an area light, an expression from 0 on, of so many; empty
  /// where it has another number of samples here.
  std::string GetSampleShare(vtkLight* light, int samples, const std::string& sample,
    const std::string& place, const std::string& plane) const;
  /// Sets the uniforms of a program with that source, of which places are in coordinates that \a
  /// worldFromPlace leads from. The textures have to be active.
  void SetUniforms(vtkShaderProgram* program, const glm::dmat4& worldFromPlace) const;
  /// Takes all samples from a program that draws depths alone, which would compare them for
  /// nothing.
  void ClearUniforms(vtkShaderProgram* program) const;
  /// Has maps of samples compared as if they were so many of their texels nearer to the light, for
  /// surfaces whose plane is not known.
  void AddBias(vtkShaderProgram* program, double texels) const;
  /// The names of the textures in the source, and the textures, of which some are empty.
  std::vector<std::pair<const char*, vtkTextureObject*>> GetTextures() const;

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  void SetEmitterUniforms(vtkShaderProgram* program, const glm::dmat4& worldFromPlace) const;

  CasterViews Views;
  CasterMaps Maps;
  EmitterViews Emitters;
  CasterMaps EmitterMaps;
  UnitSpace Space;
  int Samples = 0;
  vtkTimeStamp DrawTime;
};

}

#endif
