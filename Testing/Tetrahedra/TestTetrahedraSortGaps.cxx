// SPDX-License-Identifier: BSD-3-Clause
// Tests the visibility order of meshes with gaps along view rays, which are intersected with all
// tetrahedra.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Tetrahedra/ReferenceViewRays.h"
#include "Support/Tetrahedra/ReferenceTetrahedra.h"

#include "Order/VisibilityOrder.h"

#include <iostream>

namespace
{

using namespace reference;

struct Tally : OrderTally
{
  long long RandomPairs = 0;
  long long RandomMisordered = 0;
  // Number of misordered pairs if the order is computed only from shared faces (MPVO). They show
  // that the meshes require relations across gaps.
  long long MisorderedByFacesOnly = 0;
};

void CheckMesh(const interlume::TetrahedraMesh& mesh, const std::string& name,
  const std::array<double, 3>& hole, int lines, bool mayBeCyclic, Tally& tally, Check& check)
{
  const ViewRayCheck viewRays(mesh);
  interlume::VisibilityOrder visibility;
  check.That(visibility.Build(mesh), "the order can be built");
  std::vector<std::uint32_t> order;
  for (const View& view : GetViews(160, glm::make_vec3(hole.data())))
  {
    check.SetContext(name + ", " + view.Name);
    visibility.Compute(mesh, view.Rays, order);
    if (!CheckOrder(viewRays, visibility, view.Rays, order, lines, mayBeCyclic, tally, check))
    {
      continue;
    }
    const OrderErrors errors = viewRays.CheckRandom(view.Rays, order, lines, 2);
    tally.RandomPairs += errors.Pairs;
    tally.RandomMisordered += errors.Misordered;

    interlume::ViewRays facesOnly = view.Rays;
    facesOnly.Height = 0;
    visibility.Compute(mesh, facesOnly, order);
    check.Equal(visibility.GetNumberOfGapRelations(), 0, "relations without an image");
    tally.MisorderedByFacesOnly += viewRays.CheckPixels(view.Rays, order, lines, 1).Misordered;
  }
}

// Returns two touching slabs that are split into tetrahedra differently and share no points.
interlume::TetrahedraMesh MakeTouchingSlabs()
{
  CubeMeshSettings form;
  form.Cubes = 8;
  form.IsIn = [](const std::array<double, 3>& p) { return p[2] < 0.0; };
  interlume::TetrahedraMesh mesh = MakeCubeMesh(form);
  form.Cubes = 10;
  form.Pieces = 5;
  form.IsIn = [](const std::array<double, 3>& p) { return p[2] > 0.0; };
  const interlume::TetrahedraMesh other = MakeCubeMesh(form);
  const std::uint32_t points = static_cast<std::uint32_t>(mesh.Points.size() / 3);
  mesh.Points.insert(mesh.Points.end(), other.Points.begin(), other.Points.end());
  for (const std::uint32_t corner : other.Corners)
  {
    mesh.Corners.push_back(points + corner);
  }
  return mesh;
}
}

int TestTetrahedraSortGaps(int, char*[])
{
  Check check;
  Tally tally;
  CubeMeshSettings form;
  for (const Shape& shape : GetShapes())
  {
    form.IsIn = shape.IsIn;
    form.Cubes = 16;
    form.Jitter = 0.0;
    form.Pieces = 6;
    CheckMesh(MakeCubeMesh(form), shape.Name, shape.Hole, 60, false, tally, check);
    form.Pieces = 5;
    form.Jitter = 0.12;
    CheckMesh(Shuffle(MakeCubeMesh(form), 3), shape.Name + ", displaced", shape.Hole, 60, true,
      tally, check);
  }
  form.Jitter = 0.0;
  form.Pieces = 6;
  form.Cubes = 30;
  form.IsIn = GetShapes()[0].IsIn;
  const interlume::TetrahedraMesh large = MakeCubeMesh(form);
  CheckMesh(large, std::to_string(large.GetNumberOfTetrahedra()) + " tetrahedra",
    GetShapes()[0].Hole, 30, false, tally, check);

  CubeMeshSettings small;
  small.Cubes = 6;
  const std::array<double, 3> inside = { { 0.11, 0.13, 0.12 } };
  CheckMesh(
    SeparateTetrahedra(MakeCubeMesh(small)), "no shared points", inside, 100, false, tally, check);
  CheckMesh(MakeDelaunay(1500, 4), "Delaunay", inside, 100, false, tally, check);
  CheckMesh(MakeTouchingSlabs(), "touching slabs", inside, 100, false, tally, check);

  std::cout << tally.Orders << " orders, " << tally.Cyclic << " skipped because of cycles, "
            << tally.Pairs << " pairs through pixels; between pixels " << tally.RandomMisordered
            << " of " << tally.RandomPairs << " wrong; by faces only "
            << tally.MisorderedByFacesOnly << " wrong\n";
  check.SetContext("");
  check.That(tally.Pairs > 20000, "pairs were compared");
  check.That(tally.MisorderedByFacesOnly > 0, "shared faces are not sufficient");
  check.That(
    tally.RandomMisordered * 1000 <= tally.RandomPairs, "at most 0.1 % errors between pixels");
  return check.Result();
}
