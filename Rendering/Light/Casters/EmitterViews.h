// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_EmitterViews_h
#define interlume_EmitterViews_h

#include "Casters/CasterView.h"
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
 * @class   EmitterViews
 * @brief   from where and through which windows area lights see the surfaces that cast shadows
 *
 * Each sample of an emitter sees them as a light without extent at its place would (CasterViews),
 * but that all samples of a light look along the axis of the emitter's centre, so that they differ
 * by their place and their window alone. Where one of them would look more than 75 degrees aside,
 * all look through the sides of cubes. A cone of 45 degrees or less makes one side of that, 30
 * degrees wider than the cone, since the samples stand beside its tip.
 */
class EmitterViews
{
public:
  struct Sample
  {
    /// From the light's place, in coordinates of size 1 around the scene. Of lights without a
    /// place, how far their light goes right and up for each distance of 1 along the axis.
    glm::dvec3 Offset{ 0.0 };
    /// Places, or tangents, less the middle, times the scale are -1 to 1.
    glm::dvec2 Scale{ 1.0 };
    glm::dvec2 Middle{ 0.0 };
    glm::dvec3 Weight{ 1.0 };
  };

  /// A light, its samples, which follow each other, and the sides that each of them has, one or
  /// six. The views of a sample follow each other.
  struct Light
  {
    vtkLight* Source = nullptr;
    bool IsPositional = true;
    glm::dvec3 Place{ 0.0 };
    /// A and B of CasterView.
    glm::dvec2 Depth{ 0.0 };
    /// The width and height of the part of the emitter that a sample's shadow is smoothed over.
    std::array<glm::dvec3, 2> Stratum{ { glm::dvec3(0.0), glm::dvec3(0.0) } };
    int FirstView = 0;
    int FirstSample = 0;
    int Samples = 0;
    int FirstSide = 0;
    int Sides = 1;
  };

  /// Finds the views of all area lights of an extent that surfaces cast shadows of, with so many
  /// samples each; else as CasterViews.
  void Fit(const std::vector<LightSource>& lights, const UnitSpace& space,
    const std::vector<CasterView::Box>& casters, int resolution, int samples);

  /// Returns the columns and rows of the map of a sample, of what a light without extent has: half
  /// of them up to 16 samples, a third up to 81, a quarter beyond.
  static int GetResolution(int resolution, int samples);

  const std::vector<Light>& GetLights() const { return this->Lights; }
  const std::vector<Sample>& GetSamples() const { return this->Samples; }
  const std::vector<CasterView::Axes>& GetSides() const { return this->Sides; }
  const std::vector<CasterView>& GetViews() const { return this->Views; }
  /// Returns the number of a light, or -1 where it has no views here.
  int Find(vtkLight* light) const;

private:
  void FitDirectional(const LightSource& source, const UnitSpace& space,
    const std::vector<glm::dvec3>& corners, int resolution, Light& light);
  void FitPositional(const LightSource& source, const UnitSpace& space,
    const std::vector<glm::dvec3>& corners, int resolution, Light& light);
  void AddWindow(Light& light, const CasterView::Window& window, const glm::dvec3& offset,
    const glm::dvec3& weight, double unit);
  /// The samples of an emitter, which take long where it has an image.
  struct Emitter
  {
    vtkLight* Source = nullptr;
    vtkMTimeType Time = 0;
    std::vector<EmitterSamples::Sample> Samples;
  };

  /// Appends the samples of a light to Emitters, those of the frame before where they are the same.
  void FindSamples(const LightSource& source, int samples, std::vector<Emitter>& before);

  std::vector<Emitter> Emitters;
  std::vector<Light> Lights;
  std::vector<Sample> Samples;
  std::vector<CasterView::Axes> Sides;
  std::vector<CasterView> Views;
};

}

#endif
