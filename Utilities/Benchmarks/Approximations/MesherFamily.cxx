// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Approximations/FilterFamilies.h"
#include "Benchmarks/Suites/ChildProcess.h"

#include <filesystem>

namespace approximations
{
namespace
{
/// The mesher is under another licence, and measured by a program of its own beside this one, where
/// it was built.
void AddMesherRows(const Question&, const BenchOptions& options, BenchRows& rows)
{
  const std::filesystem::path own = options.Program;
  const std::filesystem::path program =
    own.parent_path() / ("interlume-bench-mesher" + own.extension().string());
  if (own.empty() || !std::filesystem::exists(program))
  {
    return;
  }
  for (const nlohmann::ordered_json& row : RunProgram(program.string(), "", options))
  {
    rows.Add(BenchRow::FromJson(row));
  }
}
}

Family MakeMesherFamily()
{
  return {
    { "mesher-bounds", "Tetrahedra of a ball: error against run time, 1 thread",
      "How fine and how well shaped are tetrahedra to be for the values within them?",
      "vtkTetrahedralMesher fills a ball of triangles that have x^2 - y^2 in their points; by "
      "MaximumVolume in parts of the ball, by QualityBound, or by both; vtkDelaunay3D of the "
      "points; the linear interpolation of all against x^2 - y^2, which is what the values on the "
      "boundary mean within. Without a bound the mesher adds no point, which is why that stays the "
      "default; the peer fills the convex hull alone, and no surface that is not convex.",
      "run time (s)", "interpolation within, rms, share of the values' range" },
    AddMesherRows
  };
}
}
