// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Scattering/ScatteringSlabs.h"

#include "Benchmarks/Scattering/ScatteringModes.h"
#include "Pictures/PictureSettings.h"
#include "Pictures/ShadowCases.h"
#include "Transport/SlabTransport.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace scattering
{
namespace
{
/// H. C. van de Hulst, "Multiple Light Scattering", 1980.
struct Slab
{
  const char* Name;
  double Depth;
  double Albedo;
  double G;
  /// Of the light's angle to the normal.
  double Cosine;
  double Reflected;
  /// Of scattered light; none published where it is 0.
  double Transmitted;
};

const Slab Slabs[] = {
  { "slab II 35", 2.0, 0.9, 0.75, 1.0, 0.09739, 0.52562 },
  { "slab II 37 depth 1", 1.0, 1.0, 0.75, 1.0, 0.07874, 0.55338 },
  { "slab II 37 depth 8", 8.0, 1.0, 0.75, 1.0, 0.50642, 0.49325 },
  { "slab I 12 depth 1/32 albedo 0.2", 0.03125, 0.2, 0.0, 0.1, 0.025447, 0.0 },
  { "slab I 12 depth 1/32 albedo 1", 0.03125, 1.0, 0.0, 0.1, 0.13462, 0.0 },
  { "slab I 12 depth 32 albedo 0.2", 32.0, 0.2, 0.0, 0.1, 0.082661, 0.0 },
  { "slab I 12 depth 32 albedo 1", 32.0, 1.0, 0.0, 0.1, 0.978453, 0.021548 },
};

/// Nodes and weights of Gauss and Legendre on 0 to 1, for cosines of the eye.
constexpr std::array<double, 5> Nodes = { { 0.0469100770306680, 0.2307653449471585, 0.5,
  0.7692346550528415, 0.9530899229693320 } };
constexpr std::array<double, 5> Weights = { { 0.1184634425280945, 0.2393143352496832,
  0.2844444444444444, 0.2393143352496832, 0.1184634425280945 } };

/// A slab of thickness 1, wide enough that its middle sees nothing of its ends: oblique light comes
/// from far.
reference::ShadowScene MakeSlab(const Slab& slab)
{
  const int across = slab.Cosine < 1.0 ? 24 : 12;
  reference::ShadowScene scene;
  scene.Image = reference::MakeImage({ { across * 2, 12, 16 } }, { { 0.5, 0.5, 1.0 / 16.0 } },
    [](const reference::Double3&) { return 1.0; });
  // The albedo is the colour; the unit makes the opacity small, the extinction depth per unit.
  const double a = slab.Albedo;
  constexpr double opacity = 0.02;
  scene.Property =
    reference::MakeProperty({ { 0.0, { { a, a, a } }, 0.0 }, { 1.0, { { a, a, a } }, opacity } },
      -std::log1p(-opacity) / slab.Depth);
  scene.Lights = { reference::MakeDirectionalLight(
    { { std::sqrt(1.0 - slab.Cosine * slab.Cosine), 0.0, -slab.Cosine } }) };
  scene.Lights.front()->SetIntensity(1.0);
  scene.Size = { { 4, 4 } };
  return scene;
}

/// The camera that looks at the slab's middle at a cosine, from above for reflected light.
vtkSmartPointer<vtkCamera> MakeEye(double cosine, bool isAbove)
{
  const double across = std::sqrt(1.0 - cosine * cosine);
  auto camera = reference::LookAt(
    reference::Point3{}, 13.0, { { across, 0.0, isAbove ? -cosine : cosine } }, true);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetParallelScale(0.02);
  return camera;
}

/// Flux of scattered light over incident flux: the integral over directions of cosine times
/// radiance.
double Integrate(reference::VolumeStage& stage, const Slab& slab,
  const reference::ShadowScene& scene, const Change& change, bool isAbove)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < Nodes.size(); ++i)
  {
    reference::ShadowScene seen = scene;
    seen.Camera = MakeEye(Nodes[i], isAbove);
    const reference::RgbaPicture picture = shadows::MakeSlices(stage, seen, change)->Capture();
    sum += Weights[i] * Nodes[i] * picture.At(2, 2)[0];
  }
  // A light of colour 1 has an irradiance of 4 pi across its direction; the azimuth gives 2 pi.
  return 0.5 * sum / slab.Cosine;
}

void AddMonteCarloRow(const Slab& slab, const BenchOptions& options, BenchRows& rows)
{
  reference::SlabTransportSettings settings;
  settings.Depth = slab.Depth;
  settings.Albedo = slab.Albedo;
  settings.Phase = reference::TransportPhase::HenyeyGreenstein(slab.G);
  settings.Cosine = slab.Cosine;
  settings.Paths = static_cast<std::uint64_t>(options.Pick(4000000, 100000, 1000));
  settings.Seed = options.Seed;
  reference::SlabTransportResult result;
  const double seconds = TimeOnce(WithThreads(options.Threads,
    [&]()
    {
      result = reference::TraceSlab(settings);
      return vtkSmartPointer<vtkObjectBase>();
    }));
  BenchRow row = rows.Make(slab.Name, MonteCarlo);
  row.Parameter = settings.Paths;
  row.Seconds = seconds;
  row.ErrorNorm = "relative standard error of the reflection";
  row.Error = result.Reflected.StandardError / slab.Reflected;
  row.Counts["reflected"] = result.Reflected.Value;
  row.Counts["transmitted"] = result.Transmitted.Value;
  rows.Add(row);
}

void AddModeRow(reference::VolumeStage& stage, const Slab& slab, const std::string& mode, int cells,
  const BenchOptions& options, BenchRows& rows)
{
  reference::ShadowScene scene = MakeSlab(slab);
  const Change change = InMode(mode, slab.G,
    [cells](vtkShadowedSliceMapper* mapper) { mapper->SetScatteringGridSize(cells); });
  const double reflected = Integrate(stage, slab, scene, change, true);
  const double transmitted = Integrate(stage, slab, scene, change, false);
  BenchRow row = rows.Make(slab.Name, mode);
  row.Parameter = cells;
  row.ErrorNorm = "relative difference of reflection or transmission, the larger one";
  row.Error = std::abs(reflected - slab.Reflected) / slab.Reflected;
  row.Counts["reflected"] = reflected;
  row.Counts["published_reflected"] = slab.Reflected;
  row.Counts["transmitted"] = transmitted;
  if (slab.Transmitted > 0.0)
  {
    row.Error = std::max(*row.Error, std::abs(transmitted - slab.Transmitted) / slab.Transmitted);
    row.Counts["published_transmitted"] = slab.Transmitted;
  }
  scene.Camera = MakeEye(0.5, true);
  const shadows::MethodPointer drawn = shadows::MakeSlices(stage, scene, change);
  row.Seconds =
    MeasureAlternately({ GetLitFrame(*drawn, scene.Lights.front(), options.Threads) }, 1).front();
  rows.Add(row);
}
}

void AddSlabRows(const BenchOptions& options, BenchRows& rows)
{
  const std::array<int, 2> pixels = { { 4, 4 } };
  reference::VolumeStage stage(pixels);
  const std::vector<int> grids = options.Pick<std::vector<int>>({ 32, 64, 128 }, { 32 }, { 8 });
  for (const Slab& slab : Slabs)
  {
    for (const std::string& mode : GetModes())
    {
      for (const int cells : mode == Single ? std::vector<int>{ grids.front() } : grids)
      {
        AddModeRow(stage, slab, mode, cells, options, rows);
      }
    }
    AddMonteCarloRow(slab, options, rows);
  }
}
}
