// SPDX-License-Identifier: BSD-3-Clause
#include "Topology/ZeroSearch.h"

#include "Common/ArrayRows.h"
#include "Common/Batches.h"
#include "Common/Blanking.h"
#include "Common/Vectors.h"
#include "Topology/CellZeros.h"

#include "vtkAlgorithm.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPThreadLocalObject.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <utility>

namespace interlume
{

namespace
{
// Minimum interpolation weight of a point listed in Zero::Points. The largest weight is at least
// 1/8. All cells that contain a position on a shared face give the same weights to the points of
// that face.
constexpr double MinimumSharedWeight = 0.05;
// Distance from a face, in parametric coordinates, within which other cells may find the same zero.
constexpr double NearFace = 1e-4;
constexpr double NearPoint = 1e-6;

// Collects the speeds at visible points, and counts vectors that are not finite.
SpeedCount CountSpeeds(vtkDataSet* data, vtkDataArray* vectors)
{
  Blanking blanking;
  blanking.SetBlanking(data);
  ArrayRows rows;
  rows.Build(vectors);
  vtkSMPThreadLocal<SpeedCount> counts;
  vtkSMPTools::For(0, vectors->GetNumberOfTuples(),
    [&](vtkIdType first, vtkIdType last)
    {
      SpeedCount& count = counts.Local();
      for (vtkIdType point = first; point < last; ++point)
      {
        double v[3];
        rows.Get<3>(point, v);
        if (!blanking.IsPointBlanked(point))
        {
          count.Add(v);
        }
      }
    });
  SpeedCount all;
  for (const SpeedCount& count : counts)
  {
    all.Add(count);
  }
  return all;
}
}

class ZeroSearch::Worker
{
public:
  struct Local
  {
    std::vector<ZeroSearch::Zero> Zeros;
    std::vector<vtkIdType> Marks;
    ZeroSearch::Counts Counts;
    CellZeros Solver;
    std::vector<CellZeros::Zero> Found;
    MultilinearCell Cell;
  };

  Worker(vtkDataSet* data, vtkDataArray* vectors, const Systems& systems, const FillValues& fill)
    : Data(data)
    , Vectors(vectors)
    , Solved(systems)
    , Fill(fill)
  {
    this->Blanking.SetBlanking(data);
  }

  void operator()(vtkIdType first, vtkIdType last)
  {
    Local& local = this->Locals.Local();
    vtkIdList* ids = this->Ids.Local();
    for (vtkIdType cell = first; cell < last; ++cell)
    {
      if (this->Blanking.IsCellBlanked(cell) ||
        MultilinearCell::GetShape(this->Data->GetCellType(cell)) == MultilinearCell::NONE)
      {
        continue;
      }
      local.Cell.Load(this->Data, this->Vectors, cell, ids);
      if (this->HasHiddenPoint(local.Cell))
      {
        continue;
      }
      if (!local.Cell.IsFinite())
      {
        ++local.Counts.NonFiniteCells;
        continue;
      }
      if (this->Fill.Number > 0 && local.Cell.GetLargestSpeed() > this->Fill.Scale)
      {
        ++local.Counts.FillValueCells;
        continue;
      }
      int begin = 0;
      int end = 0;
      this->Solved.GetRange(local.Cell, begin, end);
      for (int system = begin; system < end; ++system)
      {
        this->Solve(system, local);
      }
    }
  }

  vtkSMPThreadLocal<Local> Locals;
  vtkSMPThreadLocalObject<vtkIdList> Ids;

private:
  bool HasHiddenPoint(const MultilinearCell& cell) const
  {
    bool isHidden = false;
    for (int i = 0; i < cell.GetNumberOfPoints(); ++i)
    {
      isHidden = isHidden || this->Blanking.IsPointBlanked(cell.GetPointId(i));
    }
    return isHidden;
  }

  void Solve(int system, Local& local) const
  {
    MultilinearCell::Values values;
    this->Solved.Evaluate(local.Cell, system, values);
    if (local.Solver.Find(local.Cell.GetShape(), values, local.Found))
    {
      for (const CellZeros::Zero& zero : local.Found)
      {
        local.Zeros.push_back(MakeZero(local.Cell, system, zero));
      }
      return;
    }
    const bool isZero =
      std::all_of(&values[0][0], &values[0][0] + 24, [](double value) { return value == 0.0; });
    ++(isZero ? local.Counts.ZeroCells : local.Counts.DegenerateCells);
    const int* corners = nullptr;
    const int number = MultilinearCell::GetCorners(local.Cell.GetShape(), corners);
    for (int i = 0; i < number; ++i)
    {
      const double* value = values[corners[i]];
      if (value[0] == 0.0 && value[1] == 0.0 && value[2] == 0.0)
      {
        local.Marks.push_back(local.Cell.GetPointId(i));
      }
    }
  }

