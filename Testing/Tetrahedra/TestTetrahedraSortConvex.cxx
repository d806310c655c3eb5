// SPDX-License-Identifier: BSD-3-Clause
// Tests the visibility order of convex meshes along view rays, which are intersected with all
// tetrahedra.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Tetrahedra/ReferenceViewRays.h"
#include "Support/Tetrahedra/ReferenceTetrahedra.h"

#include "Order/VisibilityOrder.h"

#include <iostream>

namespace
{

using namespace reference;

void CheckMesh(const interlume::TetrahedraMesh& mesh, const std::string& name, int lines,
  bool mayBeCyclic, OrderTally& tally, Check& check)
{
  const ViewRayCheck viewRays(mesh);
  interlume::VisibilityOrder visibility;
  check.That(visibility.Build(mesh), "the order can be built");
  std::vector<std::uint32_t> order;
  std::vector<std::uint32_t> orderOfFaces;
  for (const View& view : GetViews(200, { 0.31, -0.12, 0.22 }))
  {
    check.SetContext(name + ", " + view.Name);
    visibility.Compute(mesh, view.Rays, order);
    check.Equal(visibility.GetNumberOfGapRelations(), 0, "relations across gaps");
    if (!CheckOrder(viewRays, visibility, view.Rays, order, lines, mayBeCyclic, tally, check))
    {
      continue;
    }
    const OrderErrors errors = viewRays.CheckRandom(view.Rays, order, lines, 2);
    check.Equal(errors.Misordered, 0, "errors along random rays");
    tally.Pairs += errors.Pairs;

    // The order computed only from shared faces must be identical.
    interlume::ViewRays facesOnly = view.Rays;
    facesOnly.Width = 0;
    visibility.Compute(mesh, facesOnly, orderOfFaces);
    check.That(order == orderOfFaces, "the order without an image is the same");
  }
}
}

int TestTetrahedraSortConvex(int, char*[])
{
  Check check;
  OrderTally tally;
  CubeMeshSettings form;
  for (const int pieces : { 5, 6 })
  {
    form.Pieces = pieces;
    form.Cubes = 12;
    form.Jitter = 0.0;
    CheckMesh(MakeCubeMesh(form), std::to_string(pieces) + " per cube", 60, false, tally, check);
    CheckMesh(Shuffle(MakeCubeMesh(form), 9), std::to_string(pieces) + " per cube, shuffled", 60,
      false, tally, check);
    for (const double jitter : { 0.05, 0.15, 0.25 })
    {
      form.Jitter = jitter;
      form.Seed = pieces + static_cast<unsigned int>(100 * jitter);
      CheckMesh(MakeCubeMesh(form), std::to_string(pieces) + " per cube, displaced", 60, true,
        tally, check);
    }
  }
  form.Jitter = 0.0;
  form.Cubes = 25;
  CheckMesh(MakeCubeMesh(form), "93,750 tetrahedra", 40, false, tally, check);
  form.Cubes = 8;
  for (unsigned int seed = 1; seed <= 6; ++seed)
  {
    form.Pieces = seed % 2 ? 5 : 6;
    interlume::TetrahedraMesh mesh = MakeCubeMesh(form);
    Distort(mesh, 0.02 * seed, 10, seed);
    CheckMesh(mesh, "distorted, " + std::to_string(seed), 100, true, tally, check);
  }
  std::cout << tally.Orders << " orders, " << tally.Cyclic << " skipped because of cycles, "
            << tally.Pairs << " pairs\n";
  check.SetContext("");
  check.That(tally.Pairs > 20000, "pairs were compared");
  return check.Result();
}
