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

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
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
 * their common step. The shared points are found by merging the point lists of both slabs, which
 * are sorted in the same order.
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
    /// The interval of each 4-simplex. Empty if there is only one interval.
    ExtractionBuffer<int> Items;
    /// The degenerate facets of each 4-simplex (see SimplexProjection). Empty if no projection is
    /// requested.
    ExtractionBuffer<std::uint8_t> Flats;
    /// For each 4-simplex, 1 if values equal a bound in its cell, or if there are criteria. Empty
    /// if 4-simplices are not requested.
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
    /// If true, values in the input cell equal a bound. This boundary cell may then cancel another
    /// one, or bound no volume.
    bool IsTied;
    /// If true, the input cell belongs to another piece.
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
  /// Returns true if the volume at both steps is required from all cells: 4-simplices do not tell
  /// where a criterion touches its bound at a step only.
  bool HasStepVolumes() const
  {
    return this->Options.Settings.GenerateSimplices && this->Options.GetNumberOfCuts() > 0;
  }
  static bool IsVolume(int kind)
  {
    return kind == vtkTimeVaryingSettings::VOLUME_AT_START ||
      kind == vtkTimeVaryingSettings::VOLUME_AT_END;
  }

  /// Calls visit(face) for each face of a simplex, oriented outward.
  template <std::size_t Size, typename Visitor>
  static void ForEachFace(const std::array<vtkIdType, Size>& simplex, Visitor&& visit)
  {
    for (std::size_t i = 0; i < Size; ++i)
    {
      std::array<vtkIdType, Size - 1> face;
      std::copy_n(simplex.begin(), i, face.begin());
      std::copy(simplex.begin() + i + 1, simplex.end(), face.begin() + i);
      // In a positively oriented tetrahedron or 4-simplex, the face without point i is oriented
      // outward if i is even.
      if (i % 2 == 1)
      {
        std::swap(face[0], face[1]);
      }
      visit(face);
    }
  }

  /**
   * Adds the points of the slab and returns their ids. \a points must be the result of MakePoints()
   * of \a lists. Set \a isStatic if the grid points do not move.
   */
  ExtractionBuffer<vtkIdType> AddPoints(const TimeStep& first, const TimeStep& second,
    const ExtractionBuffer<ExtractionPoint>& points, const CrossingLists& lists, bool isStatic);

  /// Adds boundary cells of the slab and sets their slab number.
  void AddBoundary(const std::vector<BoundaryCell>& cells);

  /// Adds tetrahedra of the interval volume at either step of the slab, from cells where values
  /// equal a bound.
  void AddStepVolume(const std::vector<BoundaryCell>& cells);

  /// Removes pairs with the same points and opposite orientation from the 4-simplices of the slab
  /// whose indices are in \a tied. Returns the number of removed 4-simplices.
  vtkIdType RemoveOppositeSimplices(const std::vector<vtkIdType>& tied);

  /// Removes pairs of 4-simplices that lie entirely at one time step and have the same points and
  /// opposite orientation, even if one belongs to the slab before the step and the other to the
  /// slab after it. Applies only if 4-simplices are requested. Returns the number of removed
  /// 4-simplices.
  vtkIdType RemoveOppositeSimplicesAtSteps();

  /**
   * Decides which boundary cells to keep where values equal a bound. Call this after all slabs were
   * added. Pairs with the same points and opposite orientation are removed. A remaining tetrahedron
   * of a surface in time is kept if it is a face of a 4-simplex, and a remaining triangle if it is
   * a face of the volume at its step. Faces with opposite orientation cancel each other.
   */
  void ResolveTiedBoundary();

  /// Removes duplicates among the tetrahedra added by AddStepVolume(), and pairs with the same
  /// points and opposite orientation. Both slabs adjacent to a step may add the same tetrahedron.
  void CleanStepVolume();

  /// Removes the output of cells of other pieces, and the points that only this output uses. Call
  /// this last. Returns the number of removed 4-simplices.
  vtkIdType RemoveDuplicates();

  /// Removes the points that no output uses.
  void RemoveUnusedPoints();

  /// Returns the slab started last.
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
  vtkIdType GetNumberOfSimplices() const;
  const std::vector<BoundaryCell>& GetBoundary() const { return this->Boundary; }
  const std::vector<BoundaryCell>& GetStepVolume() const { return this->StepVolume; }

  /// Returns the keys (see ArrayMatch) of the skipped point arrays: those that a step lacks, and
  /// those named `Time` or `DeltaT`.
  const std::vector<std::string>& GetSkippedArrays() const { return this->SkippedArrays; }

  std::size_t GetBytes() const;

  /// Returns the size in bytes of a point with its time and arrays, or 0 if the mesh is empty.
  std::size_t GetBytesPerPoint() const;

  /// Returns a point in projection coordinates, see TimeVaryingOptions::Project().
  SimplexProjection::Point GetProjected(vtkIdType id) const
  {
    return this->Floats ? this->GetProjected(this->Floats, id)
                        : this->GetProjected(this->Doubles, id);
  }

  /// Gets the corners of \a number simplices in projection coordinates.
  void GetProjected(const Simplex* simplices, int number, SimplexProjection::Corners* corners) const
  {
    this->Floats ? this->GetProjected(this->Floats, simplices, number, corners)
                 : this->GetProjected(this->Doubles, simplices, number, corners);
  }

private:
  friend class CriterionCut;

  // A point at the second step of a slab: its owner and key in the next slab, and its id in the
  // mesh.
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
  void StoreEndPoints(const ExtractionBuffer<ExtractionPoint>& points, const CrossingLists& lists,
    vtkIdType split, const ExtractionBuffer<vtkIdType>& ids);

  void AppendPoints(const TimeStep& first, const TimeStep& second,
    const ExtractionBuffer<ExtractionPoint>& points, bool isStatic);
  void Append(vtkPoints* positions, vtkDoubleArray* times, vtkPointData* arrays);
  void AppendArrays(vtkPointData* more);
  /// Adds points on edges between points of the mesh.
  void AddEdgePoints(const std::vector<ExtractionPoint>& points);
  bool IsAtOneTime(const Simplex& simplex) const;
  /// Marks surfaces of criteria that are also surfaces of an interval or of an earlier criterion.
  void MarkRepeatedSurfaces(std::vector<bool>& isRemoved) const;
  void UpdateCoordinatePointers();

  TimeVaryingOptions Options;
  std::array<bool, vtkTimeVaryingSettings::NUMBER_OF_BOUNDARY_KINDS> RequiredKinds{};
  vtkSmartPointer<vtkPoints> Points;
  // The point coordinates. One of the two pointers is null.
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
