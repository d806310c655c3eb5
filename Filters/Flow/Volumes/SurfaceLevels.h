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
 * @brief   intervals cut at the values of further surfaces, and all surfaces by their value
 */
class SurfaceLevels
{
public:
  using Interval = std::array<double, 2>;

  /**
   * Surfaces lie at \a values and at the bounds of \a intervals, but not at VTK_DOUBLE_MAX and its
   * opposite. The function is nowhere below \a lowest: an interval that begins there is open.
   */
  SurfaceLevels(
    const std::vector<Interval>& intervals, const std::vector<double>& values, double lowest);

  /// Returns the parts of the intervals between surfaces, in the order of the intervals.
  const std::vector<Interval>& GetItems() const { return this->Items; }
  int GetInterval(int item) const { return this->IntervalOfItem[item]; }
  /// Returns the index of the surface at a side (vtkIntervalVolume::BoundarySides) of an item, or
  /// -1.
  int GetSurface(int item, int side) const { return this->SurfacesOfItem[item][side]; }
  /// Returns the values of all surfaces, ascending, each once.
  const std::vector<double>& GetValues() const { return this->Values; }
  /// Returns whether one surface is the side of several items.
  bool HasSharedSurfaces() const;
  /// Gives the items to \a filter, which is modified only where they have changed.
  void SetItems(vtkIntervalVolume* filter) const;

private:
  std::vector<Interval> Items;
  std::vector<int> IntervalOfItem;
  std::vector<std::array<int, 2>> SurfacesOfItem;
  std::vector<double> Values;
};

}

#endif
