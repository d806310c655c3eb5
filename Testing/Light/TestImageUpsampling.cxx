// SPDX-License-Identifier: BSD-3-Clause
// Volumes that are rendered at a lower resolution than the viewport, with actors: the edges of
// actors match an image with one ray per pixel.
#include "Support/Checks/ReferenceCheck.h"
#include "SceneStage.h"

#include "vtkActor.h"
#include "vtkProperty.h"
#include "vtkShadowedSliceMapper.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

namespace
{
using namespace reference;

constexpr int PIXELS = 128;

struct Difference
{
  double Largest = 0.0;
  /// Fraction of pixels with an error above 0.1.
  double LargeErrors = 0.0;
};

Difference Compare(const RgbaImage& found, const RgbaImage& expected)
{
  Difference difference;
  for (std::size_t i = 0; i < found.Values.size(); i += 4)
  {
    const double error = std::abs(found.Values[i] - expected.Values[i]);
    difference.Largest = std::max(difference.Largest, error);
    difference.LargeErrors += error > 0.1 ? 1.0 / (PIXELS * PIXELS) : 0.0;
  }
  return difference;
}

// A layer of smoke, a dark sphere in front of the smoke, and a dark plate that is partly inside it.
struct Scene
{
  Scene()
    : Stage(PIXELS)
  {
    const vtkSmartPointer<vtkActor> sphere = MakeSphereActor({ { 0.1, 0.05, 0.9 } }, 0.45, 48);
    const vtkSmartPointer<vtkActor> plate =
      MakeRectangle({ { -0.9, -0.8, -0.4 } }, { { 0.5, 0.1, 0.5 } }, { { 0.0, 1.4, 0.3 } });
    for (const vtkSmartPointer<vtkActor>& actor : { sphere, plate })
    {
      actor->GetProperty()->SetColor(0.02, 0.02, 0.02);
      // Actors cast no shadows, since the edges of shadows in the smoke would be as wide as the
      // coarse pixels.
      vtkShadowedScenePass::SetCastsShadows(actor, false);
      this->Stage.Add(actor);
    }
    this->Stage.AddSmoke({ { -3.0, 3.0, -3.0, 3.0, -0.6, 0.3 } }, 8.0, 12);
    this->Stage.Stage.SetLights({ MakeSun({ { 0.2, 0.1, -1.0 } }) });
  }

  RgbaImage Draw(double distance, bool hasPass)
  {
    this->Stage.Mapper->SetImageSampleDistance(distance);
    return this->Stage.Draw(hasPass);
  }

  SceneStage Stage;
};

void CheckEdges(Check& check, Scene& scene, bool hasPass, const std::string& name)
{
  const RgbaImage fine = scene.Draw(1.0, hasPass);
  for (const double distance : { 1.5, 2.0, 3.0 })
  {
    const Difference found = Compare(scene.Draw(distance, hasPass), fine);
    std::cout << name << ", distance " << distance << ": largest " << found.Largest
              << ", above 0.1: " << found.LargeErrors << "\n";
    check.That(found.LargeErrors < 0.001 * distance,
      name + ", distance " + std::to_string(distance) + ": fraction of large errors " +
        std::to_string(found.LargeErrors));
  }
}

}

int TestImageUpsampling(int, char*[])
{
  Check check;
  Scene scene;
  CheckEdges(check, scene, true, "in a scene");
  CheckEdges(check, scene, false, "without the pass");
  scene.Stage.LookAlong({ { 0.5, 0.3, -1.0 } });
  CheckEdges(check, scene, true, "oblique view");
  const vtkSmartPointer<vtkActor> square =
    MakeTranslucentSquare({ { -0.3, 0.4, 0.6 } }, { { 0.1, 0.0, 1.0 } }, 0.7);
  vtkShadowedScenePass::SetCastsShadows(square, false);
  scene.Stage.Add(square);
  CheckEdges(check, scene, true, "with a translucent square");
  return check.Result();
}
