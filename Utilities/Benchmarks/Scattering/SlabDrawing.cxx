// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Scattering/SlabDrawing.h"

#include "Support/Images/CameraSettings.h"
#include "Support/Images/ShadowCases.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkShadowedSliceMapper.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace scattering
{
namespace
{
/// Nodes and weights of Gauss-Legendre quadrature on [0, 1].
constexpr std::array<double, 8> Nodes = { { 0.0198550717512319, 0.1016667612931866,
  0.2372337950418355, 0.4082826787521751, 0.5917173212478248, 0.7627662049581645,
  0.8983332387068135, 0.9801449282487682 } };
constexpr std::array<double, 8> Weights = { { 0.0506142681451884, 0.1111905172266872,
  0.1568533229389437, 0.1813418916891810, 0.1813418916891810, 0.1568533229389437,
  0.1111905172266872, 0.0506142681451884 } };

/// Number of columns and rows of the light buffer for short mean free paths.
constexpr int FineBuffer = 384;

/// Maximum number of grid cells along the width of the box.
constexpr int MaximumCells = 128;

/// Returns the width of the box divided by its thickness. Optically thin slabs require wide boxes,
/// since light in grazing directions comes from far away.
int GetWidth(const Slab& slab)
{
  return slab.Depth < 0.1 ? 64 : slab.Depth < 4.0 ? 12 : slab.Depth < 16.0 ? 8 : 3;
}

reference::ShadowScene MakeScene(const Slab& slab)
{
  const int width = GetWidth(slab);
  reference::ShadowScene scene;
  scene.Image = reference::MakeImage({ { 2 * width, 2 * width, 32 } }, { { 0.5, 0.5, 1.0 / 32.0 } },
    [](const reference::Double3&) { return 1.0; });
  // The color is the albedo. The thickness is 1, so the extinction equals the optical depth. The
  // unit distance is the one at which this extinction results in a small opacity.
  const double a = slab.Albedo;
  constexpr double opacity = 0.02;
  scene.Property =
    reference::MakeProperty({ { 0.0, { { a, a, a } }, 0.0 }, { 1.0, { { a, a, a } }, opacity } },
      -std::log1p(-opacity) / slab.Depth);
  scene.Lights = { reference::MakeDirectionalLight(
    { { std::sqrt(1.0 - slab.Cosine * slab.Cosine), 0.0, -slab.Cosine } }) };
  scene.Lights.front()->SetIntensity(1.0);
  scene.Camera = vtkSmartPointer<vtkCamera>::New();
  scene.Size = { { 4, 4 } };
  return scene;
}

/// Returns a camera that views the center of the upper or lower face of the slab. \a cosine is the
/// cosine of the angle between the view direction and the face normal.
vtkSmartPointer<vtkCamera> MakeCamera(double cosine, bool isAbove, double width)
{
  const double across = std::sqrt(1.0 - cosine * cosine);
  const double side = isAbove ? 1.0 : -1.0;
  auto camera = reference::LookAt(reference::Point3{ { 0.0, 0.0, 0.5 * side } }, width,
    { { across, 0.0, -side * cosine } }, true);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetParallelScale(0.02);
  return camera;
}
}

SlabDrawing::SlabDrawing(
  reference::VolumeStage& stage, const Slab& slab, const std::string& mode, int across)
  : Medium(slab)
  , Across(across)
  , Scene(MakeScene(slab))
{
  const int cells = std::min(across * GetWidth(slab), MaximumCells);
  // Depth along the normal that incident light reaches in one mean free path.
  const double path = slab.Cosine / slab.Depth;
  const double spacing = std::min(1.0 / 32.0, 0.5 * path);
  this->Drawn = shadows::MakeSliceMethod(stage, this->Scene,
    MakeModeSetter(mode, slab.G,
      [=](vtkShadowedSliceMapper* mapper)
      {
        mapper->SetScatteringGridSize(cells);
        mapper->SetSliceSpacing(spacing);
        mapper->SetLightBufferSize(path < 1.0 / 64.0 ? FineBuffer : 0);
      }));
}

int SlabDrawing::GetCellsAlongThickness(const Slab& slab, int across)
{
  return std::max(std::min(across * GetWidth(slab), MaximumCells) / GetWidth(slab), 1);
}

double SlabDrawing::GetFlux(bool isReflected)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < Nodes.size(); ++i)
  {
    // View directions are denser near the normal, so that a Henyey-Greenstein phase function with
    // g = 0.9 in a thin slab is integrated with an error below 0.5 %.
    const double rest = 1.0 - Nodes[i];
    const double cosine = 1.0 - rest * rest * rest;
    this->Scene.Camera->DeepCopy(MakeCamera(cosine, isReflected, GetWidth(this->Medium)));
    sum += 3.0 * rest * rest * Weights[i] * cosine * this->Drawn->Capture().At(2, 2)[0];
  }
  // A light of color 1 has an irradiance of 4 pi perpendicular to its direction. The integral over
  // the azimuth contributes a factor of 2 pi.
  return 0.5 * sum / this->Medium.Cosine;
}

BenchWork SlabDrawing::MakeRelightingWork(int threads)
{
  this->Scene.Camera->DeepCopy(MakeCamera(0.5, true, GetWidth(this->Medium)));
  return scattering::MakeRelightingWork(*this->Drawn, this->Scene.Lights.front(), threads);
}
}
