// SPDX-License-Identifier: BSD-3-Clause
// Liquid oxygen that parts around a post on a plate, with textured time surfaces, and with paint on
// its inflow that moves.

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
#include "vtkStructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace
{
constexpr double RADIUS = 0.5;
constexpr double HEIGHT = 3.0;

/// Of what is shown, around the post, whose axis is z: where it begins and ends along the flow, and
/// half its width.
constexpr double BEGIN = -2.4;
constexpr double END = 3.1;
constexpr double WIDTH = 1.9;

/// Points on lines from the post to the sides of a box, nearer to each other at the post and at the
/// plate.
vtkSmartPointer<vtkStructuredGrid> MakeSamples()
{
  constexpr int outward = 37;
  constexpr int around = 113;
  constexpr int upward = 33;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int k = 0; k < upward; ++k)
  {
    const double height = HEIGHT * std::pow((k + 0.3) / (upward - 0.7), 1.5);
    for (int j = 0; j < around; ++j)
    {
      const double angle = 2.0 * vtkMath::Pi() * (j % (around - 1)) / (around - 1);
      const double x = std::cos(angle);
      const double y = std::sin(angle);
      const double side = std::min((x < 0.0 ? BEGIN : END) / x, WIDTH / std::abs(y));
      for (int i = 0; i < outward; ++i)
      {
        const double share = std::pow(static_cast<double>(i) / (outward - 1), 1.5);
        const double radius = (1.0 - share) * 1.01 * RADIUS + share * side;
        points->InsertNextPoint(radius * x, radius * y, height);
      }
    }
  }
  auto samples = vtkSmartPointer<vtkStructuredGrid>::New();
  samples->SetDimensions(outward, around, upward);
  samples->SetPoints(points);
  return samples;
}

/// The grid closes around the post; hexahedra of shared points let the flow pass where it does.
vtkSmartPointer<vtkAppendFilter> ReadFlow()
{
  vtkSmartPointer<vtkDataSet> post = interlume::ReadData("post.vts");
  auto joined = vtkSmartPointer<vtkAppendFilter>::New();
  joined->AddInputData(post);
  joined->MergePointsOn();
  return joined;
}

/// The rectangle in front of the post, half as wide as told.
vtkSmartPointer<vtkTerminationPlane> MakeInflow(double width)
{
  return gallery::MakeInflowPlane(
    { BEGIN, 0.0, 0.5 * HEIGHT }, { 0.0, width, 0.0 }, { 0.0, 0.0, 0.5 * HEIGHT });
}

void AddPost(gallery::Panel& panel)
{
  panel.Add(gallery::MakePillar(RADIUS, 0.0, 1.1 * HEIGHT, gallery::Pencil()));
  vtkNew<vtkPlaneSource> plate;
  plate->SetOrigin(-2.9, -2.2, 0.0);
  plate->SetPoint1(3.3, -2.2, 0.0);
  plate->SetPoint2(-2.9, 2.2, 0.0);
  plate->Update();
  panel.Add(gallery::MakeActor(plate->GetOutput(), gallery::Pencil()));
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
  panel.Add(gallery::MakeVolumeOfIntervals(tetrahedra, { { gallery::IntervalColour(0), 0.25 } }));
  for (int id = 0; id < 3; ++id)
  {
    panel.Add(
      gallery::MakeFlowActor(gallery::GetFlowSurface(filter, gallery::TIME_SURFACES, id + 1),
        gallery::MakeGridTexture(32, 16, gallery::IntervalColour(1 + id), gallery::Ink())));
  }
  AddPost(panel);
}

/// Discs in rows, each row of one colour.
gallery::Paint Discs(double u, double v)
{
  const double across = 8.0 * u;
  const double up = 6.0 * v;
  const double r = std::hypot(across - std::floor(across) - 0.5, up - std::floor(up) - 0.5);
  const int row = static_cast<int>(std::min(up, 5.0));
  return { gallery::IntervalColour(row % 4), r < 0.34 ? 0.5 : 0.0 };
}

