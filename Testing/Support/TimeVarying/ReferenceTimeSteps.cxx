// SPDX-License-Identifier: BSD-3-Clause
#include "Support/TimeVarying/ReferenceTimeSteps.h"

#include "Support/Meshes/ReferenceLattice.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/Meshes/ReferenceTransform.h"
#include "Support/Meshes/ReferenceVolume.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <random>
#include <stdexcept>

namespace reference
{

namespace
{

using Point = std::array<double, 3>;

void ChangePoints(const TimeStep& step, const std::function<void(vtkIdType, Point&)>& change)
{
  auto* grid = vtkPointSet::SafeDownCast(step.Data);
  if (!grid)
  {
    throw std::invalid_argument("only the points of a vtkPointSet can be moved");
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(grid->GetNumberOfPoints());
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    Point x;
    grid->GetPoint(i, x.data());
    change(i, x);
    points->SetPoint(i, x.data());
  }
  grid->SetPoints(points);
}

}

vtkDataSet* GetDataSet(const TimeStep& step)
{
  return vtkDataSet::SafeDownCast(step.Data);
}

TimeSteps RepeatGrid(vtkDataSet* grid, const std::vector<double>& times)
{
  TimeSteps steps;
  for (double time : times)
  {
    vtkSmartPointer<vtkDataSet> copy;
    copy.TakeReference(grid->NewInstance());
    copy->CopyStructure(grid);
    copy->GetPointData()->DeepCopy(grid->GetPointData());
    copy->GetCellData()->DeepCopy(grid->GetCellData());
    steps.push_back({ time, copy });
    if (vtkPointSet::SafeDownCast(copy))
    {
      ChangePoints(steps.back(), [](vtkIdType, Point&) {});
    }
  }
  return steps;
}

void AddSpaceTimeField(const TimeSteps& steps, const SpaceTimeFunction& function, const char* name)
{
  for (const TimeStep& step : steps)
  {
    vtkDataSet* data = GetDataSet(step);
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfTuples(data->GetNumberOfPoints());
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    {
      Point x;
      data->GetPoint(i, x.data());
      array->SetValue(i, function(x, step.Time, i));
    }
    data->GetPointData()->AddArray(array);
    data->GetPointData()->SetActiveScalars(name);
  }
}

void AddRandomTimeField(const TimeSteps& steps, unsigned int seed, const char* name)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  AddSpaceTimeField(
    steps, [&](const Point&, double, vtkIdType) { return uniform(random); }, name);
}

void AddIntegerTimeField(const TimeSteps& steps, int values, unsigned int seed, const char* name)
{
  std::mt19937 random(seed);
  AddSpaceTimeField(
    steps, [&](const Point&, double, vtkIdType) { return static_cast<double>(random() % values); },
    name);
}

void AddDriftingField(const TimeSteps& steps, double rate, unsigned int seed, const char* name)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<double> start(GetDataSet(steps.front())->GetNumberOfPoints());
  for (double& value : start)
  {
    value = uniform(random);
  }
  AddSpaceTimeField(
    steps, [&](const Point&, double time, vtkIdType point) { return start[point] + rate * time; },
    name);
}

void MovePoints(const TimeSteps& steps, const Motion& motion)
{
  for (const TimeStep& step : steps)
  {
    ChangePoints(step, [&](vtkIdType, Point& x) { motion(x, step.Time); });
  }
}

void Stretch(std::array<double, 3>& x, double time)
{
  x[0] = x[0] * (1 + 0.31 * time) - 0.4 * time;
  x[1] = x[1] * (1 - 0.13 * time) + 0.7 * time;
  x[2] = x[2] * (1 + 0.07 * time);
}

void PerturbInteriorPoints(const TimeSteps& steps, double reach, unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> amount(-reach, reach);
  bool moved = false;
  for (const TimeStep& step : steps)
  {
    double box[6];
    GetDataSet(step)->GetBounds(box);
    ChangePoints(step,
      [&](vtkIdType, Point& x)
      {
        const Point by = { amount(random), amount(random), amount(random) };
        for (int a = 0; a < 3; ++a)
        {
          if (x[a] == box[2 * a] || x[a] == box[2 * a + 1])
          {
            return;
          }
        }
        moved = true;
        for (int a = 0; a < 3; ++a)
        {
          x[a] += by[a];
        }
      });
  }
  if (!moved)
  {
    throw std::invalid_argument("no point is inside the bounding box");
  }
}

std::vector<NamedGrid> MakeAllGridTypes(const std::array<int, 3>& cells, unsigned int seed)
{
  std::vector<NamedGrid> grids;
  for (const DataSetVariant& form : FormsOf(MakeImage(cells)))
  {
    if (!vtkUnstructuredGrid::SafeDownCast(form.Data))
    {
      grids.push_back({ form.Name, form.Data });
    }
  }
  for (MeshKind kind : AllMeshKinds())
  {
    grids.push_back({ GetName(kind),
      RenumberPoints(RotateCellPointOrder(MakeMesh(kind, cells, seed), seed), seed) });
  }
  return grids;
}

bool IsTetrahedral(vtkDataSet* data)
{
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    if (data->GetCellType(cell) != VTK_TETRA)
    {
      return false;
    }
  }
  return true;
}

bool HasBoxDomain(vtkDataSet* data)
{
  double box[6];
  data->GetBounds(box);
  const double volume = (box[1] - box[0]) * (box[3] - box[2]) * (box[5] - box[4]);
  return std::abs(static_cast<double>(MeshVolume(data)) - volume) <= 1e-9 * volume;
}

}
