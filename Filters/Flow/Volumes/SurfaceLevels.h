// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SurfaceLevels_h
#define interlume_SurfaceLevels_h

#include <array>
#include <vector>

class vtkIntervalVolume;

namespace interlume
{

/**
 * @class   SurfaceLevels
 * @brief   divides intervals at the values of additional surfaces, and sorts the values of all
 * surfaces
 */
class SurfaceLevels
{
public:
  using Interval = std::array<double, 2>;

  /**
   * Surfaces are at \a values and at the finite bounds of \a intervals (not +-VTK_DOUBLE_MAX). \a
   * lowest is the minimum of the function: an interval that starts there has no surface at its
   * lower bound.
   */
  SurfaceLevels(
    const std::vector<Interval>& intervals, const std::vector<double>& values, double lowest);

  /// Returns the items, which are the parts of the intervals between surfaces, in the order of the
  /// intervals.
  const std::vector<Interval>& GetItems() const { return this->Items; }
  int GetInterval(int item) const { return this->IntervalOfItem[item]; }
  /// Returns the index of the surface at a side (vtkIntervalVolume::BoundarySides) of an item, or
  /// -1 if there is none.
  int GetSurface(int item, int side) const { return this->SurfacesOfItem[item][side]; }
  /// Returns the distinct values of all surfaces in ascending order.
  const std::vector<double>& GetValues() const { return this->Values; }
  /// Returns whether several items share a surface.
  bool HasSharedSurfaces() const;
  /// Sets the items as the intervals of \a filter. Does not modify \a filter if they are unchanged.
  void SetItems(vtkIntervalVolume* filter) const;

private:
  std::vector<Interval> Items;
  std::vector<int> IntervalOfItem;
  std::vector<std::array<int, 2>> SurfacesOfItem;
  std::vector<double> Values;
};

}

#endif
