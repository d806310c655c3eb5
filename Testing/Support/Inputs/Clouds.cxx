// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Inputs/Clouds.h"

#include "vtkColorTransferFunction.h"
#include "vtkConstructiveVolume.h"
#include "vtkTurbulenceSource.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkSpatialOperation.h"
#include "vtkSpatialPrimitive.h"
#include "vtkSpatialTurbulence.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace interlume
{

namespace
{

constexpr double Pi = 3.14159265358979324;

/// Generates the same random numbers on all platforms, unlike std::uniform_real_distribution.
class PortableRandom
{
public:
  explicit PortableRandom(unsigned seed)
    : Engine(seed)
  {
  }

  double Get(double lower, double upper)
  {
    return lower + (upper - lower) * static_cast<double>(this->Engine()) / 4294967296.0;
  }

private:
  std::mt19937 Engine;
};

vtkSmartPointer<vtkSpatialPrimitive> MakePuff(const std::array<double, 3>& center, double radius)
{
  auto puff = vtkSmartPointer<vtkSpatialPrimitive>::New();
  puff->SetCenter(center[0], center[1], center[2]);
  puff->SetRadius(radius);
  // The erosion in MakeClouds() requires a soft edge.
  puff->SetEdgeWidth(0.5 * radius);
  return puff;
}

/// Arranges large spheres in a spiral over the base, higher toward the center. Each is covered with
/// smaller spheres, mostly on its upper half.
vtkSmartPointer<vtkSpatialObject> MakeHeaps(const Cumulus& cloud)
{
  auto heaps = vtkSmartPointer<vtkSpatialOperation>::New();
  PortableRandom random(cloud.Seed);
  const double turn = random.Get(0.0, 2.0 * Pi);
  for (int i = 0; i < cloud.Heaps; ++i)
  {
    const double fraction = std::sqrt((i + 0.5) / cloud.Heaps);
    const double angle = turn + i * Pi * (3.0 - std::sqrt(5.0));
    const double radius = cloud.Radius * (0.44 - 0.2 * fraction) * random.Get(0.85, 1.2);
    const double reach = 0.8 * cloud.Radius * fraction;
    const std::array<double, 3> center = { { cloud.Base[0] + reach * std::cos(angle),
      cloud.Base[1] + cloud.Depth * reach * std::sin(angle),
      cloud.Base[2] + 0.5 * radius +
        (cloud.Height - 0.9 * radius) * (1.0 - fraction * fraction) * random.Get(0.35, 1.0) } };
    heaps->AddOperand(MakePuff(center, radius));
    // Fills the gap between the sphere and the base with slightly smaller spheres.
    for (double z = center[2] - 0.8 * radius; z > cloud.Base[2]; z -= 0.8 * radius)
    {
      heaps->AddOperand(MakePuff({ { center[0], center[1], z } }, 0.95 * radius));
    }
    for (int j = 0; j < 9; ++j)
    {
      const double up = random.Get(-0.25, 1.0);
      const double around = random.Get(0.0, 2.0 * Pi);
      const double across = 0.95 * radius * std::sqrt(1.0 - up * up);
      heaps->AddOperand(
        MakePuff({ { center[0] + across * std::cos(around), center[1] + across * std::sin(around),
                   center[2] + 0.95 * radius * up } },
          radius * random.Get(0.3, 0.55)));
    }
  }
  auto aboveBase = vtkSmartPointer<vtkSpatialPrimitive>::New();
  aboveBase->SetShapeToBox();
  aboveBase->SetCenter(cloud.Base[0], cloud.Base[1], cloud.Base[2] + 2.0 * cloud.Radius);
  aboveBase->SetLengths(6.0 * cloud.Radius, 6.0 * cloud.Radius, 4.0 * cloud.Radius);
  aboveBase->SetEdgeWidth(0.16 * cloud.Radius);
  auto cut = vtkSmartPointer<vtkSpatialOperation>::New();
  cut->SetOperationToIntersection();
  cut->AddOperand(heaps);
  cut->AddOperand(aboveBase);
  return cut;
}

}

vtkSmartPointer<vtkSpatialObject> MakeClouds(const std::vector<Cumulus>& clouds)
{
  auto all = vtkSmartPointer<vtkSpatialOperation>::New();
  for (const Cumulus& cloud : clouds)
  {
    vtkNew<vtkSpatialTurbulence> billows;
    billows->SetOperand(MakeHeaps(cloud));
    billows->SetModeToDisplacement();
    billows->SetSum(vtkTurbulenceSource::FRACTAL_SUM);
    billows->SetNumberOfOctaves(4);
    billows->SetFrequency(2.6 / cloud.Radius);
    billows->SetAmplitude(0.13 * cloud.Radius);
    billows->SetSeed(static_cast<int>(cloud.Seed));
    vtkNew<vtkSpatialTurbulence> fringes;
    fringes->SetOperand(billows);
    fringes->SetModeToErosion();
    fringes->SetSum(vtkTurbulenceSource::TURBULENCE);
    fringes->SetNumberOfOctaves(4);
    fringes->SetFrequency(5.0 / cloud.Radius);
    fringes->SetAmplitude(0.55);
    fringes->SetGain(2.0);
    fringes->SetSeed(static_cast<int>(cloud.Seed) + 100);
    all->AddOperand(fringes);
  }
  return all;
}

vtkSmartPointer<vtkImageData> SampleDensity(
  vtkSpatialObject* object, const std::array<double, 6>& bounds, int cells)
{
  const double size =
    std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] }) / cells;
  std::array<double, 6> extended = bounds;
  std::array<int, 3> points;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double length = bounds[2 * axis + 1] - bounds[2 * axis];
    points[axis] = static_cast<int>(std::ceil(length / size - 1e-6)) + 1;
    extended[2 * axis + 1] = bounds[2 * axis] + (points[axis] - 1) * size;
  }
  vtkNew<vtkConstructiveVolume> volume;
  volume->SetRoot(object);
  volume->SetBounds(extended.data());
  volume->SetDimensions(points[0], points[1], points[2]);
  volume->Update();
  return volume->GetOutput();
}

vtkSmartPointer<vtkVolumeProperty> MakeCloudProperty(double extinction)
{
  // The extinction per unit distance is -ln(1 - opacity). Up to an opacity of 0.02, it is
  // proportional to the opacity within 1 %.
  constexpr double opacity = 0.02;
  vtkNew<vtkPiecewiseFunction> function;
  function->AddPoint(0.0, 0.0);
  function->AddPoint(1.0, opacity);
  vtkNew<vtkColorTransferFunction> white;
  white->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
  white->AddRGBPoint(1.0, 1.0, 1.0, 1.0);
  auto medium = vtkSmartPointer<vtkVolumeProperty>::New();
  medium->SetScalarOpacity(function);
  medium->SetScalarOpacityUnitDistance(-std::log1p(-opacity) / extinction);
  medium->SetColor(white);
  medium->SetInterpolationTypeToLinear();
  medium->ShadeOff();
  return medium;
}

}
