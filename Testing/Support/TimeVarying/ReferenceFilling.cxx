// SPDX-License-Identifier: BSD-3-Clause
#include "Support/TimeVarying/ReferenceFilling.h"

#include "Support/Meshes/ReferenceGrid.h"
#include "Support/TimeVarying/ReferenceSimplices.h"
#include "Support/TimeVarying/ReferenceSpaceTime.h"
#include "Support/TimeVarying/ReferenceTimeVarying.h"
#include "Support/TimeVarying/ReferenceWalls.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"
#include "vtkTimeVaryingIntervalVolume.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <iterator>
#include <map>

namespace reference
{

namespace
{

using Filter = vtkTimeVaryingIntervalVolume;

constexpr double VolumeTolerance = 1e-12;

/// The sorted point ids of each cell.
template <size_t N>
using Keys = std::vector<std::array<vtkIdType, N>>;

template <size_t N>
Keys<N> NetKeys(const std::vector<OrientedSimplex<N>>& simplices)
{
  Keys<N> keys;
  for (const SimplexUse<N>& use : CountUses(simplices))
  {
    if (use.Net() != 0)
    {
      keys.push_back(use.Key);
    }
  }
  return keys;
}

class FillingChecker
{
public:
  FillingChecker(const TimeSteps& steps, const std::vector<double>& bounds, bool generic,
    Check& check, FillingCounts& counts)
    : Steps(steps)
    , Bounds(bounds)
    , Generic(generic)
    , Test(check)
    , Counts(counts)
    , Walls(steps)
  {
    TimeVaryingSettings settings;
    for (size_t i = 0; i + 1 < bounds.size(); ++i)
    {
      settings.Intervals.push_back({ bounds[i], bounds[i + 1] });
    }
    this->Found = ExtractTimeVarying(steps, settings);
  }

  void Run()
  {
    if (!this->Test.That(
          IsValid(this->Found.Tetrahedra, VTK_TETRA), "port 0 consists of tetrahedra") ||
      !this->Test.That(AreFourSimplices(this->Found.Simplices), "port 2 consists of 4-simplices") ||
      !this->Test.That(this->Found.Simplices->GetNumberOfCells() > 0, "the output has 4-simplices"))
    {
      return;
    }
    vtkPointData* data = this->Found.Simplices->GetPointData();
    this->Times = data->GetArray("Time");
    this->Values =
      data->GetArray(GetDataSet(this->Steps.front())->GetPointData()->GetScalars()->GetName());
    if (!this->Test.That(
          this->Times && this->Values, "the output has the time and the scalar array"))
    {
      return;
    }
    this->CheckHypervolume();
    std::vector<Keys<4>> uppers;
    for (int i = 0; i + 1 < static_cast<int>(this->Bounds.size()); ++i)
    {
      this->CheckInterval(i);
      const Keys<4> lower = this->BoundaryKeys<4>(i, Filter::LOWER_SURFACE_IN_TIME);
      if (i > 0)
      {
        this->CheckShared(i, uppers.back(), lower);
      }
      uppers.push_back(this->BoundaryKeys<4>(i, Filter::UPPER_SURFACE_IN_TIME));
    }
  }

private:
  /// Checks that the lower boundary of interval \a i equals the upper boundary of interval i - 1.
  /// Unless Generic is set, unmatched cells are allowed on side walls and at the first and last
  /// step.
  void CheckShared(int i, const Keys<4>& upper, const Keys<4>& lower)
  {
    Keys<4> unmatched;
    std::set_symmetric_difference(
      upper.begin(), upper.end(), lower.begin(), lower.end(), std::back_inserter(unmatched));
    this->Test.Equal(std::count_if(unmatched.begin(), unmatched.end(),
                       [this](const auto& key) {
                         return this->Generic ||
                           (!this->Walls.Hold(this->EventsOf(key)) && !this->IsAtEnd(key));
                       }),
      0, "unmatched cells between interval " + std::to_string(i) + " and the interval below");
  }

  void CheckHypervolume()
  {
    const long double domain = DomainHypervolume(this->Steps);
    const HypervolumeSum simplices = MeasureSimplices(this->Found.Simplices);
    const HypervolumeSum weighted = MeasureWeightedTetrahedra(this->Found.Tetrahedra);
    this->Test.Near(static_cast<double>(simplices.Sum), static_cast<double>(domain),
      VolumeTolerance, "sum of the hypervolumes");
    this->Test.Near(static_cast<double>(weighted.Sum), static_cast<double>(domain), VolumeTolerance,
      "sum of the volumes times DeltaT");
    const auto error = [&](const HypervolumeSum& sum)
    { return static_cast<double>(std::abs(sum.Sum - domain) / domain); };
    this->Counts.Simplices += simplices.Count;
    this->Counts.Inverted += this->Found.Report->GetCount("InvertedSimplices");
    this->Counts.Tetrahedra += weighted.Count;
    this->Counts.Error = std::max(this->Counts.Error, error(simplices));
    this->Counts.WeightedError = std::max(this->Counts.WeightedError, error(weighted));
    ++this->Counts.Extractions;
  }

