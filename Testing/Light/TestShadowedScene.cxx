// SPDX-License-Identifier: BSD-3-Clause
// Shadows between opaque actors in vtkShadowedScenePass: positions of shadow edges, no specks, and
// VTK's own image where no shadow falls.
#include "Common/Vectors.h"
#include "Support/Checks/LargestError.h"
#include "Support/Checks/ReferenceCheck.h"
#include "SceneStage.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkLight.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

#include <glm/vec2.hpp>

namespace
{
using namespace reference;

void TestEdges(Check& check)
{
  // A box of height 0.2 on a plane, lit from the left at 45 degrees.
  for (const int resolution : { 64, 256, 1024 })
  {
    SceneStage stage;
    stage.Pass->SetDepthMapResolution(resolution);
    stage.Add(MakeRectangle({ { -1.0, -1.0, 0.0 } }, { { 2.0, 0.0, 0.0 } }, { { 0.0, 2.0, 0.0 } }));
    stage.Add(MakeBox({ { -0.3, 0.1, -0.2, 0.2, 0.0, 0.2 } }));
    stage.Stage.SetLights({ MakeSun({ { 1.0, 0.0, -1.0 } }) });
    const RgbaImage image = stage.Draw();
    const std::string name = "box, " + std::to_string(resolution);
    const double lit = std::sqrt(0.5);
    // Along y, which is perpendicular to the light, the shadow map covers 2 units.
    const double texel = 2.0 / resolution;
    const double pixel = 2.0 / 256.0;
    check.Near(stage.At(image, -0.6, 0.0), lit, 1e-4, name + ": lit");
    check.Near(stage.At(image, 0.2, 0.0), 0.0, 0.0, name + ": in shadow", 1.0);
    check.Near(stage.At(image, -0.1, 0.0), lit, 1e-4, name + ": top of the box");
    // The tolerance is half a texel, projected onto the plane, plus half a pixel.
    check.Near(stage.FindEdge(image, 0.15, 0.9, 0.0, 0.5 * lit), 0.3,
      0.5 * texel * std::sqrt(2.0) + 0.5 * pixel, name + ": edge along the light", 1.0);
    check.Near(stage.FindEdge(image, 0.05, 0.15, 0.0, 0.5 * lit), 0.1, 0.01,
      name + ": edge of the box", 1.0);
    check.Equal(stage.GetReport()->GetCount("DepthMaps"), 1, name + ": maps");
    check.Equal(stage.GetReport()->GetCount("DepthMapsDrawn"), 1, name + ": maps drawn");
    check.Equal(stage.GetReport()->GetCount("DepthMapBytes"), 4LL * resolution * resolution,
      name + ": bytes");
    stage.Draw();
    check.Equal(stage.GetReport()->GetCount("DepthMapsDrawn"), 0, name + ": drawn again");
  }
}

void TestPointLight(Check& check)
{
  // The shadow of a plate between a point light and a plane is twice as large as the plate.
  for (const double offset : { 0.0, 0.4 })
  {
    SceneStage stage;
    stage.Add(MakeRectangle({ { -1.0, -1.0, 0.0 } }, { { 2.0, 0.0, 0.0 } }, { { 0.0, 2.0, 0.0 } }));
    stage.Add(MakeRectangle({ { -0.2, -0.2, 0.5 } }, { { 0.4, 0.0, 0.0 } }, { { 0.0, 0.4, 0.0 } }));
    stage.Stage.SetLights({ MakePointLight({ { offset, 0.0, 1.0 } }, { { offset, 0.0, 0.0 } }) });
    const RgbaImage image = stage.Draw();
    const std::string name = "point light at " + std::to_string(offset);
    check.Equal(stage.GetReport()->GetCount("DepthMaps"), 1, name + ": maps");
    const double cosine = 1.0 / std::hypot(1.0, 0.4 + 2.0 * offset);
    check.Near(stage.FindEdge(image, -0.9, -0.25 - offset, 0.0, 0.5 * cosine), -0.4 - offset, 0.006,
      name + ": edge", 1.0);
  }
}

void TestSpecks(Check& check)
{
  // A single sphere or thin plate casts no visible shadow on itself, so it looks the same with and
  // without shadows.
  for (const double height : { 1.0, 0.3, 0.1 })
  {
    for (int shape = 0; shape < 3; ++shape)
    {
      SceneStage stage;
      stage.Add(shape == 0 ? MakeSphereActor({ { 0.0, 0.0, 0.0 } }, 0.8, 96)
          : shape == 1     ? MakeBox({ { -0.8, 0.8, -0.8, 0.8, -0.001, 0.001 } })
                           : MakeSphereActor({ { 0.0, 0.0, 0.0 } }, 0.8, 12));
      stage.Stage.SetLights({ MakeSun({ { 1.0, 0.3, -height } }) });
      const RgbaImage with = stage.Draw();
      const RgbaImage without = stage.Draw(false);
      double largest = 0.0;
      double mean = 0.0;
      for (std::size_t i = 0; i < with.Values.size(); i += 4)
      {
        const double difference = std::abs(with.Values[i] - without.Values[i]);
        reference::KeepLargest(largest, difference);
        mean += difference / (with.Values.size() / 4);
      }
      const std::string name =
        "shape " + std::to_string(shape) + ", light at " + std::to_string(height);
      std::cout << name << ": largest " << largest << ", mean " << mean << std::endl;
      check.Near(largest, 0.0, shape == 2 ? 1.0 : 0.05, name + ": largest", 1.0);
      check.Near(mean, 0.0, shape == 2 ? 0.02 : 0.001, name + ": mean", 1.0);
    }
  }
}

// Tests a sphere or thin plate under an area light. Points that face the entire light look the same
// with and without shadows, and points that face away from the entire light are black.
void TestSoftSpecks(Check& check)
{
  for (const double height : { 1.0, 0.3 })
  {
    for (int shape = 0; shape < 2; ++shape)
    {
      SceneStage stage;
      stage.Add(shape == 0 ? MakeSphereActor({ { 0.0, 0.0, 0.0 } }, 0.8, 96)
                           : MakeBox({ { -0.8, 0.8, -0.8, 0.8, -0.001, 0.001 } }));
      const glm::dvec3 direction = glm::normalize(glm::dvec3(1.0, 0.3, -height));
      vtkNew<vtkAreaLight> sun;
      sun->SetPosition(0.0, 0.0, 0.0);
      sun->SetFocalPoint(glm::value_ptr(direction));
      sun->SetSize(0.1, 0.1);
      sun->SetShadowAttenuation(1.0F);
      stage.Stage.SetLights({ sun.Get() });
      const RgbaImage with = stage.Draw();
      check.Equal(stage.GetReport()->GetCount("SampleMaps"), 16, "shadow maps of an area light");
      const RgbaImage without = stage.Draw(false);
      double lit = 0.0;
      double dark = 0.0;
      for (int j = 0; j < with.Height; ++j)
      {
        for (int i = 0; i < with.Width; ++i)
        {
          const glm::dvec2 at(
            2.0 * (i + 0.5) / with.Width - 1.0, 2.0 * (j + 0.5) / with.Height - 1.0);
          const double rest = 0.64 - glm::dot(at, at);
          // Skips the silhouette, where a polygonal sphere differs from an exact sphere.
          if (shape == 0 && rest < 0.02)
          {
            continue;
          }
          const glm::dvec3 normal = shape == 0
            ? glm::dvec3(at, std::sqrt(std::max(rest, 0.0))) / 0.8
            : glm::dvec3(0.0, 0.0, 1.0);
          const double cosine = -glm::dot(normal, direction);
          const double found = with.At(i, j)[0];
          lit = cosine > 0.12 ? std::max(lit, std::abs(found - without.At(i, j)[0])) : lit;
          dark = cosine < -0.12 ? std::max(dark, found) : dark;
        }
      }
      const std::string name =
        "soft, shape " + std::to_string(shape) + ", light at " + std::to_string(height);
      std::cout << name << ": " << lit << " where fully lit, " << dark << " where dark"
                << std::endl;
      check.Near(lit, 0.0, 0.02, name + ": specks in lit areas", 1.0);
      check.Near(dark, 0.0, 0.0, name + ": light in dark areas", 1.0);
    }
  }
}

}

int TestShadowedScene(int, char*[])
{
  Check check;
  TestEdges(check);
  TestPointLight(check);
  TestSpecks(check);
  TestSoftSpecks(check);
  return check.Result();
}
