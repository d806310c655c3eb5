// SPDX-License-Identifier: BSD-3-Clause
#include "Tetrahedra/PixelSegments.h"

#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Checks/ReferenceCheck.h"

#include "vtkCamera.h"
#include "vtkCell.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkHardwareSelector.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cmath>

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
  const Point3 direction = Difference(this->Far, this->Near);
  return this->IsEmpty() ? 0.0 : (this->To - this->From) * vtkMath::Norm(direction.data());
}

Point3 PixelSegment::At(double fraction) const
{
  const Point3 direction = Difference(this->Far, this->Near);
  return { { this->Near[0] + fraction * direction[0], this->Near[1] + fraction * direction[1],
    this->Near[2] + fraction * direction[2] } };
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
  vtkNew<vtkMatrix4x4> matrix;
  volume->GetMatrix(matrix);
  vtkNew<vtkMatrix4x4> inverse;
  vtkMatrix4x4::Invert(matrix, inverse);
  for (const auto& [axis, side] : AllIndices(3, 2))
  {
    double corner[4] = { box[0], box[2], box[4], 1.0 };
    corner[axis] = box[2 * axis + side];
    matrix->MultiplyPoint(corner, corner);
    // The inward normal of this side in world coordinates. The gradient of the volume's coordinate
    // along the axis is a row of the inverse matrix.
    Point3 normal;
    for (int k = 0; k < 3; ++k)
    {
      normal[k] = (side == 0 ? 1.0 : -1.0) * inverse->GetElement(axis, k);
    }
    this->Clip(normal, { { corner[0], corner[1], corner[2] } });
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

namespace
{
/// Returns the point of a segment up to which its opacity is half of the total.
Point3 FindHalfOpacity(
  const PixelSegment& segment, const std::function<double(const Point3&)>& extinction)
{
  constexpr int steps = 1000;
  std::array<double, steps + 1> depths{};
  const double step = (segment.GetTo() - segment.GetFrom()) / steps;
  for (int i = 0; i < steps; ++i)
  {
    depths[i + 1] = depths[i] +
      extinction(segment.At(segment.GetFrom() + (i + 0.5) * step)) * segment.GetLength() / steps;
  }
  const double half = -std::log(1.0 - 0.5 * (1.0 - std::exp(-depths.back())));
  const auto next = std::upper_bound(depths.begin() + 1, depths.end() - 1, half);
  const double behind = (*next - half) / (*next - *(next - 1));
  return segment.At(
    segment.GetFrom() + (static_cast<double>(next - depths.begin()) - behind) * step);
}
}

int CheckSelection(Check& check, vtkRenderer* renderer, vtkVolume* volume, vtkDataSet* grid,
  const std::function<void(PixelSegment&)>& cut,
  const std::function<double(const Point3&)>& extinction)
{
  const PixelSegments segments(renderer);
  vtkNew<vtkMatrix4x4> inverse;
  vtkMatrix4x4::Invert(volume->GetMatrix(), inverse);
  const int* size = renderer->GetSize();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(renderer);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  selector->SetArea(
    0, 0, static_cast<unsigned int>(size[0] - 1), static_cast<unsigned int>(size[1] - 1));
  selector->CaptureBuffers();
  int found = 0;
  for (int j = 0; j < size[1]; j += 3)
  {
    for (int i = 0; i < size[0]; i += 3)
    {
      PixelSegment segment = segments.Get(i, j);
      cut(segment);
      const unsigned int pixel[2] = { static_cast<unsigned int>(i), static_cast<unsigned int>(j) };
      const vtkHardwareSelector::PixelInformation seen = selector->GetPixelInformation(pixel);
      if (segment.GetLength() < 1e-4)
      {
        check.That(
          segment.GetLength() > 0.0 || !seen.Valid, "selection: no cell outside the volume");
        continue;
      }
      check.That(seen.Valid, "selection: a cell inside the volume");
      if (!seen.Valid)
      {
        continue;
      }
      ++found;
      const Point3 position = FindHalfOpacity(segment, extinction);
      double point[4] = { position[0], position[1], position[2], 1.0 };
      inverse->MultiplyPoint(point, point);
      int subId = 0;
      double parametric[3];
      double closest[3];
      double distance = 0.0;
      double weights[4];
      grid->GetCell(seen.AttributeID)
        ->EvaluatePosition(point, closest, subId, parametric, distance, weights);
      check.That(distance < 1e-6, "selection: the cell is at half of the opacity");
    }
  }
  return found;
}

}
