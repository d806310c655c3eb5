// SPDX-License-Identifier: BSD-3-Clause
// The contour at an interval's bound equals the interval's boundary, triangle by triangle. Several
// values extracted in one pass yield the same triangles as separate extractions.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Intervals/ReferenceExtraction.h"
#include "Support/Meshes/ReferenceBoundary.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceGrid.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/Meshes/ReferenceTransform.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <map>

namespace
{

using namespace reference;

/// Returns the triangles whose last element, an array value, equals \a value. Removes this element.
std::vector<GeometricSimplex> Having(const std::vector<GeometricSimplex>& set, double value)
{
  std::vector<GeometricSimplex> result;
  for (const GeometricSimplex& simplex : set)
  {
    if (simplex.back() == value)
    {
      result.emplace_back(simplex.begin(), simplex.end() - 1);
    }
  }
  return result;
}

/// Returns the sum of the orientation signs of each triangle, times \a sign. Omits zero sums.
std::map<GeometricSimplex, double> Net(const std::vector<GeometricSimplex>& set, double sign = 1)
{
  std::map<GeometricSimplex, double> net;
  for (const GeometricSimplex& simplex : set)
  {
    const GeometricSimplex key(simplex.begin() + 1, simplex.end());
    net[key] += sign * simplex[0];
    if (net[key] == 0)
    {
      net.erase(key);
    }
  }
  return net;
}

void CheckMesh(vtkUnstructuredGrid* mesh, double lower, double upper, bool ties, Check& check)
{
  const auto boundary =
    GeometricSet(ExtractIntervals(mesh, { { lower, upper } }).Surface, { "BoundarySide" });
  const auto contours =
    GeometricSet(ExtractContours(mesh, { lower, upper }).Surface, { "ContourId" });
  check.That(!Having(contours, 0).empty(), "there is a contour");
  // On the domain boundary, the contour also contains faces of cells that have the isovalue on the
  // face and lower values elsewhere.
  std::map<GeometricSimplex, double> left = Net(Having(contours, 0));
  for (const auto& triangle : Net(Having(boundary, 0)))
  {
    left[triangle.first] -= triangle.second;
  }
  const DomainBoundary domain(mesh);
  const bool isSame = std::all_of(left.begin(), left.end(),
    [&](const auto& triangle)
    {
      std::vector<DomainBoundary::Point> points(3);
      for (int p = 0; p < 3; ++p)
      {
        std::copy_n(triangle.first.begin() + 3 * p, 3, points[p].begin());
      }
      return triangle.second == 0 || (ties && domain.Find(points) >= 0);
    });
  check.That(isSame, "the lower side equals the contour");
  // With ties, the upper side differs: values equal to the upper bound are inside the interval, but
  // above the contour.
  if (!ties)
  {
    check.That(Having(boundary, 0) == Having(contours, 0), "no triangle is repeated");
    check.That(Net(Having(boundary, 1)) == Net(Having(contours, 1), -1),
      "the upper side equals the reversed contour");
  }
  check.That(Having(contours, 0) == GeometricSet(ExtractContours(mesh, { lower }).Surface),
    "the first value in a separate pass");
  check.That(Having(contours, 1) == GeometricSet(ExtractContours(mesh, { upper }).Surface),
    "the second value in a separate pass");
}

}

int TestIsotableContourIntervals(int, char*[])
{
  Check check;
  for (MeshKind kind : AllMeshKinds())
  {
    for (unsigned int seed = 1; seed <= 3; ++seed)
    {
      check.SetContext(GetName(kind) + ", seed " + std::to_string(seed));
      auto mesh =
        RenumberPoints(RotateCellPointOrder(MakeMesh(kind, { 3, 3, 3 }, seed), seed), seed);
      AddRandomField(mesh, seed);
      CheckMesh(mesh, 0.35, 0.7, false, check);
      AddIntegerField(mesh, 4, seed);
      CheckMesh(mesh, 1, 2, true, check);
    }
  }
  return check.Result();
}
