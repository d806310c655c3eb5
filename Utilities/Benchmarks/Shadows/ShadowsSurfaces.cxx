// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Shadows/ShadowsParts.h"

#include "Benchmarks/Measures/BenchTiming.h"
#include "Support/Pictures/ReferenceShadowPicture.h"
#include "Benchmarks/Shadows/ShadowsMethods.h"
#include "Benchmarks/Shadows/ShadowsScene.h"
#include "Support/Pictures/SurfaceCases.h"

#include "vtkImageData.h"

#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace shadows
{
namespace
{
using reference::Double3;
using reference::RgbaPicture;
using reference::SurfaceErrors;

/// A scene, and how far a picture of it is off.
struct Surface
{
  std::string Name;
  reference::ShadowScene Scene;
  std::function<SurfaceErrors(const RgbaPicture&)> Measure;
};

Surface MakeClosed(const std::string& name, const reference::SurfaceCase& from)
{
  return { name, from.Scene, [expected = from.Expected](const RgbaPicture& found) {
            return reference::MeasureSurface(found, expected);
          } };
}

/// The marcher does not end its steps where opacity jumps, so that it needs shorter ones.
Surface MakeMarched(const std::string& name, const reference::ShadowScene& scene, int refinement)
{
  return { name, scene,
    [scene, refinement](const RgbaPicture& found)
    { return reference::MeasureSurface(found, reference::MakeShadowPicture(scene, refinement)); } };
}

std::vector<Surface> MakeSurfaces(const BenchOptions& options)
{
  const int cells = options.Pick(32, 24, 8);
  const int refinement = options.Pick(4, 2, 1);
  const auto angles =
    options.Pick<std::vector<double>>({ 0.0, 20.0, 40.0, 50.0, 60.0 }, { 0.0, 50.0 }, { 50.0 });
  const Double3 tilted = { { 0.2, 0.35, 1.0 } };
  std::vector<Surface> surfaces = { MakeClosed("cube", reference::MakeOpaqueCube(cells)) };
  for (const double angle : angles)
  {
    surfaces.push_back(MakeClosed("plate, light at " + std::to_string(static_cast<int>(angle)),
      reference::MakePlate(cells, tilted, angle, 30.0, 120.0)));
  }
  surfaces.push_back(MakeMarched("ball of two steps", reference::MakeStepBall(cells), refinement));
  surfaces.push_back(MakeMarched("shell of one voxel", reference::MakeShell(cells), refinement));
  surfaces.push_back(MakeMarched("sheet of one voxel", reference::MakeSheet(cells), refinement));
  const int step = options.Pick(2, 8, 16);
  std::vector<Case> scans = { MakeBonsai(step, step) };
  if (options.Size != BenchOptions::TINY)
  {
    scans.push_back(MakeHead());
    scans.push_back(MakeTooth());
  }
  const int pixels = options.Pick(64, 48, 16);
  for (const Case& scan : scans)
  {
    for (Case one : { MakeScattering(scan), MakeScattering(MakeStepped(scan)) })
    {
      one.Scene.Size = { { pixels, pixels } };
      surfaces.push_back(MakeMarched(one.Name, one.Scene, options.Pick(2, 1, 1)));
    }
  }
  return surfaces;
}

/**
 * Method `surfaces`, at the mapper's own settings: an opaque cube and a plate whose opacity jumps,
 * under light from 0 to 60 degrees, against closed forms; a ball of steps of opacity, a thin shell,
 * a sheet of one voxel and three CT volumes, with ramps and with steps of opacity, by scattered
 * light, against the ray marcher. The error is the mean difference of a pixel's red, over the
 * pixels that show anything; p95, largest and rms are of the same, rms over the mean of what is
 * expected, and brightness is the picture's mean over that, less 1. Seconds are those of a frame of
 * 512^2; the peer is `shadows-off`.
 */
void AddSurfaceRows(const BenchOptions& options, BenchRows& rows)
{
  const int pixels = options.Pick(512, 192, 32);
  const std::array<int, 2> size = { { pixels, pixels } };
  for (const Surface& surface : MakeSurfaces(options))
  {
    reference::VolumeStage stage(size);
    reference::ShadowScene unshadowed = surface.Scene;
    unshadowed.Shadows = false;
    const MethodPointer on = MakeSlices(stage, surface.Scene);
    const MethodPointer off = MakeSlices(stage, unshadowed);
    const std::vector<BenchSeconds> seconds = MeasureAlternately(
      { on->GetFrame(options.Threads), off->GetFrame(options.Threads) }, options.GetRepeats());
    reference::VolumeStage small(surface.Scene.Size);
    const SurfaceErrors errors = surface.Measure(MakeSlices(small, surface.Scene)->Capture());
    BenchRow row = rows.Make(surface.Name, "surfaces");
    row.SetError("red difference, mean over what is seen", errors.Mean);
    row.SetTimes(seconds[0], "shadows-off", seconds[1]);
    AddReport(on->GetSlices()->GetReport(), row);
    row.Set({ { "p95", errors.P95 }, { "largest", errors.Max }, { "rms", errors.Rms },
      { "brightness", errors.Bias } });
    rows.Add(row);
  }
}
}

BenchPart MakeSurfacePart()
{
  return { AddSurfaceRows };
}
}
