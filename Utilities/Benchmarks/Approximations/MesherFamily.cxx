// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Approximations/FilterFamilies.h"
#include "Benchmarks/Suites/ChildProcess.h"

#include <filesystem>

namespace approximations
{
namespace
{
/// Runs interlume-bench-mesher in the directory of this program, if it was built. The mesher has
/// another license, so a separate program measures it.
void AddMesherRows(const Question&, const BenchOptions& options, BenchRows& rows)
{
  const std::filesystem::path self = options.Program;
  const std::filesystem::path program =
    self.parent_path() / ("interlume-bench-mesher" + self.extension().string());
  if (self.empty() || !std::filesystem::exists(program))
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
  return { { "mesher-bounds", "Tetrahedra of a ball: error against run time, 1 thread",
             "Which bounds on tetrahedra are required for accurate values inside?",
             "vtkTetrahedralMesher fills a triangulated sphere with x^2 - y^2 at its points, with "
             "MaximumVolume "
             "(labels are fractions of the sphere's volume), with QualityBound, or with both. The "
             "baseline is "
             "vtkDelaunay3D on the same points. The linear interpolation in all meshes is compared "
             "with x^2 - y^2. "
             "Without bounds the mesher inserts no points, and this is its default. vtkDelaunay3D "
             "fills the convex "
             "hull and cannot mesh nonconvex surfaces.",
             "run time (s)", "interpolation within, rms, share of the values' range" },
    AddMesherRows };
}
}
