#include "vtkCentroidOrder.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr vtkIdType Grain = 16384;

using Vector = std::array<double, 3>;

double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Four times the centroid.
Vector SumCorners(const vtkTetrahedraMesh& mesh, std::uint32_t tetrahedron)
{
  const std::uint32_t* corners = mesh.GetCorners(tetrahedron);
  const double* a = mesh.GetPoint(corners[0]);
  const double* b = mesh.GetPoint(corners[1]);
  const double* c = mesh.GetPoint(corners[2]);
  const double* d = mesh.GetPoint(corners[3]);
  return { { (a[0] + b[0]) + (c[0] + d[0]), (a[1] + b[1]) + (c[1] + d[1]),
    (a[2] + b[2]) + (c[2] + d[2]) } };
}

// The greatest distance of a point from the origin.
double GetRadius(const vtkTetrahedraMesh& mesh)
{
  const vtkIdType number = static_cast<vtkIdType>(mesh.Points.size() / 3);
  std::vector<double> radii((number + Grain - 1) / Grain, 0.0);
  vtkSMPTools::For(0, static_cast<vtkIdType>(radii.size()), 1,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType chunk = first; chunk < last; ++chunk)
      {
        double radius = 0.0;
        for (vtkIdType i = chunk * Grain; i < std::min(number, (chunk + 1) * Grain); ++i)
        {
          const double* p = &mesh.Points[3 * i];
          radius = std::max(radius, p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
        }
        radii[chunk] = radius;
      }
    });
  double radius = 0.0;
  for (const double r : radii)
  {
    radius = std::max(radius, r);
  }
  return std::sqrt(radius);
}

template <typename Measure>
void FillKeys(
  const vtkTetrahedraMesh& mesh, std::vector<std::uint32_t>& keys, const Measure& measure)
{
  keys.resize(mesh.GetNumberOfTetrahedra());
  vtkSMPTools::For(0, static_cast<vtkIdType>(keys.size()), Grain,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        const double value = measure(SumCorners(mesh, static_cast<std::uint32_t>(i)));
        keys[i] = vtkRadixOrder::MakeKey(static_cast<float>(value));
      }
    });
}
}

void vtkCentroidOrder::Compute(
  const vtkTetrahedraMesh& mesh, const vtkViewpoint& view, std::vector<std::uint32_t>& frontToBack)
{
  // All measures are of sums of corners: the eye is moved out as far.
  const Vector eye = { { 4.0 * view.Eye[0], 4.0 * view.Eye[1], 4.0 * view.Eye[2] } };
  const double distance = std::sqrt(Dot(eye, eye));
  const double radius = view.IsParallel ? 0.0 : 4.0 * GetRadius(mesh);
  if (view.IsParallel)
  {
    FillKeys(mesh, this->Keys, [&](const Vector& sum) { return Dot(sum, view.Direction); });
  }
  else if (distance <= radius)
  {
    FillKeys(mesh, this->Keys,
      [&](const Vector& sum)
      {
        const Vector d = { { sum[0] - eye[0], sum[1] - eye[1], sum[2] - eye[2] } };
        return Dot(d, d);
      });
  }
  else
  {
    // Squared distance less that of the nearest place within the radius: of a far eye's squared
    // distances single precision would keep too little.
    const double offset = radius * (2.0 * distance - radius);
    FillKeys(mesh, this->Keys,
      [&](const Vector& sum) { return Dot(sum, sum) - 2.0 * Dot(sum, eye) + offset; });
  }
  frontToBack.resize(this->Keys.size());
  this->Radix.Sort(
    this->Keys.data(), static_cast<std::uint32_t>(this->Keys.size()), frontToBack.data());
}

std::size_t vtkCentroidOrder::GetBytes() const
{
  return this->Keys.capacity() * sizeof(std::uint32_t) + this->Radix.GetBytes();
}
