// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Suites/BenchParts.h"

#include "Benchmarks/Scattering/SlabDrawing.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace scattering
{
namespace
{
const char* const SlabNorm = "relative difference of reflection or transmission, the larger one";

/// Results published by H. C. van de Hulst, "Multiple Light Scattering", 1980: flux of scattered
/// light divided by the incident flux.
struct Published
{
  const char* Name;
  Slab Medium;
  double Reflected;
  /// 0 if not published.
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

void AddModeRow(reference::VolumeStage& stage, const Published& slab, const std::string& mode,
  int across, const BenchOptions& options, BenchRows& rows)
{
  SlabDrawing drawing(stage, slab.Medium, mode, across);
  const double reflected = drawing.GetFlux(true);
  const double transmitted = drawing.GetFlux(false);
  BenchRow row = rows.Make(slab.Name, mode, drawing.GetCellsAlongThickness());
  row.SetError(SlabNorm, std::abs(reflected - slab.Reflected) / slab.Reflected);
  row.Set({ { "reflected", reflected }, { "published_reflected", slab.Reflected },
    { "transmitted", transmitted } });
  if (slab.Transmitted > 0.0)
  {
    row.Error = std::max(*row.Error, std::abs(transmitted - slab.Transmitted) / slab.Transmitted);
    row.Counts["published_transmitted"] = slab.Transmitted;
  }
  row.Seconds = MeasureAlternately({ drawing.MakeRelightingWork(options.Threads) }, 1).front();
  rows.Add(row);
}

/**
 * Compares the reflection and transmission of slabs with van de Hulst's tables. Each slab is
 * rendered from several directions on both sides, and the flux is integrated over the directions.
 * Each case is a row of a table; cases with grazing light are in the full suite only. Methods:
 * `single`, `forward` and `full`. The parameter is the number of grid cells along the thickness of
 * the slab. The error is the larger of the relative errors of reflection and transmission. Counts:
 * reflected, transmitted (scattered light only) and the published values.
 */
void AddSlabRows(const BenchOptions& options, BenchRows& rows)
{
  const std::array<int, 2> pixels = { { 4, 4 } };
  reference::VolumeStage stage(pixels);
  const std::vector<int> grids = options.Pick<std::vector<int>>({ 8, 16, 32 }, { 16 }, { 2 });
  // Slabs in grazing light require fine slices or wide boxes, and take minutes per row.
  const auto number = static_cast<std::size_t>(options.Pick(7, 3, 1));
  for (std::size_t i = 0; i < number; ++i)
  {
    const Published& slab = Slabs[i];
    for (const std::string& mode : GetModes())
    {
      int last = 0;
      for (const int across : mode == Single ? std::vector<int>{ grids.front() } : grids)
      {
        // In wide boxes the number of cells is limited, so different requests may result in the
        // same grid.
        const int found = SlabDrawing::GetCellsAlongThickness(slab.Medium, across);
        if (found > last)
        {
          AddModeRow(stage, slab, mode, across, options, rows);
        }
        last = found;
      }
    }
  }
}
}

BenchPart MakeSlabPart()
{
  return { AddSlabRows };
}
}