  static Zero MakeZero(const MultilinearCell& cell, int system, const CellZeros::Zero& found)
  {
    Zero zero;
    zero.Cell = cell.GetCell();
    zero.System = system;
    const double* p = found.Parameters;
    MultilinearCell::Interpolate(cell.GetPositions(), p, zero.Position);
    MultilinearCell::Interpolate(cell.GetVectors(), p, zero.Velocity);
    zero.IsDegenerate = !cell.GetGradient(p, zero.Gradient) || found.IsDegenerate;
    zero.CellLength = cell.GetLength();
    const double largest = std::max(
      { std::abs(zero.Position[0]), std::abs(zero.Position[1]), std::abs(zero.Position[2]) });
    zero.Tolerance =
      found.Tolerance * cell.GetDiagonal() + 8.0 * std::numeric_limits<double>::epsilon() * largest;
    zero.IsShared = MultilinearCell::GetExcess(cell.GetShape(), p) > -NearFace;
    double weights[8];
    cell.GetWeights(p, weights);
    int order[8];
    const int number = cell.GetNumberOfPoints();
    std::iota(order, order + number, 0);
    std::stable_sort(
      order, order + number, [&weights](int a, int b) { return weights[a] > weights[b]; });
    std::fill_n(zero.Points, 8, -1);
    for (int i = 0; i < number && weights[order[i]] > MinimumSharedWeight; ++i)
    {
      zero.Points[i] = cell.GetPointId(order[i]);
    }
    zero.AtPoint = weights[order[0]] > 1.0 - NearPoint ? zero.Points[0] : -1;
    return zero;
  }

  vtkDataSet* Data;
  vtkDataArray* Vectors;
  const Systems& Solved;
  const FillValues& Fill;
  interlume::Blanking Blanking;
};

void ZeroSearch::Merge(const std::vector<unsigned char>& marks)
{
  // Indices into merged, by system and by each point in Zero::Points.
  std::map<std::pair<int, vtkIdType>, std::vector<std::size_t>> known;
  std::vector<Zero> merged;
  for (const Zero& zero : this->Zeros)
  {
    if (zero.AtPoint >= 0 && marks[zero.AtPoint])
    {
      continue;
    }
    if (zero.IsShared)
    {
      const auto isSame = [&](std::size_t i)
      {
        const double reach = std::max(zero.Tolerance, merged[i].Tolerance);
        return Vectors::SafeLength(Vectors::Difference(merged[i].Position, zero.Position)) <= reach;
      };
      const auto around = known.find({ zero.System, zero.Points[0] });
      if (around != known.end() &&
        std::any_of(around->second.begin(), around->second.end(), isSame))
      {
        continue;
      }
      for (int i = 0; i < 8 && zero.Points[i] >= 0; ++i)
      {
        known[{ zero.System, zero.Points[i] }].push_back(merged.size());
      }
    }
    merged.push_back(zero);
  }
  this->Zeros = std::move(merged);
}

void ZeroSearch::Warn(vtkAlgorithm* owner, const char* array) const
{
  const char* const effect = " cells with such points are skipped.";
  if (this->Total.FillValueCells > 0)
  {
    vtkWarningWithObjectMacro(
      owner, << this->Fill.Describe(array, std::to_string(this->Total.FillValueCells) + effect));
  }
  if (this->Total.NonFiniteCells > 0 && this->NonFinitePoints > 0)
  {
    vtkWarningWithObjectMacro(owner, << DescribeNonFinite(this->NonFinitePoints, array,
                                       std::to_string(this->Total.NonFiniteCells) + effect));
  }
}

bool ZeroSearch::Execute(
  vtkAlgorithm* owner, vtkDataSet* data, vtkDataArray* vectors, const Systems& systems)
{
  this->Zeros.clear();
  this->Total = Counts();
  const vtkIdType cells = data->GetNumberOfCells();
  const SpeedCount count = CountSpeeds(data, vectors);
  this->Fill = count.Speeds.FindFillValues();
  this->NonFinitePoints = count.NonFinite;
  Worker worker(data, vectors, systems, this->Fill);
  if (!Batches::Run(cells, owner, 0.0, 1.0, worker))
  {
    return false;
  }
  std::vector<unsigned char> marks(data->GetNumberOfPoints(), 0);
  for (const Worker::Local& local : worker.Locals)
  {
    this->Zeros.insert(this->Zeros.end(), local.Zeros.begin(), local.Zeros.end());
    for (const vtkIdType mark : local.Marks)
    {
      marks[mark] = 1;
    }
    this->Total.ZeroCells += local.Counts.ZeroCells;
    this->Total.DegenerateCells += local.Counts.DegenerateCells;
    this->Total.NonFiniteCells += local.Counts.NonFiniteCells;
    this->Total.FillValueCells += local.Counts.FillValueCells;
  }
  // A stable sort keeps the zeros of one cell and system in order.
  std::stable_sort(this->Zeros.begin(), this->Zeros.end(),
    [](const Zero& a, const Zero& b)
    { return a.System != b.System ? a.System < b.System : a.Cell < b.Cell; });
  this->Merge(marks);
  this->Warn(owner, vectors->GetName());
  return true;
}

}
