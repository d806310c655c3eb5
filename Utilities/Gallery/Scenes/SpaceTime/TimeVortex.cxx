// SPDX-License-Identifier: BSD-3-Clause
// Vortex tubes over two and over three time steps, coloured by time.

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
/// Draws the tubes between evenly spaced steps.
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
  vtkNew<vtkTemporalColorTransferFunction> colours;
  colours->SetTimes(static_cast<int>(times.size()), times.data());
  const std::array<const char*, 5> labels = { { "at 0", "at 0.5", "at 1", "at 1.5", "at 2" } };
  std::vector<gallery::ColourEntry> key;
  double time = 0.0;
  for (const char* label : labels)
  {
    vtkColor3d colour;
    colours->GetColor(time, colour.GetData());
    key.emplace_back(colour, label);
    time += 0.5;
  }
  key.emplace_back(vtkColor3d(1.0, 1.0, 1.0), "all the time");
  stage.SetColourKey("time", key);
}

const gallery::SceneRegistration two(
  { "time-vortex", "3.23", "Vortices between two time steps, coloured by time",
    "Vortex tubes of an analytic field on 96 x 96 x 96 points, over all times between two "
    "steps at once. Green is where a tube was at first, red where it is at last, yellow "
    "where it is half of the time or all of it. Two tubes appear meanwhile, orange and red "
    "without green; one fades, faint and green. Colours of different times are added up.",
    {}, &BuildTwo });

const gallery::SceneRegistration three(
  { "time-vortex-three", "3.25", "Vortices over three time steps, coloured by time",
    "The vortex tubes over three time steps. Blue, green and red are the steps, cyan and "
    "yellow the times between them, and what stays adds up to white. The tubes that are blue "
    "alone fade, those that are red alone appear, and stripes from blue to red are tubes "
    "that move aside, each in its direction.",
    {}, &BuildThree });
}
