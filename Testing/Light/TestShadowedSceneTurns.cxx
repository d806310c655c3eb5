// SPDX-License-Identifier: BSD-3-Clause
// A scene of smoke and surfaces that eye and light go around in small steps: no picture stands out.
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

// The mean of each picture of a turn, less the middle of its neighbours, as a share of the mean.
void TestTurn(Check& check, bool isOfLight)
{
  SceneStage stage(64);
  stage.Add(MakeRectangle({ { -2.0, -2.0, -0.5 } }, { { 4.0, 0.0, 0.0 } }, { { 0.0, 4.0, 0.0 } }));
  stage.Add(MakeBox({ { 0.3, 0.5, -0.5, 0.1, -0.5, 0.4 } }));
  stage.Add(MakeBall({ { -0.2, 0.1, 0.0 } }, 0.2, 32));
  stage.AddSmoke({ { -0.5, 0.5, -0.4, 0.4, -0.3, 0.3 } }, 2.0, 24);
  std::vector<double> means;
  for (int i = 0; i < STEPS; ++i)
  {
    const double angle = vtkMath::RadiansFromDegrees(360.0 * i / STEPS);
    const double eye = isOfLight ? 0.3 : angle;
    const double light = isOfLight ? angle : 0.7;
    stage.LookAlong({ { std::cos(eye), std::sin(eye), -1.0 } });
    stage.Stage.SetLights({ MakeSun({ { std::cos(light), std::sin(light), -0.8 } }) });
    const RgbaPicture picture = stage.Draw();
    double mean = 0.0;
    for (std::size_t k = 0; k < picture.Values.size(); k += 4)
    {
      mean += picture.Values[k] / static_cast<double>(picture.Values.size() / 4);
    }
    means.push_back(mean);
  }
  double largest = 0.0;
  for (std::size_t i = 0; i < means.size(); ++i)
  {
    const double before = means[(i + means.size() - 1) % means.size()];
    const double after = means[(i + 1) % means.size()];
    largest = std::max(largest, std::abs(0.5 * (before + after) - means[i]) / means[i]);
  }
  const std::string name = isOfLight ? "light" : "eye";
  std::cout << name << ": largest second difference " << largest << " of the mean" << std::endl;
  check.Near(largest, 0.0, 0.01, "a turn of the " + name, 1.0);
}

}

int TestShadowedSceneTurns(int, char*[])
{
  Check check;
  TestTurn(check, false);
  TestTurn(check, true);
  return check.Result();
}
