// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzCases.h"
#include "FuzzData.h"
#include "FuzzRun.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImplicitFlowField.h"
#include "vtkIntervalVolume.h"
#include "vtkIsotableContour.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <functional>
#include <limits>

namespace fuzz
{

namespace
{

/// Shortens all point arrays to \a points tuples.
void ShortenArrays(vtkDataSet* data, vtkIdType points)
{
  for (int i = 0; i < data->GetPointData()->GetNumberOfArrays(); ++i)
  {
    data->GetPointData()->GetAbstractArray(i)->SetNumberOfTuples(points);
  }
}

/// Removes polyhedra, and damages one cell or the array of cell types. Returns the text that the
/// error message must contain, or an empty string if nothing was damaged.
std::string DamageCells(FuzzRandom& random, vtkUnstructuredGrid* grid)
{
  const vtkIdType points = grid->GetNumberOfPoints();
  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdTypeArray> ids;
  vtkNew<vtkUnsignedCharArray> types;
  offsets->InsertNextValue(0);
  vtkNew<vtkIdList> corners;
  std::vector<vtkIdType> numbers;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const int type = grid->GetCellType(cell);
    grid->GetCellPoints(cell, corners);
    if (type == VTK_POLYHEDRON || corners->GetNumberOfIds() == 0)
    {
      continue;
    }
    for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
    {
      ids->InsertNextValue(corners->GetId(i));
    }
    offsets->InsertNextValue(ids->GetNumberOfValues());
    types->InsertNextValue(static_cast<unsigned char>(type));
  }
  const vtkIdType cells = types->GetNumberOfValues();
  if (cells == 0)
  {
    return {};
  }
  const int cell = random.Integer(0, static_cast<int>(cells) - 1);
  switch (random.Integer(0, 3))
  {
    case 0:
      ids->SetValue(offsets->GetValue(cell),
        random.Pick<vtkIdType>(
          { -1, points, points + 1000, std::numeric_limits<vtkIdType>::max(), -(1LL << 40) }));
      break;
    case 1:
      offsets->SetValue(
        cell + 1, random.Pick<vtkIdType>({ -1, ids->GetNumberOfValues() + 1, 1LL << 50 }));
      break;
    case 2:
    {
      const vtkIdType size = offsets->GetValue(cell + 1) - offsets->GetValue(cell);
      if (size >= 20)
      {
        return {};
      }
      types->SetValue(cell,
        size >= 8 ? static_cast<unsigned char>(VTK_QUADRATIC_HEXAHEDRON)
                  : random.Pick<unsigned char>({ VTK_QUADRATIC_HEXAHEDRON, VTK_LAGRANGE_HEXAHEDRON,
                      VTK_BEZIER_HEXAHEDRON }));
      break;
    }
    default:
      types->SetNumberOfValues(cells - 1);
  }
  vtkNew<vtkCellArray> changed;
  changed->SetData(offsets, ids);
  grid->SetCells(types, changed);
  grid->GetCellData()->Initialize();
  return types->GetNumberOfValues() < cells ? "type" : "ell ";
}

/// Damages a dataset. Returns the text that the error message must contain, or an empty string if
/// nothing was damaged.
std::string Damage(FuzzRandom& random, vtkDataSet* data)
{
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    return DamageCells(random, grid);
  }
  const vtkIdType points = data->GetNumberOfPoints();
  if (auto* grid = vtkStructuredGrid::SafeDownCast(data))
  {
    const vtkIdType fewer = random.Integer(1, static_cast<int>(points) - 1);
    grid->GetPoints()->SetNumberOfPoints(fewer);
    ShortenArrays(grid, fewer);
    return "extent";
  }
  if (auto* grid = vtkRectilinearGrid::SafeDownCast(data))
  {
    vtkNew<vtkDoubleArray> none;
    random.Chance(0.5) ? grid->SetXCoordinates(none) : grid->SetZCoordinates(none);
    return "coordinate";
  }
  return {};
}

}

void RunDamage(FuzzRandom& random, std::string& text, reference::Check& check)
{
  FuzzData generated = MakeData(random);
  AddVectors(random, generated);
  if (generated.Data->GetNumberOfPoints() < 2)
  {
    return;
  }
  const auto data = vtkSmartPointer<vtkDataSet>::Take(generated.Data->NewInstance());
  data->DeepCopy(generated.Data);
  const std::string expected = Damage(random, data);
  text = generated.Text + ", damaged, message with " + expected;
  if (expected.empty())
  {
    return;
  }
  const std::function<vtkSmartPointer<vtkAlgorithm>()> makers[] = {
    [&data]() -> vtkSmartPointer<vtkAlgorithm>
    {
      auto filter = vtkSmartPointer<vtkIntervalVolume>::New();
      filter->SetInputData(data);
      filter->SetInterval(0, 0.2, 0.7);
      return filter;
    },
    [&data]() -> vtkSmartPointer<vtkAlgorithm>
    {
      auto filter = vtkSmartPointer<vtkIsotableContour>::New();
      filter->SetInputData(data);
      filter->SetValue(0, 0.5);
      return filter;
    },
    [&data]() -> vtkSmartPointer<vtkAlgorithm>
    {
      auto filter = vtkSmartPointer<vtkImplicitFlowField>::New();
      filter->SetInputData(data);
      filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "v");
      filter->DomainFacesOn();
      filter->SetMaximumNumberOfSteps(100);
      return filter;
    },
  };
  const std::string context[] = { "intervals", "contours", "flow" };
  for (int i = 0; i < 3; ++i)
  {
    const std::string message = CheckRun(makers[i], true, check);
    check.Contains(message, expected);
  }
}

}
