// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/FlowTexture/FlowTextureError.h"
#include "Support/Images/FlowImages.h"
#include "Support/Images/CameraSettings.h"
#include "Support/Images/VolumeStage.h"

#include "vtkImplicitFlowVolumeMapper.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkVolumeProperty.h"

#include <array>
#include <cmath>

namespace approximations
{
namespace
{
using Mapper = vtkImplicitFlowVolumeMapper;

/// Number of view rays along each edge of a pixel in the reference image.
constexpr int Finer = 3;

/// Returns the inflow coordinates (u,v) and the advection time of the streamline through x, in a
/// curved flow along the x axis.
reference::FlowEnd Bent(const reference::Position3& x)
{
  const double a = x[0] + 0.5;
  return { true, 0, 0.5 + 0.8 * x[1] + 0.08 * std::sin(5.0 * a + 3.0 * x[2]),
    0.5 + 0.8 * x[2] + 0.08 * std::cos(4.0 * a + 2.0 * x[1]), a };
}

/// Returns the color of a pattern of stripes and spots that 257 x 257 texels resolve.
reference::Color4 Paint(double u, double v)
{
  const double stripes = 0.5 + 0.5 * std::sin(60.0 * u);
  const double spots = 0.5 + 0.25 * (std::sin(40.0 * u) + std::cos(50.0 * v));
  return { { stripes, spots, 1.0 - stripes, 0.5 * spots * spots } };
}

/// Returns an image of lower resolution. Each pixel is the mean of Finer x Finer pixels.
reference::RgbaImage MakeCoarser(const reference::RgbaImage& fine)
{
  reference::RgbaImage image(fine.Width / Finer, fine.Height / Finer);
  for (int j = 0; j < fine.Height; ++j)
  {
    for (int i = 0; i < fine.Width; ++i)
    {
      for (int c = 0; c < 4; ++c)
      {
        image.At(i / Finer, j / Finer)[c] += fine.At(i, j)[c] / (Finer * Finer);
      }
    }
  }
  return image;
}

reference::FlowScene MakeScene(int pixels)
{
  reference::FlowScene scene;
  scene.Flow = &Bent;
  scene.Paint = [](const reference::FlowEnd& end) { return Paint(end.U, end.V); };
  scene.Size = { { Finer * pixels, Finer * pixels } };
  scene.Camera = reference::LookAt({ { 0.0, 0.0, 0.0 } }, 0.87, { { -0.8, 0.5, -0.4 } }, false);
  return scene;
}

void AddVoxelRows(const Question& question, const BenchOptions& options, BenchRows& rows)
{
  const int pixels = options.Pick(192, 64, 16);
  const reference::FlowScene scene = MakeScene(pixels);
  const reference::RgbaImage expected =
    MakeCoarser(reference::MakeFlowReferenceImage(scene, options.Pick(1500, 500, 200)));
  reference::VolumeStage stage(std::array<int, 2>{ { pixels, pixels } });
  vtkNew<vtkVolumeProperty> property;
  property->SetScalarOpacityUnitDistance(scene.UnitDistance);
  const auto paint = reference::MakePaint(257, 257, &Paint);
  const auto sizes =
    options.Pick<std::vector<int>>({ 9, 17, 33, 65, 129 }, { 9, 17, 33, 65 }, { 9, 17 });
  Trials trials;
  trials.SetSize("pixels along an edge", pixels);
  int frames = 0;
  for (const bool isFiltered : { true, false })
  {
    for (const int points : sizes)
    {
      auto mapper = vtkSmartPointer<Mapper>::New();
      mapper->SetInputData(
        static_cast<vtkDataSet*>(reference::MakeFlowVoxels(points, &Bent).GetPointer()));
      mapper->SetInflowTexture(Mapper::ALL, paint);
      mapper->SetTextureFilter(isFiltered);
      trials.Add(isFiltered ? "paint filtered" : "paint looked up once", NumberText(points),
        isFiltered && points == sizes.back() ? Maker::Default : Maker::Own,
        WithThreads(options.Threads,
          [&, mapper]()
          {
            vtkNew<vtkCamera> moved;
            moved->DeepCopy(scene.Camera);
            moved->Azimuth(0.5 * (++frames % 40));
            stage.SetVolume(mapper, property);
            stage.SetCamera(moved);
            stage.Render();
            return vtkSmartPointer<vtkObjectBase>(mapper);
          }),
        [&, mapper]()
        {
          stage.SetVolume(mapper, property);
          stage.SetCamera(scene.Camera);
          return reference::CompareImages(stage.Capture(), expected).Mean;
        });
    }
  }
  trials.Run(question, options, rows, SelectClock(stage.GetWindow()));
}
}

Family MakeFlowVoxelFamily()
{
  return { { "flow-texture-voxels", "Voxels of a painted flow: error against time of a frame",
             "How many voxels are required for a painted flow, and should its texture be filtered?",
             "A curved flow painted with stripes and spots, rendered by "
             "vtkImplicitFlowVolumeMapper; labels are voxels along an edge. The reference is "
             "rendered from the formula with nine view rays per pixel.",
             "time of a frame (s)", "channel difference, mean" },
    AddVoxelRows };
}
}
