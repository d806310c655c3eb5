// SPDX-License-Identifier: BSD-3-Clause
// Vortex tubes over two and over three time steps, colored by time.

#include "Gallery/Scene.h"
#include "Gallery/Stage.h"
#include "Gallery/TimePanel.h"

#include "vtkAnalyticFieldSource.h"
#include "vtkNew.h"
#include "vtkTemporalColorTransferFunction.h"

#include <array>
#include <vector>

namespace
{
/// Adds a panel with the vortex tubes over the time steps \a times, which are evenly spaced.
void Draw(gallery::Stage& stage, const std::vector<double>& times, double extinction,
  const vtkVector3d& from)
{
  vtkNew<vtkAnalyticFieldSource> vortices;
  vortices->SetDimensions(96, 96, 96);
  vortices->SetTimeRange(times.front(), times.back());
  vortices->SetNumberOfTimeSteps(static_cast<int>(times.size()));
  gallery::AddPanelInTime(stage, vortices, 0.5, 2.0, extinction).LookFrom(from, { 0.0, 0.0, 1.0 });
}

void BuildTwo(gallery::Stage& stage)
{
  Draw(stage, { 1.2, 2.0 }, 22.0, { 0.3, -1.0, 0.25 });
}

void BuildThree(gallery::Stage& stage)
{
  const std::vector<double> times = { 0.0, 1.0, 2.0 };
  Draw(stage, times, 14.0, { 0.3, 1.0, 0.4 });
  vtkNew<vtkTemporalColorTransferFunction> colors;
  colors->SetTimes(static_cast<int>(times.size()), times.data());
  const std::array<const char*, 5> labels = { { "at 0", "at 0.5", "at 1", "at 1.5", "at 2" } };
  std::vector<gallery::ColorEntry> key;
  double time = 0.0;
  for (const char* label : labels)
  {
    vtkColor3d color;
    colors->GetColor(time, color.GetData());
    key.emplace_back(color, label);
    time += 0.5;
  }
  key.emplace_back(vtkColor3d(1.0, 1.0, 1.0), "all the time");
  stage.SetColorKey("time", key);
}

const gallery::SceneRegistration two(
  { "time-vortex", "3.23", "Vortices between two time steps, colored by time",
    "Vortex tubes of an analytic field on 96 x 96 x 96 points, over all times between two steps. "
    "Green marks tubes at the first step, red at the last, and yellow tubes that exist half of the "
    "time or all the time. Two tubes appear, orange and red without green; one fades, faint and "
    "green. Colors of different times are added.",
    {}, &BuildTwo });

const gallery::SceneRegistration three(
  { "time-vortex-three", "3.25", "Vortices over three time steps, colored by time",
    "The vortex tubes over three time steps. Blue, green and red are the steps, cyan and yellow "
    "the times between them, and stationary parts add up to white. Tubes that are only blue fade, "
    "tubes that are only red appear, and stripes from blue to red are tubes that move sideways.",
    {}, &BuildThree });
}
