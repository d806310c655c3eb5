// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Scattering/ScatteringParts.h"

#include "Benchmarks/Scattering/SlabDrawing.h"
#include "Support/Transport/SlabTransport.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

namespace scattering
{
namespace
{
/// Through the slabs of the limits.
constexpr int LimitCells = 16;
/// The share of incident light below which no relative error is asked for.
constexpr double LeastFlux = 1e-3;
const char* const Norm = "relative difference of reflection or transmission, the larger one";

/// H. C. van de Hulst, "Multiple Light Scattering", 1980.
struct Published
{
  const char* Name;
  Slab Matter;
  double Reflected;
  /// Of scattered light; none published where it is 0.
  double Transmitted;
};

const Published Slabs[] = {
  { "slab II 35", { 2.0, 0.9, 0.75, 1.0 }, 0.09739, 0.52562 },
  { "slab II 37 depth 1", { 1.0, 1.0, 0.75, 1.0 }, 0.07874, 0.55338 },
  { "slab II 37 depth 8", { 8.0, 1.0, 0.75, 1.0 }, 0.50642, 0.49325 },
  { "slab I 12 depth 1/32 albedo 0.2", { 0.03125, 0.2, 0.0, 0.1 }, 0.025447, 0.0 },
  { "slab I 12 depth 1/32 albedo 1", { 0.03125, 1.0, 0.0, 0.1 }, 0.13462, 0.0 },
  { "slab I 12 depth 32 albedo 0.2", { 32.0, 0.2, 0.0, 0.1 }, 0.082661, 0.0 },
  { "slab I 12 depth 32 albedo 1", { 32.0, 1.0, 0.0, 0.1 }, 0.978453, 0.021548 },
};

reference::SlabTransportResult Trace(const Slab& slab, std::uint64_t paths, unsigned int seed)
{
  reference::SlabTransportSettings settings;
  settings.Depth = slab.Depth;
  settings.Albedo = slab.Albedo;
  settings.Phase = reference::TransportPhase::HenyeyGreenstein(slab.G);
  settings.Cosine = slab.Cosine;
  settings.Paths = paths;
  settings.Seed = seed;
  return reference::TraceSlab(settings);
}

void AddMonteCarloRow(const Published& slab, const BenchOptions& options, BenchRows& rows)
{
  const auto paths = static_cast<std::uint64_t>(options.Pick(4000000, 100000, 1000));
  reference::SlabTransportResult result;
  const BenchSeconds seconds = TimeOnce(WithThreads(options.Threads,
    [&]()
    {
      result = Trace(slab.Matter, paths, options.Seed);
      return vtkSmartPointer<vtkObjectBase>();
    }));
  BenchRow row = rows.Make(slab.Name, MonteCarlo, paths);
  row.Seconds = seconds;
  row.SetError(
    "relative standard error of the reflection", result.Reflected.StandardError / slab.Reflected);
  row.Set({ { "reflected", result.Reflected.Value }, { "transmitted", result.Transmitted.Value } });
  rows.Add(row);
}

void AddModeRow(reference::VolumeStage& stage, const Published& slab, const std::string& mode,
  int across, const BenchOptions& options, BenchRows& rows)
{
  SlabDrawing drawing(stage, slab.Matter, mode, across);
  const double reflected = drawing.GetFlux(true);
  const double transmitted = drawing.GetFlux(false);
  BenchRow row = rows.Make(slab.Name, mode, drawing.GetAcross());
  row.SetError(Norm, std::abs(reflected - slab.Reflected) / slab.Reflected);
  row.Set({ { "reflected", reflected }, { "published_reflected", slab.Reflected },
    { "transmitted", transmitted } });
  if (slab.Transmitted > 0.0)
  {
    row.Error = std::max(*row.Error, std::abs(transmitted - slab.Transmitted) / slab.Transmitted);
    row.Counts["published_transmitted"] = slab.Transmitted;
  }
  row.Seconds = MeasureAlternately({ drawing.GetLitFrame(options.Threads) }, 1).front();
  rows.Add(row);
}

std::string ToText(double number)
{
  std::ostringstream text;
  text << number;
  return text.str();
}

/**
 * Slabs of van de Hulst's tables, drawn from directions on both sides and integrated over them,
 * against the published reflection and transmission. A case is a row of a table; those of light
 * that grazes are in the full suite alone. Methods `single`, `forward`, `full`; the parameter is
 * the number of cells of the grid through the slab. Errors are relative, the larger of both sides;
 * counts reflected, transmitted (scattered light alone) and what is published. `monte-carlo`: the
 * parameter is the number of paths of reference::TraceSlab, the error its standard error.
 */
void AddSlabRows(const BenchOptions& options, BenchRows& rows)
{
  const std::array<int, 2> pixels = { { 4, 4 } };
  reference::VolumeStage stage(pixels);
  const std::vector<int> grids = options.Pick<std::vector<int>>({ 8, 16, 32 }, { 16 }, { 2 });
  // Light that grazes takes fine slices or wide boxes, and minutes.
  const auto number = static_cast<std::size_t>(options.Pick(7, 3, 1));
  for (std::size_t i = 0; i < number; ++i)
  {
    const Published& slab = Slabs[i];
    for (const std::string& mode : GetModes())
    {
      int last = 0;
      for (const int across : mode == Single ? std::vector<int>{ grids.front() } : grids)
      {
        // Wide boxes have no more cells than the largest number.
        const int found = SlabDrawing::GetAcross(slab.Matter, across);
        if (found > last)
        {
          AddModeRow(stage, slab, mode, across, options, rows);
        }
        last = found;
      }
    }
    AddMonteCarloRow(slab, options, rows);
  }
}

/**
 * Where `full` holds: the same errors of slabs in light at right angles, against
 * reference::TraceSlab. A row for each phase function and albedo, with the differences at each
 * depth as counts, reflected and transmitted, relative, where that is more than a thousandth of the
 * light; the error is the largest. Then how many of
 * these settings are within 5, 10 and 20 %.
 */
void AddLimitRows(const BenchOptions& options, BenchRows& rows)
{
  using Values = std::vector<double>;
  const std::array<int, 2> pixels = { { 4, 4 } };
  reference::VolumeStage stage(pixels);
  const auto paths = static_cast<std::uint64_t>(options.Pick(400000, 100000, 1000));
  std::vector<double> errors;
  for (const double g : options.Pick<Values>({ 0.0, 0.5, 0.75, 0.9 }, { 0.0, 0.75 }, { 0.5 }))
  {
    for (const double albedo : options.Pick<Values>({ 0.5, 0.9, 0.99, 1.0 }, { 0.9, 1.0 }, { 1.0 }))
    {
      BenchRow row = rows.Make("limits", Full, "g " + ToText(g) + ", albedo " + ToText(albedo));
      row.SetError(Norm, 0.0);
      for (const double depth :
        options.Pick<Values>({ 0.25, 1.0, 4.0, 16.0, 64.0 }, { 1.0, 4.0 }, { 1.0 }))
      {
        const Slab slab{ depth, albedo, g, 1.0 };
        SlabDrawing drawing(stage, slab, Full, LimitCells);
        const reference::SlabTransportResult expected = Trace(slab, paths, options.Seed);
        double largest = 0.0;
        const auto compare =
          [&](bool isReflected, const reference::TransportEstimate& estimate, const char* what)
        {
          if (estimate.Value > LeastFlux)
          {
            const double error = drawing.GetFlux(isReflected) / estimate.Value - 1.0;
            row.Counts["depth " + ToText(depth) + what] = error;
            largest = std::max(largest, std::abs(error));
          }
        };
        compare(true, expected.Reflected, " reflected");
        compare(false, expected.Transmitted, " transmitted");
        errors.push_back(largest);
        row.Error = std::max(*row.Error, errors.back());
      }
      rows.Add(row);
    }
  }
  for (const double bound : { 0.05, 0.1, 0.2 })
  {
    BenchRow row = rows.Make("limits", Full, "within " + ToText(bound));
    row.Counts["settings"] = errors.size();
    row.Counts["within"] =
      std::count_if(errors.begin(), errors.end(), [bound](double error) { return error <= bound; });
    rows.Add(row);
  }
}
}

BenchPart MakeSlabPart()
{
  return { [](const BenchOptions& options, BenchRows& rows)
    {
      AddSlabRows(options, rows);
      AddLimitRows(options, rows);
    } };
}
}