  void CheckInterval(int i)
  {
    const std::string name = "interval " + std::to_string(i) + ": ";
    const std::vector<FourSimplex> simplices = FourSimplicesOf(this->Found.Simplices, i);
    this->CheckLocations(i, name);
    const std::vector<OrientedSimplex<4>> faces = FacesOf(simplices);
    if (this->Generic)
    {
      const auto uses = CountUses(faces);
      this->Test.Equal(std::count_if(uses.begin(), uses.end(),
                         [](const SimplexUse<4>& use) { return use.Plus > 1 || use.Minus > 1; }),
        0, name + "faces used more than once with one orientation");
    }
    const Keys<4> net = NetKeys(faces);
    Keys<4> solids;
    for (int kind : { Filter::LOWER_SURFACE_IN_TIME, Filter::UPPER_SURFACE_IN_TIME,
           Filter::VOLUME_AT_START, Filter::VOLUME_AT_END })
    {
      const Keys<4> part = this->BoundaryKeys<4>(i, kind);
      solids.insert(solids.end(), part.begin(), part.end());
      this->CheckKind<4>(i, kind, name);
    }
    this->CheckClosed(net, solids, name + "boundary tetrahedra");
    const double steps[2] = { this->Steps.front().Time, this->Steps.back().Time };
    for (int end = 0; end < 2; ++end)
    {
      Keys<3> triangles;
      for (int kind :
        { Filter::LOWER_SURFACE_AT_START + 2 * end, Filter::UPPER_SURFACE_AT_START + 2 * end })
      {
        const Keys<3> part = this->BoundaryKeys<3>(i, kind);
        triangles.insert(triangles.end(), part.begin(), part.end());
        this->CheckKind<3>(i, kind, name);
      }
      const std::vector<Tetrahedron> volume =
        this->BoundaryCells<4>(i, Filter::VOLUME_AT_START + end);
      this->CheckClosed(NetKeys(FacesOf(volume)), triangles,
        name + "boundary triangles at time " + std::to_string(steps[end]));
    }
  }

  /// Checks that each unmatched face (\a net) is in \a boundary or lies in a side wall, and that
  /// \a boundary contains no other cells and no duplicates.
  template <size_t N>
  void CheckClosed(const Keys<N>& net, Keys<N> boundary, const std::string& name)
  {
    std::sort(boundary.begin(), boundary.end());
    Keys<N> open;
    Keys<N> extra;
    std::set_difference(
      net.begin(), net.end(), boundary.begin(), boundary.end(), std::back_inserter(open));
    std::set_difference(
      boundary.begin(), boundary.end(), net.begin(), net.end(), std::back_inserter(extra));
    const auto isInside = [&](const auto& key) { return !this->Walls.Hold(this->EventsOf(key)); };
    // At the first or last step, a region where all values equal a bound has boundary cells, even
    // if the interval is empty at all other times.
    this->Test.Equal(std::count_if(extra.begin(), extra.end(),
                       [this](const auto& key) { return N == 3 || !this->IsAtEnd(key); }),
      0, name + " that are not faces");
    this->Test.That(!this->Generic || extra.empty(), name + " are all faces");
    this->Test.Equal(std::count_if(open.begin(), open.end(), isInside), 0,
      name + ", open faces inside the domain without a boundary cell");
  }

  template <size_t N>
  std::vector<DomainWalls::Event> EventsOf(const std::array<vtkIdType, N>& ids) const
  {
    std::vector<DomainWalls::Event> events(N);
    for (size_t i = 0; i < N; ++i)
    {
      this->Found.Simplices->GetPoint(ids[i], events[i].X.data());
      events[i].Time = this->Times->GetComponent(ids[i], 0);
    }
    return events;
  }

  /// Returns whether all points are at the first step, or all at the last step.
  template <size_t N>
  bool IsAtEnd(const std::array<vtkIdType, N>& ids) const
  {
    const auto isAt = [&](double time)
    {
      return std::all_of(ids.begin(), ids.end(),
        [&](vtkIdType id) { return this->Times->GetComponent(id, 0) == time; });
    };
    return isAt(this->Steps.front().Time) || isAt(this->Steps.back().Time);
  }

