// SPDX-License-Identifier: BSD-3-Clause
// Text that is painted on the inflow and advected through the volume.

#include "Gallery/Look.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Flow/FlowScene.h"
#include "Gallery/Scenes/Flow/InflowPaint.h"
#include "Gallery/Stage.h"

#include "vtkImplicitFlowVolumeMapper.h"
#include "vtkNew.h"

#include <cmath>

namespace
{
/// Returns the flow of air that rises from a square, rotates and converges.
vtkSmartPointer<vtkDataSet> MakeUpdraft(vtkTerminationPlane* plane, int n)
{
  const vtkSmartPointer<vtkAnalyticFlowSource> updraft = gallery::MakeAnalyticFlow(
    vtkAnalyticFlowSource::NODE, { { 9, 9, 9 }, { -1.1, 1.1, -1.1, 1.1, 0.3, 2.0 } });
  updraft->SetNodeRates(-0.15, -0.15, 0.3);
  updraft->SetSwirl(0.32);
  return gallery::MakeImplicitFlow(
    updraft, { plane }, { { n, n, n }, { -0.85, 0.85, -0.85, 0.85, 0.4, 1.8 } });
}

vtkSmartPointer<vtkTerminationPlane> MakePlane()
{
  return gallery::MakeInflowPlane({ 0.0, 0.0, 0.4 }, { 0.85, 0.0, 0.0 }, { 0.0, 0.85, 0.0 });
}

void Show(gallery::Stage& stage, vtkImageData* image, const vtkColor3d& ground)
{
  const vtkSmartPointer<vtkTerminationPlane> plane = MakePlane();
  gallery::Panel& panel = stage.AddPanel("", { -0.12, -1.0, 0.75 });
  panel.Add(gallery::MakeInflowVolume(MakeUpdraft(plane, 65), image, 0.05));
  panel.Add(gallery::MakeTerminationActor(plane, gallery::MakeInflowTexture(image, ground)));
}

/// Paints letters with thin strokes on the inflow.
void BuildPainted(gallery::Stage& stage)
{
  const vtkSmartPointer<vtkImageData> image =
    gallery::MakePaint(512, 512, [](double, double) { return gallery::Paint{}; });
  gallery::WriteText(image, "vis", gallery::IntervalColor(0), 0.3, 0.36, 0.68);
  gallery::WriteText(image, "2004", gallery::IntervalColor(1), 0.3, 0.32, 0.32);
  Show(stage, image, { 0.97, 0.97, 0.97 });
}

/// Returns the paint of a sign with rings and rays.
gallery::Paint Sign(double u, double v)
{
  const double r = 2.0 * std::hypot(u - 0.5, v - 0.5);
  const double turns = std::atan2(v - 0.5, u - 0.5) / 6.283185307179586;
  const double ray = 12.0 * turns - std::floor(12.0 * turns);
  if (r < 0.2)
  {
    return { gallery::IntervalColor(1), 0.35 };
  }
  if (r > 0.32 && r < 0.58)
  {
    return { ray < 0.5 ? gallery::IntervalColor(2) : gallery::IntervalColor(0),
      ray < 0.5 ? 0.12 : 0.04 };
  }
  if (r > 0.72 && r < 0.8)
  {
    return { gallery::IntervalColor(3), 0.25 };
  }
  return {};
}

void BuildImage(gallery::Stage& stage)
{
  Show(stage, gallery::MakePaint(512, 512, &Sign), { 0.97, 0.97, 0.97 });
}

/// Paints colored blobs, small dots released in pulses, and both combined.
void BuildDual(gallery::Stage& stage)
{
  const vtkSmartPointer<vtkImageData> broad = gallery::MakePaint(256, 256,
    [](double u, double v)
    {
      const double a = std::hypot(u - 0.36, v - 0.4) / 0.2;
      const double b = std::hypot(u - 0.65, v - 0.62) / 0.18;
      const double one = std::exp(-a * a);
      const double two = std::exp(-b * b);
      const double fraction = one / (one + two + 1e-9);
      gallery::Paint paint;
      for (int c = 0; c < 3; ++c)
      {
        paint.Color[c] =
          fraction * gallery::IntervalColor(0)[c] + (1.0 - fraction) * gallery::IntervalColor(1)[c];
      }
      paint.Opacity = 0.08 * std::max(one, two);
      return paint;
    });
  const vtkSmartPointer<vtkImageData> dots = gallery::MakePaint(512, 512,
    [](double u, double v)
    {
      const double x = 14.0 * u - std::floor(14.0 * u) - 0.5;
      const double y = 14.0 * v - std::floor(14.0 * v) - 0.5;
      const double r = std::hypot(u - 0.5, v - 0.5);
      return gallery::Paint{ gallery::Ink(), r < 0.45 && std::hypot(x, y) < 0.22 ? 0.5 : 0.0 };
    });
  const vtkSmartPointer<vtkImageData> transparent =
    gallery::MakePaint(2, 2, [](double, double) { return gallery::Paint{}; });
  const vtkSmartPointer<vtkTerminationPlane> plane = MakePlane();
  const vtkSmartPointer<vtkDataSet> flow = MakeUpdraft(plane, 65);
  vtkNew<vtkPiecewiseFunction> gate;
  gate->AddPoint(0.0, 0.0);
  gate->AddPoint(0.25, 1.0);
  gate->AddPoint(0.5, 0.0);
  gate->AddPoint(1.0, 0.0);
  const char* captions[] = { "inflow", "detail", "both" };
  for (int i = 0; i < 3; ++i)
  {
    gallery::Panel& panel = stage.AddPanel(captions[i], { -0.12, -1.0, 0.75 });
    const vtkSmartPointer<vtkVolume> volume =
      gallery::MakeInflowVolume(flow, i == 1 ? transparent : broad, 0.05);
    if (i > 0)
    {
      vtkImplicitFlowVolumeMapper* mapper = gallery::GetInflowMapper(volume);
      mapper->SetDetailTexture(dots);
      mapper->SetDetailModeToOver();
      mapper->SetTimeGate(gate);
      mapper->SetTimeGateTargetToDetail();
      mapper->SetTimePeriod(0.8);
    }
    panel.Add(volume);
    panel.Add(gallery::MakeTerminationActor(
      plane, gallery::MakeInflowTexture(i == 1 ? dots : broad, { 0.97, 0.97, 0.97 })));
  }
}

const gallery::SceneRegistration painted(
  { "inflow-painted", "4.15", "Painted text, advected through the volume",
    "Air rises from a square, rotates and converges. Text is painted on the square. Each point of "
    "the volume has the color at the inflow point of its streamline.",
    {}, &BuildPainted });
const gallery::SceneRegistration image({ "inflow-image", "4.16", "An image as inflow texture",
  "The same flow with a sign as color and opacity of the inflow. The dissertation shows the logo "
  "of a conference.",
  {}, &BuildImage });
const gallery::SceneRegistration dual(
  { "inflow-dual", "4.18", "Two inflow textures, the second in pulses",
    "A broad inflow texture, small dots that are released in pulses of the advection time, and "
    "both combined.",
    {}, &BuildDual });
}
