// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_AreaLightViews_h
#define interlume_AreaLightViews_h

#include "ShadowMaps/ShadowMapView.h"
#include "Lights/EmitterSamples.h"
#include "Lights/LightSource.h"

#include "vtkType.h"

#include <array>
#include <vector>

class vtkLight;

namespace interlume
{

class UnitSpace;

/**
 * @class   AreaLightViews
 * @brief   shadow map views of area lights: their positions and windows
 *
 * Each sample of an emitter has the views that a light without extent would have at its position
 * (ShadowMapViews). The views of all samples of a light have the same directions, so only their
 * positions and windows differ. If the view of any sample would reach more than 75 degrees off its
 * axis, all samples use the six faces of a cube. A cone with a half angle of 45 degrees or less
 * needs only one view. The half angle of that view is 30 degrees larger than the cone's, because
 * the samples lie next to the tip of the cone.
 */
class AreaLightViews
{
public:
  struct Sample
  {
    /// Offset from the position of the light, in the unit space of the scene. For a directional
    /// light, the displacement to the right and up per unit distance along the view axis.
    glm::dvec3 Offset{ 0.0 };
    /// Window of the view. In the window, (p - Center) * Scale is between -1 and 1, where p are the
    /// coordinates perpendicular to the view axis. For a positional light, p is divided by the
    /// distance along the axis.
    glm::dvec2 Scale{ 1.0 };
    glm::dvec2 Center{ 0.0 };
    glm::dvec3 Weight{ 1.0 };
  };

  /// A light, its consecutive samples, and the number of views per sample (Sides): one, or six for
  /// the faces of a cube. The views of a sample are consecutive.
  struct Light
  {
    vtkLight* Source = nullptr;
    bool IsPositional = true;
    glm::dvec3 Position{ 0.0 };
    /// The depth coefficients A and B of ShadowMapView.
    glm::dvec2 Depth{ 0.0 };
    /// Width and height vectors, on the emitter, of the filter that smooths a sample's shadow.
    std::array<glm::dvec3, 2> Stratum{ { glm::dvec3(0.0), glm::dvec3(0.0) } };
    int FirstView = 0;
    int FirstSample = 0;
    int Samples = 0;
    int FirstSide = 0;
    int Sides = 1;
  };

  /// Finds the views of all area lights that cast shadows, with \a samples samples per light. The
  /// other arguments are the same as those of ShadowMapViews::Fit.
  void Fit(const std::vector<LightSource>& lights, const UnitSpace& space,
    const std::vector<ShadowMapView::Box>& occluders, int resolution, int samples);

  /// Returns the number of columns and rows of a sample's map: \a resolution divided by the fourth
  /// root of \a samples (rounded up), but at least 4.
  static int GetResolution(int resolution, int samples);

  const std::vector<Light>& GetLights() const { return this->Lights; }
  const std::vector<Sample>& GetSamples() const { return this->Samples; }
  const std::vector<ShadowMapView::Axes>& GetSides() const { return this->Sides; }
  const std::vector<ShadowMapView>& GetViews() const { return this->Views; }
  /// Returns the index of a light, or -1 if it has no views here.
  int Find(vtkLight* light) const;

private:
  void FitDirectional(const LightSource& source, const UnitSpace& space,
    const std::vector<glm::dvec3>& corners, int resolution, Light& light);
  void FitPositional(const LightSource& source, const UnitSpace& space,
    const std::vector<glm::dvec3>& corners, int resolution, Light& light);
  void AddWindow(Light& light, const ShadowMapView::Window& window, const glm::dvec3& offset,
    const glm::dvec3& weight, double unit);
  /// Cached samples of an emitter. They are expensive to compute for an emitter with an image.
  struct Emitter
  {
    vtkLight* Source = nullptr;
    vtkMTimeType Time = 0;
    std::vector<EmitterSamples::Sample> Samples;
  };

  /// Appends a light's samples to Emitters. If the light is unchanged, reuses its samples from
  /// \a before, the emitters of the previous frame.
  void FindSamples(const LightSource& source, int samples, std::vector<Emitter>& before);

  std::vector<Emitter> Emitters;
  std::vector<Light> Lights;
  std::vector<Sample> Samples;
  std::vector<ShadowMapView::Axes> Sides;
  std::vector<ShadowMapView> Views;
};

}

#endif