  void CheckLocations(int i, const std::string& name)
  {
    const double tolerance = 1e-14 * (this->Bounds.back() - this->Bounds.front());
    long long values = 0;
    long long times = 0;
    for (int slab = 0; slab + 1 < static_cast<int>(this->Steps.size()); ++slab)
    {
      for (const FourSimplex& simplex : FourSimplicesOf(this->Found.Simplices, i, slab))
      {
        for (vtkIdType id : simplex)
        {
          const double value = this->Values->GetComponent(id, 0);
          const double time = this->Times->GetComponent(id, 0);
          values +=
            value < this->Bounds[i] - tolerance || value > this->Bounds[i + 1] + tolerance ? 1 : 0;
          times += time < this->Steps[slab].Time || time > this->Steps[slab + 1].Time ? 1 : 0;
        }
      }
    }
    this->Test.Equal(values, 0, name + "points of 4-simplices with values outside the interval");
    this->Test.Equal(times, 0, name + "points of 4-simplices with times outside the slab");
  }

  /// Returns whether the point may belong to a boundary cell of the given kind.
  bool IsOfKind(vtkIdType id, int interval, int kind) const
  {
    const double tolerance = 1e-14 * (this->Bounds.back() - this->Bounds.front());
    const double value = this->Values->GetComponent(id, 0);
    const double time = this->Times->GetComponent(id, 0);
    const bool isStart = time == this->Steps.front().Time;
    const bool isEnd = time == this->Steps.back().Time;
    const bool isLower = std::abs(value - this->Bounds[interval]) <= tolerance;
    const bool isUpper = std::abs(value - this->Bounds[interval + 1]) <= tolerance;
    switch (kind)
    {
      case Filter::LOWER_SURFACE_AT_START:
        return isStart && isLower;
      case Filter::UPPER_SURFACE_AT_START:
        return isStart && isUpper;
      case Filter::LOWER_SURFACE_AT_END:
        return isEnd && isLower;
      case Filter::UPPER_SURFACE_AT_END:
        return isEnd && isUpper;
      case Filter::LOWER_SURFACE_IN_TIME:
        return isLower;
      case Filter::UPPER_SURFACE_IN_TIME:
        return isUpper;
      case Filter::VOLUME_AT_START:
        return isStart;
      default:
        return isEnd;
    }
  }

  template <size_t N>
  void CheckKind(int interval, int kind, const std::string& name)
  {
    long long errors = 0;
    for (const auto& cell : this->BoundaryCells<N>(interval, kind))
    {
      errors += std::all_of(cell.begin(), cell.end(),
                  [&](vtkIdType id) { return this->IsOfKind(id, interval, kind); })
        ? 0
        : 1;
    }
    this->Test.Equal(
      errors, 0, name + "cells that do not match their kind " + std::to_string(kind));
    const Keys<N> keys = this->BoundaryKeys<N>(interval, kind);
    this->Test.That(std::adjacent_find(keys.begin(), keys.end()) == keys.end(),
      name + "cells of kind " + std::to_string(kind) + " occur once");
  }

  template <size_t N>
  std::vector<std::array<vtkIdType, N>> BoundaryCells(int interval, int kind) const
  {
    return BoundaryCellsOf<N>(this->Found.Boundaries, interval, kind);
  }

  template <size_t N>
  Keys<N> BoundaryKeys(int interval, int kind) const
  {
    Keys<N> keys;
    for (const auto& cell : this->BoundaryCells<N>(interval, kind))
    {
      keys.push_back(OrientedSimplex<N>(cell).Key);
    }
    std::sort(keys.begin(), keys.end());
    return keys;
  }

  const TimeSteps& Steps;
  const std::vector<double>& Bounds;
  bool Generic;
  Check& Test;
  FillingCounts& Counts;
  DomainWalls Walls;
  TimeVaryingExtraction Found;
  vtkDataArray* Times = nullptr;
  vtkDataArray* Values = nullptr;
};

}

void CheckFilling(const TimeSteps& steps, const std::vector<double>& bounds, bool generic,
  Check& check, FillingCounts& counts)
{
  FillingChecker(steps, bounds, generic, check, counts).Run();
}

void Print(const FillingCounts& counts, const std::string& name)
{
  std::cout << name << ": " << counts.Extractions << " extractions, " << counts.Simplices
            << " 4-simplices, " << counts.Inverted << " inverted, " << counts.Tetrahedra
            << " tetrahedra, hypervolume error " << counts.Error << ", weighted "
            << counts.WeightedError << '\n';
}

}
