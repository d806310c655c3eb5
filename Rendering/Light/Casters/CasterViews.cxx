// SPDX-License-Identifier: BSD-3-Clause
#include "Casters/CasterViews.h"

#include "Space/UnitSpace.h"
#include "Space/UnitVector.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace interlume
{

namespace
{
using View = CasterViews::View;

/// The least cosine between the axis of a single view and what it sees: 75 degrees.
constexpr double LEAST_COSINE = 0.2588;
/// The nearest place that a light within the scene sees, as a share of the farthest.
constexpr double NEAREST = 1e-3;
/// What windows are larger than what they are around.
constexpr double MARGIN = 1e-3;

// Two directions across the axis, of which the first goes along a world axis as far as it can.
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
  void Limit(double first, double last)
  {
    this->First = std::max(this->First, first);
    this->Last = std::min(this->Last, last);
  }
};

// The window of a view: places across the axis, or their tangents, and along it.
struct Window
{
  Range Right;
  Range Up;
  Range Along;
};

std::vector<glm::dvec3> GetCorners(const std::vector<CasterViews::Box>& boxes)
{
  std::vector<glm::dvec3> corners;
  corners.reserve(8 * boxes.size());
  for (const CasterViews::Box& box : boxes)
  {
    for (unsigned corner = 0; corner < 8; ++corner)
    {
      corners.emplace_back(
        box[corner & 1U], box[2 + (corner >> 1 & 1U)], box[4 + (corner >> 2 & 1U)]);
    }
  }
  return corners;
}

glm::dmat4 MakeLightFromWorld(const glm::dvec3& origin, const Axes& axes)
{
  const auto makeRow = [&origin](const glm::dvec3& axis)
  { return glm::dvec4(axis, -glm::dot(axis, origin)); };
  return glm::transpose(glm::dmat4(
    makeRow(axes.Right), makeRow(axes.Up), makeRow(-axes.Along), glm::dvec4(0.0, 0.0, 0.0, 1.0)));
}

// Sets the matrices of a view whose window is given, and the depth of its texels.
View MakeView(const glm::dvec3& origin, const Axes& axes, const Window& window, bool isPerspective,
  int resolution)
{
  View view;
  view.IsPerspective = isPerspective;
  view.LightFromWorld = MakeLightFromWorld(origin, axes);
  const double nearest = window.Along.First;
  const double farthest = window.Along.Last;
  const double depth = farthest - nearest;
  const std::array<Range, 2> across{ { window.Right, window.Up } };
  glm::dmat4& clip = view.ClipFromLight;
  for (int i = 0; i < 2; ++i)
  {
    const double scale = 2.0 / across[i].GetSize();
    const double middle = across[i].GetMiddle();
    clip[i][i] = scale;
    // The light looks along -z, and w is -z in perspective.
    clip[isPerspective ? 2 : 3][i] = isPerspective ? scale * middle : -scale * middle;
  }
  const double texel = std::max(window.Right.GetSize(), window.Up.GetSize()) / resolution;
  if (isPerspective)
  {
    clip[2][2] = -(farthest + nearest) / depth;
    clip[3][2] = -2.0 * farthest * nearest / depth;
    clip[2][3] = -1.0;
    // A step along the ray by a share of the way to the light.
    view.TexelDepth = { { 0.0, texel * 2.0 * farthest * nearest / depth } };
  }
  else
  {
    clip[2][2] = -2.0 / depth;
    clip[3][2] = -(farthest + nearest) / depth;
    clip[3][3] = 1.0;
    view.TexelDepth = { { texel * 2.0 / depth, 0.0 } };
  }
  view.ClipFromWorld = clip * view.LightFromWorld;
  return view;
}

void GrowAcross(Window& window, double least)
{
  for (Range* range : { &window.Right, &window.Up })
  {
    range->Grow(std::max(MARGIN * range->GetSize(), least));
  }
}

View FitDirectional(
  const glm::dvec3& direction, const std::vector<glm::dvec3>& corners, double size, int resolution)
{
  const Axes axes(direction);
  glm::dvec3 origin(0.0);
  for (const glm::dvec3& corner : corners)
  {
    origin += corner / static_cast<double>(corners.size());
  }
  Window window;
  for (const glm::dvec3& corner : corners)
  {
    const glm::dvec3 offset = corner - origin;
    window.Right.Add(glm::dot(offset, axes.Right));
    window.Up.Add(glm::dot(offset, axes.Up));
    window.Along.Add(glm::dot(offset, axes.Along));
  }
  GrowAcross(window, 1e-6 * size);
  window.Along.Grow(std::max(MARGIN * window.Along.GetSize(), 1e-4 * size));
  return MakeView(origin, axes, window, false, resolution);
}

// Finds the window of a positional light along an axis; false where something lies too far aside.
bool FindWindow(const glm::dvec3& position, const Axes& axes,
  const std::vector<glm::dvec3>& corners, Window& window)
{
  for (const glm::dvec3& corner : corners)
  {
    const glm::dvec3 offset = corner - position;
    const double along = glm::dot(offset, axes.Along);
    if (!(along > LEAST_COSINE * Vectors::SafeLength(offset)))
    {
      return false;
    }
    window.Right.Add(glm::dot(offset, axes.Right) / along);
    window.Up.Add(glm::dot(offset, axes.Up) / along);
    window.Along.Add(along);
  }
  return true;
}

void FitPositional(const LightSource& source, const UnitSpace& space,
  const std::vector<glm::dvec3>& corners, int resolution, std::vector<View>& views)
{
  const glm::dvec3 position = space.Center + space.Radius * source.Position;
  double farthest = 0.0;
  glm::dvec3 middle(0.0);
  for (const glm::dvec3& corner : corners)
  {
    farthest = std::max(farthest, Vectors::SafeLength(corner - position));
    middle += (corner - position) / static_cast<double>(corners.size());
  }
  farthest *= 1.0 + MARGIN;
  Window window;
  const Axes towards(UnitVector::Normalize(middle, source.Direction));
  if (FindWindow(position, towards, corners, window))
  {
    GrowAcross(window, 1e-6);
    window.Along.First = std::max(window.Along.First * (1.0 - MARGIN), NEAREST * farthest);
    window.Along.Last = std::max(window.Along.Last, window.Along.First) * (1.0 + MARGIN);
    views.push_back(MakeView(position, towards, window, true, resolution));
    return;
  }
  window = Window();
  window.Along = Range{ NEAREST * farthest, farthest };
  if (source.ConeCosine > LEAST_COSINE)
  {
    const double tangent =
      std::sqrt(std::max(1.0 - source.ConeCosine * source.ConeCosine, 1e-12)) / source.ConeCosine;
    window.Right = window.Up = Range{ -tangent, tangent };
    GrowAcross(window, 2.0 * tangent / resolution);
    views.push_back(MakeView(position, Axes(source.Direction), window, true, resolution));
    return;
  }
  // A side reaches over its edges by the texels that are interpolated there.
  const double reach = 1.0 + 4.0 / resolution;
  window.Right = window.Up = Range{ -reach, reach };
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double sign : { -1.0, 1.0 })
    {
      glm::dvec3 direction(0.0);
      direction[axis] = sign;
      views.push_back(MakeView(position, Axes(direction), window, true, resolution));
    }
  }
}
}

