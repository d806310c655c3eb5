// SPDX-License-Identifier: BSD-3-Clause
// Tests that orders do not depend on the number of threads or the backend.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceExecution.h"
#include "Support/Tetrahedra/ReferenceViewRays.h"
#include "Support/Tetrahedra/ReferenceTetrahedra.h"

#include "Order/CentroidOrder.h"
#include "Order/FaceAdjacency.h"
#include "Order/VisibilityOrder.h"

#include <string>
#include <vector>

namespace
{

using namespace reference;

struct Orders
{
  std::vector<std::uint32_t> Twins;
  std::vector<std::vector<std::uint32_t>> Lists;
  std::vector<vtkIdType> Counts;

  bool operator==(const Orders& other) const
  {
    return this->Twins == other.Twins && this->Lists == other.Lists && this->Counts == other.Counts;
  }
};

Orders ComputeAll(const interlume::TetrahedraMesh& mesh)
{
  Orders all;
  interlume::CentroidOrder centroids;
  interlume::VisibilityOrder visibility;
  visibility.Build(mesh);
  all.Twins = interlume::FaceAdjacency::FindTwins(mesh);
  for (const View& view : GetViews(150, { 0.12, 0.01, 0.02 }))
  {
    std::vector<std::uint32_t> order;
    centroids.Compute(mesh, view.Rays.Viewpoint, order);
    all.Lists.push_back(order);
    visibility.Compute(mesh, view.Rays, order);
    all.Lists.push_back(order);
    all.Counts.push_back(visibility.GetNumberOfTetrahedraInCycles());
    all.Counts.push_back(visibility.GetNumberOfGapRelations());
  }
  return all;
}

void CheckMesh(const interlume::TetrahedraMesh& mesh, const std::string& name, Check& check)
{
  CheckSame(
    name, [&mesh]() { return ComputeAll(mesh); }, check);
}
}

int TestTetrahedraSortThreads(int, char*[])
{
  Check check;
  CubeMeshSettings form;
  form.Cubes = 22;
  form.IsIn = GetShapes()[0].IsIn;
  CheckMesh(MakeCubeMesh(form), "sphere with holes", check);
  // The distorted mesh has visibility cycles. Without shared points, it has the maximum number of
  // boundary faces.
  form.Cubes = 8;
  form.Pieces = 5;
  interlume::TetrahedraMesh mesh = MakeCubeMesh(form);
  Distort(mesh, 0.1, 20, 1);
  CheckMesh(mesh, "distorted", check);
  CheckMesh(SeparateTetrahedra(mesh), "no shared points", check);
  return check.Result();
}
