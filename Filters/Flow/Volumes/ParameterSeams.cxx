// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/ParameterSeams.h"

#include "Fields/PointCopies.h"
#include "Samples/ImplicitFlowArrays.h"
#include "Volumes/InterpolableCells.h"
#include "Volumes/SimplexPoints.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkFlowStatus.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <vector>

namespace interlume
{

namespace
{
// Classes of cells by the seams that they cross: none, u, v or both.
constexpr int NumberOfClasses = 4;

class Unwrapper
{
public:
  Unwrapper(
    const InterpolableCells& cells, const ImplicitFlowArrays& arrays, vtkUnstructuredGrid* mesh)
    : Cells(cells)
    , Arrays(arrays)
    , Mesh(mesh)
    , NumberOfPoints(mesh->GetNumberOfPoints())
  {
  }

  // Assigns ids to the points and returns the number of added points.
  vtkIdType NumberPoints()
  {
    const SimplexPoints tetrahedra(this->Mesh, 4);
    const vtkIdType* origins = GetOrigins(this->Mesh->GetCellData(), "OriginCell");
    std::vector<unsigned char> uses(this->NumberOfPoints, 0);
    for (vtkIdType t = 0; t < tetrahedra.GetNumber(); ++t)
    {
      for (int corner = 0; corner < 4; ++corner)
      {
        uses[tetrahedra.Get(t, corner)] |=
          static_cast<unsigned char>(1 << this->GetClass(origins[t]));
      }
    }
    for (int group = 1; group < NumberOfClasses; ++group)
    {
      for (vtkIdType p = 0; p < this->NumberOfPoints; ++p)
      {
        if (!((uses[p] >> group) & 1))
        {
          continue;
        }
        if (this->NewIds[group].empty())
        {
          this->NewIds[group].assign(this->NumberOfPoints, -1);
        }
        // The first class that uses a point keeps the original.
        const bool isOwn = (uses[p] & ((1 << group) - 1)) == 0;
        this->NewIds[group][p] =
          isOwn ? p : this->NumberOfPoints + static_cast<vtkIdType>(this->Sources.size());
        if (!isOwn)
        {
          this->Sources.push_back(p);
        }
      }
    }
    return static_cast<vtkIdType>(this->Sources.size());
  }

  void AddPoints()
  {
    vtkNew<vtkPoints> points;
    vtkNew<vtkPointData> data;
    PointCopies::Append(this->Mesh, this->Sources, points, data);
    this->SetParameters(
      this->Mesh->GetPointData(), data->GetArray(vtkFlowStatus::ParametersArray()));
    this->Mesh->SetPoints(points);
    this->Mesh->GetPointData()->ShallowCopy(data);
  }

  // Replaces the point ids of a grid's simplices.
  void Renumber(vtkUnstructuredGrid* grid, int type, int size) const
  {
    const SimplexPoints simplices(grid, size);
    const vtkIdType number = simplices.GetNumber();
    if (number == 0)
    {
      return;
    }
    const vtkIdType* origins = GetOrigins(grid->GetCellData(), "OriginCell");
    vtkNew<vtkCellArray> cells;
    cells->DeepCopy(grid->GetCells());
    if (!cells->IsStorage64Bit() && this->Mesh->GetNumberOfPoints() > VTK_INT_MAX)
    {
      cells->ConvertTo64BitStorage();
    }
    for (vtkIdType cell = 0; cell < number; ++cell)
    {
      const int group = this->GetClass(origins[cell]);
      if (group == 0)
      {
        continue;
      }
      std::array<vtkIdType, 4> ids{};
      for (int corner = 0; corner < size; ++corner)
      {
        ids[corner] = this->NewIds[group][simplices.Get(cell, corner)];
      }
      cells->ReplaceCellAtId(cell, size, ids.data());
    }
    grid->SetCells(type, cells);
  }

private:
  int GetClass(vtkIdType cell) const
  {
    return this->Cells.GetKind(cell) & InterpolableCells::ACROSS;
  }

  void SetParameters(vtkPointData* from, vtkDataArray* parameters) const
  {
    const vtkIdType* ends = GetOrigins(from, "OriginPoints");
    const double* weights =
      vtkDoubleArray::SafeDownCast(from->GetArray("OriginWeight"))->GetPointer(0);
    for (int group = 1; group < NumberOfClasses; ++group)
    {
      const std::vector<vtkIdType>& newIds = this->NewIds[group];
      for (std::size_t p = 0; p < newIds.size(); ++p)
      {
        for (int direction = 0; newIds[p] >= 0 && direction < 2; ++direction)
        {
          if (!((group >> direction) & 1))
          {
            continue;
          }
          const auto get = [&](vtkIdType end)
          { return InterpolableCells::Unwrap(this->Arrays.GetParameters(end)[direction]); };
          const double near = get(ends[2 * p]);
          const double far = get(ends[2 * p + 1]);
          parameters->SetComponent(newIds[p], direction, near + weights[p] * (far - near));
        }
      }
    }
  }

  const InterpolableCells& Cells;
  const ImplicitFlowArrays& Arrays;
  vtkUnstructuredGrid* Mesh;
  vtkIdType NumberOfPoints;
  // New id of each point for each class of cells, or -1 if the class does not use the point.
  std::vector<vtkIdType> NewIds[NumberOfClasses];
  // Original of each added point.
  std::vector<vtkIdType> Sources;
};
}

vtkIdType ParameterSeams::Unwrap(const InterpolableCells& cells, const ImplicitFlowArrays& arrays,
  vtkUnstructuredGrid* mesh, vtkUnstructuredGrid* boundary)
{
  if (mesh->GetNumberOfCells() == 0)
  {
    return 0;
  }
  Unwrapper unwrapper(cells, arrays, mesh);
  const vtkIdType added = unwrapper.NumberPoints();
  unwrapper.AddPoints();
  unwrapper.Renumber(mesh, VTK_TETRA, 4);
  if (boundary)
  {
    unwrapper.Renumber(boundary, VTK_TRIANGLE, 3);
    boundary->SetPoints(mesh->GetPoints());
    boundary->GetPointData()->ShallowCopy(mesh->GetPointData());
  }
  return added;
}

}