/// A gate by a function of the time when paint was put in.
vtkSmartPointer<vtkPiecewiseFunction> MakeGate(const std::vector<std::array<double, 2>>& points)
{
  auto gate = vtkSmartPointer<vtkPiecewiseFunction>::New();
  for (const std::array<double, 2>& point : points)
  {
    gate->AddPoint(point[0], point[1]);
  }
  return gate;
}

/// Paint that is put in from a time on, and paint in pulses, at a part of their animation.
void BuildInflow(gallery::Stage& stage)
{
  // What the liquid takes to pass through the box, and the pulses in that time.
  constexpr double duration = 4.2;
  constexpr int pulses = 4;
  constexpr double still = 0.7;
  const vtkSmartPointer<vtkTerminationPlane> plane = MakeInflow(WIDTH);
  const vtkSmartPointer<vtkDataSet> flow = gallery::MakeImplicitFlow(
    ReadFlow(), { plane }, { { 89, 61, 49 }, { BEGIN, END, -WIDTH, WIDTH, 0.0, HEIGHT } }, 15.0);
  const vtkSmartPointer<vtkImageData> discs = gallery::MakePaint(480, 384, &Discs);
  vtkSmartPointer<vtkImplicitFlowVolumeMapper> mappers[2];
  for (int i = 0; i < 2; ++i)
  {
    gallery::Panel& panel =
      stage.AddPanel(i == 0 ? "time grows" : "dye in pulses", { -0.55, -1.0, 0.6 });
    const vtkSmartPointer<vtkVolume> volume = gallery::MakeInflowVolume(flow, discs, 0.15);
    mappers[i] = gallery::GetInflowMapper(volume);
    panel.Add(volume);
    panel.Add(gallery::MakeTerminationActor(
      plane, gallery::MakeInflowTexture(discs, { 0.97, 0.97, 0.97 })));
    AddPost(panel);
  }
  mappers[0]->SetTimeGate(MakeGate({ { { -0.01, 0.0 } }, { { 0.01, 1.0 } } }));
  mappers[0]->TimeGateRepeatOff();
  mappers[1]->SetTimeGate(
    MakeGate({ { { 0.0, 0.0 } }, { { 0.2, 1.0 } }, { { 0.4, 0.0 } }, { { 1.0, 0.0 } } }));
  mappers[1]->SetTimePeriod(duration / pulses);
  const auto setPart = [mappers](double part)
  {
    mappers[0]->SetTimePhase(duration * part);
    mappers[1]->SetTimePhase(pulses * part);
  };
  setPart(still);
  stage.SetAnimation(
    [mappers, setPart](double part)
    {
      setPart(part);
      // Frames are averaged down from larger ones.
      mappers[0]->SetImageSampleDistance(2.0);
      mappers[1]->SetImageSampleDistance(2.0);
    });
}

const gallery::SceneRegistration registration(
  { "flow-post", "4.12", "Liquid oxygen that parts around a post, with three time surfaces",
    "Computed flow past a post on a plate, from the left. A grid of squares was laid on an upright "
    "rectangle in front of the post; the three surfaces are where the liquid has carried it after "
    "0.8, 2.6 and 4.2 units of time. At the plate it stands still, so that they lie down there; "
    "around the post they are held up and stretched, and pass it on both sides.",
    { "post.vts" }, &Build });
const gallery::SceneRegistration inflow(
  { "inflow-post", "4.18", "Paint on the inflow of liquid oxygen that flows past a post",
    "The same flow. Discs are painted on a rectangle in front of the post, and each place has the "
    "paint of where its liquid came in: as far as it has come since the paint was put in, and of "
    "pulses of paint. From frame to frame of the animation only a number changes.",
    { "post.vts" }, &BuildInflow });
}
