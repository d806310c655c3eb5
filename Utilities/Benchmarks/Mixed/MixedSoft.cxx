// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Mixed/MixedParts.h"

#include "Benchmarks/Mixed/MixedCases.h"
#include "Benchmarks/Mixed/MixedDrawing.h"
#include "Support/Pictures/LightPoints.h"
#include "Support/Pictures/ReferenceMixedPicture.h"

#include "vtkAreaLight.h"
#include "vtkMath.h"

namespace mixed
{
namespace
{
const char* const Soft = "soft";
const char* const Hard = "hard";
constexpr double Diameter = 0.8;
constexpr int DefaultSamples = 16;

/// The case under a round light in the place of its own.
Case MakeRound(const Case& from)
{
  Case made = from;
  auto light = vtkSmartPointer<vtkAreaLight>::New();
  light->DeepCopy(from.Scene.Lights.front().Light);
  light->SetShapeToRound();
  light->SetSize(Diameter, Diameter);
  reference::Double3 along;
  reference::Double3 side;
  reference::Double3 up;
  vtkMath::Subtract(light->GetFocalPoint(), light->GetPosition(), along.data());
  vtkMath::Normalize(along.data());
  vtkMath::Perpendiculars(along.data(), side.data(), up.data(), 0.0);
  vtkMath::MultiplyScalar(side.data(), Diameter);
  vtkMath::MultiplyScalar(up.data(), Diameter);
  made.Scene.Lights = { { light, reference::MakeRoundPoints(made.LightPosition, side, up, 400) } };
  return made;
}

BenchRow MakeSoftRow(const BenchRows& rows, const std::string& name, const char* method,
  int samples, const BenchSeconds& seconds, const reference::PictureError& error)
{
  BenchRow row = rows.Make(name, method, samples);
  row.Seconds = seconds;
  row.SetError("channel difference, mean", error.Mean);
  row.Counts["largest"] = error.Max;
  return row;
}

/**
 * Surfaces alone under a round vtkAreaLight by vtkShadowedScenePass, whose peer is the same light
 * without its extent; errors against the ray caster in double precision with 400 points of the
 * light. `soft`: the parameter is NumberOfLightSamples, the light moves from frame to frame and
 * over_hard is the time over the peer's. `hard`: the peer.
 */
void AddSoftRows(const BenchOptions& options, BenchRows& rows)
{
  const Case point = MakePosts(options.Pick(256, 128, 48), options.Pick(20000, 5000, 200));
  const Case round = MakeRound(point);
  const std::string name = "posts, round light";
  const reference::RgbaPicture expected = reference::MakeMixedPicture(round.Scene);
  Drawing hard(point.Scene, Method::ScenePass);
  for (const int samples : options.Pick<std::vector<int>>({ 4, 16, 64, 256 }, { 4, 16, 64 }, { 4 }))
  {
    Drawing soft(round.Scene, Method::ScenePass);
    soft.SetNumberOfLightSamples(samples);
    const std::vector<BenchSeconds> seconds = MeasureAlternately(
      { soft.GetFrame(options.Threads, true), hard.GetFrame(options.Threads, true) },
      options.GetRepeats());
    round.Scene.Lights.front().Light->SetPosition(point.LightPosition.data());
    soft.SetCamera(round.Scene.Camera);
    BenchRow row = MakeSoftRow(
      rows, name, Soft, samples, seconds[0], reference::ComparePictures(soft.Capture(), expected));
    row.Peer = Hard;
    row.PeerSeconds = seconds[1];
    row.Set({ { "over_hard", seconds[0] / seconds[1] },
      { "processor_over_hard", seconds[0].Processor / seconds[1].Processor },
      { "maps", soft.GetReport()->SampleMaps },
      { "map_resolution", soft.GetReport()->SampleMapResolution },
      { "map_bytes", soft.GetReport()->SampleMapBytes } });
    rows.Add(row);
    if (samples == 4)
    {
      point.Scene.Lights.front().Light->SetPosition(point.LightPosition.data());
      hard.SetCamera(point.Scene.Camera);
      rows.Add(MakeSoftRow(
        rows, name, Hard, 1, seconds[1], reference::ComparePictures(hard.Capture(), expected)));
    }
  }
}

std::vector<BenchPlot> MakeSoftPlots(const std::vector<BenchRow>& rows)
{
  BenchPlot plot = BenchPlot::OfErrors("mixed-soft",
    "Soft shadows of surfaces: error against run time, maps of 4 samples and more",
    "time of a frame (s)", "error: channel difference, mean",
    "How many samples of an area light for the soft shadows of surfaces?",
    "Posts under a round light, maps of so many samples, and the hard shadows of the light's "
    "center; against a ray caster in double precision.");
  for (const BenchRow& row : rows)
  {
    if (row.Method == Soft || row.Method == Hard)
    {
      plot.AddRow(row, row.Method == Hard);
    }
  }
  plot.SetDefault(Soft, std::to_string(DefaultSamples));
  return { plot };
}
}

BenchPart MakeSoftPart()
{
  return { AddSoftRows, MakeSoftPlots };
}
}
