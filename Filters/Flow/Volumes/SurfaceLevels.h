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
   * Surfaces lie at \a values and at the bounds of \a intervals, but at VTK_DOUBLE_MAX and its
   * opposite. The function is nowhere below \a lowest: what begins there is open.
   */
  SurfaceLevels(
    const std::vector<Interval>& intervals, const std::vector<double>& values, double lowest);

  /// The parts of the intervals between surfaces, in the order of the intervals.
  const std::vector<Interval>& GetItems() const { return this->Items; }
  int GetInterval(int item) const { return this->IntervalOfItem[item]; }
  /// Of a side (vtkIntervalVolume::BoundarySides) of an item, the index of its surface, or -1.
  int GetSurface(int item, int side) const { return this->SurfacesOfItem[item][side]; }
  /// Of all surfaces, ascending, each once.
  const std::vector<double>& GetValues() const { return this->Values; }
  /// Whether one surface is the side of several items.
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
