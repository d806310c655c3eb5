// SPDX-License-Identifier: BSD-3-Clause
// Tests the centroid order against a stable sort of the same distances.
#include "Support/Checks/LargestError.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Tetrahedra/ReferenceViewRays.h"
#include "Support/Tetrahedra/ReferenceTetrahedra.h"

#include "Order/CentroidOrder.h"
#include "Order/RadixSorter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace
{

using namespace reference;

template <typename Key>
std::vector<std::uint32_t> SortStably(const std::vector<Key>& keys)
{
  std::vector<std::uint32_t> order(keys.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
    [&](std::uint32_t a, std::uint32_t b) { return keys[a] < keys[b]; });
  return order;
}

void CheckRadix(Check& check)
{
  std::mt19937 random(7);
  interlume::RadixSorter radix;
  for (const std::uint32_t number : { 0u, 1u, 2u, 1000u, 16384u, 300000u, 17u })
  {
    // One or two different keys, and keys of one to three digits of 11 bits. Keys of less than 32
    // bits have an offset.
    for (const int bits : { 0, 1, 11, 12, 22, 23, 32 })
    {
      const std::uint32_t mask = bits == 32 ? ~0u : (1u << bits) - 1;
      const std::uint32_t start = bits == 32 ? 0u : 12345678u;
      std::vector<std::uint32_t> keys(number);
      std::generate(keys.begin(), keys.end(),
        [&] { return start + static_cast<std::uint32_t>(random() & mask); });
      std::vector<std::uint32_t> order(number);
      radix.Sort(keys.data(), number, order.data());
      check.That(order == SortStably(keys),
        std::to_string(number) + " keys of " + std::to_string(bits) + " bits");
    }
  }
}

void CheckFloatKeys(Check& check)
{
  const std::vector<float> values = { std::numeric_limits<float>::lowest(), -1.0f,
    -std::numeric_limits<float>::denorm_min(), 0.0f, std::numeric_limits<float>::denorm_min(), 1.0f,
    std::numeric_limits<float>::max(), std::numeric_limits<float>::infinity() };
  for (std::size_t i = 1; i < values.size(); ++i)
  {
    check.That(
      interlume::RadixSorter::MakeKey(values[i - 1]) < interlume::RadixSorter::MakeKey(values[i]),
      "keys sort as floats do");
  }
  check.That(interlume::RadixSorter::MakeKey(-0.0f) == interlume::RadixSorter::MakeKey(0.0f),
    "0 and -0 have the same key");
}

// Returns a measure of the distance of each tetrahedron. In perspective, this is the squared length
// of the sum of its corners minus four times the eye position. In parallel projection, it is the
// component of the sum along the view direction.
std::vector<double> Measure(const interlume::TetrahedraMesh& mesh, const interlume::Viewpoint& view)
{
  std::vector<double> measures;
  for (std::uint32_t t = 0; t < mesh.GetNumberOfTetrahedra(); ++t)
  {
    double measure = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      double sum = 0.0;
      for (int k = 0; k < 4; ++k)
      {
        sum += mesh.GetPoint(mesh.GetCorners(t)[k])[axis];
      }
      const double distance = sum - 4.0 * view.Eye[axis];
      measure += view.IsParallel ? sum * view.Direction[axis] : distance * distance;
    }
    measures.push_back(measure);
  }
  return measures;
}

// Tests that the order is stable. Coordinates are multiples of 1/16, so distances are exact, and
// many are equal.
void CheckRegularGrid(Check& check)
{
  CubeMeshSettings form;
  form.Cubes = 16;
  const interlume::TetrahedraMesh mesh = Shuffle(MakeCubeMesh(form), 3);
  interlume::CentroidOrder centroids;
  std::vector<std::uint32_t> order;
  for (const bool isParallel : { false, true })
  {
    interlume::Viewpoint view;
    view.IsParallel = isParallel;
    view.Direction = { 0.5, -0.25, 0.75 };
    for (const double distance : { 0.0, 0.125, 1.0, 8.0 })
    {
      view.Eye = { 0.5 * distance, distance, -0.75 * distance };
      centroids.Compute(mesh, view, order);
      check.That(order == SortStably(Measure(mesh, view)),
        "the order is stable at a distance of " + std::to_string(distance));
    }
  }
}

// Tests, for near and far eye positions, that misordered tetrahedra differ in distance by at most
// the single-precision rounding error of the mesh size.
void CheckPrecision(Check& check)
{
  CubeMeshSettings form;
  form.Cubes = 12;
  form.Jitter = 0.2;
  const interlume::TetrahedraMesh mesh = MakeCubeMesh(form);
  interlume::CentroidOrder centroids;
  std::vector<std::uint32_t> order;
  for (const double distance : { 0.001, 0.3, 0.9, 2.0, 1e3, 1e6 })
  {
    interlume::Viewpoint view;
    view.Eye = { 0.6 * distance, 0.0, 0.8 * distance };
    centroids.Compute(mesh, view, order);
    check.That(IsPermutation(order, mesh.GetNumberOfTetrahedra()), "each tetrahedron occurs once");
    const std::vector<double> squared = Measure(mesh, view);
    double largestError = 0.0;
    for (std::size_t i = 1; i < order.size(); ++i)
    {
      const double step = std::sqrt(squared[order[i - 1]]) - std::sqrt(squared[order[i]]);
      reference::KeepLargest(largestError, step / 4.0);
    }
    check.That(largestError < 3e-7,
      "error of " + std::to_string(1e9 * largestError) + "e-9 from a distance of " +
        std::to_string(distance));
  }
}

void CheckSmall(Check& check)
{
  interlume::CentroidOrder centroids;
  std::vector<std::uint32_t> order(5);
  centroids.Compute(interlume::TetrahedraMesh(), interlume::Viewpoint(), order);
  check.That(order.empty(), "the order of an empty mesh is empty");
  interlume::TetrahedraMesh mesh;
  Append(mesh, { { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } } });
  centroids.Compute(mesh, interlume::Viewpoint(), order);
  check.That(order == std::vector<std::uint32_t>{ 0 }, "one tetrahedron");
  check.That(centroids.GetBytes() > 0, "memory is reported");
}
}

int TestTetrahedraSortCentroid(int, char*[])
{
  return RunChecks({ CheckRadix, CheckFloatKeys, CheckRegularGrid, CheckPrecision, CheckSmall });
}
