// SPDX-License-Identifier: BSD-3-Clause
#include "TetGen/MeshingJob.h"

#include "vtkCell.h"
#include "vtkGenericCell.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>

namespace interlume
{

namespace
{
/// Smallest volume bound passed to TetGen. A bound must not become 0, which means no bound.
constexpr double MinimumVolumeBound = 1e-300;
}

void MeshingJob::SetUnit(int exponent)
{
  this->Mesh.UnitExponent = exponent;
  if (this->MaximumVolume > 0.0)
  {
    this->MaximumVolume = std::ldexp(this->MaximumVolume, -3 * exponent);
    this->MaximumVolume =
      std::max(MinimumVolumeBound, std::min(this->MaximumVolume, VTK_DOUBLE_MAX));
  }
}

std::string MeshingJob::GetRefinementSwitches(double quality, double volume, int points) const
{
  std::ostringstream switches;
  switches.imbue(std::locale::classic());
  switches << std::setprecision(17);
  if (quality > 0.0)
  {
    // TetGen does not parse exponents in the q switch.
    switches << std::fixed << "q" << quality << "/" << this->MinimumDihedralAngle;
  }
  if (volume > 0.0)
  {
    switches << std::scientific << "a" << volume;
  }
  switches << "S" << points;
  return switches.str();
}

int MeshingJob::GetDimension(int cellType)
{
  static const std::array<int, VTK_NUMBER_OF_CELL_TYPES> dimensions = []()
  {
    std::array<int, VTK_NUMBER_OF_CELL_TYPES> list{};
    for (int type = 0; type < VTK_NUMBER_OF_CELL_TYPES; ++type)
    {
      const auto cell = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
      list[type] = cell ? cell->GetCellDimension() : 0;
    }
    return list;
  }();
  return cellType >= 0 && cellType < VTK_NUMBER_OF_CELL_TYPES ? dimensions[cellType] : 0;
}

Error MeshingJob::Solve(const TetGenProblem& problem, TetGenSolution& solution)
{
  ++this->Report.TetGenCalls;
  Error error = this->TetGen.Solve(problem, solution);
  if (error || this->IsCanceled())
  {
    return error;
  }
  // All meshers require the solution to start with the unchanged points of the problem.
  if (solution.Points.size() < problem.Points.size() ||
    !std::equal(problem.Points.begin(), problem.Points.end(), solution.Points.begin()))
  {
    error = Error("TetGen failed: it moved or dropped points of the input", ErrorCode::Process);
  }
  return error;
}

}
