// SPDX-License-Identifier: BSD-3-Clause
// A spotlight in an almost transparent grid: cone, fall-off toward the cone's edge and attenuation,
// compared with their formulas.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Light/ReferenceUnitSpace.h"

#include "Grid/GridLight.h"
#include "Grid/ExtinctionGrid.h"
#include "Plan/ClipRegion.h"
#include "Volume/MaterialTable.h"
#include "Volume/VolumeBlocks.h"
#include "Volume/VolumeSamples.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <cstddef>
#include <iostream>

namespace
{

using namespace reference;
using interlume::ExtinctionGrid;
using interlume::LightSource;

/// A cubic volume whose cells have the value 1, with its extinction grid.
struct Cube
{
  explicit Cube(int size)
    : Space(MakeUnitSpace({ { size + 1, size + 1, size + 1 } }, { { 1.0, 1.0, 1.0 } }))
  {
    vtkNew<vtkDoubleArray> values;
    values->SetNumberOfTuples(static_cast<vtkIdType>(size) * size * size);
    values->Fill(1.0);
    static_cast<void>(this->Samples.Build(values, { { size, size, size } }, false));
    this->Blocks.Build(this->Samples);
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(0.0, 1e-7);
    opacity->AddPoint(2.0, 1e-7);
    vtkNew<vtkVolumeProperty> property;
    property->SetScalarOpacity(opacity);
    static_cast<void>(this->Material.Build(property, this->Samples, nullptr, { true, nullptr }));
    this->Blocks.Classify(this->Material);
    static_cast<void>(this->Region.Set({}, this->Space));
    this->Grid.Build({ { this->Samples, this->Blocks, this->Material, this->Space, this->Region,
      glm::dvec3(1.0), { { 1.0, 1.0, 1.0, 1.0 } }, size, true } });
  }

  interlume::UnitSpace Space;
  interlume::VolumeSamples Samples;
  interlume::VolumeBlocks Blocks;
  interlume::MaterialTable Material;
  interlume::ClipRegion Region;
  ExtinctionGrid Grid;
};

double GetFormula(const LightSource& light, const glm::dvec3& position)
{
  const glm::dvec3 path = position - light.Position;
  const double distance = glm::length(path);
  const double cosine = glm::dot(path, light.Direction) / distance;
  const double attenuation = light.Attenuation.x + light.Attenuation.y * distance +
    light.Attenuation.z * distance * distance;
  return cosine < light.ConeCosine ? 0.0 : std::pow(cosine, light.Exponent) / attenuation;
}

/// The mean light in a cell. IsCut is true if the boundary of the light's cone intersects the cell.
struct CellMean
{
  double Mean = 0.0;
  bool IsCut = false;
};

CellMean GetMean(const ExtinctionGrid& grid, const LightSource& light, std::size_t cell)
{
  constexpr int steps = 6;
  CellMean result;
  int lit = 0;
  for (int sample = 0; sample < steps * steps * steps; ++sample)
  {
    const glm::dvec3 offset =
      (glm::dvec3(sample % steps, sample / steps % steps, sample / (steps * steps)) + 0.5) /
        double(steps) -
      0.5;
    const glm::dvec3 position =
      grid.GetCellCenter(grid.GetCell(cell)) + offset * grid.GetMedium().CellSize;
    const double value = GetFormula(light, grid.ToUnit(position));
    lit += value > 0.0 ? 1 : 0;
    result.Mean += value / (steps * steps * steps);
  }
  result.IsCut = lit > 0 && lit < steps * steps * steps;
  return result;
}

void TestCone(Check& check)
{
  const Cube cube(16);
  for (const double angle : { 12.0, 25.0 })
  {
    LightSource light;
    light.IsPositional = true;
    light.Position = { 0.1, -0.2, 2.0 };
    light.Direction = glm::normalize(glm::dvec3(0.05, 0.1, -1.0));
    light.ConeCosine = std::cos(angle * std::acos(-1.0) / 180.0);
    light.Exponent = 6.0;
    light.Attenuation = { 0.5, 0.2, 0.1 };
    light.Diffuse = { 0.9, 0.6, 0.3 };
    light.ShadowStrength = 0.8;
    const std::vector<glm::vec3> found = interlume::GridLight::Make(cube.Grid, light, 1).Direct;
    double largest = 0.0;
    double sum = 0.0;
    double exact = 0.0;
    int cut = 0;
    for (std::size_t cell = 0; cell < found.size(); ++cell)
    {
      const CellMean mean = GetMean(cube.Grid, light, cell);
      sum += found[cell].y;
      exact += 0.8 * 0.6 * mean.Mean;
      cut += mean.IsCut ? 1 : 0;
      largest =
        std::max(largest, mean.IsCut ? 0.0 : std::abs(found[cell].y - 0.8 * 0.6 * mean.Mean));
    }
    const std::string name = "cone of " + std::to_string(angle);
    std::cout << name << ": largest error of uncut cells " << largest << ", of all light "
              << 100.0 * (sum / exact - 1.0) << " %, " << cut << " of " << found.size()
              << " cells cut\n";
    check.Near(largest, 0.0, 0.001, name + ": cells inside and outside", 1.0);
    check.Near(sum / exact, 1.0, 0.01, name + ": all light", 1.0);
    check.That(cut > 100, name + ": the boundary of the cone intersects the grid");
  }
}

}

int TestGridLight(int, char*[])
{
  Check check;
  TestCone(check);
  return check.Result();
}
