// SPDX-License-Identifier: BSD-3-Clause
// Multiple scattering of vtkShadowedSliceMapper: images compared with the solver, a medium without
// absorption in light from all directions, and invariance under slice spacing, light buffer size
// and grid size.
#include "Support/Checks/LargestError.h"
#include "Support/Images/ShadowCases.h"
#include "Support/Drawing/ShadowImage.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Scattering/ScatteringSolver.h"
#include "Support/Transport/SceneTransport.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <random>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

namespace
{

using namespace reference;
using Mapper = vtkShadowedSliceMapper;
using interlume::ScatteredLight;
using interlume::ScatteringLight;
using interlume::ScatteringMedium;

/// Number of cells along each edge of the unit cube.
constexpr int Cells = 16;

void SetMode(vtkShadowedSliceMapper* mapper, int mode, double g)
{
  mapper->SetScatteringMode(mode);
  mapper->SetPhaseFunctionToHenyeyGreenstein();
  mapper->SetAnisotropy(g);
}

/// Returns a cube with albedo 1, seen along -z in parallel projection and lit by one light.
ShadowScene MakeCube(double extinction, const Double3& direction)
{
  ShadowScene scene = MakeHomogeneousScene(Cells, extinction);
  scene.Size = { { 32, 32 } };
  scene.Camera = LookAt(scene.Image, { { 0.0, 0.0, -1.0 } }, true);
  scene.Camera->SetParallelScale(0.5);
  scene.Lights = { MakeDirectionalLight(direction) };
  scene.Lights.front()->SetIntensity(1.0);
  return scene;
}

/// Returns the mean pixel value of the image without its border.
double GetMean(const RgbaImage& image, int border = 2)
{
  double sum = 0.0;
  int count = 0;
  for (int j = border; j < image.Height - border; ++j)
  {
    for (int i = border; i < image.Width - border; ++i, ++count)
    {
      sum += image.At(i, j)[1];
    }
  }
  return sum / count;
}

/// Returns the mean pixel value expected from the solver's field: the source terms of each column
/// of cells, attenuated toward the camera, without single scattering.
double GetSolved(double extinction, double g, const Double3& direction, bool isFull)
{
  ScatteringMedium medium;
  medium.Cells = glm::ivec3(Cells);
  medium.CellSize = glm::dvec3(1.0 / Cells);
  medium.Extinction.assign(medium.GetNumberOfCells(), static_cast<float>(extinction));
  medium.Albedo.assign(medium.GetNumberOfCells(), glm::vec3(1.0F));
  static_cast<void>(medium.Phase.SetHenyeyGreenstein(g));
  std::vector<ScatteringLight> lights(1);
  lights[0].Direction = glm::normalize(glm::dvec3(direction[0], direction[1], direction[2]));
  lights[0].Fill(medium, glm::vec3(1.0F));
  ScatteredLight field;
  interlume::ScatteringReport report;
  static_cast<void>(interlume::ScatteringSolver::Solve(medium, lights,
    isFull ? interlume::ScatteringMode::Full : interlume::ScatteringMode::Forward, {}, field,
    report));
  const glm::dvec3 toCamera(0.0, 0.0, 1.0);
  const double phase =
    4.0 * vtkMath::Pi() * medium.Phase.Value(glm::dot(lights[0].Direction, toCamera));
  double sum = 0.0;
  int columns = 0;
  for (int j = 1; j + 1 < Cells; ++j)
  {
    for (int i = 1; i + 1 < Cells; ++i, ++columns)
    {
      double transmittance = 1.0;
      for (int k = Cells - 1; k >= 0; --k)
      {
        const std::size_t cell = medium.GetIndex({ i, j, k });
        double source = field.Forward.empty() ? 0.0 : phase * field.Forward[0][cell].y;
        source += field.Fluence.empty() ? 0.0
                                        : field.Fluence[cell].y *
            (1.0 + 3.0 * g * glm::dot(glm::dvec3(field.NetFlux[cell]), toCamera));
        const double transmitted = std::exp(-extinction / Cells);
        sum += transmittance * (1.0 - transmitted) * source;
        transmittance *= transmitted;
      }
    }
  }
  return sum / columns;
}

void TestAgainstSolver(Check& check)
{
  for (const int mode : { Mapper::FORWARD_SCATTERING, Mapper::FULL_SCATTERING })
  {
    for (const double g : { 0.0, 0.75 })
    {
      for (const Double3& direction : { Double3{ { 0.0, 0.0, 1.0 } }, Double3{ { 0.0, 0.0, -1.0 } },
             Double3{ { 1.0, 0.3, -0.2 } } })
      {
        constexpr double extinction = 4.0;
        const ShadowScene scene = MakeCube(extinction, direction);
        const auto draw = [&](int drawnMode)
        {
          vtkNew<Mapper> mapper;
          SetMode(mapper, drawnMode, g);
          mapper->SetScatteringGridSize(Cells);
          return GetMean(DrawByMapper(mapper, scene));
        };
        const double found = draw(mode) - draw(Mapper::SINGLE_SCATTERING);
        const double expected =
          GetSolved(extinction, g, direction, mode == Mapper::FULL_SCATTERING);
        const std::string name = std::string(mode == Mapper::FULL_SCATTERING ? "full" : "forward") +
          ", g " + std::to_string(g) + ", light along " + std::to_string(direction[0]) + " " +
          std::to_string(direction[2]);
        std::cout << name << ": " << found << " for " << expected << std::endl;
        check.Near(found, expected, 0.02 * expected + 1e-4, name, 1.0);
        check.That(expected > 0.01, name + ": the light is not negligible");
      }
    }
  }
}

/// Returns fourteen lights with the directions and weights of a spherical quadrature rule of degree
/// 5 (Lebedev).
std::vector<vtkSmartPointer<vtkLight>> MakeFurnace()
{
  std::vector<vtkSmartPointer<vtkLight>> lights;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double sign : { -1.0, 1.0 })
    {
      Double3 direction{};
      direction[static_cast<std::size_t>(axis)] = sign;
      lights.push_back(MakeDirectionalLight(direction));
      lights.back()->SetIntensity(1.0 / 15.0);
    }
  }
  for (unsigned corner = 0; corner < 8; ++corner)
  {
    lights.push_back(MakeDirectionalLight(
      { { corner & 1u ? 1.0 : -1.0, corner & 2u ? 1.0 : -1.0, corner & 4u ? 1.0 : -1.0 } }));
    lights.back()->SetIntensity(3.0 / 40.0);
  }
  return lights;
}

