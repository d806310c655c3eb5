// SPDX-License-Identifier: BSD-3-Clause
#include "View/TetrahedraView.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace interlume
{

namespace
{
/// View rays are offset from pixel centers by this many pixels. Otherwise, in axis-aligned views of
/// regular meshes, edges and faces would pass exactly through pixel centers, and rounding errors
/// would decide which adjacent cell a view ray hits. The smaller the offset, the thinner a mesh
/// seen edge-on may be.
constexpr double PIXEL_OFFSET_X = 2.3e-9;
constexpr double PIXEL_OFFSET_Y = 3.7e-9;

// Returns the transposed matrix, whose columns are the rows of \a matrix.
glm::dmat4 GetRows(vtkMatrix4x4* matrix)
{
  return glm::make_mat4(matrix->GetData());
}

// Returns the rows of the matrix to clip coordinates. It is the product of the camera's matrix from
// world to clip coordinates and the matrix to world coordinates whose rows are \a toWorld.
glm::dmat4 GetClipRows(vtkRenderer* renderer, const glm::dmat4& toWorld)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  return (toWorld * GetRows(camera->GetModelViewTransformMatrix())) *
    GetRows(camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0));
}

glm::dvec4 Normalized(const glm::dvec4& plane)
{
  return plane / glm::length(glm::dvec3(plane));
}
}

/// The right-handed axes of eye coordinates, in world coordinates, from an RQ decomposition of the
/// clip matrix. Clip coordinates (X, Y, Z, w) depend on eye coordinates (x, y, z) as follows: X =
/// ScaleX x + SkewX y + ShiftX z and Y = ScaleY y + ShiftY z. In perspective, w = -Depth z; in
/// parallel projection, Z = -Depth z.
struct TetrahedraView::Axes
{
  Axes(const glm::dmat4& clip, int deepRow)
    : DeepRow(deepRow)
  {
    const glm::dvec3 deep(clip[deepRow]);
    this->Depth = glm::length(deep);
    this->Back = -deep / this->Depth;
    const glm::dvec3 y(clip[1]);
    this->ShiftY = glm::dot(y, this->Back);
    this->Up = y - this->ShiftY * this->Back;
    this->ScaleY = glm::length(this->Up);
    this->Up /= this->ScaleY;
    this->Right = glm::cross(this->Up, this->Back);
    const glm::dvec3 x(clip[0]);
    this->ScaleX = glm::dot(x, this->Right);
    this->SkewX = glm::dot(x, this->Up);
    this->ShiftX = glm::dot(x, this->Back);
  }

  bool IsValid() const
  {
    const double inverse = 1.0 / (this->Depth * this->ScaleX * this->ScaleY);
    return std::isfinite(inverse) && inverse != 0.0;
  }

  // Returns the rows of the matrix to eye coordinates, given the rows of the matrix to clip
  // coordinates.
  std::array<glm::dvec4, 3> GetEyeRows(const glm::dmat4& clip) const
  {
    const glm::dvec4 z = clip[this->DeepRow] / -this->Depth;
    const glm::dvec4 y = (clip[1] - this->ShiftY * z) / this->ScaleY;
    return { { (clip[0] - this->SkewX * y - this->ShiftX * z) / this->ScaleX, y, z } };
  }

  // Returns the coefficients (a, b, c) of Z = a X + b Y + c w + constant, in perspective.
  glm::dvec3 GetDepthRow(const glm::dmat4& clip) const
  {
    const glm::dvec3 z(clip[2]);
    const double x = glm::dot(z, this->Right) / this->ScaleX;
    const double y = (glm::dot(z, this->Up) - x * this->SkewX) / this->ScaleY;
    return { x, y, (x * this->ShiftX + y * this->ShiftY - glm::dot(z, this->Back)) / this->Depth };
  }

  int DeepRow;
  glm::dvec3 Right;
  glm::dvec3 Up;
  glm::dvec3 Back;
  double Depth;
  double ScaleX;
  double SkewX;
  double ShiftX;
  double ScaleY;
  double ShiftY;
};

