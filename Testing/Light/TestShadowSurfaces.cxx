// SPDX-License-Identifier: BSD-3-Clause
// Sharp surfaces in vtkShadowedSliceMapper compared with closed forms, with default settings: an
// opaque cube, and plates whose opacity jumps between two voxels, lit and viewed at 0 to 60
// degrees.
#include "Support/Drawing/ShadowImage.h"
#include "Support/Images/SurfaceCases.h"
#include "Support/Checks/ReferenceCheck.h"

#include "vtkNew.h"
#include "vtkShadowedSliceMapper.h"

#include <iostream>
#include <string>
#include <utility>

namespace
{

using namespace reference;

void TestCube(Check& check)
{
  const SurfaceCase cube = MakeOpaqueCube(24);
  vtkNew<vtkShadowedSliceMapper> mapper;
  const SurfaceErrors errors = MeasureSurface(DrawByMapper(mapper, cube.Scene), cube.Expected);
  std::cout << "cube: " << errors << std::endl;
  check.Near(errors.Mean, 0.0, 0.01, "cube, mean error", 1.0);
  check.Near(errors.P95, 0.0, 0.01, "cube, error of 95 % of the pixels", 1.0);
}

SurfaceErrors MeasurePlate(
  const Double3& normal, double light, double viewAngle, double azimuth, double spacing)
{
  constexpr int cells = 32;
  const SurfaceCase plate = MakePlate(cells, normal, light, viewAngle, azimuth);
  vtkNew<vtkShadowedSliceMapper> mapper;
  mapper->SetSliceSpacing(spacing / cells);
  if (spacing > 0.0)
  {
    mapper->SetLightBufferSize(static_cast<int>(cells / spacing));
  }
  const SurfaceErrors errors = MeasureSurface(DrawByMapper(mapper, plate.Scene), plate.Expected);
  std::cout << "plate, light " << light << ", view " << viewAngle << ", azimuth " << azimuth
            << (normal[0] > 0.0 ? ", tilted" : "") << ", spacing " << spacing << ": " << errors
            << std::endl;
  return errors;
}

void TestPlates(Check& check)
{
  const Double3 straight = { { 0.0, 0.0, 1.0 } };
  const Double3 tilted = { { 0.2, 0.35, 1.0 } };
  for (const double light : { 0.0, 20.0, 40.0, 50.0, 60.0 })
  {
    for (const auto& [viewAngle, azimuth] :
      { std::pair<double, double>{ 0.0, 0.0 }, std::pair<double, double>{ 30.0, 120.0 } })
    {
      for (const Double3& normal : { straight, tilted })
      {
        const SurfaceErrors errors = MeasurePlate(normal, light, viewAngle, azimuth, 0.0);
        check.Near(errors.Rms, 0.0, 0.02, "plate under light at " + std::to_string(light), 1.0);
      }
    }
  }
  const SurfaceErrors coarse = MeasurePlate(tilted, 50.0, 30.0, 120.0, 1.0);
  const SurfaceErrors fine = MeasurePlate(tilted, 50.0, 30.0, 120.0, 0.25);
  check.That(fine.Mean < 0.7 * coarse.Mean, "the error decreases with spacing and buffer size");
}

}

int TestShadowSurfaces(int, char*[])
{
  Check check;
  TestCube(check);
  TestPlates(check);
  return check.Result();
}
