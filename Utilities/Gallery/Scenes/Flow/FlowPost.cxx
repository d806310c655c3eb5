// SPDX-License-Identifier: BSD-3-Clause
// Liquid oxygen that flows around a post on a plate, with textured time surfaces, and with an
// animated texture on its inflow.

#include "Gallery/Look.h"
#include "Gallery/Props.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Flow/FlowScene.h"
#include "Gallery/Scenes/Flow/FlowTextures.h"
#include "Gallery/Scenes/Flow/InflowPaint.h"
#include "Gallery/Stage.h"
#include "Gallery/Volumes.h"
#include "Support/Inputs/DataFiles.h"

#include "vtkAppendFilter.h"
#include "vtkFlowVolume.h"
#include "vtkImplicitFlowVolumeMapper.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlaneSource.h"
#include "vtkPoints.h"
#include "vtkProperty.h"
#include "vtkStructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace
{
constexpr double RADIUS = 0.5;
constexpr double HEIGHT = 3.0;

/// The displayed region around the post: x of its start and end, and half its width along y. The
/// post's axis is z.
constexpr double BEGIN = -2.4;
constexpr double END = 3.1;
constexpr double WIDTH = 1.9;

/// Returns points on lines from the post to the sides of a box. The points are denser near the post
/// and near the plate.
vtkSmartPointer<vtkStructuredGrid> MakeSamples()
{
  constexpr int outward = 49;
  constexpr int around = 145;
  constexpr int upward = 37;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int k = 0; k < upward; ++k)
  {
    const double height = HEIGHT * std::pow((k + 1.5) / (upward + 0.5), 1.5);
    for (int j = 0; j < around; ++j)
    {
      const double angle = 2.0 * vtkMath::Pi() * (j % (around - 1)) / (around - 1);
      const double x = std::cos(angle);
      const double y = std::sin(angle);
      const double side = std::min((x < 0.0 ? BEGIN : END) / x, WIDTH / std::abs(y));
      for (int i = 0; i < outward; ++i)
      {
        const double fraction = std::pow(static_cast<double>(i) / (outward - 1), 1.5);
        const double radius = (1.0 - fraction) * 1.01 * RADIUS + fraction * side;
        points->InsertNextPoint(radius * x, radius * y, height);
      }
    }
  }
  auto samples = vtkSmartPointer<vtkStructuredGrid>::New();
  samples->SetDimensions(outward, around, upward);
  samples->SetPoints(points);
  return samples;
}

/// Reads the flow. Merges the coincident points where the grid closes around the post, so that
/// streamlines can cross this seam.
vtkSmartPointer<vtkAppendFilter> ReadFlow()
{
  vtkSmartPointer<vtkDataSet> post = interlume::ReadData("post.vts");
  auto joined = vtkSmartPointer<vtkAppendFilter>::New();
  joined->AddInputData(post);
  joined->MergePointsOn();
  return joined;
}

/// Returns a rectangle upstream of the post. \a width is half its width.
vtkSmartPointer<vtkTerminationPlane> MakeInflow(double width)
{
  return gallery::MakeInflowPlane(
    { BEGIN, 0.0, 0.5 * HEIGHT }, { 0.0, width, 0.0 }, { 0.0, 0.0, 0.5 * HEIGHT });
}

/// Adds the post and a plate, which ends at x = \a end and extends past the other sides of the
/// displayed region by \a margin.
void AddPost(gallery::Panel& panel, double margin, double end)
{
  panel.Add(gallery::MakePillar(RADIUS, 0.0, 1.1 * HEIGHT, gallery::OutlineColor()));
  vtkNew<vtkPlaneSource> plate;
  plate->SetOrigin(BEGIN - margin, -WIDTH - margin, 0.0);
  plate->SetPoint1(end, -WIDTH - margin, 0.0);
  plate->SetPoint2(BEGIN - margin, WIDTH + margin, 0.0);
  plate->Update();
  panel.Add(gallery::MakeActor(plate->GetOutput(), gallery::OutlineColor()));
}

void Build(gallery::Stage& stage)
{
  const vtkSmartPointer<vtkTerminationPlane> plane = MakeInflow(3.0);
  const vtkSmartPointer<vtkDataSet> inflow =
    gallery::MapInflow(gallery::MakeImplicitFlow(ReadFlow(), { plane }, MakeSamples(), 15.0),
      "max(abs(u - 0.5) / 0.25, v / 0.9)");

  vtkNew<vtkFlowVolume> filter;
  filter->SetInterval(0, 0.0, 1.0);
  filter->SetTimeRange(0.0, 4.2);
  filter->SetTimeSurface(0, 0.8);
  filter->SetTimeSurface(1, 2.6);
  filter->GenerateTimeSurfacesOn();
  filter->GenerateNormalsOn();
  filter->ParametersAsTextureCoordinatesOn();
  vtkSmartPointer<vtkUnstructuredGrid> tetrahedra = stage.Extract(filter, inflow);

  gallery::Panel& panel = stage.AddPanel("", { -0.55, -1.0, 0.6 });
  panel.SetAmbientOcclusion(0.02);
  panel.Add(gallery::MakeVolumeOfIntervals(tetrahedra, { { gallery::IntervalColor(0), 0.25 } }));
  for (int id = 0; id < 3; ++id)
  {
    panel.Add(
      gallery::MakeFlowActor(gallery::GetFlowSurface(filter, gallery::TIME_SURFACES, id + 1),
        gallery::MakeGridTexture(23, 12, gallery::IntervalColor(1 + id), gallery::TextColor())));
  }
  AddPost(panel, 0.3, END + 0.3);
}