Error TetrahedraView::Set(
  vtkRenderer* renderer, vtkVolume* volume, const TetrahedraMesh& mesh, int stride)
{
  int width = 0;
  int height = 0;
  int left = 0;
  int bottom = 0;
  renderer->GetTiledSizeAndOrigin(&width, &height, &left, &bottom);
  this->Width = (width + stride - 1) / stride;
  this->Height = (height + stride - 1) / stride;

  // Multiply the matrices in double precision first, and then transform points with the product.
  vtkNew<vtkMatrix4x4> volumeMatrix;
  volume->GetMatrix(volumeMatrix);
  vtkNew<vtkMatrix4x4> meshMatrix;
  for (int i = 0; i < 3; ++i)
  {
    meshMatrix->SetElement(i, i, mesh.Scale);
    meshMatrix->SetElement(i, 3, mesh.Origin[i]);
  }
  vtkMatrix4x4::Multiply4x4(volumeMatrix, meshMatrix, volumeMatrix);
  const double determinant = std::abs(volumeMatrix->Determinant());
  if (!(determinant > 0.0) || !std::isfinite(determinant))
  {
    return "the volume's matrix is singular or not finite; check the volume's position, scale and "
           "user matrix";
  }
  this->Unit = std::cbrt(determinant);
  this->WorldFromMesh = GetRows(volumeMatrix);
  return this->SetEye(GetClipRows(renderer, glm::dmat4(1.0)),
    GetClipRows(renderer, this->WorldFromMesh),
    glm::make_vec3(renderer->GetActiveCamera()->GetPosition()),
    { { 0.5 * width / stride, 0.5 * height / stride } });
}

Error TetrahedraView::SetEye(glm::dmat4 world, glm::dmat4 mesh, const glm::dvec3& camera,
  const std::array<double, 2>& halfSize)
{
  this->Parallel = glm::dvec3(world[3]) == glm::dvec3(0.0);
  if (this->Parallel)
  {
    mesh /= world[3].w;
    world /= world[3].w;
  }
  this->NearPlane = Normalized(mesh[3] + mesh[2]);
  this->FarPlane = Normalized(mesh[3] - mesh[2]);
  const Axes axes(world, this->Parallel ? 2 : 3);
  if (!axes.IsValid() || !std::isfinite(this->NearPlane.w) || !std::isfinite(this->FarPlane.w))
  {
    return "the camera matrix is singular or not finite; check the camera's position, focal point, "
           "clipping range and transforms";
  }

  // The origin of eye coordinates is the point where view rays meet, or the camera position in
  // parallel projection.
  glm::dvec3 origin(0.0);
  if (this->Parallel)
  {
    for (int row = 0; row < 3; ++row)
    {
      origin[row] = glm::dot(world[row], glm::dvec4(camera, 1.0));
      mesh[row].w -= origin[row];
      world[row].w -= origin[row];
    }
    const double unit = 1.0 / (axes.Depth * this->Unit);
    this->DepthOfBuffer = { (origin[2] + 1.0) * unit, -2.0 * unit, 0.0, 0.0 };
  }
  else
  {
    const glm::dvec3 row = axes.GetDepthRow(world);
    const double constant = mesh[2].w - row.x * mesh[0].w - row.y * mesh[1].w - row.z * mesh[3].w;
    const double unit = axes.Depth * this->Unit / constant;
    this->DepthOfBuffer = { (row.x + row.y - row.z - 1.0) * unit, 2.0 * unit,
      -row.x * unit / halfSize[0], -row.y * unit / halfSize[1] };
  }
  const std::array<glm::dvec4, 3> meshRows = axes.GetEyeRows(mesh);
  this->EyeFromWorld = axes.GetEyeRows(world);
  for (int i = 0; i < 3; ++i)
  {
    const glm::dvec4 row = meshRows[i] / this->Unit;
    std::copy_n(glm::value_ptr(row), 4, &this->EyeFromMesh[4 * i]);
    this->EyeFromWorld[i] /= this->Unit;
  }
  const double length = this->Parallel ? this->Unit : 1.0 / axes.Depth;
  this->ScaleX = halfSize[0] * axes.ScaleX * length;
  this->SkewX = halfSize[0] * axes.SkewX * length;
  this->ShiftX = halfSize[0] * axes.ShiftX * length;
  this->OffsetX = halfSize[0] * (1.0 + origin[0]) + PIXEL_OFFSET_X;
  this->ScaleY = halfSize[1] * axes.ScaleY * length;
  this->ShiftY = halfSize[1] * axes.ShiftY * length;
  this->OffsetY = halfSize[1] * (1.0 + origin[1]) + PIXEL_OFFSET_Y;
  return {};
}

