// SPDX-License-Identifier: BSD-3-Clause
#include "Tetrahedra/PixelSegments.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>

namespace reference
{

namespace
{
Point3 Difference(const Point3& a, const Point3& b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2] } };
}
}

double PixelSegment::GetLength() const
{
  const Point3 way = Difference(this->Far, this->Near);
  return this->IsEmpty() ? 0.0 : (this->To - this->From) * vtkMath::Norm(way.data());
}

Point3 PixelSegment::At(double fraction) const
{
  const Point3 way = Difference(this->Far, this->Near);
  return { { this->Near[0] + fraction * way[0], this->Near[1] + fraction * way[1],
    this->Near[2] + fraction * way[2] } };
}

void PixelSegment::Clip(const Point3& normal, const Point3& origin)
{
  const double near = vtkMath::Dot(normal.data(), Difference(this->Near, origin).data());
  const double far = vtkMath::Dot(normal.data(), Difference(this->Far, origin).data());
  const double cut = near / (near - far);
  if (near < 0.0)
  {
    this->From = far < 0.0 ? this->To : std::max(this->From, cut);
  }
  else if (far < 0.0)
  {
    this->To = std::min(this->To, cut);
  }
}

void PixelSegment::ClipToBox(const std::array<double, 6>& box, vtkVolume* volume)
{
  vtkNew<vtkMatrix4x4> place;
  volume->GetMatrix(place);
  vtkNew<vtkMatrix4x4> inverse;
  vtkMatrix4x4::Invert(place, inverse);
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int side = 0; side < 2; ++side)
    {
      double corner[4] = { box[0], box[2], box[4], 1.0 };
      corner[axis] = box[2 * axis + side];
      place->MultiplyPoint(corner, corner);
      // The gradient of the volume's coordinate.
      Point3 normal;
      for (int k = 0; k < 3; ++k)
      {
        normal[k] = (side == 0 ? 1.0 : -1.0) * inverse->GetElement(axis, k);
      }
      this->Clip(normal, { { corner[0], corner[1], corner[2] } });
    }
  }
}

PixelSegments::PixelSegments(vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  vtkMatrix4x4::Multiply4x4(
    camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0),
    camera->GetModelViewTransformMatrix(), this->WorldFromClip);
  this->WorldFromClip->Invert();
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&this->Size[0], &this->Size[1], &origin[0], &origin[1]);
}

Point3 PixelSegments::Unproject(double x, double y, double z) const
{
  double point[4] = { x, y, z, 1.0 };
  this->WorldFromClip->MultiplyPoint(point, point);
  return { { point[0] / point[3], point[1] / point[3], point[2] / point[3] } };
}

PixelSegment PixelSegments::Get(int i, int j) const
{
  const double x = (2 * i + 1) / static_cast<double>(this->Size[0]) - 1.0;
  const double y = (2 * j + 1) / static_cast<double>(this->Size[1]) - 1.0;
  return { this->Unproject(x, y, -1.0), this->Unproject(x, y, 1.0) };
}

}
