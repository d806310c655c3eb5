#include "Order/CentroidOrder.h"

#include "Mesh/TetrahedraExtent.h"
#include "Mesh/Triple.h"

#include "vtkSMPTools.h"

#include <cmath>

namespace interlume
{

namespace
{
using namespace TripleMath;

constexpr vtkIdType Grain = 16384;

// Four times the centroid.
Triple SumCorners(const TetrahedraMesh& mesh, std::uint32_t tetrahedron)
{
  const std::uint32_t* corners = mesh.GetCorners(tetrahedron);
  const double* a = mesh.GetPoint(corners[0]);
  const double* b = mesh.GetPoint(corners[1]);
  const double* c = mesh.GetPoint(corners[2]);
  const double* d = mesh.GetPoint(corners[3]);
  return { { (a[0] + b[0]) + (c[0] + d[0]), (a[1] + b[1]) + (c[1] + d[1]),
    (a[2] + b[2]) + (c[2] + d[2]) } };
}

template <typename Measure>
void FillKeys(const TetrahedraMesh& mesh, std::vector<std::uint32_t>& keys, const Measure& measure)
{
  keys.resize(mesh.GetNumberOfTetrahedra());
  vtkSMPTools::For(0, static_cast<vtkIdType>(keys.size()), Grain,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        const double value = measure(SumCorners(mesh, static_cast<std::uint32_t>(i)));
        keys[i] = RadixOrder::MakeKey(static_cast<float>(value));
      }
    });
}
}

void CentroidOrder::Compute(
  const TetrahedraMesh& mesh, const Viewpoint& view, std::vector<std::uint32_t>& frontToBack)
{
  // All measures are of sums of corners: the eye is moved out as far.
  const Triple eye = { { 4.0 * view.Eye[0], 4.0 * view.Eye[1], 4.0 * view.Eye[2] } };
  const double distance = std::sqrt(Dot(eye, eye));
  const double radius = view.IsParallel ? 0.0 : 4.0 * TetrahedraExtent::GetRadius(mesh);
  if (view.IsParallel)
  {
    FillKeys(mesh, this->Keys, [&](const Triple& sum) { return Dot(sum, view.Direction); });
  }
  else if (distance <= radius)
  {
    FillKeys(mesh, this->Keys,
      [&](const Triple& sum)
      {
        const Triple d = Subtract(sum, eye);
        return Dot(d, d);
      });
  }
  else
  {
    // Squared distance less that of the nearest place within the radius: of a far eye's squared
    // distances single precision would keep too little.
    const double offset = radius * (2.0 * distance - radius);
    FillKeys(mesh, this->Keys,
      [&](const Triple& sum) { return Dot(sum, sum) - 2.0 * Dot(sum, eye) + offset; });
  }
  frontToBack.resize(this->Keys.size());
  this->Radix.Sort(
    this->Keys.data(), static_cast<std::uint32_t>(this->Keys.size()), frontToBack.data());
}

std::size_t CentroidOrder::GetBytes() const
{
  return this->Keys.capacity() * sizeof(std::uint32_t) + this->Radix.GetBytes();
}

}
