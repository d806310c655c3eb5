// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CriterionCut_h
#define interlume_CriterionCut_h

#include "TimeVarying/TimeVaryingMesh.h"

#include <cstdint>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

class vtkDataArray;

namespace interlume
{

/**
 * @class   CriterionCut
 * @brief   cuts the 4-simplices and the boundary of a mesh where an array equals a bound
 *
 * The array is linear in each simplex. How a simplex is cut depends on the order of its point ids,
 * so adjacent simplices match. Points with a value equal to the bound are not duplicated.
 */
class CriterionCut
{
public:
  /// The part of space-time where the array is at least, or at most, a bound. If it is open,
  /// simplices where the array equals the bound everywhere do not belong to it.
  struct Half
  {
    double Bound;
    bool IsAbove;
    bool IsOpen;
    /// Kind of the boundary cells where the array equals the bound; -1 generates none.
    int Kind;
  };

  /// \a key is the key of a point array of the mesh with one component (see ArrayMatch).
  CriterionCut(TimeVaryingMesh& mesh, const std::string& key);

  /// Retains the parts of the mesh in any of at most two halves, which must not overlap. Drops
  /// simplices with a NaN or an infinite value.
  void Execute(const std::vector<Half>& halves);

  /// Returns the array, or null if the mesh has none.
  vtkDataArray* GetArray() const { return this->Array; }

private:
  using BoundaryCell = TimeVaryingMesh::BoundaryCell;

  template <std::size_t Size>
  struct Clip;

  /// Calls add(ids) for each part of a simplex in a half, and addFace(ids, isTied) for its faces
  /// where the array equals the bound.
  template <std::size_t Size, typename Add, typename AddFace>
  void Cut(const std::array<vtkIdType, Size>& ids, const Half& half, Add&& add, AddFace&& addFace);
  /// Returns the sorted ids of a tetrahedron, or of a triangle with -1 as an id.
  static std::array<vtkIdType, 4> MakeKey(std::array<vtkIdType, 4> ids);
  /// Finds the faces of simplices with a value that is not finite.
  void FindDroppedFaces();
  void CutSlab(TimeVaryingMesh::Slab& slab, std::vector<BoundaryCell>& boundary);
  void CutCells(std::vector<BoundaryCell>& cells);
  /// Returns the point on the edge between a point in a half and a point outside of it.
  vtkIdType GetPoint(vtkIdType inside, vtkIdType outside, const Half& half);
  /// Returns whether the array equals the bound at all points.
  bool HasBound(const vtkIdType* ids, int number, const Half& half) const;
  bool IsFinite(const vtkIdType* ids, std::size_t number) const;

  TimeVaryingMesh& Mesh;
  vtkDataArray* Array;
  std::vector<double> Values;
  std::vector<Half> Halves;
  /// Keys of the tetrahedra and triangles that are faces of dropped simplices.
  std::set<std::array<vtkIdType, 4>> Dropped;
  std::vector<ExtractionPoint> Points;
  /// Bounds at the new points.
  std::vector<double> Bounds;
  std::unordered_map<std::uint64_t, vtkIdType> Ids;
};

}

#endif
