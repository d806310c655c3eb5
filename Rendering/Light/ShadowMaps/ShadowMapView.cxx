// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowMaps/ShadowMapView.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"

namespace interlume
{

namespace
{
glm::dmat4 MakeLightFromWorld(const glm::dvec3& origin, const ShadowMapView::Axes& axes)
{
  const auto makeRow = [&origin](const glm::dvec3& axis)
  { return glm::dvec4(axis, -glm::dot(axis, origin)); };
  return glm::transpose(glm::dmat4(
    makeRow(axes.Right), makeRow(axes.Up), makeRow(-axes.Along), glm::dvec4(0.0, 0.0, 0.0, 1.0)));
}
}

void ShadowMapView::Window::AddSideMargins(double minimum)
{
  for (Range* range : { &this->Right, &this->Up })
  {
    range->Grow(std::max(Margin * range->GetSize(), minimum));
  }
}

void ShadowMapView::Window::AddDepthMargins(double farthest)
{
  this->Along.First = std::max(this->Along.First * (1.0 - Margin), Nearest * farthest);
  this->Along.Last = std::max(this->Along.Last, this->Along.First) * (1.0 + Margin);
}

void ShadowMapView::Window::SetCubeFace(double farthest, int resolution)
{
  const double reach = 1.0 + 4.0 / resolution;
  this->Along = Range{ Nearest * farthest, farthest };
  this->Right = this->Up = Range{ -reach, reach };
}

void ShadowMapView::Window::SetCone(double farthest, double tangent, int resolution)
{
  this->Along = Range{ Nearest * farthest, farthest };
  this->Right = this->Up = Range{ -tangent, tangent };
  this->AddSideMargins(2.0 * tangent / resolution);
}

glm::dvec2 ShadowMapView::Window::GetDepth(bool isPerspective) const
{
  const double nearest = this->Along.First;
  const double farthest = this->Along.Last;
  const double depth = farthest - nearest;
  return isPerspective ? glm::dvec2((farthest + nearest) / depth, 2.0 * farthest * nearest / depth)
                       : glm::dvec2(-(farthest + nearest) / depth, 2.0 / depth);
}

std::vector<glm::dvec3> ShadowMapView::GetCorners(const std::vector<Box>& boxes)
{
  std::vector<glm::dvec3> corners;
  corners.reserve(8 * boxes.size());
  for (const Box& box : boxes)
  {
    for (unsigned corner = 0; corner < 8; ++corner)
    {
      corners.emplace_back(
        box[corner & 1U], box[2 + (corner >> 1 & 1U)], box[4 + (corner >> 2 & 1U)]);
    }
  }
  return corners;
}

glm::dvec3 ShadowMapView::GetSide(int side)
{
  glm::dvec3 direction(0.0);
  direction[side / 2] = side % 2 == 0 ? -1.0 : 1.0;
  return direction;
}

bool ShadowMapView::FindWindow(const glm::dvec3& position, const Axes& axes,
  const std::vector<glm::dvec3>& corners, Window& window)
{
  for (const glm::dvec3& corner : corners)
  {
    const glm::dvec3 offset = corner - position;
    const double along = glm::dot(offset, axes.Along);
    if (!(along > MinimumCosine * Vectors::SafeLength(offset)))
    {
      return false;
    }
    window.Right.Add(glm::dot(offset, axes.Right) / along);
    window.Up.Add(glm::dot(offset, axes.Up) / along);
    window.Along.Add(along);
  }
  return true;
}

ShadowMapView::Window ShadowMapView::FindWindow(const glm::dvec3& origin, const Axes& axes,
  const glm::dvec2& shear, const std::vector<glm::dvec3>& corners, double size)
{
  Window window;
  window.Shear = shear;
  for (const glm::dvec3& corner : corners)
  {
    const glm::dvec3 offset = corner - origin;
    const double along = glm::dot(offset, axes.Along);
    window.Right.Add(glm::dot(offset, axes.Right) - shear.x * along);
    window.Up.Add(glm::dot(offset, axes.Up) - shear.y * along);
    window.Along.Add(along);
  }
  window.AddSideMargins(1e-6 * size);
  window.Along.Grow(std::max(Margin * window.Along.GetSize(), 1e-4 * size));
  return window;
}

ShadowMapView ShadowMapView::Make(const glm::dvec3& origin, const Axes& axes, const Window& window,
  bool isPerspective, int resolution)
{
  ShadowMapView view;
  view.IsPerspective = isPerspective;
  view.LightFromWorld = MakeLightFromWorld(origin, axes);
  const glm::dvec2 depth = window.GetDepth(isPerspective);
  const std::array<Range, 2> across{ { window.Right, window.Up } };
  glm::dmat4& clip = view.ClipFromLight;
  for (int i = 0; i < 2; ++i)
  {
    const double scale = 2.0 / across[i].GetSize();
    const double center = across[i].GetCenter();
    // The light looks along -z. For a positional light, w is -z.
    clip[i][i] = scale;
    clip[2][i] = isPerspective ? scale * center : scale * window.Shear[i];
    clip[3][i] = isPerspective ? 0.0 : -scale * center;
  }
  const double texel = std::max(window.Right.GetSize(), window.Up.GetSize()) / resolution;
  if (isPerspective)
  {
    clip[2][2] = -depth.x;
    clip[3][2] = -depth.y;
    clip[2][3] = -1.0;
    // The width of a texel at distance w is texel * w. The depth changes by texel * depth.y / w
    // over that distance.
    view.TexelDepth = { { 0.0, texel * depth.y } };
  }
  else
  {
    clip[2][2] = -depth.y;
    clip[3][2] = depth.x;
    clip[3][3] = 1.0;
    view.TexelDepth = { { texel * depth.y, 0.0 } };
  }
  view.ClipFromWorld = clip * view.LightFromWorld;
  return view;
}

void ShadowMapView::SetCamera(vtkCamera* camera) const
{
  const glm::dmat4& light = this->LightFromWorld;
  const glm::dvec3 right = UnitVector::GetRow(light, 0);
  const glm::dvec3 up = UnitVector::GetRow(light, 1);
  const glm::dvec3 along = -UnitVector::GetRow(light, 2);
  const glm::dvec3 origin = -(light[3][0] * right + light[3][1] * up - light[3][2] * along);
  const glm::dvec3 focus = origin + along;
  camera->SetPosition(origin.x, origin.y, origin.z);
  camera->SetFocalPoint(focus.x, focus.y, focus.z);
  camera->SetViewUp(up.x, up.y, up.z);
  camera->SetParallelProjection(this->IsPerspective ? 0 : 1);
  vtkNew<vtkMatrix4x4> projection;
  projection->DeepCopy(glm::value_ptr(glm::transpose(this->ClipFromLight)));
  camera->SetExplicitProjectionTransformMatrix(projection);
  camera->SetUseExplicitProjectionTransformMatrix(true);
}

}
