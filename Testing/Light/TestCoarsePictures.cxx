// SPDX-License-Identifier: BSD-3-Clause
// Volumes whose picture is coarser than the viewport beside actors: no rims around these, against
// the picture with a ray for each pixel.
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
  /// The share of pixels that are off by more than 0.1.
  double Off = 0.0;
};

Difference Compare(const RgbaPicture& found, const RgbaPicture& expected)
{
  Difference difference;
  for (std::size_t i = 0; i < found.Values.size(); i += 4)
  {
    const double apart = std::abs(found.Values[i] - expected.Values[i]);
    difference.Largest = std::max(difference.Largest, apart);
    difference.Off += apart > 0.1 ? 1.0 / (PIXELS * PIXELS) : 0.0;
  }
  return difference;
}

// Smoke over all of the picture, behind, around and before dark actors. The camera looks straight
// down, or aslant with perspective.
struct Scene
{
  Scene()
    : Stage(PIXELS)
  {
    const vtkSmartPointer<vtkActor> ball = MakeBall({ { 0.1, 0.05, 0.9 } }, 0.45, 48);
    const vtkSmartPointer<vtkActor> plate =
      MakeRectangle({ { -0.9, -0.8, -0.4 } }, { { 0.5, 0.1, 0.5 } }, { { 0.0, 1.4, 0.3 } });
    for (const vtkSmartPointer<vtkActor>& actor : { ball, plate })
    {
      actor->GetProperty()->SetColor(0.02, 0.02, 0.02);
      // Edges of shadows in the smoke are as wide as the picture's pixels.
      vtkShadowedScenePass::SetCastsShadows(actor, false);
      this->Stage.Add(actor);
    }
    this->Stage.AddSmoke({ { -3.0, 3.0, -3.0, 3.0, -0.6, 0.3 } }, 8.0, 12);
    this->Stage.Stage.SetLights({ MakeSun({ { 0.2, 0.1, -1.0 } }) });
  }

  RgbaPicture Draw(double distance, bool hasPass)
  {
    this->Stage.Mapper->SetImageSampleDistance(distance);
    return this->Stage.Draw(hasPass);
  }

  SceneStage Stage;
};

void CheckRims(Check& check, Scene& scene, bool hasPass, const std::string& name)
{
  const RgbaPicture fine = scene.Draw(1.0, hasPass);
  for (const double distance : { 1.5, 2.0, 3.0 })
  {
    const Difference found = Compare(scene.Draw(distance, hasPass), fine);
    std::cout << name << ", distance " << distance << ": largest " << found.Largest
              << ", above 0.1: " << found.Off << "\n";
    check.That(found.Off < 0.001 * distance,
      name + ", distance " + std::to_string(distance) + ": share of pixels off " +
        std::to_string(found.Off));
  }
}

}

int TestCoarsePictures(int, char*[])
{
  Check check;
  Scene scene;
  CheckRims(check, scene, true, "in a scene");
  CheckRims(check, scene, false, "without the pass");
  scene.Stage.LookAlong({ { 0.5, 0.3, -1.0 } });
  CheckRims(check, scene, true, "aslant");
  const vtkSmartPointer<vtkActor> pane =
    MakePane({ { -0.3, 0.4, 0.6 } }, { { 0.1, 0.0, 1.0 } }, 0.7);
  vtkShadowedScenePass::SetCastsShadows(pane, false);
  scene.Stage.Add(pane);
  CheckRims(check, scene, true, "with a pane");
  return check.Result();
}
