// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ImplicitFlowArrays_h
#define interlume_ImplicitFlowArrays_h

#include "Common/Error.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkFlowStatus.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <map>

class vtkDataSet;

namespace interlume
{

/**
 * @class   ImplicitFlowArrays
 * @brief   provides typed access to the arrays of vtkFlowStatus
 *
 * Arrays whose types differ from the types of the members, for example after an extraction filter,
 * are copied and converted.
 */
class ImplicitFlowArrays
{
public:
  /// Finds the arrays. Returns an error if a required array is missing or has the wrong number of
  /// components. TerminationSide and AdvectionTime are optional.
  Error Find(vtkDataSet* data);
  /// Returns an error if a point array is missing or has the wrong number of components.
  static Error CheckArray(vtkDataSet* data, const char* name, int components);

  bool IsReached(vtkIdType point) const { return this->Statuses->GetValue(point) == 0; }
  int GetStatus(vtkIdType point) const { return this->Statuses->GetValue(point); }
  int GetId(vtkIdType point) const { return this->Ids->GetValue(point); }
  /// Returns true if two samples have the same status and id.
  bool HaveSameEnd(vtkIdType a, vtkIdType b) const
  {
    return this->Statuses->GetValue(a) == this->Statuses->GetValue(b) &&
      this->GetId(a) == this->GetId(b);
  }
  const double* GetParameters(vtkIdType point) const
  {
    return this->Parameters->GetPointer(2 * point);
  }

  double GetTime(vtkIdType point) const { return this->Times->GetValue(point); }

  bool HasTimes() const { return this->Times != nullptr; }
  /// Returns true if TerminationSide and AdvectionTime exist. IsAcrossSurface and GetTimeJump need
  /// them.
  bool HasSides() const { return this->Sides && this->Times; }
  /**
   * For a cell whose corners all reach the same surface: returns true if this surface crosses the
   * cell and AdvectionTime is discontinuous there. On one side of the surface, the time approaches
   * 0: streamlines start toward the surface, or a corner lies on it. On the other side, some
   * streamlines start away from the surface and return later. If all start toward the surface, the
   * time approaches 0 on both sides and is continuous.
   */
  template <typename Ids>
  bool IsAcrossSurface(const Ids* corners, vtkIdType number) const
  {
    bool isOn[2] = { false, false };
    bool isAway[2] = { false, false };
    for (vtkIdType i = 0; i < number; ++i)
    {
      const signed char side = this->Sides->GetValue(corners[i]);
      const bool isAt = side == 0 && this->Times->GetValue(corners[i]) == 0.0;
      isOn[0] = isOn[0] || isAt || side < 0;
      isOn[1] = isOn[1] || isAt || side > 0;
      isAway[side > 0 ? 1 : 0] =
        isAway[side > 0 ? 1 : 0] || side == vtkFlowStatus::AWAY || side == -vtkFlowStatus::AWAY;
    }
    return (isOn[0] && isAway[1]) || (isOn[1] && isAway[0]);
  }
  /// Returns the difference between the largest and the smallest AdvectionTime of the corners.
  template <typename Ids>
  double GetTimeJump(const Ids* corners, vtkIdType number) const
  {
    double lowest = VTK_DOUBLE_MAX;
    double highest = -VTK_DOUBLE_MAX;
    for (vtkIdType i = 0; i < number; ++i)
    {
      lowest = std::min(lowest, this->Times->GetValue(corners[i]));
      highest = std::max(highest, this->Times->GetValue(corners[i]));
    }
    return highest - lowest;
  }

  /// Returns the ids in use, and whether u and v are periodic for each.
  const std::map<int, std::array<bool, 2>>& GetSurfaces() const { return this->Surfaces; }
  /// Returns whether u and v are periodic for an id; false for both if the id is not in use.
  std::array<bool, 2> GetPeriodicity(int id) const;

  /**
   * Reads the field array \a name, TerminationSurfaces or InflowPeriodic. Each tuple contains an
   * id, a flag for u and a flag for v. The result is empty if \a data has no such array.
   */
  static std::map<int, std::array<bool, 2>> ReadFlags(vtkDataSet* data, const char* name);

private:
  vtkSmartPointer<vtkAOSDataArrayTemplate<unsigned char>> Statuses;
  vtkSmartPointer<vtkAOSDataArrayTemplate<int>> Ids;
  vtkSmartPointer<vtkAOSDataArrayTemplate<double>> Parameters;
  vtkSmartPointer<vtkAOSDataArrayTemplate<double>> Times;
  vtkSmartPointer<vtkAOSDataArrayTemplate<signed char>> Sides;
  std::map<int, std::array<bool, 2>> Surfaces;
};

}

#endif