std::array<double, 4> TetrahedraView::FindEye(vtkRenderer* renderer, vtkVolume* volume)
{
  vtkNew<vtkMatrix4x4> volumeMatrix;
  volume->GetMatrix(volumeMatrix);
  // The eye is the only point whose clip coordinates X, Y and w are 0.
  glm::dvec4 eye =
    glm::dvec4(0.0, 0.0, -1.0, 0.0) * glm::inverse(GetClipRows(renderer, GetRows(volumeMatrix)));
  eye = eye.w < 0.0 ? -eye : eye;
  return { { eye.x, eye.y, eye.z, eye.w } };
}

glm::dvec4 TetrahedraView::GetPlane(const double* normal, const double* origin) const
{
  glm::dvec4 plane(0.0);
  for (int i = 0; i < 3; ++i)
  {
    plane += normal[i] * (this->WorldFromMesh[i] - glm::dvec4(0.0, 0.0, 0.0, origin[i]));
  }
  return Normalized(plane);
}

std::array<double, 12> TetrahedraView::GetPixelsFromMesh() const
{
  std::array<double, 12> rows = this->EyeFromMesh;
  for (int j = 0; j < 4; ++j)
  {
    rows[j] = this->ScaleX * this->EyeFromMesh[j] + this->SkewX * this->EyeFromMesh[4 + j] +
      this->ShiftX * this->EyeFromMesh[8 + j];
    rows[4 + j] = this->ScaleY * this->EyeFromMesh[4 + j] + this->ShiftY * this->EyeFromMesh[8 + j];
  }
  return rows;
}

std::array<glm::dvec3, 2> TetrahedraView::GetEyeFromPixels() const
{
  const glm::dvec3 first = this->GetEyeCoordinates(0.0, 0.0, this->Parallel ? 0.0 : 1.0);
  return { { { 1.0 / this->ScaleX, -this->SkewX / (this->ScaleX * this->ScaleY), first.x },
    { 0.0, 1.0 / this->ScaleY, first.y } } };
}

glm::dvec2 TetrahedraView::GetTilt() const
{
  const double y = this->ShiftY / this->ScaleY;
  return { (this->ShiftX - this->SkewX * y) / this->ScaleX, y };
}

double TetrahedraView::GetViewRayLengthRatio(double x, double y) const
{
  const glm::dvec2 tilt =
    this->Parallel ? this->GetTilt() : glm::dvec2(this->GetEyeCoordinates(x, y, 1.0));
  return std::sqrt(glm::dot(tilt, tilt) + 1.0);
}

ViewRays TetrahedraView::GetRays() const
{
  vtkNew<vtkMatrix4x4> matrix;
  for (int i = 0; i < 12; ++i)
  {
    matrix->SetElement(i / 4, i % 4, this->EyeFromMesh[i]);
  }
  matrix->Invert();
  const auto column = [&matrix](int j)
  {
    return glm::dvec3(matrix->GetElement(0, j), matrix->GetElement(1, j), matrix->GetElement(2, j));
  };
  ViewRays rays;
  rays.Viewpoint.IsParallel = this->Parallel;
  rays.Viewpoint.Eye = column(3);
  // In parallel projection, view shear tilts the view rays relative to the view axis.
  const glm::dvec2 tilt = this->Parallel ? this->GetTilt() : glm::dvec2(0.0);
  const glm::dvec3 direction = tilt.x * column(0) + tilt.y * column(1) - column(2);
  const double length = glm::length(direction);
  rays.Viewpoint.Direction = direction / length;
  // In perspective, scale Right and Up together with the direction.
  const double size = this->Parallel ? 1.0 : length;
  const double skew = this->SkewX / this->ScaleX;
  rays.Right = column(0) / size;
  rays.Up = (column(1) - skew * column(0)) / size;
  rays.HalfSize = { { 0.5 * this->Width / this->ScaleX, 0.5 * this->Height / this->ScaleY } };
  const glm::dvec3 center =
    this->GetEyeCoordinates(0.5 * this->Width, 0.5 * this->Height, this->Parallel ? 0.0 : 1.0);
  rays.Center = { { center.x + skew * center.y, center.y } };
  rays.Width = this->Width;
  rays.Height = this->Height;
  return rays;
}

bool TetrahedraView::operator==(const TetrahedraView& other) const
{
  const auto tie = [](const TetrahedraView& v)
  {
    return std::tie(v.Width, v.Height, v.Parallel, v.Unit, v.EyeFromMesh, v.NearPlane, v.FarPlane,
      v.ScaleX, v.SkewX, v.ShiftX, v.OffsetX, v.ScaleY, v.ShiftY, v.OffsetY);
  };
  return tie(*this) == tie(other);
}

}