/// Light scattered by the medium of the furnace, plus the transmitted white background. Values are
/// means over blocks of 4 x 4 pixels and over the eight symmetries of the cube and its lights.
class FurnaceImage
{
public:
  explicit FurnaceImage(const RgbaImage& image)
  {
    const int last = Pixels - 1;
    for (int j = 0; j < Pixels; ++j)
    {
      for (int i = 0; i < Pixels; ++i)
      {
        const auto& pixel = image.At(i, j);
        const int u = std::min(i, last - i);
        const int v = std::min(j, last - j);
        this->Means[GetBlock(std::min(u, v), std::max(u, v))] += pixel[1] + 1.0 - pixel[3];
      }
    }
    for (int v = 0; v < Pixels / 2; ++v)
    {
      for (int u = 0; u <= v; ++u)
      {
        this->Counts[GetBlock(u, v)] += u == v ? 4.0 : 8.0;
      }
    }
    for (auto& [block, mean] : this->Means)
    {
      mean /= this->Counts[block];
    }
  }

  double GetMean() const
  {
    double sum = 0.0;
    for (const auto& [block, mean] : this->Means)
    {
      sum += this->Counts.at(block) * mean;
    }
    return sum / (Pixels * Pixels);
  }
  /// Returns the largest difference between corresponding blocks of two images.
  double GetDifference(const FurnaceImage& other) const
  {
    double largest = 0.0;
    for (const auto& [block, mean] : this->Means)
    {
      reference::KeepLargest(largest, std::abs(mean - other.Means.at(block)));
    }
    return largest;
  }

  static constexpr int Pixels = 32;

private:
  static int GetBlock(int u, int v) { return u / 4 + Pixels * (v / 4); }

  std::map<int, double> Means;
  std::map<int, double> Counts;
};

