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
 * @brief   the arrays of vtkFlowStatus of a dataset, in the types they are defined with
 *
 * An array of another type, as an extraction leaves it, is copied.
 */
class ImplicitFlowArrays
{
public:
  /// Finds the arrays. Returns an error if an array is missing or of the wrong shape.
  /// TerminationSide may be missing, and AdvectionTime too.
  Error Find(vtkDataSet* data);
  /// Returns an error if a point array is missing or of the wrong shape.
  static Error CheckArray(vtkDataSet* data, const char* name, int components);

  bool IsReached(vtkIdType point) const { return this->Statuses->GetValue(point) == 0; }
  int GetStatus(vtkIdType point) const { return this->Statuses->GetValue(point); }
  int GetId(vtkIdType point) const { return this->Ids->GetValue(point); }
  /// Returns whether two samples ended in the same way, on the same surface if on one.
  bool AreAlike(vtkIdType a, vtkIdType b) const
  {
    return this->Statuses->GetValue(a) == this->Statuses->GetValue(b) &&
      this->GetId(a) == this->GetId(b);
  }
  const double* GetParameters(vtkIdType point) const
  {
    return this->Parameters->GetPointer(2 * point);
  }

  double GetTime(vtkIdType point) const { return this->Times->GetValue(point); }

  /// Returns whether there are TerminationSide and AdvectionTime, which the following two functions
  /// need.
  bool HasSides() const { return this->Sides && this->Times; }
  /**
   * Returns whether time jumps on the surface of the one id of all these samples, the corners of a
   * cell: it is 0 in the limit on a side that streamlines leave towards the surface, or is 0 at a
   * corner on the surface, and some streamlines of the other side leave away from it, to come back.
   * Where they all leave towards it, time is 0 from both sides and does not jump.
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
  /// Returns by how much AdvectionTime differs among samples.
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

  /// Returns the ids in use, and whether u and v are periodic there.
  const std::map<int, std::array<bool, 2>>& GetSurfaces() const { return this->Surfaces; }
  /// Returns whether u and v are periodic for an id; false twice for one that is not in use.
  std::array<bool, 2> GetPeriodicity(int id) const;

  /**
   * Reads the tuples of a field array of three integers, an id and a flag for u and v:
   * TerminationSurfaces, InflowPeriodic. Empty where \a data has none.
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
