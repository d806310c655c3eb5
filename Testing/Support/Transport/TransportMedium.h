// SPDX-License-Identifier: BSD-3-Clause
#ifndef TransportMedium_h
#define TransportMedium_h

#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace reference
{

/**
 * A ray in world coordinates. The direction has length 1.
 */
struct TransportRay
{
  glm::dvec3 Origin;
  glm::dvec3 Direction;

  glm::dvec3 At(double distance) const { return this->Origin + distance * this->Direction; }
};

/**
 * Bounds of the extinction in part of a medium.
 */
struct ExtinctionRange
{
  double Minimum = 0.0;
  double Largest = 0.0;
};

/**
 * @class   TransportMedium
 * @brief   absorbing and scattering medium in a box
 *
 * The extinction is per unit length. The albedo is the scattered fraction of the extinction, 0 to
 * 1, for red, green and blue. The box is divided into cells, each with a range that contains its
 * extinction. Ranges need not be tight. Tighter ranges reduce the number of steps per path.
 */
class TransportMedium
{
public:
  virtual ~TransportMedium() = default;

  virtual double GetExtinction(const glm::dvec3& position) const = 0;
  virtual glm::dvec3 GetAlbedo(const glm::dvec3& position) const = 0;

  /// Clips [begin, end] to the box. Returns false if the result is empty.
  bool Clip(const TransportRay& ray, double& begin, double& end) const;

  /// Calls visit(a, b, range) for each cell along the ray, where [a, b] is the ray's interval of
  /// distances in the cell. Stops if visit returns false, at \a end, or where the ray leaves the
  /// box.
  template <typename Visit>
  void Walk(const TransportRay& ray, double end, const Visit& visit) const;

protected:
  /// Sets the box, the number of cells along each axis, and the extinction ranges of the cells,
  /// with x varying fastest. The box may be infinite along an axis with only one cell.
  void SetCells(const glm::dvec3& lower, const glm::dvec3& upper, const std::array<int, 3>& counts,
    std::vector<ExtinctionRange> ranges);

  const glm::dvec3& GetLower() const { return this->Lower; }

private:
  glm::dvec3 Lower{};
  glm::dvec3 Upper{};
  glm::dvec3 Size{};
  std::array<int, 3> Counts{};
  std::vector<ExtinctionRange> Ranges;
};

template <typename Visit>
void TransportMedium::Walk(const TransportRay& ray, double end, const Visit& visit) const
{
  constexpr double never = std::numeric_limits<double>::infinity();
  double a = 0.0;
  if (!this->Clip(ray, a, end))
  {
    return;
  }
  std::array<int, 3> cell{};
  glm::dvec3 next(never);
  const auto findNext = [&](int axis)
  {
    const double step = ray.Direction[axis];
    const double plane = cell[axis] + (step > 0.0 ? 1.0 : 0.0);
    next[axis] = (this->Lower[axis] + plane * this->Size[axis] - ray.Origin[axis]) / step;
  };
  for (int axis = 0; axis < 3; ++axis)
  {
    if (this->Counts[axis] > 1)
    {
      const double at = (ray.At(a)[axis] - this->Lower[axis]) / this->Size[axis];
      cell[axis] = std::min(std::max(static_cast<int>(at), 0), this->Counts[axis] - 1);
      if (ray.Direction[axis] != 0.0)
      {
        findNext(axis);
      }
    }
  }
  for (;;)
  {
    int axis = next[0] < next[1] ? 0 : 1;
    axis = next[2] < next[axis] ? 2 : axis;
    const double b = std::min(end, next[axis]);
    const std::size_t number =
      static_cast<std::size_t>(cell[0] + this->Counts[0] * (cell[1] + this->Counts[1] * cell[2]));
    if (b > a && !visit(a, b, this->Ranges[number]))
    {
      return;
    }
    a = std::max(a, b);
    cell[axis] += ray.Direction[axis] > 0.0 ? 1 : -1;
    if (next[axis] >= end || cell[axis] < 0 || cell[axis] >= this->Counts[axis])
    {
      return;
    }
    findNext(axis);
  }
}

}

#endif
