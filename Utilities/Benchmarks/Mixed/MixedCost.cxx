// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Suites/BenchParts.h"

#include "Benchmarks/Mixed/MixedCases.h"
#include "Benchmarks/Mixed/MixedDrawing.h"
#include "Benchmarks/Shadows/ShadowsScene.h"

#include "vtkMapper.h"
#include "vtkPolyData.h"

namespace mixed
{
namespace
{
const char* const ScenePass = "scene-pass";
const char* const Moving = "scene-pass, light moves";
const char* const OverBudget = "over_budget";

vtkIdType CountTriangles(const reference::MixedScene& scene)
{
  vtkIdType count = 0;
  for (const reference::SceneSurface& surface : scene.Surfaces)
  {
    surface.Actor->GetMapper()->Update();
    count += vtkPolyData::SafeDownCast(surface.Actor->GetMapper()->GetInput())->GetNumberOfCells();
  }
  return count;
}

void AddRows(const Case& what, const BenchOptions& options, BenchRows& rows)
{
  reference::MixedScene volumeOnly = what.Scene;
  volumeOnly.Surfaces.clear();
  reference::MixedScene actorsOnly = what.Scene;
  actorsOnly.Volumes.clear();
  Drawing ours(what.Scene, Method::ScenePass);
  Drawing volume(volumeOnly, Method::Plain);
  Drawing actors(actorsOnly, Method::Plain);
  for (const bool isMoving : { false, true })
  {
    const std::vector<BenchSeconds> seconds = MeasureAlternately(
      { ours.GetFrame(options.Threads, isMoving), volume.GetFrame(options.Threads, isMoving),
        actors.GetFrame(options.Threads, isMoving) },
      options.GetRepeats());
    const auto count = [](vtkInterlumeReport* report, const char* name)
    { return report->GetCount(name); };
    BenchRow row = rows.Make(what.Name, isMoving ? Moving : ScenePass, CountTriangles(what.Scene));
    row.SetTimes(
      seconds[0], "volume + 2 actors", { seconds[1] + 2.0 * seconds[2], seconds[1].Runs });
    row.Set({ { OverBudget, *row.Seconds / *row.BaselineSeconds },
      { "processor_over_budget",
        seconds[0].Processor / (seconds[1].Processor + 2.0 * seconds[2].Processor) },
      { "volume_seconds", seconds[1].Value }, { "actors_seconds", seconds[2].Value },
      { "depth_maps_drawn", count(ours.GetReport(), "DepthMapsDrawn") },
      { "receiver_passes", count(ours.GetReport(), "ReceiverPasses") },
      { "slices", count(ours.GetSliceMapper()->GetReport(), "SlicesDrawn") } });
    rows.Add(row);
  }
}

/**
 * Measures the time to render a frame of a volume and actors with vtkShadowedScenePass. The
 * parameter is the number of triangles, about a million. The baseline is the time to render only
 * the volume, plus twice the time to render only the actors with VTK: once for a shadow map and
 * once for the frame. Methods:
 * - `scene-pass`: the camera moves, and shadow maps are reused;
 * - `scene-pass, light moves`: shadow maps are rendered for each frame.
 *
 * The count over_budget is the time divided by the baseline's time; processor_over_budget is the
 * ratio of the processor times.
 */
void AddCostRows(const BenchOptions& options, BenchRows& rows)
{
  const int pixels = options.Pick(512, 256, 32);
  const int triangles = options.Pick(1000000, 250000, 2000);
  const int step = options.Pick(1, 4, 16);
  const shadows::Case bonsai = shadows::MakeBonsai(step, step);
  const shadows::Case smoke = shadows::MakeSmoke(options.Pick(128, 48, 12));
  AddRows(MakeVolumeAmongSpheres("bonsai", bonsai.Scene, pixels, triangles), options, rows);
  AddRows(MakeVolumeAmongSpheres("smoke", smoke.Scene, pixels, triangles), options, rows);
}

std::vector<BenchClaim> CheckCostClaims(const std::vector<BenchRow>& rows)
{
  return {
    BenchClaim::AtMost(
      "a frame of surfaces and a volume at most 1.25 times the volume alone and the actors twice",
      1.25, rows, CountOf(ScenePass, OverBudget)),
    BenchClaim::AtMost("the same where the light moves", 1.25, rows, CountOf(Moving, OverBudget))
  };
}
}

BenchPart MakeCostPart()
{
  return { AddCostRows, nullptr, CheckCostClaims };
}
}
