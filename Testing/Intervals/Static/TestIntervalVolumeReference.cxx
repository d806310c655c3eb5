// SPDX-License-Identifier: BSD-3-Clause
// The reference implementations: the meshes are conforming and have the expected volume, and
// clipping agrees with the formula for a box cut by a plane.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Meshes/ReferenceBoundary.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/Meshes/ReferenceTransform.h"
#include "Support/Meshes/ReferenceVolume.h"

#include "vtkUnstructuredGrid.h"

#include <cmath>

int TestIntervalVolumeReference(int, char*[])
{
  using namespace reference;
  Check check;
  const std::array<int, 3> cells = { 3, 2, 2 };
  const LinearFunction function = { 0.2, { 0.7, -0.3, 0.5 } };
  const double honeycomb = 12 * 1.5 * std::sqrt(3.0);
  const double kelvin = 24 * 0.5;
  for (MeshKind kind : AllMeshKinds())
  {
    check.SetContext(GetName(kind));
    auto mesh = MakeMesh(kind, cells);
    const double volume = kind == MeshKind::Honeycomb ? honeycomb
      : kind == MeshKind::Kelvin                      ? kelvin
                                                      : 12;
    check.Near(static_cast<double>(MeshVolume(mesh)), volume, 1e-14, "volume of the mesh");
    const auto turned = RenumberPoints(RotateCellPointOrder(mesh, 3), 4);
    check.Near(
      static_cast<double>(MeshVolume(turned)), volume, 1e-14, "volume of renumbered cells");
    check.Equal(DomainBoundary(turned).GetNumberOfFaces(), DomainBoundary(mesh).GetNumberOfFaces(),
      "boundary faces of renumbered cells");
    if (GetName(kind).find("tetrahedra") == 0)
    {
      const TetrahedraVolume measured = MeasureTetrahedra(turned);
      check.Equal(measured.Inverted, 0, "inverted tetrahedra");
      check.Equal(MeasureTetrahedra(InvertCells(turned)).Inverted, measured.Count,
        "inverted tetrahedra after inversion");
    }
    if (kind == MeshKind::Honeycomb || kind == MeshKind::Kelvin)
    {
      continue;
    }
    AddLinearField(mesh, function);
    const std::array<double, 3> size = { 3, 2, 2 };
    const double analytic = static_cast<double>(
      BoxVolumeBelow(size, function, 1.1) - BoxVolumeBelow(size, function, 0.4));
    check.Near(static_cast<double>(ClippedVolume(mesh, { { "f", 0.4, 1.1 } })), analytic, 1e-15,
      "clipped volume");
    if (kind != MeshKind::Mixed)
    {
      // Tetrahedra split all of the 32 boundary squares into two triangles, wedges split the 12
      // squares at the top and bottom, and other cells split none.
      const bool tetrahedra = GetName(kind).find("tetrahedra") == 0;
      check.Equal(DomainBoundary(mesh).GetNumberOfFaces(),
        tetrahedra                   ? 64
          : kind == MeshKind::Wedges ? 44
                                     : 32,
        "boundary faces");
    }
  }
  return check.Result();
}
