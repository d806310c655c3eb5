// SPDX-License-Identifier: BSD-3-Clause
#include "Support/TimeVarying/ReferenceSimplexGrid.h"

#include "Support/Checks/ReferenceMessages.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSimplexTimeSlice.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace reference
{

namespace
{

class KuhnGridBuilder
{
public:
  explicit KuhnGridBuilder(const KuhnOptions& options)
    : Options(options)
    , Random(options.Seed)
  {
    vtkIdType points = 1;
    for (int axis = 0; axis < 4; ++axis)
    {
      this->Steps[axis] = points;
      points *= options.Cells[axis] + 1;
    }
    this->Ids.resize(points);
    std::iota(this->Ids.begin(), this->Ids.end(), 0);
    std::shuffle(this->Ids.begin(), this->Ids.end(), this->Random);
    this->Events.resize(points);
    for (vtkIdType point = 0; point < points; ++point)
    {
      this->Events[this->Ids[point]] = this->MakeEvent(point);
    }
  }

  vtkSmartPointer<vtkUnstructuredGrid> Make()
  {
    const auto& cells = this->Options.Cells;
    for (int i = 0; i < cells[0] * cells[1] * cells[2] * cells[3]; ++i)
    {
      const std::array<int, 4> cell = { { i % cells[0], i / cells[0] % cells[1],
        i / (cells[0] * cells[1]) % cells[2], i / (cells[0] * cells[1] * cells[2]) } };
      if (!this->Options.IsRetained || this->Options.IsRetained(cell))
      {
        this->AddHypercube(cell);
      }
    }
    std::shuffle(this->Simplices.begin(), this->Simplices.end(), this->Random);
    return MakeSimplexGrid(this->Events, this->Simplices);
  }

private:
  Event MakeEvent(vtkIdType point)
  {
    std::uniform_real_distribution<double> move(-1.0, 1.0);
    Event event;
    for (int axis = 0; axis < 4; ++axis)
    {
      const int cells = this->Options.Cells[axis];
      const vtkIdType index = point / this->Steps[axis] % (cells + 1);
      const double maximum = axis == 3 ? this->Options.MovedInTime : this->Options.MovedInSpace;
      double moved = move(this->Random) * (index > 0 && index < cells ? maximum : 0.0);
      if (axis == 3 && this->Options.HasEqualTimes)
      {
        moved = std::trunc(8 * moved) / 8;
      }
      event[axis] = (static_cast<double>(index) + moved) / (axis == 3 ? 1 : cells);
    }
    return event;
  }

  void AddHypercube(const std::array<int, 4>& cell)
  {
    std::array<int, 4> axes = { { 0, 1, 2, 3 } };
    do
    {
      vtkIdType corner = 0;
      for (int axis = 0; axis < 4; ++axis)
      {
        corner += cell[axis] * this->Steps[axis];
      }
      SimplexIds ids;
      ids[0] = this->Ids[corner];
      for (int v = 0; v < 4; ++v)
      {
        corner += this->Steps[axes[v]];
        ids[v + 1] = this->Ids[corner];
      }
      std::shuffle(ids.begin(), ids.end(), this->Random);
      SimplexEvents events;
      std::transform(
        ids.begin(), ids.end(), events.begin(), [this](vtkIdType id) { return this->Events[id]; });
      if (Determinant(events) < 0)
      {
        std::swap(ids[0], ids[1]);
      }
      this->Simplices.push_back(ids);
    } while (std::next_permutation(axes.begin(), axes.end()));
  }

  const KuhnOptions& Options;
  std::mt19937 Random;
  std::array<vtkIdType, 4> Steps;
  std::vector<vtkIdType> Ids;
  std::vector<Event> Events;
  std::vector<SimplexIds> Simplices;
};

}

vtkSmartPointer<vtkUnstructuredGrid> MakeSimplexGrid(
  const std::vector<Event>& points, const std::vector<SimplexIds>& simplices)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> positions;
  positions->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> times;
  times->SetName("Time");
  for (const Event& point : points)
  {
    positions->InsertNextPoint(point.data());
    times->InsertNextValue(point[3]);
  }
  grid->SetPoints(positions);
  grid->GetPointData()->AddArray(times);
  vtkNew<vtkCellArray> cells;
  for (const SimplexIds& simplex : simplices)
  {
    cells->InsertNextCell(static_cast<vtkIdType>(simplex.size()), simplex.data());
  }
  grid->SetCells(VTK_POLY_VERTEX, cells);
  return grid;
}

SimplexIds GetSimplexIds(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  vtkIdType count;
  const vtkIdType* ids;
  grid->GetCellPoints(cell, count, ids);
  SimplexIds simplex;
  std::copy_n(ids, simplex.size(), simplex.begin());
  return simplex;
}

SimplexEvents GetSimplexEvents(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  const SimplexIds ids = GetSimplexIds(grid, cell);
  SimplexEvents events;
  for (size_t v = 0; v < ids.size(); ++v)
  {
    grid->GetPoint(ids[v], events[v].data());
    events[v][3] = grid->GetPointData()->GetArray("Time")->GetComponent(ids[v], 0);
  }
  return events;
}

long double Determinant(const SimplexEvents& simplex)
{
  std::array<int, 4> columns = { { 0, 1, 2, 3 } };
  long double sum = 0;
  do
  {
    long double product = 1;
    for (int row = 0; row < 4; ++row)
    {
      product *=
        static_cast<long double>(simplex[row + 1][columns[row]]) - simplex[0][columns[row]];
      for (int before = 0; before < row; ++before)
      {
        product = columns[before] > columns[row] ? -product : product;
      }
    }
    sum += product;
  } while (std::next_permutation(columns.begin(), columns.end()));
  return sum;
}

long double SliceVolume(const SimplexEvents& simplex, double t)
{
  long double difference = 0;
  for (size_t i = 0; i < simplex.size(); ++i)
  {
    const long double above = std::max(static_cast<long double>(simplex[i][3]) - t, 0.0L);
    long double term = above * above * above;
    for (size_t j = 0; j < simplex.size(); ++j)
    {
      term /= i == j ? 1.0L : static_cast<long double>(simplex[i][3]) - simplex[j][3];
    }
    difference += term;
  }
  const long double determinant = Determinant(simplex);
  return (determinant < 0 ? -determinant : determinant) / 24 * 4 * difference;
}

vtkSmartPointer<vtkUnstructuredGrid> MakeKuhnGrid(const KuhnOptions& options)
{
  return KuhnGridBuilder(options).Make();
}

vtkSmartPointer<vtkUnstructuredGrid> SliceAt(vtkUnstructuredGrid* simplices, double t)
{
  vtkNew<vtkSimplexTimeSlice> filter;
  filter->SetInputData(simplices);
  filter->SetTime(t);
  UpdateAndCheckWarnings(filter);
  return filter->GetOutput();
}

}