/// A medium without absorption in light from all directions is indistinguishable from its
/// background, except for the error of approximating uniform light by fourteen lights. Path tracing
/// with the same lights has the same error.
void TestFurnace(Check& check)
{
  for (const double depth : { 0.1, 1.0, 3.0, 10.0 })
  {
    for (const double g : { 0.0, 0.3 })
    {
      ShadowScene scene = MakeCube(depth, { { 0.0, 0.0, -1.0 } });
      scene.Lights = MakeFurnace();
      vtkNew<Mapper> mapper;
      SetMode(mapper, Mapper::FULL_SCATTERING, g);
      const RgbaImage image = DrawByMapper(mapper, scene);
      SceneTransportSettings settings;
      settings.Phase = TransportPhase::HenyeyGreenstein(g);
      settings.PathsPerPixel = 64;
      const TransportImage paths = TraceScene(scene, settings);
      double noise = 0.0;
      double largest = 0.0;
      for (int j = 0; j < FurnaceImage::Pixels; ++j)
      {
        for (int i = 0; i < FurnaceImage::Pixels; ++i)
        {
          noise += std::pow(paths.StandardError.At(i, j)[1], 2.0);
          reference::KeepLargest(largest, image.At(i, j)[1] + 1.0 - image.At(i, j)[3]);
        }
      }
      noise = std::sqrt(noise) / (FurnaceImage::Pixels * FurnaceImage::Pixels);
      const FurnaceImage found(image);
      const FurnaceImage expected(paths.Mean);
      const std::string name =
        "furnace, depth " + std::to_string(depth) + ", g " + std::to_string(g);
      std::cout << name << ": mean " << found.GetMean() << " for " << expected.GetMean() << " +- "
                << noise << ", largest difference of blocks " << found.GetDifference(expected)
                << ", brightest " << largest << std::endl;
      // With 400 paths per pixel, the measured means differ by at most 0.008 up to depth 3 and by
      // 0.024 at depth 10. The smallest blocks combine 64 pixels, so their noise is four times the
      // noise of the mean.
      check.Near(found.GetMean(), expected.GetMean(), noise + (depth < 5.0 ? 0.008 : 0.025),
        name + ": mean", 1.0);
      check.Near(found.GetDifference(expected), 0.0, 0.045 + 12.0 * noise, name + ": blocks", 1.0);
      check.That(largest < 1.02, name + ": nothing is brighter than the background");
    }
  }
}

/// A soft sphere in oblique light: slice spacing, light buffer size and grid size do not change the
/// image.
void TestInvariance(Check& check)
{
  auto scene = MakeScene(MakeImage(64, MakeSphere(0.1, 0.45)), MakeTranslucentProperty(0.6, false));
  vtkNew<vtkColorTransferFunction> albedo;
  albedo->AddRGBPoint(0.0, 0.95, 0.95, 0.95);
  scene.Size = { { 48, 48 } };
  for (const int mode : { Mapper::FORWARD_SCATTERING, Mapper::FULL_SCATTERING })
  {
    const auto draw = [&](double spacing, int buffer, int cells)
    {
      vtkNew<Mapper> mapper;
      SetMode(mapper, mode, 0.5);
      mapper->SetScatteringAlbedo(albedo);
      mapper->SetSliceSpacing(spacing);
      mapper->SetLightBufferSize(buffer);
      mapper->SetScatteringGridSize(cells);
      const RgbaImage image = DrawByMapper(mapper, scene);
      std::cout << mapper->GetReport()->GetNumber("ScatteringCells") << " cells in "
                << mapper->GetReport()->GetNumber("ScatteringSeconds") << " s, image in "
                << mapper->GetReport()->GetNumber("Seconds") << " s" << std::endl;
      return image;
    };
    const auto expect = [&](const std::string& what, const std::vector<RgbaImage>& images)
    {
      double last = 0.02;
      for (std::size_t i = 1; i < images.size(); ++i)
      {
        const double change = CompareImages(images[i - 1], images[i]).Mean / GetMean(images[i], 0);
        const std::string name = what + (mode == Mapper::FULL_SCATTERING ? ", full" : ", forward");
        std::cout << name << ": step " << i << " changes " << change << std::endl;
        check.Near(change, 0.0, last, name, 1.0);
        last = std::max(0.5 * change, 1e-4);
      }
    };
    expect("slice spacing halved",
      { draw(0.04, 64, 16), draw(0.02, 64, 16), draw(0.01, 64, 16), draw(0.005, 64, 16) });
    expect(
      "light buffer size doubled", { draw(0.01, 32, 16), draw(0.01, 64, 16), draw(0.01, 128, 16) });
    expect("grid size doubled", { draw(0.01, 64, 16), draw(0.01, 64, 32), draw(0.01, 64, 64) });
  }
}

}

int TestScatteringField(int, char*[])
{
  Check check;
  TestAgainstSolver(check);
  TestFurnace(check);
  TestInvariance(check);
  return check.Result();
}
