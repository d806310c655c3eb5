// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Measures/TetrahedronSums.h"

#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>

double TetrahedronSums::GetInvertedFraction() const
{
  return this->Tetrahedra > 0 ? static_cast<double>(this->Inverted) / this->Tetrahedra : 0.0;
}

double TetrahedronSums::GetInvertedVolumeFraction() const
{
  return this->AbsoluteVolume > 0.0 ? this->InvertedVolume / this->AbsoluteVolume : 0.0;
}

TetrahedronSums SumTetrahedra(vtkUnstructuredGrid* grid)
{
  TetrahedronSums sums;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    if (grid->GetCellType(cell) != VTK_TETRA)
    {
      continue;
    }
    grid->GetCellPoints(cell, ids);
    double corner[4][3];
    for (int i = 0; i < 4; ++i)
    {
      grid->GetPoint(ids->GetId(i), corner[i]);
    }
    double longest = 0.0;
    for (int i = 0; i < 4; ++i)
    {
      for (int j = i + 1; j < 4; ++j)
      {
        longest = std::max(longest, vtkMath::Distance2BetweenPoints(corner[i], corner[j]));
      }
    }
    double edge[3][3];
    for (int i = 0; i < 3; ++i)
    {
      vtkMath::Subtract(corner[i + 1], corner[0], edge[i]);
    }
    const double volume = vtkMath::Determinant3x3(edge[0], edge[1], edge[2]) / 6.0;
    ++sums.Tetrahedra;
    sums.Volume += volume;
    sums.AbsoluteVolume += std::abs(volume);
    if (volume < -1e-12 * longest * std::sqrt(longest))
    {
      ++sums.Inverted;
      sums.InvertedVolume -= volume;
    }
  }
  return sums;
}
