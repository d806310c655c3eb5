// SPDX-License-Identifier: BSD-3-Clause
#include "Order/CentroidOrder.h"

#include "Common/ParallelFor.h"
#include "Common/Vectors.h"

#include <cmath>

namespace interlume
{

namespace
{
constexpr vtkIdType CentroidGrain = 16384;

// Returns four times the centroid.
glm::dvec3 SumCorners(const TetrahedraMesh& mesh, std::uint32_t tetrahedron)
{
  const std::uint32_t* corners = mesh.GetCorners(tetrahedron);
  const auto point = [&](int i) { return glm::make_vec3(mesh.GetPoint(corners[i])); };
  return (point(0) + point(1)) + (point(2) + point(3));
}

template <typename Measure>
void FillKeys(const TetrahedraMesh& mesh, std::vector<std::uint32_t>& keys, const Measure& measure)
{
  keys.resize(mesh.GetNumberOfTetrahedra());
  ParallelFor(0, static_cast<vtkIdType>(keys.size()), CentroidGrain,
    [&](vtkIdType i)
    {
      const double value = measure(SumCorners(mesh, static_cast<std::uint32_t>(i)));
      keys[i] = RadixSorter::MakeKey(static_cast<float>(value));
    });
}
}

bool CentroidOrder::Compute(const TetrahedraMesh& mesh, const Viewpoint& view,
  std::vector<std::uint32_t>& frontToBack, const std::function<bool()>& isAborted)
{
  // Keys use the sum of the corners, four times the centroid, so scale the camera position equally.
  const glm::dvec3 eye = 4.0 * view.Eye;
  const double distance = std::sqrt(glm::dot(eye, eye));
  const double radius = view.IsParallel ? 0.0 : 4.0 * mesh.GetRadius();
  if (view.IsParallel)
  {
    FillKeys(
      mesh, this->Keys, [&](const glm::dvec3& sum) { return glm::dot(sum, view.Direction); });
  }
  else if (distance <= radius)
  {
    FillKeys(mesh, this->Keys,
      [&](const glm::dvec3& sum)
      {
        const glm::dvec3 d = sum - eye;
        return glm::dot(d, d);
      });
  }
  else
  {
    // The squared distance minus its minimum over the bounding sphere. For a distant camera,
    // squared distances in single precision would have too few digits.
    const double offset = radius * (2.0 * distance - radius);
    FillKeys(mesh, this->Keys,
      [&](const glm::dvec3& sum)
      { return glm::dot(sum, sum) - 2.0 * glm::dot(sum, eye) + offset; });
  }
  if (isAborted && isAborted())
  {
    return false;
  }
  frontToBack.resize(this->Keys.size());
  this->Radix.Sort(
    this->Keys.data(), static_cast<std::uint32_t>(this->Keys.size()), frontToBack.data());
  return true;
}

std::size_t CentroidOrder::GetBytes() const
{
  return this->Keys.capacity() * sizeof(std::uint32_t) + this->Radix.GetBytes();
}

}
