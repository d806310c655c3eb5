// SPDX-License-Identifier: BSD-3-Clause
// Shadows that opaque actors cast on each other by vtkShadowedScenePass: edges where they have to
// be, no specks, VTK's own picture where no shadow falls.
#include "Common/Vectors.h"
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
  // A box of height 0.2 on a plane, under light from the left at 45 degrees.
  for (const int resolution : { 64, 256, 1024 })
  {
    SceneStage stage;
    stage.Pass->SetDepthMapResolution(resolution);
    stage.Add(MakeRectangle({ { -1.0, -1.0, 0.0 } }, { { 2.0, 0.0, 0.0 } }, { { 0.0, 2.0, 0.0 } }));
    stage.Add(MakeBox({ { -0.3, 0.1, -0.2, 0.2, 0.0, 0.2 } }));
    stage.Stage.SetLights({ MakeSun({ { 1.0, 0.0, -1.0 } }) });
    const RgbaPicture picture = stage.Draw();
    const std::string name = "box, " + std::to_string(resolution);
    const double lit = std::sqrt(0.5);
    // The map shows the scene across the light, 2 units along y.
    const double texel = 2.0 / resolution;
    const double pixel = 2.0 / 256.0;
    check.Near(stage.At(picture, -0.6, 0.0), lit, 1e-4, name + ": lit");
    check.Near(stage.At(picture, 0.2, 0.0), 0.0, 0.0, name + ": in shadow", 1.0);
    check.Near(stage.At(picture, -0.1, 0.0), lit, 1e-4, name + ": lid");
    // Half a texel, on the plane, and half a pixel.
    check.Near(stage.FindEdge(picture, 0.15, 0.9, 0.0, 0.5 * lit), 0.3,
      0.5 * texel * std::sqrt(2.0) + 0.5 * pixel, name + ": edge along the light", 1.0);
    check.Near(stage.FindEdge(picture, 0.05, 0.15, 0.0, 0.5 * lit), 0.1, 0.01,
      name + ": edge of the box", 1.0);
    check.Near(stage.GetReport()->GetNumber("DepthMaps"), 1, 0.0, name + ": maps");
    check.Near(stage.GetReport()->GetNumber("DepthMapsDrawn"), 0, 0.0, name + ": drawn again");
    check.Near(stage.GetReport()->GetNumber("DepthMapBytes"), 4LL * resolution * resolution, 0.0,
      name + ": bytes");
  }
}

void TestLamp(Check& check)
{
  // A plate between a lamp and a plane: its shadow is twice as large.
  for (const double aside : { 0.0, 0.4 })
  {
    SceneStage stage;
    stage.Add(MakeRectangle({ { -1.0, -1.0, 0.0 } }, { { 2.0, 0.0, 0.0 } }, { { 0.0, 2.0, 0.0 } }));
    stage.Add(MakeRectangle({ { -0.2, -0.2, 0.5 } }, { { 0.4, 0.0, 0.0 } }, { { 0.0, 0.4, 0.0 } }));
    stage.Stage.SetLights({ MakeLamp({ { aside, 0.0, 1.0 } }, { { aside, 0.0, 0.0 } }) });
    const RgbaPicture picture = stage.Draw();
    const std::string name = "lamp at " + std::to_string(aside);
    check.Near(stage.GetReport()->GetNumber("DepthMaps"), 1, 0.0, name + ": maps");
    const double cosine = 1.0 / std::hypot(1.0, 0.4 + 2.0 * aside);
    check.Near(stage.FindEdge(picture, -0.9, -0.25 - aside, 0.0, 0.5 * cosine), -0.4 - aside, 0.006,
      name + ": edge", 1.0);
  }
}

void TestSpecks(Check& check)
{
  // Where light falls on nothing but a ball, or a thin plate, it looks as without shadows.
  for (const double height : { 1.0, 0.3, 0.1 })
  {
    for (int shape = 0; shape < 3; ++shape)
    {
      SceneStage stage;
      stage.Add(shape == 0 ? MakeBall({ { 0.0, 0.0, 0.0 } }, 0.8, 96)
          : shape == 1     ? MakeBox({ { -0.8, 0.8, -0.8, 0.8, -0.001, 0.001 } })
                           : MakeBall({ { 0.0, 0.0, 0.0 } }, 0.8, 12));
      stage.Stage.SetLights({ MakeSun({ { 1.0, 0.3, -height } }) });
      const RgbaPicture with = stage.Draw();
      const RgbaPicture without = stage.Draw(false);
      double largest = 0.0;
      double mean = 0.0;
      for (std::size_t i = 0; i < with.Values.size(); i += 4)
      {
        const double difference = std::abs(with.Values[i] - without.Values[i]);
        largest = std::max(largest, difference);
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

// The same under a sun with an extent, where all of it or nothing of it shines on a ball or a thin
// plate: as without shadows, or dark.
void TestSoftSpecks(Check& check)
{
  for (const double height : { 1.0, 0.3 })
  {
    for (int shape = 0; shape < 2; ++shape)
    {
      SceneStage stage;
      stage.Add(shape == 0 ? MakeBall({ { 0.0, 0.0, 0.0 } }, 0.8, 96)
                           : MakeBox({ { -0.8, 0.8, -0.8, 0.8, -0.001, 0.001 } }));
      const glm::dvec3 direction = glm::normalize(glm::dvec3(1.0, 0.3, -height));
      vtkNew<vtkAreaLight> sun;
      sun->SetPosition(0.0, 0.0, 0.0);
      sun->SetFocalPoint(glm::value_ptr(direction));
      sun->SetSize(0.1, 0.1);
      sun->SetShadowAttenuation(1.0F);
      stage.Stage.SetLights({ sun.Get() });
      const RgbaPicture with = stage.Draw();
      check.Near(
        stage.GetReport()->GetNumber("SampleMaps"), 16, 0.0, "maps of a sun with an extent");
      const RgbaPicture without = stage.Draw(false);
      double lit = 0.0;
      double dark = 0.0;
      for (int j = 0; j < with.Height; ++j)
      {
        for (int i = 0; i < with.Width; ++i)
        {
          const glm::dvec2 at(
            2.0 * (i + 0.5) / with.Width - 1.0, 2.0 * (j + 0.5) / with.Height - 1.0);
          const double rest = 0.64 - glm::dot(at, at);
          // The rim of a ball of polygons is not that of a ball.
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
      std::cout << name << ": " << lit << " where all shines, " << dark << " where nothing does"
                << std::endl;
      check.Near(lit, 0.0, 0.02, name + ": specks in the light", 1.0);
      check.Near(dark, 0.0, 0.0, name + ": light in the dark", 1.0);
    }
  }
}

}

int TestShadowedScene(int, char*[])
{
  Check check;
  TestEdges(check);
  TestLamp(check);
  TestSpecks(check);
  TestSoftSpecks(check);
  return check.Result();
}
