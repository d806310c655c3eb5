// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Data/CellSplits.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{
using Tetrahedron = std::array<int, 4>;
using Index = std::array<int, 3>;

/// Corner c of a cell lies at (c & 1, c >> 1 & 1, c >> 2 & 1).
const std::vector<Tetrahedron> FiveEven = { { 0, 3, 6, 5 }, { 0, 1, 3, 5 }, { 0, 3, 2, 6 },
  { 0, 6, 4, 5 }, { 3, 6, 5, 7 } };
const std::vector<Tetrahedron> FiveOdd = { { 1, 7, 2, 4 }, { 0, 1, 2, 4 }, { 1, 3, 2, 7 },
  { 1, 7, 4, 5 }, { 2, 4, 7, 6 } };
const std::vector<Tetrahedron> Six = { { 0, 1, 3, 7 }, { 0, 3, 2, 7 }, { 0, 2, 6, 7 },
  { 0, 6, 4, 7 }, { 0, 4, 5, 7 }, { 0, 5, 1, 7 } };
/// The corners around each face, as seen from outside: -x, +x, -y, +y, -z, +z.
const int Faces[6][4] = { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 },
  { 0, 2, 3, 1 }, { 4, 5, 7, 6 } };

/// The image's points, then the centres where there are such, numbered by where they lie.
class SplitGrid
{
public:
  explicit SplitGrid(vtkImageData* image)
  {
    image->GetDimensions(this->Dimensions.data());
    this->Points->SetDataTypeToDouble();
    this->Points->SetNumberOfPoints(image->GetNumberOfPoints());
    this->Values->SetName(image->GetPointData()->GetScalars()->GetName());
    this->Values->SetNumberOfValues(image->GetNumberOfPoints());
    for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
    {
      double x[3];
      image->GetPoint(id, x);
      this->Points->SetPoint(id, x);
      this->Values->SetValue(id, image->GetPointData()->GetScalars()->GetTuple1(id));
    }
  }

  const std::array<int, 3>& GetDimensions() const { return this->Dimensions; }

  vtkIdType Corner(const Index& cell, int corner) const
  {
    return cell[0] + (corner & 1) +
      static_cast<vtkIdType>(this->Dimensions[0]) *
      (cell[1] + (corner >> 1 & 1) +
        static_cast<vtkIdType>(this->Dimensions[1]) * (cell[2] + (corner >> 2 & 1)));
  }

  /// A new point in the middle of the \a number of corners, with the mean of their values.
  vtkIdType AddCentre(const Index& cell, const int* corners, int number)
  {
    double centre[3] = { 0.0, 0.0, 0.0 };
    double value = 0.0;
    for (int i = 0; i < number; ++i)
    {
      const vtkIdType id = this->Corner(cell, corners[i]);
      double x[3];
      this->Points->GetPoint(id, x);
      for (int axis = 0; axis < 3; ++axis)
      {
        centre[axis] += x[axis] / number;
      }
      value += this->Values->GetValue(id) / number;
    }
    this->Values->InsertNextValue(value);
    return this->Points->InsertNextPoint(centre);
  }

  void AddTetrahedron(vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType d)
  {
    this->Connectivity->InsertNextValue(a);
    this->Connectivity->InsertNextValue(b);
    this->Connectivity->InsertNextValue(c);
    this->Connectivity->InsertNextValue(d);
  }

  void AddTetrahedra(const Index& cell, const std::vector<Tetrahedron>& pieces)
  {
    for (const Tetrahedron& piece : pieces)
    {
      this->AddTetrahedron(this->Corner(cell, piece[0]), this->Corner(cell, piece[1]),
        this->Corner(cell, piece[2]), this->Corner(cell, piece[3]));
    }
  }

  vtkSmartPointer<vtkUnstructuredGrid> Finish()
  {
    vtkNew<vtkCellArray> cells;
    cells->SetData(4, this->Connectivity);
    auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    grid->SetPoints(this->Points);
    grid->SetCells(VTK_TETRA, cells);
    grid->GetPointData()->SetScalars(this->Values);
    return grid;
  }

private:
  std::array<int, 3> Dimensions;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkDoubleArray> Values;
  vtkNew<vtkIdTypeArray> Connectivity;
};

/// Four tetrahedra a face, with the centre of each face made once for the two cells it divides.
class CentredSplit
{
public:
  explicit CentredSplit(SplitGrid& grid)
    : Grid(grid)
  {
    const std::array<int, 3>& dimensions = grid.GetDimensions();
    const std::size_t points =
      static_cast<std::size_t>(dimensions[0]) * dimensions[1] * dimensions[2];
    for (std::vector<vtkIdType>& centres : this->FaceCentres)
    {
      centres.assign(points, -1);
    }
  }

  void AddCell(const Index& cell)
  {
    const int corners[8] = { 0, 1, 2, 3, 4, 5, 6, 7 };
    const vtkIdType centre = this->Grid.AddCentre(cell, corners, 8);
    for (int face = 0; face < 6; ++face)
    {
      const vtkIdType faceCentre = this->GetFaceCentre(cell, face);
      for (int i = 0; i < 4; ++i)
      {
        this->Grid.AddTetrahedron(this->Grid.Corner(cell, Faces[face][(i + 1) % 4]),
          this->Grid.Corner(cell, Faces[face][i]), faceCentre, centre);
      }
    }
  }

private:
  /// A face is named by its axis and its first corner.
  vtkIdType GetFaceCentre(const Index& cell, int face)
  {
    const int axis = face / 2;
    const vtkIdType first = this->Grid.Corner(cell, face % 2 == 1 ? 1 << axis : 0);
    vtkIdType& centre = this->FaceCentres[axis][first];
    if (centre < 0)
    {
      centre = this->Grid.AddCentre(cell, Faces[face], 4);
    }
    return centre;
  }

  SplitGrid& Grid;
  std::array<std::vector<vtkIdType>, 3> FaceCentres;
};
}

vtkSmartPointer<vtkUnstructuredGrid> SplitIntoTetrahedra(vtkImageData* image, int pieces)
{
  if (pieces != 5 && pieces != 6 && pieces != 24)
  {
    throw std::invalid_argument("no split into " + std::to_string(pieces) + " tetrahedra");
  }
  SplitGrid grid(image);
  std::optional<CentredSplit> centred;
  if (pieces == 24)
  {
    centred.emplace(grid);
  }
  const std::array<int, 3>& dimensions = grid.GetDimensions();
  for (int k = 0; k + 1 < dimensions[2]; ++k)
  {
    for (int j = 0; j + 1 < dimensions[1]; ++j)
    {
      for (int i = 0; i + 1 < dimensions[0]; ++i)
      {
        const Index cell = { i, j, k };
        if (centred)
        {
          centred->AddCell(cell);
        }
        else
        {
          grid.AddTetrahedra(cell, pieces == 6 ? Six : (i + j + k) % 2 == 0 ? FiveEven : FiveOdd);
        }
      }
    }
  }
  return grid.Finish();
}
