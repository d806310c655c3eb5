// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Suites/BenchParts.h"

#include "Benchmarks/Mixed/MixedCases.h"
#include "Benchmarks/Mixed/MixedDrawing.h"
#include "Support/Images/ReferenceMixedImage.h"

#include <array>

namespace mixed
{
namespace
{
const char* const ScenePass = "scene-pass";
const char* const Moving = "scene-pass, light moves";
const char* const ShadowMaps = "shadow-maps";
const char* const OverBaseline = "over_peer";
const char* const ErrorOverBaseline = "error_over_peer";
constexpr int DefaultResolution = 1024;

void SetError(
  BenchRow& row, const reference::RgbaImage& image, const reference::RgbaImage& expected)
{
  row.SetError("channel difference, mean", reference::CompareImages(image, expected).Mean);
}

/**
 * Measures the time to render a frame of surfaces under a spotlight, without a volume, with
 * vtkShadowedScenePass. The baseline is vtkShadowMapPass with shadow maps of the same resolution,
 * which is the parameter. The reference for errors is a ray caster in double precision. Methods:
 * - `scene-pass`, and `shadow-maps` (the baseline): only the camera moves;
 * - `scene-pass, light moves`: shadow maps are rendered for each frame.
 *
 * The counts over_peer, processor_over_peer and error_over_peer are Interlume's wall time,
 * processor time and error divided by those of the baseline.
 */
void AddMapRows(const BenchOptions& options, BenchRows& rows)
{
  const Case what = MakePosts(options.Pick(512, 256, 64), options.Pick(400000, 100000, 1000));
  const reference::RgbaImage expected = reference::MakeMixedImage(what.Scene);
  for (const int resolution : options.Pick<std::vector<int>>(
         { 128, 256, 512, 1024, 2048, 4096 }, { 256, 512, 1024, 2048 }, { 32, 64 }))
  {
    Drawing ours(what.Scene, Method::ScenePass, resolution);
    Drawing maps(what.Scene, Method::ShadowMaps, resolution);
    std::array<std::vector<BenchSeconds>, 2> seconds;
    for (const bool isMoving : { false, true })
    {
      seconds[isMoving] = MeasureAlternately(
        { ours.GetFrame(options.Threads, isMoving), maps.GetFrame(options.Threads, isMoving) },
        options.GetRepeats());
    }
    what.Scene.Lights.front().Light->SetPosition(what.LightPosition.data());
    ours.SetCamera(what.Scene.Camera);
    maps.SetCamera(what.Scene.Camera);

    BenchRow theirs = rows.Make(what.Name, ShadowMaps, resolution);
    theirs.Seconds = seconds[0][1];
    SetError(theirs, maps.Capture(), expected);
    for (const bool isMoving : { false, true })
    {
      BenchRow row = rows.Make(what.Name, isMoving ? Moving : ScenePass, resolution);
      row.SetTimes(seconds[isMoving][0], ShadowMaps, seconds[isMoving][1]);
      row.Set({ { OverBaseline, *row.Seconds / *row.BaselineSeconds },
        { "processor_over_peer",
          seconds[isMoving][0].Processor / seconds[isMoving][1].Processor } });
      if (!isMoving)
      {
        SetError(row, ours.Capture(), expected);
        row.Counts[ErrorOverBaseline] = *row.Error / *theirs.Error;
      }
      rows.Add(row);
    }
    rows.Add(theirs);
  }
}

std::vector<BenchClaim> CheckMapClaims(const std::vector<BenchRow>& rows)
{
  return { BenchClaim::AtMost("surfaces alone: no slower than vtkShadowMapPass", 1.0, rows,
             CountOf(ScenePass, OverBaseline)),
    BenchClaim::AtMost("surfaces alone, light moves: no slower than vtkShadowMapPass", 1.0, rows,
      CountOf(Moving, OverBaseline)),
    BenchClaim::AtMost("surfaces alone: no larger error than vtkShadowMapPass", 1.0, rows,
      CountOf(ScenePass, ErrorOverBaseline)) };
}

std::vector<BenchPlot> MakeMapPlots(const std::vector<BenchRow>& rows)
{
  BenchPlot plot = BenchPlot::OfErrors("mixed-surfaces",
    "Surfaces alone: error against run time, depth maps of growing resolution",
    "time of a frame (s)", "error: channel difference, mean",
    "Which shadow map resolution is required for surfaces?",
    "Posts under one light; labels are columns of the shadow maps. vtkShadowMapPass is the "
    "baseline. The reference is a ray caster in double precision.");
  for (const BenchRow& row : rows)
  {
    const bool isBaseline = row.Method == ShadowMaps;
    if (isBaseline || row.Baseline == ShadowMaps)
    {
      plot.AddRow(row, isBaseline);
    }
  }
  plot.SetDefault(ScenePass, std::to_string(DefaultResolution));
  return { plot };
}
}

BenchPart MakeMapPart()
{
  return { AddMapRows, MakeMapPlots, CheckMapClaims };
}
}
