// SPDX-License-Identifier: BSD-3-Clause
// Single 4-simplices: their tetrahedra have the hypervolume of the simplex, share one thick point,
// and are as many as their class requires. Also tests which classes occur for projections along
// time and in other directions.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/TimeVarying/ReferenceSimplices.h"
#include "Support/TimeVarying/ReferenceTimeVarying.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkTimeVaryingIntervalVolume.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>

namespace
{

using namespace reference;

using Filter = vtkTimeVaryingIntervalVolume;

const std::vector<int> Classes = { Filter::CLASS_1, Filter::CLASS_2, Filter::CLASS_3A,
  Filter::CLASS_3B, Filter::CLASS_4, Filter::CLASS_5 };
const std::map<int, long long> TetrahedraOfClass = { { Filter::CLASS_1, 6 }, { Filter::CLASS_2, 4 },
  { Filter::CLASS_3A, 4 }, { Filter::CLASS_3B, 3 }, { Filter::CLASS_4, 2 },
  { Filter::CLASS_5, 1 } };

struct Counts
{
  std::map<int, long long> Simplices;
  long long Flat = 0;
  double Error = 0;
};

/// Sorts hypervolumes in descending order.
void Sort(std::vector<long double>& hypervolumes)
{
  std::sort(hypervolumes.begin(), hypervolumes.end(), std::greater<>());
}

void CheckGroups(const TimeVaryingExtraction& found, double size, Counts& counts, Check& check)
{
  std::vector<long double> projected;
  std::map<int, long long> tetrahedra;
  long long wrong = 0;
  long long thin = 0;
  for (const auto& group : GroupByThickPoint(WeightedTetrahedraOf(found.Tetrahedra)))
  {
    const int simplexClass = group.front().Class;
    long double sum = 0;
    for (const WeightedTetrahedron& tetrahedron : group)
    {
      wrong += tetrahedron.Class != simplexClass ? 1 : 0;
      thin += tetrahedron.ThickPoints != 1 ? 1 : 0;
      sum += tetrahedron.Hypervolume;
    }
    const auto expected = TetrahedraOfClass.find(simplexClass);
    wrong += expected == TetrahedraOfClass.end() ||
        expected->second != static_cast<long long>(group.size())
      ? 1
      : 0;
    tetrahedra[simplexClass] += static_cast<long long>(group.size());
    ++counts.Simplices[simplexClass];
    projected.push_back(sum);
  }
  check.Equal(thin, 0, "tetrahedra without exactly one thick point");
  check.Equal(wrong, 0, "tetrahedra that do not match one class");
  std::vector<long double> expected;
  long long inverted = 0;
  for (const FourSimplex& simplex : FourSimplicesOf(found.Simplices))
  {
    expected.push_back(HypervolumeOf(found.Simplices, simplex));
    inverted += expected.back() < -1e-15L * size ? 1 : 0;
  }
  check.Equal(found.Report->GetCount("Simplices"), static_cast<long long>(expected.size()),
    "4-simplices reported");
  check.Equal(found.Report->GetCount("Simplices") - found.Report->GetCount("FlatSimplices"),
    static_cast<long long>(projected.size()), "non-degenerate 4-simplices reported");
  check.That(
    found.Report->GetNumber("InvertedSimplices") >= inverted, "inverted 4-simplices reported");
  for (size_t i = 0; i < Classes.size(); ++i)
  {
    check.Equal(found.Report->GetCount("Tetrahedra", static_cast<vtkIdType>(i)),
      tetrahedra[Classes[i]], "tetrahedra reported of class " + std::to_string(Classes[i]));
  }
  counts.Flat += found.Report->GetCount("FlatSimplices");
  // The hypervolumes of the 4-simplices equal those of the groups of projected tetrahedra. Skipped
  // 4-simplices are degenerate and have no group.
  if (!check.That(projected.size() <= expected.size(), "at most as many groups as 4-simplices"))
  {
    return;
  }
  projected.resize(expected.size(), 0);
  Sort(projected);
  Sort(expected);
  double worst = 0;
  for (size_t i = 0; i < expected.size(); ++i)
  {
    worst = std::max(worst,
      static_cast<double>(
        (std::abs(expected[i] - projected[i]) - 1e-12L * std::abs(expected[i])) / size));
  }
  check.Near(worst, 0, 1e-15, "relative errors of hypervolumes above 1e-12", 1);
  counts.Error = std::max(counts.Error, worst);
}

double SizeOf(const TimeSteps& steps)
{
  return std::pow(GetDataSet(steps.front())->GetLength(), 3) *
    (steps.back().Time - steps.front().Time);
}

Counts CheckSteps(const TimeSteps& steps, const std::array<double, 4>& direction, Check& check)
{
  Counts counts;
  for (unsigned int seed = 1; seed <= 4; ++seed)
  {
    AddRandomTimeField(steps, seed);
    CheckGroups(ExtractTimeVarying(steps, { { { 0.3, 0.5 }, { 0.5, 0.9 } }, direction }),
      SizeOf(steps), counts, check);
    AddIntegerTimeField(steps, 3, seed);
    CheckGroups(ExtractTimeVarying(steps, { { { 0, 1 }, { 1, 1.5 }, { 1.5, 2 } }, direction }),
      SizeOf(steps), counts, check);
  }
  return counts;
}

void Print(const Counts& counts, const std::string& name)
{
  std::cout << name << ":";
  for (const auto& [simplexClass, count] : counts.Simplices)
  {
    std::cout << " class " << simplexClass << ' ' << count << ',';
  }
  std::cout << " degenerate " << counts.Flat << ", error " << counts.Error << '\n';
}

}

int TestTimeVaryingTetrahedra(int, char*[])
{
  Check check;
  const std::array<double, 4> alongTime = { 0, 0, 0, 1 };
  const std::array<double, 4> across = { 1, 1, 1, 1 };
  for (const std::array<int, 3>& cells : { std::array<int, 3>{ 1, 1, 1 }, { 2, 2, 2 } })
  {
    for (const NamedGrid& grid : MakeAllGridTypes(cells, 7))
    {
      const std::string name = grid.Name + ", " + std::to_string(cells[0]) + " cells per axis";
      check.SetContext(name + ", along time");
      const TimeSteps standing = RepeatGrid(grid.Data, { 0.5, 2 });
      const Counts along = CheckSteps(standing, alongTime, check);
      Print(along, name + ", along time");
      if (grid.Name == "image" || grid.Name == "rectilinear")
      {
        check.Equal(along.Simplices.count(Filter::CLASS_2), 0, "kinds of class 2");
      }
      check.SetContext(name + ", other direction");
      Counts turned = CheckSteps(standing, across, check);
      Print(turned, name + ", other direction");
      if (grid.Name == "image" || grid.Name == "rectilinear")
      {
        check.That(turned.Simplices[Filter::CLASS_2] > 0, "class 2 occurs");
      }
      if (cells[0] > 1 && vtkPointSet::SafeDownCast(grid.Data) && HasBoxDomain(grid.Data))
      {
        const TimeSteps moving = RepeatGrid(grid.Data, { 0.5, 2 });
        PerturbInteriorPoints(moving, 0.02 * grid.Data->GetLength(), 5);
        MovePoints(moving, Stretch);
        check.SetContext(name + ", moving");
        Counts moved = CheckSteps(moving, alongTime, check);
        check.That(moved.Simplices[Filter::CLASS_2] > 0, "class 2 occurs");
        Print(moved, name + ", moving");
      }
    }
  }
  return check.Result();
}
