// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TimeVaryingMesh_h
#define interlume_TimeVaryingMesh_h

#include "Output/CrossingKey.h"
#include "Output/ExtractionBuffer.h"
#include "Pass/ExtractionContext.h"
#include "TimeVarying/SimplexProjection.h"
#include "TimeVarying/TimeVaryingOptions.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace interlume
{

class CrossingLists;
class TimeStep;

/**
 * @class   TimeVaryingMesh
 * @brief   the 4-simplices of one dataset over all slabs, their points and their boundary
 *
 * A point is a place in space, a time, and the arrays of the input. Points that a slab shares with
 * the one before it are found by walking along both lists, which are sorted alike.
 */
class TimeVaryingMesh
{
public:
  using Simplex = std::array<vtkIdType, 5>;

  /// The 4-simplices of one slab.
  struct Slab
  {
    int Number = 0;
    ExtractionBuffer<Simplex> Simplices;
    /// The interval of each 4-simplex; empty where there is only one.
    ExtractionBuffer<int> Items;
    /// The sides of each 4-simplex that are known to be flat, see SimplexProjection; empty where no
    /// projection is asked for.
    ExtractionBuffer<std::uint8_t> Flats;
    /// Of each whether values equal a bound in its cell; empty where 4-simplices are not asked for.
    ExtractionBuffer<std::uint8_t> Ties;
    /// Of each whether its cell is another piece's; empty where no such cell is extracted.
    ExtractionBuffer<std::uint8_t> Duplicates;

    int GetItem(vtkIdType simplex) const
    {
      return this->Items.GetSize() > 0 ? this->Items[simplex] : 0;
    }
  };

  /// A triangle, with a last id of -1, or a tetrahedron on the boundary.
  struct BoundaryCell
  {
    std::array<vtkIdType, 4> Ids;
    int Kind;
    int Item;
    int Slab;
    /// Whether values equal a bound there, so that the cell may cancel another or bound nothing.
    bool IsTied;
    /// Whether it comes of another piece's cell.
    bool IsDuplicate;
  };

  explicit TimeVaryingMesh(const TimeVaryingOptions& options)
    : Options(options)
  {
  }

  const TimeVaryingOptions& GetOptions() const { return this->Options; }

  /// Begins a slab. Boundaries at the start and end are in the first and last one only. Points are
  /// shared with the slab before where that ends at the step at which this one begins. \a hasTies
  /// tells whether a value equals a bound.
  void BeginSlab(int number, bool isFirst, bool isLast, bool isJoined, bool hasTies);

  /// Returns whether boundary cells of a kind are asked for, or needed to settle others, and can be
  /// in this slab.
  bool IsWanted(int kind) const { return this->WantedKinds[kind]; }
  bool HasWantedKinds() const;
  /// The same of a cell where values equal a bound, of which the volume at both steps is needed.
  bool IsWantedOfTied(int kind) const
  {
    return this->IsWanted(kind) || (this->Options.Settings.GenerateSimplices && IsVolume(kind));
  }
  static bool IsVolume(int kind)
  {
    return kind == vtkTimeVaryingSettings::VOLUME_AT_START ||
      kind == vtkTimeVaryingSettings::VOLUME_AT_END;
  }

  /**
   * Takes over the points of the slab and gives the id of each. \a points and \a lists are as
   * CrossingLists makes them; \a isStatic tells that the points of the grid stay in place.
   */
  ExtractionBuffer<vtkIdType> AddPoints(const TimeStep& first, const TimeStep& second,
    const ExtractionBuffer<ExtractionPoint>& points, const CrossingLists& lists, bool isStatic);

  /// Adds boundary cells of the slab, and fills in the number of the slab.
  void AddBoundary(const std::vector<BoundaryCell>& cells);

  /// Adds parts of the volume at the two steps of the slab, of cells where values equal a bound.
  void AddStepVolume(const std::vector<BoundaryCell>& cells);

  /// Removes pairs of 4-simplices of the slab, out of those in \a tied, that have the same points
  /// and opposite orientation. Returns how many are removed.
  vtkIdType RemoveOppositeSimplices(const std::vector<vtkIdType>& tied);

  /// The same of 4-simplices that lie in a step, of the slab before it and the one after; only
  /// where 4-simplices are asked for.
  vtkIdType RemoveOppositeAtSteps();

  /**
   * Settles boundary cells where values equal a bound, once all slabs are there. Pairs with the
   * same points and opposite orientation go. Among the others, tetrahedra in time stay where they
   * are faces of 4-simplices, counted with their orientation, and triangles where they are faces of
   * the volume at their step.
   */
  void SettleTiedBoundary();

  /// Leaves each part of the volume at a step once, where two slabs have it, and takes away pairs
  /// of opposite orientation.
  void SettleStepVolume();

  /// Leaves out what comes of other pieces' cells, once all else is settled, and points that only
  /// they use. Returns how many 4-simplices are removed.
  vtkIdType RemoveDuplicates();

  /// The slab begun last.
  Slab& GetSlab() { return this->Slabs.back(); }

  ///@{
  /**
   * Return the points and their arrays; null where there is nothing.
   */
  vtkPoints* GetPoints() const { return this->Points; }
  vtkDoubleArray* GetTimes() const { return this->Times; }
  ///@}
  vtkPointData* GetArrays() const { return this->Arrays; }
  const std::vector<Slab>& GetSlabs() const { return this->Slabs; }
  const std::vector<BoundaryCell>& GetBoundary() const { return this->Boundary; }
  const std::vector<BoundaryCell>& GetStepVolume() const { return this->StepVolume; }

  /// Returns the keys (ArrayMatch) of point arrays that were left out since a step lacks them.
  const std::vector<std::string>& GetArraysLeftOut() const { return this->ArraysLeftOut; }

  std::size_t GetBytes() const;

  /// Returns a point as it is projected, the coordinate along the projection last.
  SimplexProjection::Point GetProjected(vtkIdType id) const
  {
    return this->Floats ? this->GetProjected(this->Floats, id)
                        : this->GetProjected(this->Doubles, id);
  }

  /// Finds the corners of some simplices as they are projected.
  void GetProjected(const Simplex* simplices, int number, SimplexProjection::Corners* corners) const
  {
    this->Floats ? this->GetProjected(this->Floats, simplices, number, corners)
                 : this->GetProjected(this->Doubles, simplices, number, corners);
  }

private:
  // A point at the end of a slab: its origin, and its id.
  struct SharedPoint
  {
    vtkIdType Owner;
    CrossingKey Key;
    vtkIdType Id;

    bool IsBefore(const SharedPoint& other) const
    {
      return this->Owner < other.Owner || (this->Owner == other.Owner && this->Key < other.Key);
    }
  };

  template <typename Coordinate>
  SimplexProjection::Point GetProjected(const Coordinate* coordinates, vtkIdType id) const
  {
    SimplexProjection::Point x = { { coordinates[3 * id], coordinates[3 * id + 1],
      coordinates[3 * id + 2], this->Times->GetValue(id) } };
    if (!this->Options.IsAlongTime())
    {
      this->Options.Project(x.data());
    }
    return x;
  }
  template <typename Coordinate>
  void GetProjected(const Coordinate* coordinates, const Simplex* simplices, int number,
    SimplexProjection::Corners* corners) const
  {
    for (int s = 0; s < number; ++s)
    {
      for (int p = 0; p < SimplexProjection::NumberOfPoints; ++p)
      {
        corners[s][p] = this->GetProjected(coordinates, simplices[s][p]);
      }
    }
  }

  // Notes the points at the second step, for the next slab.
  void FindEndPoints(const ExtractionBuffer<ExtractionPoint>& points, const CrossingLists& lists,
    vtkIdType split, const ExtractionBuffer<vtkIdType>& ids);

  void AppendPoints(const TimeStep& first, const TimeStep& second,
    const ExtractionBuffer<ExtractionPoint>& points, bool isStatic);
  void AppendArrays(vtkPointData* more);
  bool IsAtOneTime(const Simplex& simplex) const;
  void RemoveUnusedPoints();
  void FindCoordinates();

  TimeVaryingOptions Options;
  std::array<bool, vtkTimeVaryingSettings::NUMBER_OF_BOUNDARY_KINDS> WantedKinds{};
  vtkSmartPointer<vtkPoints> Points;
  // The coordinates, as floats or as doubles.
  const float* Floats = nullptr;
  const double* Doubles = nullptr;
  vtkSmartPointer<vtkDoubleArray> Times;
  vtkNew<vtkPointData> Arrays;
  std::vector<std::string> ArraysLeftOut;
  bool IsLast = true;
  bool HasTies = false;
  std::vector<SharedPoint> EndPoints;
  std::vector<Slab> Slabs;
  std::vector<BoundaryCell> Boundary;
  std::vector<BoundaryCell> StepVolume;
};

}

#endif
