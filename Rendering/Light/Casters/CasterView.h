// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CasterView_h
#define interlume_CasterView_h

#include "Common/Vectors.h"
#include "Space/UnitVector.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

class vtkCamera;

namespace interlume
{

/**
 * @class   CasterView
 * @brief   from where and through which window a light sees the surfaces that cast shadows
 *
 * With w the distance from the light along the view's axis, a place has the depth A - B / w where
 * the light is positional, and A + B w where not, in normalised device coordinates.
 */
struct CasterView
{
  /// The bounds of one surface in world coordinates, as VTK orders them.
  using Box = std::array<double, 6>;

  /// Two directions across an axis, of which the first goes along a world axis as far as it can.
  struct Axes
  {
    explicit Axes(const glm::dvec3& axis)
      : Along(axis)
      , Up(UnitVector::Perpendicular(axis, { 0.0, 1.0, 0.0 }))
      , Right(glm::cross(axis, Up))
    {
    }
    glm::dvec3 Along;
    glm::dvec3 Up;
    glm::dvec3 Right;
  };

  struct Range
  {
    double First = std::numeric_limits<double>::infinity();
    double Last = -std::numeric_limits<double>::infinity();

    void Add(double value)
    {
      this->First = std::min(this->First, value);
      this->Last = std::max(this->Last, value);
    }
    double GetSize() const { return this->Last - this->First; }
    double GetMiddle() const { return 0.5 * (this->First + this->Last); }
    void Grow(double by)
    {
      this->First -= by;
      this->Last += by;
    }
  };

  /// The window of a view: places across the axis, or their tangents, and distances along it. Views
  /// without perspective go by Shear to the side for each distance of 1 along the axis.
  struct Window
  {
    Range Right;
    Range Up;
    Range Along;
    glm::dvec2 Shear{ 0.0, 0.0 };

    /// Makes the window larger than what it is around, at each side by \a least at least.
    void GrowAcross(double least);
    /// Makes the range of a positional light wider than what it has, where \a farthest is.
    void GrowAlong(double farthest);
    /// Makes the window that of a side of a cube around the light, which reaches over the side's
    /// edges by the texels that are interpolated there.
    void SetSide(double farthest, int resolution);
    /// Makes the window that of a cone whose half angle has this tangent.
    void SetCone(double farthest, double tangent, int resolution);
    /// Returns A and B.
    glm::dvec2 GetDepth(bool isPerspective) const;
  };

  static std::vector<glm::dvec3> GetCorners(const std::vector<Box>& boxes);

  /// Finds the window of a positional light along an axis; false where something lies too far
  /// aside.
  static bool FindWindow(const glm::dvec3& position, const Axes& axes,
    const std::vector<glm::dvec3>& corners, Window& window);

  /// Returns the axis of a side of the cube, 0 to 5: -x, x, -y, y, -z, z.
  static glm::dvec3 GetSide(int side);

  /// Finds the window of light that goes along the axis, or with some shear aside, from an origin.
  static Window FindWindow(const glm::dvec3& origin, const Axes& axes, const glm::dvec2& shear,
    const std::vector<glm::dvec3>& corners, double size);

  /// Makes the matrices of a view whose window is given, and the depth of its texels.
  static CasterView Make(const glm::dvec3& origin, const Axes& axes, const Window& window,
    bool isPerspective, int resolution);

  /// Makes \a camera draw as the view sees.
  void SetCamera(vtkCamera* camera) const;

  /// The least cosine between the axis of a single view and what it sees: 75 degrees.
  static constexpr double LeastCosine = 0.2588;
  /// The nearest place that a light within the scene sees, as a share of the farthest.
  static constexpr double Nearest = 1e-3;
  /// What windows are larger than what they are around.
  static constexpr double Margin = 1e-3;

  bool IsPerspective = false;
  /// From world to the light's own coordinates, where it looks along -z, and from those to clip
  /// coordinates.
  glm::dmat4 LightFromWorld{ 0.0 };
  glm::dmat4 ClipFromLight{ 0.0 };
  glm::dmat4 ClipFromWorld{ 0.0 };
  /// A texel's width as a depth: with w the fourth clip coordinate of a place this is [0] + [1] / w
  /// in normalised device coordinates.
  std::array<double, 2> TexelDepth{};
};

}

#endif
