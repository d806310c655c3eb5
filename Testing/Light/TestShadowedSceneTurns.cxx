// SPDX-License-Identifier: BSD-3-Clause
// Camera and light rotate in small steps around a scene of smoke and surfaces. The mean brightness
// must change smoothly.
#include "Support/Checks/LargestError.h"
#include "Support/Checks/ReferenceCheck.h"
#include "SceneStage.h"

#include "vtkActor.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkShadowedSliceMapper.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

namespace
{
using namespace reference;

constexpr int STEPS = 90;

// Checks that the mean brightness changes smoothly during a rotation: its second differences are
// small relative to the mean.
void TestRotation(Check& check, bool isLightRotated)
{
  SceneStage stage(64);
  stage.Add(MakeRectangle({ { -2.0, -2.0, -0.5 } }, { { 4.0, 0.0, 0.0 } }, { { 0.0, 4.0, 0.0 } }));
  stage.Add(MakeBox({ { 0.3, 0.5, -0.5, 0.1, -0.5, 0.4 } }));
  stage.Add(MakeSphereActor({ { -0.2, 0.1, 0.0 } }, 0.2, 32));
  stage.AddSmoke({ { -0.5, 0.5, -0.4, 0.4, -0.3, 0.3 } }, 2.0, 24);
  std::vector<double> means;
  for (int i = 0; i < STEPS; ++i)
  {
    const double angle = vtkMath::RadiansFromDegrees(360.0 * i / STEPS);
    const double viewAngle = isLightRotated ? 0.3 : angle;
    const double light = isLightRotated ? angle : 0.7;
    stage.LookAlong({ { std::cos(viewAngle), std::sin(viewAngle), -1.0 } });
    stage.Stage.SetLights({ MakeSun({ { std::cos(light), std::sin(light), -0.8 } }) });
    const RgbaImage image = stage.Draw();
    double mean = 0.0;
    for (std::size_t k = 0; k < image.Values.size(); k += 4)
    {
      mean += image.Values[k] / static_cast<double>(image.Values.size() / 4);
    }
    means.push_back(mean);
  }
  double largest = 0.0;
  for (std::size_t i = 0; i < means.size(); ++i)
  {
    const double before = means[(i + means.size() - 1) % means.size()];
    const double after = means[(i + 1) % means.size()];
    reference::KeepLargest(largest, std::abs(0.5 * (before + after) - means[i]) / means[i]);
  }
  const std::string name = isLightRotated ? "light" : "camera";
  std::cout << name << ": largest second difference " << largest << " of the mean" << std::endl;
  check.Near(largest, 0.0, 0.01, "a rotation of the " + name, 1.0);
}

}

int TestShadowedSceneTurns(int, char*[])
{
  Check check;
  TestRotation(check, false);
  TestRotation(check, true);
  return check.Result();
}
