// SPDX-License-Identifier: BSD-3-Clause
// Vortex tubes over several time steps, colored by time.

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
void Draw(gallery::Stage& stage, const std::vector<double>& times, double lower, double extinction,
  const vtkVector3d& from, const vtkVector3d& up)
{
  vtkNew<vtkAnalyticFieldSource> vortices;
  vortices->SetDimensions(96, 96, 96);
  vortices->SetTimeRange(times.front(), times.back());
  vortices->SetNumberOfTimeSteps(static_cast<int>(times.size()));
  gallery::AddTimePanel(stage, vortices, lower, 2.0, extinction).LookFrom(from, up);
}

void BuildLate(gallery::Stage& stage)
{
  Draw(stage, { 0.3, 0.8, 1.3, 1.8 }, 0.5, 16.0, { 0.3, -1.0, 0.25 }, { 0.0, 0.0, 1.0 });
}

void BuildAll(gallery::Stage& stage)
{
  const std::vector<double> times = { 0.0, 0.5, 1.0, 1.5, 2.0 };
  Draw(stage, times, 0.5, 12.0, { 0.51, -0.23, -0.83 }, { -0.12, -0.97, 0.19 });
  vtkNew<vtkTemporalColorTransferFunction> colors;
  colors->SetTimes(static_cast<int>(times.size()), times.data());
  gallery::BalanceColors(colors);
  const std::array<const char*, 5> labels = { { "at 0", "at 0.5", "at 1", "at 1.5", "at 2" } };
  std::vector<gallery::ColorEntry> key;
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    vtkColor3d color;
    colors->GetColor(times[i], color.GetData());
    key.emplace_back(color, labels[i]);
  }
  key.emplace_back(vtkColor3d(1.0, 1.0, 1.0), "all the time");
  stage.SetColorKey("time", key);
}

const gallery::SceneRegistration late(
  { "time-vortex", "3.23", "Vortices over four time steps, colored by time",
    "Vortex tubes of an analytic field on 96 x 96 x 96 points, over all times from the first to "
    "the last of four steps. Colors of all times are added: tubes that stay are white, with a blue "
    "edge that they leave and an orange one toward which they drift. Blue tubes fade. Two thin "
    "red tubes appear only toward the end.",
    {}, &BuildLate });

const gallery::SceneRegistration all({ "time-vortex-three", "3.25",
  "Vortices from birth to decay, colored by time",
  "The vortex tubes over five time steps. Colors of all times are added, and stationary parts add "
  "up to white. Blue tubes fade, orange tubes appear, and stripes from blue to red are tubes that "
  "move sideways.",
  {}, &BuildAll });
}
