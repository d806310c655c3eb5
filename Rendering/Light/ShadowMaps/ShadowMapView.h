// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ShadowMapView_h
#define interlume_ShadowMapView_h

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
 * @class   ShadowMapView
 * @brief   shadow map view of a light: its position and window
 *
 * Let w be the distance from the light along the view's axis. The depth in normalized device
 * coordinates is A - B / w for a positional light and A + B w for a directional light.
 */
struct ShadowMapView
{
  /// Bounds of a surface in world coordinates, in VTK's order.
  using Box = std::array<double, 6>;

  /// The viewing axis and two directions perpendicular to it. Up is as close to the world's y axis
  /// as possible.
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
    double GetCenter() const { return 0.5 * (this->First + this->Last); }
    void Grow(double by)
    {
      this->First -= by;
      this->Last += by;
    }
  };

  /// Window of a view: the range of coordinates (or tangents, in perspective) perpendicular to the
  /// axis, and of distances along it. Parallel views are displaced laterally by Shear per unit
  /// distance along the axis.
  struct Window
  {
    Range Right;
    Range Up;
    Range Along;
    glm::dvec2 Shear{ 0.0, 0.0 };

    /// Enlarges the window on each side by a small margin, but at least by \a minimum.
    void GrowAcross(double minimum);
    /// Enlarges the depth range of a positional light. \a farthest is the largest distance from the
    /// light.
    void GrowAlong(double farthest);
    /// Sets the window of one face of a cube around the light. It extends past the face's edges by
    /// the texels that are interpolated there.
    void SetSide(double farthest, int resolution);
    /// Sets the window of a cone. \a tangent is the tangent of its half angle.
    void SetCone(double farthest, double tangent, int resolution);
    /// Returns the depth coefficients A and B.
    glm::dvec2 GetDepth(bool isPerspective) const;
  };

  static std::vector<glm::dvec3> GetCorners(const std::vector<Box>& boxes);

  /// Finds the window of a positional light along an axis. Returns false if a corner is too far off
  /// the axis.
  static bool FindWindow(const glm::dvec3& position, const Axes& axes,
    const std::vector<glm::dvec3>& corners, Window& window);

  /// Returns the axis of a cube face, 0 to 5: -x, x, -y, y, -z, z.
  static glm::dvec3 GetSide(int side);

  /// Finds the window of a directional light along an axis, with a lateral shear. Its coordinates
  /// are relative to \a origin.
  static Window FindWindow(const glm::dvec3& origin, const Axes& axes, const glm::dvec2& shear,
    const std::vector<glm::dvec3>& corners, double size);

  /// Computes the matrices and the texel depth of a view from its window.
  static ShadowMapView Make(const glm::dvec3& origin, const Axes& axes, const Window& window,
    bool isPerspective, int resolution);

  /// Sets \a camera to this view.
  void SetCamera(vtkCamera* camera) const;

  /// Cosine of 75 degrees, the largest angle between the axis of a single view and its rays.
  static constexpr double MinimumCosine = 0.2588;
  /// Near distance of the view of a light between the actors, as a fraction of its far distance.
  static constexpr double Nearest = 1e-3;
  /// Margin around the window of a view, as a fraction of its size or of its distance from the
  /// light.
  static constexpr double Margin = 1e-3;

  bool IsPerspective = false;
  /// Transforms from world coordinates to light coordinates, where the light looks along -z, and
  /// from there to clip coordinates.
  glm::dmat4 LightFromWorld{ 0.0 };
  glm::dmat4 ClipFromLight{ 0.0 };
  glm::dmat4 ClipFromWorld{ 0.0 };
  /// Width of a texel as a depth difference in normalized device coordinates. It is [0] + [1] / w,
  /// where w is the fourth clip coordinate of the position.
  std::array<double, 2> TexelDepth{};
};

}

#endif
