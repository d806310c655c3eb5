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
 * @brief   the 4-simplices of a dataset over all slabs, with their points and boundary
 *
 * A point has a position, a time and the arrays of the input. Adjacent slabs share the points at
 * their common step. The shared points are found by merging the two point lists, which have the
 * same order.
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
    /// The interval of each 4-simplex. Empty if there is one interval.
    ExtractionBuffer<int> Items;
    /// The degenerate facets of each 4-simplex (see SimplexProjection). Empty if no projection is
    /// requested.
    ExtractionBuffer<std::uint8_t> Flats;
    /// For each 4-simplex, 1 if values equal a bound in its cell. Empty if 4-simplices are not
    /// requested.
    ExtractionBuffer<std::uint8_t> Ties;
    /// For each 4-simplex, 1 if its cell belongs to another piece. Empty if no such cell was
    /// extracted.
    ExtractionBuffer<std::uint8_t> Duplicates;

    int GetItem(vtkIdType simplex) const
    {
      return this->Items.GetSize() > 0 ? this->Items[simplex] : 0;
    }
  };

  /// A boundary tetrahedron, or a triangle with -1 as the last id.
  struct BoundaryCell
  {
    std::array<vtkIdType, 4> Ids;
    int Kind;
    int Item;
    int Slab;
    /// If true, values equal a bound in the cell. The boundary cell may then cancel another one or
    /// bound no volume.
    bool IsTied;
    /// If true, the cell belongs to another piece.
    bool IsDuplicate;
  };

  explicit TimeVaryingMesh(const TimeVaryingOptions& options)
    : Options(options)
  {
  }

  const TimeVaryingOptions& GetOptions() const { return this->Options; }

  /// Starts a slab. The first slab has the boundary at the start, and the last slab the boundary at
  /// the end. If \a isJoined is true, the slab shares points with the previous slab, which must end
  /// at the same step. Set \a hasTies if a value equals a bound.
  void BeginSlab(int number, bool isFirst, bool isLast, bool isJoined, bool hasTies);

  /// Returns true if boundary cells of a kind are possible in this slab, and are requested or
  /// needed to decide which other boundary cells to keep.
  bool IsRequired(int kind) const { return this->RequiredKinds[kind]; }
  bool HasRequiredKinds() const;
  /// Same as IsRequired(), for a cell where values equal a bound. If 4-simplices are requested, the
  /// volume at both steps is also required.
  bool IsRequiredIfTied(int kind) const
  {
    return this->IsRequired(kind) || (this->Options.Settings.GenerateSimplices && IsVolume(kind));
  }
  static bool IsVolume(int kind)
  {
    return kind == vtkTimeVaryingSettings::VOLUME_AT_START ||
      kind == vtkTimeVaryingSettings::VOLUME_AT_END;
  }

  /**
   * Adds the points of the slab and returns their ids. \a points and \a lists are the results of
   * CrossingLists::MakePoints(). Set \a isStatic if the grid points do not move.
   */
  ExtractionBuffer<vtkIdType> AddPoints(const TimeStep& first, const TimeStep& second,
    const ExtractionBuffer<ExtractionPoint>& points, const CrossingLists& lists, bool isStatic);

  /// Adds boundary cells of the slab and sets their slab number.
  void AddBoundary(const std::vector<BoundaryCell>& cells);

  /// Adds parts of the volume at the two steps of the slab, in cells where values equal a bound.
  void AddStepVolume(const std::vector<BoundaryCell>& cells);

  /// Among the 4-simplices \a tied of the slab, removes pairs with the same points and opposite
  /// orientation. Returns the number of removed 4-simplices.
  vtkIdType RemoveOppositeSimplices(const std::vector<vtkIdType>& tied);

  /// Removes pairs of 4-simplices that lie in a time step and have the same points and opposite
  /// orientation. They may belong to the slabs before and after the step. Applies only if
  /// 4-simplices are requested.
  vtkIdType RemoveOppositeAtSteps();

  /**
   * Decides which boundary cells to keep where values equal a bound. Call this after all slabs were
   * added. Pairs with the same points and opposite orientation are removed. Of the remaining cells,
   * tetrahedra in time are kept if they are faces of 4-simplices (counted with their orientation),
   * and triangles are kept if they are faces of the volume at their step.
   */
  void SettleTiedBoundary();

  /// Removes the second copy of each volume part that occurs in both slabs adjacent to a step, and
  /// pairs of parts with opposite orientation.
  void SettleStepVolume();

  /// Removes the cells of other pieces, and points that only these cells use. Call this last.
  /// Returns the number of removed 4-simplices.
  vtkIdType RemoveDuplicates();

  /// Returns the current slab, the one started last.
  Slab& GetSlab() { return this->Slabs.back(); }

  ///@{
  /**
   * Return the points and their times, or null if the mesh is empty.
   */
  vtkPoints* GetPoints() const { return this->Points; }
  vtkDoubleArray* GetTimes() const { return this->Times; }
  ///@}
  vtkPointData* GetArrays() const { return this->Arrays; }
  const std::vector<Slab>& GetSlabs() const { return this->Slabs; }
  const std::vector<BoundaryCell>& GetBoundary() const { return this->Boundary; }
  const std::vector<BoundaryCell>& GetStepVolume() const { return this->StepVolume; }

  /// Returns the keys (see ArrayMatch) of point arrays that were skipped because a step lacks them.
  const std::vector<std::string>& GetSkippedArrays() const { return this->SkippedArrays; }

  std::size_t GetBytes() const;

  /// Returns a point in the coordinates of the projection. The last coordinate is along the
  /// projection.
  SimplexProjection::Point GetProjected(vtkIdType id) const
  {
    return this->Floats ? this->GetProjected(this->Floats, id)
                        : this->GetProjected(this->Doubles, id);
  }

  /// Gets the corners of the given simplices in the coordinates of the projection.
  void GetProjected(const Simplex* simplices, int number, SimplexProjection::Corners* corners) const
  {
    this->Floats ? this->GetProjected(this->Floats, simplices, number, corners)
                 : this->GetProjected(this->Doubles, simplices, number, corners);
  }

private:
  // A point at the end of a slab: its owner and key in the next slab, and its id in the mesh.
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

  // Stores the points at the second step for the next slab.
  void FindEndPoints(const ExtractionBuffer<ExtractionPoint>& points, const CrossingLists& lists,
    vtkIdType split, const ExtractionBuffer<vtkIdType>& ids);

  void AppendPoints(const TimeStep& first, const TimeStep& second,
    const ExtractionBuffer<ExtractionPoint>& points, bool isStatic);
  void AppendArrays(vtkPointData* more);
  bool IsAtOneTime(const Simplex& simplex) const;
  void RemoveUnusedPoints();
  void FindCoordinates();

  TimeVaryingOptions Options;
  std::array<bool, vtkTimeVaryingSettings::NUMBER_OF_BOUNDARY_KINDS> RequiredKinds{};
  vtkSmartPointer<vtkPoints> Points;
  // The point coordinates; the pointer of the other type is null.
  const float* Floats = nullptr;
  const double* Doubles = nullptr;
  vtkSmartPointer<vtkDoubleArray> Times;
  vtkNew<vtkPointData> Arrays;
  std::vector<std::string> SkippedArrays;
  bool IsLast = true;
  bool HasTies = false;
  std::vector<SharedPoint> EndPoints;
  std::vector<Slab> Slabs;
  std::vector<BoundaryCell> Boundary;
  std::vector<BoundaryCell> StepVolume;
};

}

#endif
