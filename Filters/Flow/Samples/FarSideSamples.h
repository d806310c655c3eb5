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
 * A sample may have one row (tuple index) for a surface, and one row for the boundary of the
 * reached region, which is the region whose streamlines reach a surface. If all corners of a cell
 * have rows for a surface, the surface cuts the cell; otherwise the boundary does.
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

  /// Value of SampleSurface for samples that stagnate on a surface.
  static constexpr int Stagnant = -1;
  /// Value of SampleSurface for samples near the boundary of the reached region.
  static constexpr int NoSurface = -2;

  /// Returns the name of the far-side array that corresponds to the array \a name.
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
    /// 1 above the surface, -1 below it, or 0 if there is no such part.
    int Side = 0;
    /// Id shared by all samples of the part.
    int Id = -1;
    /// True if all streamlines of the part start toward the surface.
    bool IsNear = false;
    /// True if all streamlines of the part start away from the surface.
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
  /// Finds the parts of the cell with the given corners.
  Parts GetParts(
    const ImplicitFlowArrays& arrays, const vtkIdType* corners, vtkIdType number) const;

  /// Which values a corner contributes to a part of its cell.
  enum Roles
  {
    /// The corner's own values.
    OWN,
    /// The corner's far-side values.
    KNOWN,
    /// No values: the corner is on the far side and has no usable far-side values.
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
  /// Returns the unsigned distance of the sample from the surface or boundary.
  double GetDistance(vtkIdType row) const;
  /// Returns true if the row belongs to a surface, not to the boundary of the reached region.
  bool HasSurface(vtkIdType row) const { return this->Surfaces->GetComponent(row, 0) != NoSurface; }
  /// Returns the side of the surface that the sample is on: 1 above, -1 below, 0 on the surface. At
  /// the boundary of the reached region, returns 1 for samples that reach a surface, otherwise -1.
  int GetSide(vtkIdType row) const;
  /// Returns true if the sample's streamline starts away from the surface.
  bool IsAway(vtkIdType row) const;
  /// Returns the far-side id of the sample; -1 if unknown.
  int GetId(vtkIdType row) const;
  /// Returns the time that the sample's streamline takes to reach the surface, negative if it comes
  /// from the surface; 0 if the time is unknown or there is no surface.
  double GetTimeToSurface(const ImplicitFlowArrays& arrays, vtkIdType row) const;
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
