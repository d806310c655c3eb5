// SPDX-License-Identifier: BSD-3-Clause
#include "View/TetrahedraView.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cmath>

namespace interlume
{

namespace
{
/// Lines of sight pass this far from the pixels' centres. Regular meshes in regular views have
/// edges and faces through the centres, where rounding alone would choose between neighbours. The
/// less, the thinner meshes that are seen from the side may be.
constexpr double HAIR_X = 2.3e-9;
constexpr double HAIR_Y = 3.7e-9;
}

std::string TetrahedraView::Set(
  vtkRenderer* renderer, vtkVolume* volume, const TetrahedraMesh& mesh, int stride)
{
  int width = 0;
  int height = 0;
  int left = 0;
  int bottom = 0;
  renderer->GetTiledSizeAndOrigin(&width, &height, &left, &bottom);
  this->Width = (width + stride - 1) / stride;
  this->Height = (height + stride - 1) / stride;
  vtkCamera* camera = renderer->GetActiveCamera();
  this->Parallel = camera->GetParallelProjection() != 0;

  // Everything is put together in double precision before a coordinate is touched.
  vtkNew<vtkMatrix4x4> place;
  volume->GetMatrix(place);
  vtkNew<vtkMatrix4x4> meshPlace;
  for (int i = 0; i < 3; ++i)
  {
    meshPlace->SetElement(i, i, mesh.Scale);
    meshPlace->SetElement(i, 3, mesh.Origin[i]);
  }
  vtkMatrix4x4::Multiply4x4(place, meshPlace, place);
  const double determinant = std::abs(place->Determinant());
  if (!(determinant > 0.0) || !std::isfinite(determinant))
  {
    return "the volume's matrix is singular or not finite";
  }
  this->Unit = std::cbrt(determinant);
  vtkNew<vtkMatrix4x4> eye;
  vtkMatrix4x4::Multiply4x4(camera->GetModelViewTransformMatrix(), place, eye);
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      this->EyeFromMesh[4 * i + j] = eye->GetElement(i, j) / this->Unit;
    }
  }

  vtkMatrix4x4* p =
    camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0);
  const double halfWidth = 0.5 * width / stride;
  const double halfHeight = 0.5 * height / stride;
  // In perspective the row's constant, in parallel no unit, belongs to lengths.
  const double length = this->Parallel ? this->Unit : 1.0;
  this->ScaleX = halfWidth * p->GetElement(0, 0) * length;
  this->ScaleY = halfHeight * p->GetElement(1, 1) * length;
  this->ShiftX = halfWidth * p->GetElement(0, 2) * length;
  this->ShiftY = halfHeight * p->GetElement(1, 2) * length;
  this->OffsetX = halfWidth * (1.0 + (this->Parallel ? p->GetElement(0, 3) : 0.0)) + HAIR_X;
  this->OffsetY = halfHeight * (1.0 + (this->Parallel ? p->GetElement(1, 3) : 0.0)) + HAIR_Y;

  double range[2];
  camera->GetClippingRange(range);
  this->Near = range[0] / this->Unit;
  this->Far = range[1] / this->Unit;
  const double p22 = p->GetElement(2, 2);
  const double p23 = p->GetElement(2, 3);
  if (this->Parallel)
  {
    this->DepthOfBuffer = { { (-1.0 - p23) / (p22 * this->Unit), 2.0 / (p22 * this->Unit) } };
  }
  else
  {
    this->DepthOfBuffer = { { (p22 - 1.0) * this->Unit / p23, 2.0 * this->Unit / p23 } };
  }
  return {};
}

std::array<double, 2> TetrahedraView::GetReach() const
{
  // Mesh coordinates are between -1 and 1; the limit is a little more for rounding.
  const double limit = 1.0 + 1e-9;
  const double* row = &this->EyeFromMesh[8];
  const double reach = limit * (std::abs(row[0]) + std::abs(row[1]) + std::abs(row[2]));
  return { { -row[3] - reach, -row[3] + reach } };
}

double TetrahedraView::GetSlant(double x, double y) const
{
  if (this->Parallel)
  {
    const double dx = this->ShiftX / this->ScaleX;
    const double dy = this->ShiftY / this->ScaleY;
    return std::sqrt(1.0 + dx * dx + dy * dy);
  }
  const glm::dvec3 eye = this->GetEyePoint(x, y, 1.0);
  return std::sqrt(eye[0] * eye[0] + eye[1] * eye[1] + 1.0);
}

ViewRays TetrahedraView::GetRays() const
{
  vtkNew<vtkMatrix4x4> matrix;
  for (int i = 0; i < 12; ++i)
  {
    matrix->SetElement(i / 4, i % 4, this->EyeFromMesh[i]);
  }
  matrix->Invert();
  ViewRays rays;
  rays.Viewpoint.IsParallel = this->Parallel;
  // A shear bends the line of sight off the axis.
  const double dx = this->Parallel ? this->ShiftX / this->ScaleX : 0.0;
  const double dy = this->Parallel ? this->ShiftY / this->ScaleY : 0.0;
  double length = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    rays.Right[i] = matrix->GetElement(i, 0);
    rays.Up[i] = matrix->GetElement(i, 1);
    rays.Viewpoint.Eye[i] = matrix->GetElement(i, 3);
    rays.Viewpoint.Direction[i] = dx * rays.Right[i] + dy * rays.Up[i] - matrix->GetElement(i, 2);
    length += rays.Viewpoint.Direction[i] * rays.Viewpoint.Direction[i];
  }
  length = std::sqrt(length);
  for (int i = 0; i < 3; ++i)
  {
    rays.Viewpoint.Direction[i] /= length;
    // The length of the direction and their lengths belong together in perspective only.
    rays.Right[i] /= this->Parallel ? 1.0 : length;
    rays.Up[i] /= this->Parallel ? 1.0 : length;
  }
  rays.HalfSize = { { 0.5 * this->Width / this->ScaleX, 0.5 * this->Height / this->ScaleY } };
  const glm::dvec3 middle =
    this->GetEyePoint(0.5 * this->Width, 0.5 * this->Height, this->Parallel ? 0.0 : 1.0);
  rays.Center = { { middle[0], middle[1] } };
  rays.Width = this->Width;
  rays.Height = this->Height;
  return rays;
}

bool TetrahedraView::operator==(const TetrahedraView& other) const
{
  return this->Width == other.Width && this->Height == other.Height &&
    this->Parallel == other.Parallel && this->Unit == other.Unit && this->Near == other.Near &&
    this->Far == other.Far && this->EyeFromMesh == other.EyeFromMesh &&
    this->GetPixelsFromEye() == other.GetPixelsFromEye();
}

}
