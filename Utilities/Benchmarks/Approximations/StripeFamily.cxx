// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Approximations/PictureFamilies.h"
#include "Support/Pictures/VolumeStage.h"

#include "vtkStreamlineTexture.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTexture.h"
#include "vtkVolume.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace approximations
{
namespace
{
constexpr double LineWidth = 0.25;
constexpr int DefaultLines = 256;
constexpr int DefaultTexels = 16;

/// A floor to the horizon, unlit, with s from side to side: all pixels of a row of the picture have
/// the same part of s.
vtkSmartPointer<vtkActor> MakeFloor()
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-60.0, 0.0, -1.0);
  plane->SetPoint1(60.0, 0.0, -1.0);
  plane->SetPoint2(-60.0, 100.0, -1.0);
  plane->Update();
  vtkPolyData* data = plane->GetOutput();
  vtkDataArray* coordinates = data->GetPointData()->GetTCoords();
  for (vtkIdType id = 0; id < coordinates->GetNumberOfTuples(); ++id)
  {
    coordinates->SetComponent(id, 0, 20.0 * coordinates->GetComponent(id, 0));
  }
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  return actor;
}

vtkSmartPointer<vtkCamera> MakeCamera()
{
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetPosition(0.0, 0.0, 0.0);
  camera->SetFocalPoint(0.0, 1.0, -0.45);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(45.0);
  camera->SetClippingRange(0.1, 200.0);
  return camera;
}

/// The same stripes in a texture whose levels OpenGL averages.
vtkSmartPointer<vtkTexture> MakeAveraged(int lines, int texels)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(lines * texels, 1, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* values = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < lines * texels; ++i)
  {
    const double place = (i % texels + 0.5) / texels;
    std::fill_n(values + 3 * i, 3, std::min(place, 1.0 - place) < 0.5 * LineWidth ? 0 : 255);
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->InterpolateOn();
  texture->MipmapOn();
  texture->RepeatOn();
  return texture;
}

vtkSmartPointer<vtkStreamlineTexture> MakeStripes(int lines, int texels)
{
  auto texture = vtkSmartPointer<vtkStreamlineTexture>::New();
  texture->SetNumberOfLines(lines);
  texture->SetTexelsPerLine(texels);
  texture->SetLineWidth(LineWidth);
  return texture;
}

/// What rows of pixels have lost of the standard deviation of black and white stripes, on the mean
/// of those rows that the floor fills.
double MeasureContrast(const reference::RgbaPicture& picture)
{
  const double whole = std::sqrt(LineWidth * (1.0 - LineWidth));
  double lost = 0.0;
  int rows = 0;
  for (int j = 0; j < picture.Height; ++j)
  {
    double sum = 0.0;
    double squares = 0.0;
    bool isFloor = true;
    for (int i = 0; i < picture.Width; ++i)
    {
      const double red = picture.At(i, j)[0];
      isFloor = isFloor && picture.At(i, j)[3] > 0.999;
      sum += red;
      squares += red * red;
    }
    if (isFloor)
    {
      const double mean = sum / picture.Width;
      const double deviation = std::sqrt(std::max(0.0, squares / picture.Width - mean * mean));
      lost += std::abs(1.0 - deviation / whole);
      ++rows;
    }
  }
  return rows > 0 ? lost / rows : 1.0;
}

void AddStripeRows(const Question& question, const BenchOptions& options, BenchRows& rows)
{
  const int pixels = options.Pick(512, 256, 64);
  reference::VolumeStage stage(std::array<int, 2>{ { pixels, pixels } });
  stage.GetVolume()->VisibilityOff();
  auto floor = MakeFloor();
  stage.AddActor(floor);
  auto camera = MakeCamera();
  Trials trials;
  trials.SetSize("pixels along an edge", pixels);
  int frames = 0;
  const auto add = [&](const std::string& method, int setting, Maker maker, vtkTexture* made)
  {
    const vtkSmartPointer<vtkTexture> texture = made;
    trials.Add(method, NumberText(setting), maker,
      WithThreads(options.Threads,
        [&, texture]()
        {
          vtkNew<vtkCamera> moved;
          moved->DeepCopy(camera);
          moved->Yaw(0.2 * (++frames % 40));
          floor->SetTexture(texture);
          stage.SetCamera(moved);
          stage.Render();
          return vtkSmartPointer<vtkObjectBase>(texture);
        }),
      [&, texture]()
      {
        floor->SetTexture(texture);
        stage.SetCamera(camera);
        return MeasureContrast(stage.Capture());
      });
  };
  for (const int lines :
    options.Pick<std::vector<int>>({ 16, 64, 256 }, { 16, 64, 256 }, { 16, 256 }))
  {
    add("lines", lines, lines == DefaultLines ? Maker::Default : Maker::Own,
      MakeStripes(lines, DefaultTexels));
    add("averaged levels, lines", lines, Maker::Peer, MakeAveraged(lines, DefaultTexels));
  }
  for (const int texels : options.Pick<std::vector<int>>({ 4, 8, 32 }, { 4, 8, 32 }, { 4 }))
  {
    add("texels from line to line", texels, Maker::Own, MakeStripes(DefaultLines, texels));
  }
  trials.Run(question, options, rows, ClockOf(stage.GetWindow()));
}
}

Family MakeStripeFamily()
{
  return { { "streamline-texture", "Stripes on a floor to the horizon: contrast lost against time",
             "What are the levels of vtkStreamlineTexture worth, and how fine are they to be?",
             "Lines on a floor, NumberOfLines or TexelsPerLine at each point; the peer is "
             "vtkTexture with mipmaps of the same stripes. Each row of pixels is compared with "
             "black and white stripes of the same share.",
             "time of a frame (s)", "contrast lost, mean over rows of pixels" },
    AddStripeRows };
}
}
