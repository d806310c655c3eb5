// SPDX-License-Identifier: BSD-3-Clause
// The slice of a random 4-simplex has the volume of its M-spline, has the orientation of the
// simplex, and has no overlap. The integral of the volume over time is the hypervolume.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Meshes/ReferenceVolume.h"
#include "Support/TimeVarying/ReferenceSimplexGrid.h"

#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace
{

using namespace reference;
using Position = std::array<long double, 3>;
using Corners = std::array<Position, 4>;

constexpr vtkIdType NumberOfSimplices = 6000;

/// Returns simplices that share no points, each with its points in random order. The cell array
/// `simplex` stores the index of each simplex.
vtkSmartPointer<vtkUnstructuredGrid> MakeRandomSimplices(unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<Event> points(5 * NumberOfSimplices);
  for (Event& point : points)
  {
    std::generate(point.begin(), point.end(), [&] { return uniform(random); });
  }
  std::vector<SimplexIds> simplices(NumberOfSimplices);
  vtkNew<vtkIdTypeArray> numbers;
  numbers->SetName("simplex");
  for (vtkIdType s = 0; s < NumberOfSimplices; ++s)
  {
    simplices[s] = { { 5 * s, 5 * s + 1, 5 * s + 2, 5 * s + 3, 5 * s + 4 } };
    std::shuffle(simplices[s].begin(), simplices[s].end(), random);
    numbers->InsertNextValue(s);
  }
  auto grid = MakeSimplexGrid(points, simplices);
  grid->GetCellData()->AddArray(numbers);
  return grid;
}

/// Groups the tetrahedra of a slice by 4-simplex.
std::vector<std::vector<Corners>> GroupBySimplex(vtkUnstructuredGrid* slice)
{
  std::vector<std::vector<Corners>> groups(NumberOfSimplices);
  vtkDataArray* numbers = slice->GetCellData()->GetArray("simplex");
  for (vtkIdType cell = 0; cell < slice->GetNumberOfCells(); ++cell)
  {
    vtkIdType count;
    const vtkIdType* ids;
    slice->GetCellPoints(cell, count, ids);
    Corners corners;
    for (int v = 0; v < 4; ++v)
    {
      double x[3];
      slice->GetPoint(ids[v], x);
      std::copy_n(x, 3, corners[v].begin());
    }
    groups[static_cast<size_t>(numbers->GetComponent(cell, 0))].push_back(corners);
  }
  return groups;
}

long double SignedVolume(const Corners& c)
{
  return Determinant(c[0], c[1], c[2], c[3]) / 6;
}

bool Holds(const Corners& corners, const Position& point)
{
  const bool isPositive = SignedVolume(corners) > 0;
  for (int v = 0; v < 4; ++v)
  {
    Corners moved = corners;
    moved[v] = point;
    if ((SignedVolume(moved) > 0) != isPositive)
    {
      return false;
    }
  }
  return true;
}

/// Returns a random point of the slice: a random weighted mean of the points where the simplex's
/// edges intersect the slice.
Position PickPoint(const SimplexEvents& simplex, double t, std::mt19937& random)
{
  std::uniform_real_distribution<long double> uniform(0.0L, 1.0L);
  Position picked{};
  long double sum = 0;
  for (const Event& a : simplex)
  {
    for (const Event& b : simplex)
    {
      if (a[3] < t && t < b[3])
      {
        const long double along = (t - static_cast<long double>(a[3])) / (b[3] - a[3]);
        const long double weight = uniform(random);
        for (int axis = 0; axis < 3; ++axis)
        {
          picked[axis] += weight * (a[axis] + along * (b[axis] - a[axis]));
        }
        sum += weight;
      }
    }
  }
  std::for_each(picked.begin(), picked.end(), [sum](long double& x) { x /= sum; });
  return picked;
}

/// Checks the slices at time \a t. Adds the key of each case that occurs to \a cases. Bit i of a
/// key is set if the time of vertex i is at least \a t.
void CheckSlices(vtkUnstructuredGrid* simplices, double t, std::set<int>& cases, Check& check)
{
  check.SetContext("t = " + std::to_string(t));
  const auto groups = GroupBySimplex(SliceAt(simplices, t));
  std::mt19937 random(7);
  for (vtkIdType s = 0; s < NumberOfSimplices; ++s)
  {
    const SimplexEvents simplex = GetSimplexEvents(simplices, s);
    const SimplexIds ids = GetSimplexIds(simplices, s);
    int key = 0;
    for (int v = 0; v < 5; ++v)
    {
      key += (simplex[v][3] >= t ? 1 : 0) << (ids[v] - 5 * s);
    }
    cases.insert(key);
    const int sign = Determinant(simplex) > 0 ? 1 : -1;
    long double volume = 0;
    for (const Corners& corners : groups[s])
    {
      const long double part = sign * SignedVolume(corners);
      check.That(part > -1e-16L, "a tetrahedron has the orientation of its 4-simplex");
      volume += part;
    }
    // The M-spline that yields the expected volume is inaccurate if two times are close to each
    // other.
    check.Near(static_cast<double>(volume), static_cast<double>(SliceVolume(simplex, t)), 1e-12,
      "volume of simplex " + std::to_string(s), 1.0);
    if (!groups[s].empty())
    {
      const Position point = PickPoint(simplex, t, random);
      check.Equal(std::count_if(groups[s].begin(), groups[s].end(),
                    [&point](const Corners& corners) { return Holds(corners, point); }),
        1, "tetrahedra around a point of the slice");
    }
  }
}

/// Between two vertex times, the volume of the slice is a cubic polynomial of time. Two Gauss
/// points integrate it exactly.
void CheckHypervolume(unsigned int seed, Check& check)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<Event> points(5);
  std::vector<double> times;
  for (Event& point : points)
  {
    std::generate(point.begin(), point.end(), [&] { return uniform(random); });
    times.push_back(point[3]);
  }
  auto grid = MakeSimplexGrid(points, { { { 2, 0, 4, 1, 3 } } });
  std::sort(times.begin(), times.end());
  long double sum = 0;
  for (size_t i = 0; i + 1 < times.size(); ++i)
  {
    const double half = (times[i + 1] - times[i]) / 2;
    for (const double side : { -1.0, 1.0 })
    {
      const double t = times[i] + half * (1.0 + side / std::sqrt(3.0));
      sum += half * MeasureTetrahedra(SliceAt(grid, t)).Sum;
    }
  }
  const long double hypervolume = Determinant(GetSimplexEvents(grid, 0)) / 24;
  check.Near(static_cast<double>(sum), static_cast<double>(hypervolume), 1e-12,
    "integral of the slices", 1e-3);
}

}

int TestSimplexTimeSliceVolume(int, char*[])
{
  Check check;
  std::set<int> cases;
  for (const double t : { 0.2, 0.5, 0.71 })
  {
    CheckSlices(MakeRandomSimplices(static_cast<unsigned int>(1000 * t)), t, cases, check);
  }
  check.Equal(static_cast<long long>(cases.size()), 32, "number of cases that occur");
  for (unsigned int seed = 1; seed <= 50; ++seed)
  {
    check.SetContext("seed " + std::to_string(seed));
    CheckHypervolume(seed, check);
  }
  return check.Result();
}
