// SPDX-License-Identifier: BSD-3-Clause
// The visibility order of meshes with gaps along lines of sight, each intersected with all
// tetrahedra.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Tetrahedra/ReferenceSightlines.h"
#include "Support/Tetrahedra/ReferenceTetrahedra.h"

#include "Order/VisibilityOrder.h"

#include <iostream>

namespace
{

using namespace reference;

struct Tally : OrderTally
{
  long long RandomPairs = 0;
  long long RandomWrong = 0;
  // What MPVO without relations across gaps has wrong: the meshes do need them.
  long long WrongByFacesAlone = 0;
};

void CheckMesh(const interlume::TetrahedraMesh& mesh, const std::string& name,
  const std::array<double, 3>& hole, int lines, bool mayBeCyclic, Tally& tally, Check& check)
{
  const Sightlines sightlines(mesh);
  interlume::VisibilityOrder visibility;
  check.That(visibility.Build(mesh), "built");
  std::vector<std::uint32_t> order;
  for (const View& view : GetViews(160, glm::make_vec3(hole.data())))
  {
    check.SetContext(name + ", " + view.Name);
    visibility.Compute(mesh, view.Rays, order);
    if (!CheckOrder(sightlines, visibility, view.Rays, order, lines, mayBeCyclic, tally, check))
    {
      continue;
    }
    const OrderErrors errors = sightlines.CheckRandom(view.Rays, order, lines, 2);
    tally.RandomPairs += errors.Pairs;
    tally.RandomWrong += errors.Wrong;

    interlume::ViewRays facesOnly = view.Rays;
    facesOnly.Height = 0;
    visibility.Compute(mesh, facesOnly, order);
    check.Equal(visibility.GetNumberOfGapRelations(), 0, "relations without a picture");
    tally.WrongByFacesAlone += sightlines.CheckPixels(view.Rays, order, lines, 1).Wrong;
  }
}

// Two slabs that touch, cut differently: no point of one is a point of the other.
interlume::TetrahedraMesh MakeTouchingSlabs()
{
  CubeMesh form;
  form.Cubes = 8;
  form.IsIn = [](const std::array<double, 3>& p) { return p[2] < 0.0; };
  interlume::TetrahedraMesh mesh = MakeCubes(form);
  form.Cubes = 10;
  form.Pieces = 5;
  form.IsIn = [](const std::array<double, 3>& p) { return p[2] > 0.0; };
  const interlume::TetrahedraMesh other = MakeCubes(form);
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
  CubeMesh form;
  for (const Shape& shape : GetShapes())
  {
    form.IsIn = shape.IsIn;
    form.Cubes = 16;
    form.Jitter = 0.0;
    form.Pieces = 6;
    CheckMesh(MakeCubes(form), shape.Name, shape.Hole, 60, false, tally, check);
    form.Pieces = 5;
    form.Jitter = 0.12;
    CheckMesh(
      Shuffle(MakeCubes(form), 3), shape.Name + ", moved", shape.Hole, 60, true, tally, check);
  }
  form.Jitter = 0.0;
  form.Pieces = 6;
  form.Cubes = 30;
  form.IsIn = GetShapes()[0].IsIn;
  const interlume::TetrahedraMesh large = MakeCubes(form);
  CheckMesh(large, std::to_string(large.GetNumberOfTetrahedra()) + " tetrahedra",
    GetShapes()[0].Hole, 30, false, tally, check);

  CubeMesh small;
  small.Cubes = 6;
  const std::array<double, 3> inside = { { 0.11, 0.13, 0.12 } };
  CheckMesh(Separate(MakeCubes(small)), "no shared points", inside, 100, false, tally, check);
  CheckMesh(MakeDelaunay(1500, 4), "Delaunay", inside, 100, false, tally, check);
  CheckMesh(MakeTouchingSlabs(), "touching slabs", inside, 100, false, tally, check);

  std::cout << tally.Orders << " orders, " << tally.Cyclic << " with cycles left out, "
            << tally.Pairs << " pairs through pixels; between pixels " << tally.RandomWrong
            << " of " << tally.RandomPairs << " wrong; by faces alone " << tally.WrongByFacesAlone
            << " wrong\n";
  check.SetContext("");
  check.That(tally.Pairs > 20000, "pairs were compared");
  check.That(tally.WrongByFacesAlone > 0, "shared faces alone are not enough");
  check.That(tally.RandomWrong * 1000 <= tally.RandomPairs, "nearly none wrong between pixels");
  return check.Result();
}
