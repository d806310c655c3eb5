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
 * @brief   position, direction and window from which one shadow map of a light is drawn
 *
 * Let w be the distance from the light along the view's axis. The depth in normalized device
 * coordinates is A - B / w for a positional light and A + B w for a directional light.
 */
struct ShadowMapView
{
  /// Bounds of a surface in world coordinates, in VTK's order.
  using Box = std::array<double, 6>;

  /// The viewing axis and two directions perpendicular to it. Up is as close as possible to the y
  /// axis of world coordinates.
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

  /// Window of a view: the ranges of the two coordinates perpendicular to the axis (for positional
  /// lights, of these coordinates divided by the distance along the axis), and of the distance
  /// along the axis. The window of a directional light is displaced sideways by Shear per unit
  /// distance along the axis.
  struct Window
  {
    Range Right;
    Range Up;
    Range Along;
    glm::dvec2 Shear{ 0.0, 0.0 };

    /// Extends the ranges perpendicular to the axis by a small margin, at least \a minimum, at both
    /// ends.
    void AddSideMargins(double minimum);
    /// Extends the range along the axis of a positional light. \a farthest is the distance from the
    /// light to the farthest corner of a surface's bounds.
    void AddDepthMargins(double farthest);
    /// Sets the window of one face of a cube around the light. It extends two texels past the edges
    /// of the face, for interpolation.
    void SetCubeFace(double farthest, int resolution);
    /// Sets the window of a spotlight. \a tangent is the tangent of the half angle of its cone.
    void SetCone(double farthest, double tangent, int resolution);
    /// Returns the coefficients A and B of the depth, defined in ShadowMapView.
    glm::dvec2 GetDepth(bool isPerspective) const;
  };

  static std::vector<glm::dvec3> GetCorners(const std::vector<Box>& boxes);

  /// Finds the window of a positional light that contains all corners. Returns false if the
  /// direction of a corner is more than 75 degrees from the axis.
  static bool FindWindow(const glm::dvec3& position, const Axes& axes,
    const std::vector<glm::dvec3>& corners, Window& window);

  /// Returns the direction of a cube face. Faces 0 to 5 are -x, x, -y, y, -z, z.
  static glm::dvec3 GetSide(int side);

  /// Finds the window of a directional light that contains all corners, with the given shear.
  /// Coordinates of the window are relative to \a origin.
  static Window FindWindow(const glm::dvec3& origin, const Axes& axes, const glm::dvec2& shear,
    const std::vector<glm::dvec3>& corners, double size);

  /// Computes the matrices and the texel depth of a view from its window.
  static ShadowMapView Make(const glm::dvec3& origin, const Axes& axes, const Window& window,
    bool isPerspective, int resolution);

  /// Sets \a camera to this view.
  void SetCamera(vtkCamera* camera) const;

  /// Cosine of 75 degrees, the largest angle between a view's axis and its rays if the light has
  /// only one view.
  static constexpr double MinimumCosine = 0.2588;
  /// Smallest near distance of a positional light's view, as a fraction of its far distance.
  static constexpr double Nearest = 1e-3;
  /// Margin by which windows are extended, as a fraction of their size, or of the distance from the
  /// light along the axis.
  static constexpr double Margin = 1e-3;

  bool IsPerspective = false;
  /// Transforms from world coordinates to light coordinates, where the light looks along -z, and
  /// from there to clip coordinates.
  glm::dmat4 LightFromWorld{ 0.0 };
  glm::dmat4 ClipFromLight{ 0.0 };
  glm::dmat4 ClipFromWorld{ 0.0 };
  /// The difference in normalized depth over a distance of one texel's width is TexelDepth[0] +
  /// TexelDepth[1] / w, where w is the fourth clip coordinate.
  std::array<double, 2> TexelDepth{};
};

}

#endif
