// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Approximations/FinerPicture.h"
#include "Benchmarks/Approximations/PictureFamilies.h"
#include "Support/Pictures/FlowPictures.h"
#include "Support/Pictures/PictureSettings.h"
#include "Support/Pictures/VolumeStage.h"

#include "vtkImplicitFlowVolumeMapper.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkVolumeProperty.h"

#include <array>
#include <cmath>
#include <functional>

namespace approximations
{
namespace
{
using Mapper = vtkImplicitFlowVolumeMapper;

const char* const FrameLabel = "time of a frame (s)";
const char* const Norm = "channel difference, mean";
constexpr int DefaultPaintSamples = 8;

/// A flow along x that bends to and fro; places where it starts are u and v.
reference::FlowEnd Bent(const reference::Place3& x)
{
  const double a = x[0] + 0.5;
  return { true, 0, 0.5 + 0.8 * x[1] + 0.08 * std::sin(5.0 * a + 3.0 * x[2]),
    0.5 + 0.8 * x[2] + 0.08 * std::cos(4.0 * a + 2.0 * x[1]), a };
}

/// Stripes and spots, soft enough for an image of 257 x 257 to hold.
reference::Color4 Paint(double u, double v)
{
  const double stripes = 0.5 + 0.5 * std::sin(60.0 * u);
  const double spots = 0.5 + 0.25 * (std::sin(40.0 * u) + std::cos(50.0 * v));
  return { { stripes, spots, 1.0 - stripes, 0.5 * spots * spots } };
}

/// A painted flow, its picture by formula, and all ways to draw it, one after another in a window.
class Scene
{
public:
  explicit Scene(const BenchOptions& options)
    : Options(options)
    , Pixels(options.Pick(192, 64, 16))
    , Stage(std::array<int, 2>{ { this->Pixels, this->Pixels } })
    , Image(reference::MakePaint(257, 257, &Paint))
  {
    this->What.Flow = &Bent;
    this->What.Paint = [](const reference::FlowEnd& end) { return Paint(end.U, end.V); };
    this->What.Size = { { Finer * this->Pixels, Finer * this->Pixels } };
    this->What.Camera =
      reference::LookAt({ { 0.0, 0.0, 0.0 } }, 0.87, { { -0.8, 0.5, -0.4 } }, false);
    this->Expected =
      MakeCoarser(reference::MakeFlowPicture(this->What, options.Pick(1500, 500, 200)));
    this->Property->SetScalarOpacityUnitDistance(this->What.UnitDistance);
    this->AllTrials.SetSize("pixels along an edge", this->Pixels);
  }

  void Add(const std::string& method, const std::string& setting, bool isDefault,
    vtkImageData* voxels, const std::function<void(Mapper*)>& change)
  {
    auto mapper = vtkSmartPointer<Mapper>::New();
    mapper->SetInputData(static_cast<vtkDataSet*>(voxels));
    mapper->SetInflowTexture(Mapper::ALL, this->Image);
    change(mapper);
    this->AllTrials.Add(method, setting, isDefault ? Maker::Default : Maker::Own,
      WithThreads(this->Options.Threads,
        [this, mapper]()
        {
          vtkNew<vtkCamera> moved;
          moved->DeepCopy(this->What.Camera);
          moved->Azimuth(0.5 * (++this->Frames % 40));
          this->Show(mapper, moved);
          this->Stage.Render();
          return vtkSmartPointer<vtkObjectBase>(mapper);
        }),
      [this, mapper]()
      {
        this->Show(mapper, this->What.Camera);
        return reference::ComparePictures(this->Stage.Capture(), this->Expected).Mean;
      });
  }

  void SetSize(const std::string& name, double number) { this->AllTrials.SetSize(name, number); }

  void Run(const Question& question, BenchRows& rows)
  {
    this->AllTrials.Run(question, this->Options, rows, ClockOf(this->Stage.GetWindow()));
  }

private:
  void Show(Mapper* mapper, vtkCamera* camera)
  {
    this->Stage.SetVolume(mapper, this->Property);
    this->Stage.SetCamera(camera);
  }

  BenchOptions Options;
  int Pixels;
  reference::VolumeStage Stage;
  vtkSmartPointer<vtkImageData> Image;
  reference::FlowScene What;
  reference::RgbaPicture Expected;
  vtkNew<vtkVolumeProperty> Property;
  Trials AllTrials;
  int Frames = 0;
};

void AddVoxelRows(const Question& question, const BenchOptions& options, BenchRows& rows)
{
  Scene scene(options);
  const auto sizes =
    options.Pick<std::vector<int>>({ 9, 17, 33, 65, 129 }, { 9, 17, 33, 65 }, { 9, 17 });
  for (const bool isFiltered : { true, false })
  {
    for (const int points : sizes)
    {
      scene.Add(isFiltered ? "paint filtered" : "paint looked up once", NumberText(points),
        isFiltered && points == sizes.back(), reference::MakeFlowVoxels(points, &Bent),
        [isFiltered](Mapper* mapper) { mapper->SetPaintFilter(isFiltered); });
    }
  }
  scene.Run(question, rows);
}

void AddSampleRows(const Question& question, const BenchOptions& options, BenchRows& rows)
{
  Scene scene(options);
  const int points = options.Pick(129, 33, 9);
  scene.SetSize("voxels along an edge", points);
  auto voxels = reference::MakeFlowVoxels(points, &Bent);
  const double voxel = voxels->GetSpacing()[0];
  for (const double distance : options.Pick<std::vector<double>>(
         { 4.0, 2.0, 1.0, 0.5, 0.25, 0.125 }, { 4.0, 2.0, 1.0, 0.5, 0.25 }, { 1.0, 0.5 }))
  {
    scene.Add("distance of samples, voxels", NumberText(distance), distance == 0.5, voxels,
      [distance, voxel](Mapper* mapper) { mapper->SetSampleDistance(distance * voxel); });
  }
  for (const int samples : options.Pick<std::vector<int>>({ 1, 2, 4, 16 }, { 1, 2, 4 }, { 1 }))
  {
    scene.Add("places of paint for a sample", NumberText(samples), false, voxels,
      [samples](Mapper* mapper) { mapper->SetMaximumPaintSamples(samples); });
  }
  scene.Run(question, rows);
}
}

Family MakeFlowVoxelFamily()
{
  return { { "flow-texture-voxels", "Voxels of a painted flow: error against time of a frame",
             "How many voxels for a painted flow, and is its paint to be filtered?",
             "A bent flow painted with stripes and spots, voxels along an edge at each point, "
             "drawn by vtkImplicitFlowVolumeMapper; against the formula's own picture, nine lines "
             "of sight a pixel.",
             FrameLabel, Norm },
    AddVoxelRows };
}

Family MakeFlowSampleFamily()
{
  return { { "flow-texture-samples", "Samples of a painted flow: error against time of a frame",
             "How far apart are samples of a painted flow, and how many places of paint has each?",
             "A bent flow painted with stripes and spots, drawn by vtkImplicitFlowVolumeMapper; "
             "SampleDistance in voxels, or MaximumPaintSamples, at each point (default " +
               NumberText(DefaultPaintSamples) +
               ": no sample of a picture as fine as its paint has as many, and there a smaller "
               "number spares no more than runs differ by); against the formula's own picture, "
               "nine lines of sight a pixel.",
             FrameLabel, Norm },
    AddSampleRows };
}
}
