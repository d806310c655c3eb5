// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Growth/GrowthQuantity.h"

#include "Benchmarks/Shadows/ShadowsMethods.h"
#include "Benchmarks/Shadows/ShadowsScene.h"
#include "Benchmarks/Tetrahedra/TetrahedraScene.h"

#include "vtkImageData.h"
#include "vtkRenderWindow.h"

#include <memory>

namespace growth
{
namespace
{
/// The last mapper that was made, in a window of its own.
struct DrawnTetrahedra
{
  explicit DrawnTetrahedra(int pixels)
    : Theatre(pixels)
  {
  }

  tetrahedra::Theatre Theatre;
  vtkSmartPointer<vtkTimeWeightedTetrahedraMapper> Mapper;
};

Job MakeTetrahedraJob(const tetrahedra::RenderPath& path, int cubes, const BenchOptions& options)
{
  auto grid = tetrahedra::MakeGrid(cubes);
  const auto drawn = std::make_shared<DrawnTetrahedra>(options.Pick(128, 64, 32));
  Job job;
  job.Measured.Timed =
    WithThreads(options.Threads, [drawn]() { return drawn->Theatre.FrameOf(drawn->Mapper)(); });
  job.Measured.Fresh = [grid, drawn, path, frame = job.Measured.Timed]()
  {
    drawn->Mapper = tetrahedra::NewMapper(grid, path, tetrahedra::GetDefaultMode());
    return frame();
  };
  job.Measured.Forget = [drawn]()
  {
    drawn->Mapper->ReleaseGraphicsResources(drawn->Theatre.GetStage().GetWindow());
    drawn->Theatre.GetStage().GetVolume()->SetMapper(nullptr);
    drawn->Mapper = nullptr;
  };
  job.GetN = [grid]() { return static_cast<double>(grid->GetNumberOfCells()); };
  job.InputKib = static_cast<double>(grid->GetActualMemorySize());
  return job;
}

/// What is set before the first frame.
using Setting = std::function<void(vtkShadowedSliceMapper*)>;

/// The last mapper of a scene that was made, in a window that others may share.
struct DrawnSlices
{
  std::shared_ptr<reference::VolumeStage> Stage;
  reference::ShadowScene Scene;
  Setting Set;
  shadows::MethodPointer Method;
};

Execution MakeExecution(const std::shared_ptr<DrawnSlices>& drawn, int threads)
{
  Execution made;
  made.Timed = [drawn, threads]() { return drawn->Method->GetFrame(threads)(); };
  made.Fresh = [drawn, frame = made.Timed]()
  {
    drawn->Method = shadows::MakeSlices(*drawn->Stage, drawn->Scene, drawn->Set);
    return frame();
  };
  made.Forget = [drawn]() { drawn->Method = nullptr; };
  return made;
}

shadows::Case MakeSphere(const BenchOptions& options)
{
  return shadows::WithPixels(
    { shadows::MakeSphere(options.Pick(64, 32, 12)) }, options.Pick(256, 128, 32))
    .front();
}

Job MakeSlicesJob(int slices, const BenchOptions& options)
{
  const shadows::Case sphere = MakeSphere(options);
  const double spacing = sphere.Scene.Image->GetLength() / slices;
  const auto drawn = std::make_shared<DrawnSlices>();
  drawn->Stage = std::make_shared<reference::VolumeStage>(sphere.Scene.Size);
  drawn->Scene = sphere.Scene;
  drawn->Set = [spacing](vtkShadowedSliceMapper* mapper) { mapper->SetSliceSpacing(spacing); };
  Job job;
  job.Measured = MakeExecution(drawn, options.Threads);
  job.GetN = [drawn]()
  { return static_cast<double>(drawn->Method->GetSlices()->GetReport().SlicesDrawn); };
  job.InputKib = static_cast<double>(sphere.Scene.Image->GetActualMemorySize());
  return job;
}

Job MakeLightsJob(int lights, const BenchOptions& options)
{
  shadows::Case sphere = MakeSphere(options);
  sphere.Scene.Lights = shadows::MakeLights(sphere.Scene, lights);
  // Large buffers and few slices: memory that can be measured in time that can be spent.
  const double spacing = sphere.Scene.Image->GetLength() / options.Pick(16, 16, 8);
  const int columns = options.Pick(1024, 512, 32);
  const auto shadowed = std::make_shared<DrawnSlices>();
  shadowed->Stage = std::make_shared<reference::VolumeStage>(sphere.Scene.Size);
  shadowed->Scene = sphere.Scene;
  shadowed->Set = [spacing, columns](vtkShadowedSliceMapper* mapper)
  {
    mapper->SetSliceSpacing(spacing);
    mapper->SetLightBufferSize(columns);
  };
  const auto plain = std::make_shared<DrawnSlices>();
  plain->Stage = shadowed->Stage;
  plain->Scene = sphere.Scene;
  plain->Scene.Shadows = false;
  plain->Set = shadowed->Set;
  Job job;
  job.Measured = MakeExecution(shadowed, options.Threads);
  job.Without = MakeExecution(plain, options.Threads);
  job.GetN = [lights]() { return lights; };
  job.InputKib = static_cast<double>(sphere.Scene.Image->GetActualMemorySize());
  return job;
}
}

Quantity MakeTetrahedra(const BenchOptions& options, const tetrahedra::RenderPath& path)
{
  return { "tetrahedra, " + std::string(path.Name), "tetrahedra",
    "vtkTimeWeightedTetrahedraMapper of a gyroid, a small picture, all threads",
    options.Pick<std::vector<int>>({ 14, 20, 28, 40, 56 }, { 8, 12, 16, 20 }, { 3, 4, 6 }),
    { 1.0 / 3.0, 1.0,
      "each tetrahedron is sorted and projected, N; a pixel's ray meets N^(1/3) of them, which "
      "dominates where pixels outnumber tetrahedra" },
    { 1.0, 1.0, "each tetrahedron has its place in order, and its faces" },
    [path](int cubes, const BenchOptions& sizes)
    { return MakeTetrahedraJob(path, cubes, sizes); } };
}

Quantity MakeSlices(const BenchOptions& options)
{
  return { "slices", "slices drawn",
    "vtkShadowedSliceMapper of a sphere of haze, one light, all threads",
    options.Pick<std::vector<int>>(
      { 64, 128, 256, 512, 1024 }, { 32, 64, 128, 256 }, { 8, 16, 32 }),
    { 1.0, 1.0,
      "each slice is drawn once into the picture and once into the light's buffer; what a picture "
      "takes besides is a constant" },
    { 0.0, 0.0, "picture and buffer are drawn over; slices are not kept" }, MakeSlicesJob };
}

Quantity MakeLights(const BenchOptions& options)
{
  return { "lights", "lights that cast shadows",
    "vtkShadowedSliceMapper of a sphere of haze, over the same lights without shadows, all threads",
    options.Size == BenchOptions::TINY ? std::vector<int>{ 1, 2 } : std::vector<int>{ 1, 2, 4, 8 },
    { 1.0, 1.0, "each light has its own buffer, drawn once a slice" },
    { 1.0, 1.0, "each light has a buffer of the same size" }, MakeLightsJob };
}
}
