// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_BeyondSamples_h
#define interlume_BeyondSamples_h

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
 * @class   BeyondSamples
 * @brief   what samples beside a termination surface would have if they lay on its other side
 *
 * Reads the field arrays that vtkFlowStatus::BeyondPrefix describes, and says with them which parts
 * of a cell that a surface passes through have one answer: the part above the surface, where its
 * distance is, and the part below.
 *
 * A sample may have one row of a surface and one of the boundary of what reaches a surface. A cell
 * all of whose corners have rows of a surface is of that surface, any other one of the boundary.
 *
 * Arrays whose positions are not those of the dataset's points belong to another dataset, and are
 * not used.
 */
class BeyondSamples
{
public:
  static constexpr const char* Point = "SampleId";
  static constexpr const char* Position = "SamplePosition";
  static constexpr const char* Distance = "SampleDistance";
  static constexpr const char* Normal = "SampleNormal";
  static constexpr const char* Surface = "SampleSurface";

  /// The numbers of samples in place of that of their surface: those that stand still on it, and
  /// those beside the boundary of what reaches a surface, which is no surface.
  static constexpr int StandsStill = -1;
  static constexpr int NoSurface = -2;

  /// Returns the name of the field array that has \a name of such samples.
  static std::string GetName(const std::string& name)
  {
    return vtkFlowStatus::BeyondPrefix() + name;
  }
  /// Removes all field arrays of such samples.
  static void Remove(vtkFieldData* data);

  explicit BeyondSamples(vtkDataSet* data);

  bool IsEmpty() const { return this->RowsOfPoints[0].empty(); }
  vtkIdType GetNumber() const { return this->Number; }

  /// The samples on one side of the surface in a cell.
  struct Part
  {
    /// The side: 1 above and -1 below; 0 for no part.
    int Side = 0;
    /// The id that all samples of the part have.
    int Id = -1;
    /// Whether streamlines leave for the surface from all of them, or from none.
    bool IsNear = false;
    bool IsFar = false;
    /// True if what parts the cell is the boundary of what reaches a surface.
    bool IsBoundary = false;
  };
  struct Parts
  {
    Part All[2];
    /// Whether no part that samples have answers in is missing.
    bool IsResolved = false;
  };
  /// Finds the parts of a cell with these corners.
  Parts GetParts(
    const ImplicitFlowArrays& arrays, const vtkIdType* corners, vtkIdType number) const;

  /// The ways in which a corner of a cell takes part in a part of it.
  enum Roles
  {
    /// The corner counts with its own answer, with what it would have beyond, or with neither,
    /// being beyond.
    OWN,
    KNOWN,
    UNKNOWN
  };
  Roles GetRole(const ImplicitFlowArrays& arrays, vtkIdType corner, const Part& part) const;

  /// Returns the row of a point in the arrays, that of the boundary of what reaches a surface or
  /// that of a surface; -1 without one.
  vtkIdType GetRow(vtkIdType point, bool isBoundary) const
  {
    return this->RowsOfPoints[isBoundary ? 1 : 0][static_cast<std::size_t>(point)];
  }
  vtkIdType GetPoint(vtkIdType row) const;
  /// Returns the distance from the surface, 0 and above.
  double GetDistance(vtkIdType row) const;
  /// Returns whether there is a surface beside the sample, not the boundary of what reaches one.
  bool HasSurface(vtkIdType row) const { return this->Surfaces->GetComponent(row, 0) != NoSurface; }
  /// Returns the side of the surface: 1 above, -1 below, 0 on the surface; 1 for samples that reach
  /// one, -1 for others.
  int GetSide(vtkIdType row) const;
  /// Returns whether the streamline leaves away from the surface.
  bool IsAway(vtkIdType row) const;
  /// Returns the id that the sample would have beyond; -1 where that is not known.
  int GetId(vtkIdType row) const;
  /// Returns the time that the streamline takes to the surface, below 0 where it comes from there;
  /// 0 where that is not known or there is no surface.
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
