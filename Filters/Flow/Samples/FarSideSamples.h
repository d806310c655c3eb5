// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FarSideSamples_h
#define interlume_FarSideSamples_h

#include "vtkDataArray.h"
#include "vtkFlowStatus.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <string>
#include <vector>

class vtkDataSet;
class vtkFieldData;

namespace interlume
{

class ImplicitFlowArrays;

/**
 * @class   FarSideSamples
 * @brief   reads the far-side values of samples near a termination surface
 *
 * The values are stored in the field arrays described at vtkFlowStatus::FarSidePrefix. If a surface
 * crosses a cell, they allow interpolation in each of two parts: above the surface, where the
 * distance is positive, and below it.
 *
 * A sample may have one row for a surface and one row for the boundary of the reached region. If
 * all corners of a cell have rows for a surface, the surface cuts the cell; otherwise the boundary
 * does.
 *
 * Arrays whose positions do not match the dataset's points belong to another dataset and are
 * ignored.
 */
class FarSideSamples
{
public:
  static constexpr const char* Point = "SampleId";
  static constexpr const char* Position = "SamplePosition";
  static constexpr const char* Distance = "SampleDistance";
  static constexpr const char* Normal = "SampleNormal";
  static constexpr const char* Surface = "SampleSurface";

  /// Values of SampleSurface that are not surface indices: for samples that stagnate on their
  /// surface and for samples near the boundary of the reached region.
  static constexpr int Stagnant = -1;
  static constexpr int NoSurface = -2;

  /// Returns the name of the far-side array for \a name.
  static std::string GetName(const std::string& name)
  {
    return vtkFlowStatus::FarSidePrefix() + name;
  }
  /// Removes all far-side arrays.
  static void Remove(vtkFieldData* data);

  explicit FarSideSamples(vtkDataSet* data);

  bool IsEmpty() const { return this->RowsOfPoints[0].empty(); }
  vtkIdType GetNumber() const { return this->Number; }

  /// The part of a cell on one side of the surface.
  struct Part
  {
    /// Side: 1 above, -1 below, 0 for no part.
    int Side = 0;
    /// Id shared by all samples of the part.
    int Id = -1;
    /// IsNear: all streamlines of the part start toward the surface. IsFar: none does.
    bool IsNear = false;
    bool IsFar = false;
    /// True if the boundary of the reached region divides the cell.
    bool IsBoundary = false;
  };
  struct Parts
  {
    Part All[2];
    /// True if vtkFlowVolume can extract every part with a sample that reached a surface.
    bool IsResolved = false;
  };
  /// Finds the parts of a cell with these corners.
  Parts GetParts(
    const ImplicitFlowArrays& arrays, const vtkIdType* corners, vtkIdType number) const;

  /// Values that a corner contributes to a part of its cell.
  enum Roles
  {
    /// OWN: the corner's own values. KNOWN: the corner's far-side values. UNKNOWN: no values,
    /// because the corner lies on the far side and has no usable far-side values.
    OWN,
    KNOWN,
    UNKNOWN
  };
  Roles GetRole(const ImplicitFlowArrays& arrays, vtkIdType corner, const Part& part) const;

  /// Returns the row of a point for the boundary of the reached region if \a isBoundary is true,
  /// otherwise for a surface; -1 if there is no such row.
  vtkIdType GetRow(vtkIdType point, bool isBoundary) const
  {
    return this->RowsOfPoints[isBoundary ? 1 : 0][static_cast<std::size_t>(point)];
  }
  vtkIdType GetPoint(vtkIdType row) const;
  /// Returns the distance from the surface, at least 0.
  double GetDistance(vtkIdType row) const;
  /// Returns true if the row belongs to a surface, not to the boundary of the reached region.
  bool HasSurface(vtkIdType row) const { return this->Surfaces->GetComponent(row, 0) != NoSurface; }
  /// Returns the side of the surface: 1 above, -1 below, 0 on the surface. At the boundary of the
  /// reached region: 1 for samples that reach a surface, otherwise -1.
  int GetSide(vtkIdType row) const;
  /// Returns true if the streamline starts away from the surface.
  bool IsAway(vtkIdType row) const;
  /// Returns the far-side id of the sample; -1 if unknown.
  int GetId(vtkIdType row) const;
  /// Returns the time that the streamline takes to reach the surface, negative if it comes from the
  /// surface; 0 if the time is unknown or there is no surface.
  double GetNearTime(const ImplicitFlowArrays& arrays, vtkIdType row) const;
  void GetNormal(vtkIdType row, double normal[3]) const { this->Normals->GetTuple(row, normal); }

private:
  vtkIdType Number = 0;
  vtkSmartPointer<vtkDataArray> Points;
  vtkSmartPointer<vtkDataArray> Distances;
  vtkSmartPointer<vtkDataArray> Normals;
  vtkSmartPointer<vtkDataArray> Surfaces;
  vtkSmartPointer<vtkDataArray> Sides;
  vtkSmartPointer<vtkDataArray> Ids;
  vtkSmartPointer<vtkDataArray> Times;
  std::array<std::vector<vtkIdType>, 2> RowsOfPoints;
};

}

#endif