void CasterViews::Fit(const std::vector<LightSource>& lights, const UnitSpace& space,
  const std::vector<Box>& casters, int resolution)
{
  this->Lights.clear();
  this->Views.clear();
  const std::vector<glm::dvec3> corners = GetCorners(casters);
  for (const LightSource& source : lights)
  {
    if (!(source.ShadowStrength > 0.0) || source.Light->LightTypeIsHeadlight() || corners.empty())
    {
      continue;
    }
    Light light;
    light.Source = source.Light;
    light.Strength = source.ShadowStrength;
    light.FirstView = static_cast<int>(this->Views.size());
    if (source.IsPositional)
    {
      FitPositional(source, space, corners, resolution, this->Views);
    }
    else
    {
      this->Views.push_back(FitDirectional(source.Direction, corners, space.Radius, resolution));
    }
    light.Views = static_cast<int>(this->Views.size()) - light.FirstView;
    this->Lights.push_back(light);
  }
}

const CasterViews::Light* CasterViews::Find(vtkLight* light) const
{
  const auto found = std::find_if(this->Lights.begin(), this->Lights.end(),
    [light](const Light& other) { return other.Source == light; });
  return found == this->Lights.end() ? nullptr : &*found;
}

void CasterViews::SetCamera(const View& view, vtkCamera* camera)
{
  const glm::dmat4& light = view.LightFromWorld;
  const glm::dvec3 right = UnitVector::GetRow(light, 0);
  const glm::dvec3 up = UnitVector::GetRow(light, 1);
  const glm::dvec3 along = -UnitVector::GetRow(light, 2);
  const glm::dvec3 origin = -(light[3][0] * right + light[3][1] * up - light[3][2] * along);
  const glm::dvec3 focus = origin + along;
  camera->SetPosition(origin.x, origin.y, origin.z);
  camera->SetFocalPoint(focus.x, focus.y, focus.z);
  camera->SetViewUp(up.x, up.y, up.z);
  camera->SetParallelProjection(view.IsPerspective ? 0 : 1);
  vtkNew<vtkMatrix4x4> projection;
  projection->DeepCopy(glm::value_ptr(glm::transpose(view.ClipFromLight)));
  camera->SetExplicitProjectionTransformMatrix(projection);
  camera->SetUseExplicitProjectionTransformMatrix(true);
}

}
