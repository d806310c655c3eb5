// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Data/CellSplits.h"

#include "vtkCellType.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{
using Tetrahedra = std::vector<std::array<int, 4>>;

/// Corner c of a cell is at (c & 1, c >> 1 & 1, c >> 2 & 1).
const Tetrahedra FiveEven = { { { 0, 3, 6, 5 } }, { { 0, 1, 3, 5 } }, { { 0, 3, 2, 6 } },
  { { 0, 6, 4, 5 } }, { { 3, 6, 5, 7 } } };
const Tetrahedra FiveOdd = { { { 1, 7, 2, 4 } }, { { 0, 1, 2, 4 } }, { { 1, 3, 2, 7 } },
  { { 1, 7, 4, 5 } }, { { 2, 4, 7, 6 } } };
const Tetrahedra Six = { { { 0, 1, 3, 7 } }, { { 0, 3, 2, 7 } }, { { 0, 2, 6, 7 } },
  { { 0, 6, 4, 7 } }, { { 0, 4, 5, 7 } }, { { 0, 5, 1, 7 } } };
}

vtkSmartPointer<vtkUnstructuredGrid> SplitIntoTetrahedra(vtkImageData* image, int pieces)
{
  if (pieces != 5 && pieces != 6)
  {
    throw std::invalid_argument(
      "A cell cannot be split into " + std::to_string(pieces) + " tetrahedra; use 5 or 6");
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(image->GetNumberOfPoints());
  for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
  {
    points->SetPoint(id, image->GetPoint(id));
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  grid->GetPointData()->SetScalars(image->GetPointData()->GetScalars());
  grid->AllocateExact(pieces * image->GetNumberOfCells(), 4 * pieces * image->GetNumberOfCells());
  const int* dimensions = image->GetDimensions();
  const vtkIdType row = dimensions[0];
  const vtkIdType layer = row * dimensions[1];
  for (int k = 0; k + 1 < dimensions[2]; ++k)
  {
    for (int j = 0; j + 1 < dimensions[1]; ++j)
    {
      for (int i = 0; i + 1 < dimensions[0]; ++i)
      {
        const vtkIdType first = i + row * j + layer * k;
        for (const auto& piece : pieces == 6 ? Six : (i + j + k) % 2 == 0 ? FiveEven : FiveOdd)
        {
          std::array<vtkIdType, 4> ids;
          for (std::size_t c = 0; c < 4; ++c)
          {
            ids[c] = first + (piece[c] & 1) + row * (piece[c] >> 1 & 1) + layer * (piece[c] >> 2);
          }
          grid->InsertNextCell(VTK_TETRA, 4, ids.data());
        }
      }
    }
  }
  return grid;
}
