// SPDX-License-Identifier: BSD-3-Clause
// The penumbra of a half plane: the exact profile compared with the published width, and samples of
// parallel and tilted lights compared with the exact profile.
#include "Support/Checks/LargestError.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Light/ReferencePenumbra.h"

#include "vtkAreaLight.h"
#include "vtkNew.h"

namespace
{

using namespace reference;

// A light of size L at the distance Z from a parallel half plane casts a penumbra of width L dZ / Z
// at the distance dZ behind the half plane.
void CheckParallel(Check& check)
{
  constexpr double edge = 0.6;
  constexpr double distance = 1.5;
  for (const double ratio : { 0.05, 0.5, 1.0, 5.0 })
  {
    check.SetContext("dZ / Z of " + std::to_string(ratio));
    const double width = edge * ratio;
    for (const bool isRound : { false, true })
    {
      const ReferencePenumbra scene{ isRound, { 0.2, 0.0, 2.5 }, true,
        { glm::dvec3(edge, 0.0, 0.0), glm::dvec3(0.0, edge, 0.0) }, 1.0 };
      for (int i = -30; i <= 30; ++i)
      {
        const double x = width * i / 40.0;
        const double shadow = -0.2 * ratio;
        const double expected = isRound ? ReferencePenumbra::GetDiskLightFraction(x, width)
                                        : ReferencePenumbra::GetRamp(x, width);
        check.Near(scene.GetLightFraction({ shadow + x, 3.0, 1.0 - ratio * distance }), expected,
          1e-12, "visible fraction", 1.0);
      }
    }
  }
  check.SetContext("a segment of a disk");
  check.Near(ReferencePenumbra::GetDiskLightFraction(0.25, 1.0),
    2.0 / 3.0 + std::sqrt(3.0) / 4.0 / std::acos(-1.0), 1e-12, "half a radius from the center");
}

// Returns the total weight of the samples of a vtkAreaLight that are visible from a point.
double CountSamples(const std::vector<vtkAreaLight::Sample>& samples,
  const ReferencePenumbra& scene, const glm::dvec3& focalPoint, const glm::dvec3& point)
{
  double fraction = 0.0;
  for (const vtkAreaLight::Sample& sample : samples)
  {
    const glm::dvec3 position = glm::make_vec3(sample.Position);
    const glm::dvec3 toLight = position - (scene.IsPositional ? point : focalPoint);
    const double x = point.x + toLight.x * (scene.Height - point.z) / toLight.z;
    fraction += x > 0.0 ? sample.Weight[0] : 0.0;
  }
  return fraction;
}

void CheckSamples(Check& check)
{
  constexpr int count = 1024;
  for (const bool isRound : { false, true })
  {
    for (const bool isPositional : { false, true })
    {
      for (const double tilt : { 0.0, 0.4, 1.0 })
      {
        check.SetContext((isRound ? "disk, tilt " : "square, tilt ") + std::to_string(tilt) +
          (isPositional ? "" : ", directional"));
        const glm::dvec3 center(3.0 * tilt, 0.5 * tilt, 3.0);
        vtkNew<vtkAreaLight> light;
        light->SetLightTypeToSceneLight();
        light->SetPositional(isPositional);
        light->SetPosition(center.x, center.y, center.z);
        light->SetFocalPoint(0.0, 0.0, 0.0);
        light->SetShape(isRound ? vtkAreaLight::ROUND : vtkAreaLight::SQUARE);
        light->SetSize(1.2, 0.8);
        light->SetViewUp(0.3, 1.0, 0.1);
        const std::vector<vtkAreaLight::Sample> samples = light->GetSamples(count);

        // Computes the emitter's axes independently, from the light's direction and up vector.
        const glm::dvec3 forward = glm::normalize(-center);
        const glm::dvec3 up(0.3, 1.0, 0.1);
        const glm::dvec3 above = glm::normalize(up - glm::dot(up, forward) * forward);
        const ReferencePenumbra scene{ isRound, center, isPositional,
          { 1.2 * glm::cross(forward, above), 0.8 * above }, 1.0 };
        double largest = 0.0;
        double mean = 0.0;
        for (int i = 0; i <= 80; ++i)
        {
          const glm::dvec3 point(-1.5 * tilt + 0.03 * (i - 40), 0.2, -0.5);
          const double difference =
            CountSamples(samples, scene, glm::dvec3(0.0), point) - scene.GetLightFraction(point);
          reference::KeepLargest(largest, std::abs(difference));
          mean += std::abs(difference) / 81.0;
        }
        check.Near(largest, 0.0, 0.012, "largest difference", 1.0);
        check.Near(mean, 0.0, 0.0025, "mean difference", 1.0);
      }
    }
  }
}
}

int TestPenumbra(int, char*[])
{
  Check check;
  CheckParallel(check);
  CheckSamples(check);
  return check.Result();
}
