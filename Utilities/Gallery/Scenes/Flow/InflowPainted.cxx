// SPDX-License-Identifier: BSD-3-Clause
// Text and images on the inflow, advected through the volume.

#include "Gallery/Look.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Flow/FlowScene.h"
#include "Gallery/Scenes/Flow/InflowPaint.h"
#include "Gallery/Stage.h"
#include "Support/Inputs/DataFiles.h"

#include "vtkImplicitFlowVolumeMapper.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkTerminationSphere.h"

#include <algorithm>
#include <cmath>

namespace
{
/// Returns the flow of air that rises from a square, rotates and converges.
vtkSmartPointer<vtkDataSet> MakeUpdraft(
  vtkTerminationPlane* plane, const gallery::FlowGrid& samples)
{
  const vtkSmartPointer<vtkAnalyticFlowSource> updraft = gallery::MakeAnalyticFlow(
    vtkAnalyticFlowSource::NODE, { { 9, 9, 9 }, { -1.1, 1.1, -1.1, 1.1, 0.3, 2.2 } });
  updraft->SetNodeRates(-0.15, -0.15, 0.3);
  updraft->SetSwirl(0.32);
  return gallery::MakeImplicitFlow(updraft, { plane }, samples);
}

/// Returns a rectangle at the bottom of the updraft. \a width and \a depth are half its edge
/// lengths.
vtkSmartPointer<vtkTerminationPlane> MakePlane(double width, double depth)
{
  return gallery::MakeInflowPlane({ 0.0, 0.0, 0.4 }, { width, 0.0, 0.0 }, { 0.0, depth, 0.0 });
}

/// Returns a time gate with a pulse at the start of each period. \a half is half the length of the
/// pulse as a fraction of the period, and \a low is the opacity between pulses.
vtkSmartPointer<vtkPiecewiseFunction> MakePulses(double half, double low)
{
  auto gate = vtkSmartPointer<vtkPiecewiseFunction>::New();
  gate->AddPoint(0.0, low);
  gate->AddPoint(half, 1.0);
  gate->AddPoint(2.0 * half, low);
  gate->AddPoint(1.0, low);
  return gate;
}

/// Paints a word on the inflow plane. Pulses of dense dye carry copies of the word upward.
void BuildPainted(gallery::Stage& stage)
{
  const vtkSmartPointer<vtkImageData> image =
    gallery::MakePaint(768, 384, [](double, double) { return gallery::Paint{}; });
  gallery::DrawTextLine(image, "flow", gallery::IntervalColor(0), 0.9, 0.75);
  const vtkSmartPointer<vtkTerminationPlane> plane = MakePlane(0.9, 0.45);
  gallery::Panel& panel = stage.AddPanel("", { -0.1, -1.0, 1.0 });
  const vtkSmartPointer<vtkVolume> volume = gallery::MakeInflowVolume(
    MakeUpdraft(plane, { { 97, 65, 57 }, { -0.9, 0.9, -0.6, 0.6, 0.4, 1.2 } }), image, 0.05);
  vtkImplicitFlowVolumeMapper* mapper = gallery::GetInflowMapper(volume);
  mapper->SetTimeGate(MakePulses(0.07, 0.03));
  mapper->SetTimePeriod(1.6);
  mapper->SetTimePhase(0.07);
  panel.Add(volume);
  panel.Add(
    gallery::MakeTerminationActor(plane, gallery::MakeInflowTexture(image, { 0.97, 0.97, 0.97 })));
  panel.Frame(vtkBoundingBox(-0.86, 0.86, -0.46, 0.46, 0.4, 1.15));
}

/// Returns the colors of a map of the Earth, with higher opacity for land than for water.
vtkSmartPointer<vtkImageData> MakeMapPaint(vtkImageData* earth)
{
  int size[3];
  earth->GetDimensions(size);
  return gallery::MakePaint(size[0], size[1],
    [earth, &size](double u, double v)
    {
      const int x = static_cast<int>(u * (size[0] - 1) + 0.5);
      const int y = static_cast<int>(v * (size[1] - 1) + 0.5);
      double color[3];
      for (int c = 0; c < 3; ++c)
      {
        color[c] = earth->GetScalarComponentAsDouble(x, y, 0, c) / 255.0;
      }
      return gallery::Paint{ vtkColor3d(color), color[0] > 0.9 * color[2] ? 0.7 : 0.25 };
    });
}

/// Shows a globe whose colors the wind carries away.
void BuildImage(gallery::Stage& stage)
{
  constexpr double time = 1.6;
  constexpr double radius = 0.5;
  const vtkSmartPointer<vtkImageData> earth =
    vtkImageData::SafeDownCast(interlume::ReadData("earth.vti"));
  const vtkSmartPointer<vtkAnalyticFlowSource> wind = gallery::MakeAnalyticFlow(
    vtkAnalyticFlowSource::UNIFORM, { { 9, 9, 9 }, { -0.7, 2.3, -0.7, 0.7, -0.7, 0.7 } });
  wind->SetVelocity(1.0, 0.0, 0.0);
  vtkNew<vtkTerminationSphere> globe;
  globe->SetRadius(radius);
  globe->SetAxis(-0.2, -0.3, 0.93);
  const vtkSmartPointer<vtkDataSet> flow = gallery::MakeImplicitFlow(
    wind, { globe }, { { 57, 73, 73 }, { -0.1, 2.2, -0.54, 0.54, -0.54, 0.54 } }, 1.1 * time);
  vtkNew<vtkPiecewiseFunction> fading;
  fading->AddPoint(0.0, 0.0);
  fading->AddPoint(0.5, 0.6);
  fading->AddPoint(1.0, 1.0);

  gallery::Panel& panel = stage.AddPanel("", { 0.1, -1.0, 0.2 });
  panel.SetBackground(gallery::DarkBackground());
  const vtkSmartPointer<vtkVolume> volume =
    gallery::MakeInflowVolume(flow, MakeMapPaint(earth), 0.05);
  vtkImplicitFlowVolumeMapper* mapper = gallery::GetInflowMapper(volume);
  mapper->SetTimeGate(fading);
  mapper->TimeGateRepeatOff();
  mapper->SetTimePeriod(time);
  mapper->SetTimePhase(1.0);
  panel.Add(volume);
  vtkNew<vtkTexture> map;
  map->SetInputData(earth);
  map->InterpolateOn();
  panel.Add(gallery::MakeTerminationActor(globe, map));
  panel.Frame(vtkBoundingBox(-0.52, 1.95, -0.1, 0.1, -0.55, 0.55));
}

/// Adds panels of colored blobs, of small dots released in pulses, and of both combined.
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
      paint.Opacity = 0.25 * std::max(one, two);
      return paint;
    });
  const vtkSmartPointer<vtkImageData> dots = gallery::MakePaint(512, 512,
    [](double u, double v)
    {
      const double x = 7.0 * u - std::floor(7.0 * u) - 0.5;
      const double y = 7.0 * v - std::floor(7.0 * v) - 0.5;
      const double r = std::hypot(u - 0.5, v - 0.5);
      return gallery::Paint{ gallery::TextColor(),
        r < 0.45 && std::hypot(x, y) < 0.22 ? 0.5 : 0.0 };
    });
  const vtkSmartPointer<vtkImageData> transparent =
    gallery::MakePaint(2, 2, [](double, double) { return gallery::Paint{}; });
  const vtkSmartPointer<vtkTerminationPlane> plane = MakePlane(0.45, 0.45);
  const vtkSmartPointer<vtkDataSet> flow =
    MakeUpdraft(plane, { { 49, 49, 67 }, { -0.45, 0.45, -0.45, 0.45, 0.4, 1.6 } });
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
      mapper->SetTimeGate(MakePulses(0.25, 0.0));
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
    "Air rises from a rectangle, rotates and converges. A word is painted on the rectangle. Each "
    "point of the volume has the color at the inflow point of its streamline. The dye is dense in "
    "pulses, which show how the flow turns and narrows the word.",
    {}, &BuildPainted });
const gallery::SceneRegistration image({ "inflow-image", "4.16", "An image as inflow texture",
  "Wind blows over a globe from the left. The inflow has the colors of an imported map of the "
  "Earth, and the wake carries them away: streaks of land are dense, those of water thin. The "
  "dissertation shows the logo of a conference.",
  { "earth.vti" }, &BuildImage });
const gallery::SceneRegistration dual(
  { "inflow-dual", "4.18", "Two inflow textures, the second in pulses",
    "Air rises from a square. A broad inflow texture, small dots that are released in pulses of "
    "the advection time, and both combined.",
    {}, &BuildDual });
}