/// Returns the color and opacity of a pattern of disks. Each row of disks has one color.
gallery::Paint Disks(double u, double v)
{
  const double across = 4.0 * u;
  const double up = 3.0 * v;
  const double r = std::hypot(across - std::floor(across) - 0.5, up - std::floor(up) - 0.5);
  const int row = static_cast<int>(std::min(up, 2.0));
  return { gallery::IntervalColor(row), r < 0.36 ? 0.5 : 0.0 };
}

/// Returns a time gate through the given points (time, opacity).
vtkSmartPointer<vtkPiecewiseFunction> MakeGate(const std::vector<std::array<double, 2>>& points)
{
  auto gate = vtkSmartPointer<vtkPiecewiseFunction>::New();
  for (const std::array<double, 2>& point : points)
  {
    gate->AddPoint(point[0], point[1]);
  }
  return gate;
}

/// Adds two panels. Dye is released continuously from time 0 on in the first panel, and in pulses
/// in the second.
void BuildInflow(gallery::Stage& stage)
{
  // Time in which the liquid passes through the displayed region, and number of pulses in that
  // time.
  constexpr double duration = 4.2;
  constexpr int pulses = 2;
  constexpr double stillFraction = 0.7;
  // x of the end of the displayed region.
  constexpr double end = 2.4;
  const vtkSmartPointer<vtkTerminationPlane> plane = MakeInflow(WIDTH);
  const vtkSmartPointer<vtkDataSet> flow = gallery::MakeImplicitFlow(
    ReadFlow(), { plane }, { { 89, 61, 49 }, { BEGIN, end, -WIDTH, WIDTH, 0.0, HEIGHT } }, 15.0);
  const vtkSmartPointer<vtkImageData> discs = gallery::MakePaint(480, 384, &Disks);
  vtkSmartPointer<vtkImplicitFlowVolumeMapper> mappers[2];
  for (int i = 0; i < 2; ++i)
  {
    gallery::Panel& panel =
      stage.AddPanel(i == 0 ? "time grows" : "dye in pulses", { -0.8, -1.0, 0.85 });
    const vtkSmartPointer<vtkVolume> volume = gallery::MakeInflowVolume(flow, discs, 0.25);
    mappers[i] = gallery::GetInflowMapper(volume);
    panel.Add(volume);
    const vtkSmartPointer<vtkActor> board =
      gallery::MakeTerminationActor(plane, gallery::MakeInflowTexture(discs, { 0.97, 0.97, 0.97 }));
    // The board faces away from the light.
    board->GetProperty()->SetAmbient(0.55);
    panel.Add(board);
    AddPost(panel, 0.0, end);
    panel.SetAmbientOcclusion(0.0);
    panel.Frame(vtkBoundingBox(BEGIN, end, -1.9, 1.9, 0.0, 2.7));
  }
  mappers[0]->SetTimeGate(MakeGate({ { { -0.01, 0.0 } }, { { 0.01, 1.0 } } }));
  mappers[0]->TimeGateRepeatOff();
  mappers[1]->SetTimeGate(MakeGate({ { { 0.0, 0.0 } }, { { 0.2, 1.0 } }, { { 0.4, 0.0 } },
    { { 1.0, 0.0 } }, { { 1.2, 1.0 } }, { { 1.4, 0.0 } } }));
  mappers[1]->TimeGateRepeatOff();
  mappers[1]->SetTimePeriod(duration / pulses);
  const auto setFraction = [mappers](double fraction)
  {
    mappers[0]->SetTimePhase(duration * fraction);
    mappers[1]->SetTimePhase(pulses * fraction);
  };
  setFraction(stillFraction);
  stage.SetAnimation(
    [mappers, setFraction](double fraction)
    {
      setFraction(fraction);
      // Animation frames are supersampled, so coarser image sampling is sufficient.
      mappers[0]->SetImageSampleDistance(2.0);
      mappers[1]->SetImageSampleDistance(2.0);
    });
}

const gallery::SceneRegistration registration(
  { "flow-post", "4.12", "Liquid oxygen around a post, with three time surfaces",
    "Computed flow past a post on a plate, from the left. The flow carries a grid of squares from "
    "an upright rectangle in front of the post; the three surfaces show it after 0.8, 2.6 and 4.2 "
    "units of time. At the plate the velocity is zero, so the surfaces lag behind there. The post "
    "stretches them, and they pass it on both sides.",
    { "post.vts" }, &Build });
const gallery::SceneRegistration inflow(
  { "inflow-post", "4.18", "Paint on the inflow of liquid oxygen that flows past a post",
    "The same flow with disks painted on a rectangle in front of the post. Each point of the "
    "volume has the color at the inflow point of its streamline. On the left the dye advances from "
    "the time of its release; on the right it is released in pulses. From frame to frame of the "
    "animation only the phase changes.",
    { "post.vts" }, &BuildInflow });
}
