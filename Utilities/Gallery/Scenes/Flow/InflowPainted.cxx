// SPDX-License-Identifier: BSD-3-Clause
// Text and images on the inflow, advected through the volume.

#include "Gallery/Look.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Flow/FlowScene.h"
#include "Gallery/Scenes/Flow/InflowPaint.h"
#include "Gallery/Stage.h"
#include "Support/Inputs/DataFiles.h"

#include "vtkImageGaussianSmooth.h"
#include "vtkImageResize.h"
#include "vtkImplicitFlowVolumeMapper.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkTerminationSphere.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
/// Returns the flow of air that rises from a square, rotates and converges.
vtkSmartPointer<vtkDataSet> MakeUpdraft(vtkTerminationSurface* inflow,
  const gallery::FlowGrid& samples, double time = std::numeric_limits<double>::max())
{
  const vtkSmartPointer<vtkAnalyticFlowSource> updraft = gallery::MakeAnalyticFlow(
    vtkAnalyticFlowSource::NODE, { { 9, 9, 9 }, { -1.1, 1.1, -1.1, 1.1, 0.3, 2.2 } });
  updraft->SetNodeRates(-0.15, -0.15, 0.3);
  updraft->SetSwirl(0.32);
  return gallery::MakeImplicitFlow(updraft, { inflow }, samples, time);
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
  gallery::Panel& panel = stage.AddPanel("", { -0.1, -1.0, 0.85 });
  const vtkSmartPointer<vtkVolume> volume = gallery::MakeInflowVolume(
    MakeUpdraft(plane, { { 109, 73, 81 }, { -0.9, 0.9, -0.6, 0.6, 0.4, 1.5 } }), image, 0.03);
  vtkImplicitFlowVolumeMapper* mapper = gallery::GetInflowMapper(volume);
  mapper->SetTimeGate(MakePulses(0.04, 0.0));
  mapper->SetTimePeriod(2.0);
  mapper->SetTimePhase(0.04);
  panel.Add(volume);
  panel.Add(
    gallery::MakeTerminationActor(plane, gallery::MakeInflowTexture(image, { 0.97, 0.97, 0.97 })));
  panel.Frame(vtkBoundingBox(-0.86, 0.86, -0.46, 0.46, 0.4, 1.4));
}

/// Returns component \a c of the pixel at (u, v).
double GetPixel(vtkImageData* image, double u, double v, int c)
{
  int size[3];
  image->GetDimensions(size);
  return image->GetScalarComponentAsDouble(
    static_cast<int>(u * (size[0] - 1) + 0.5), static_cast<int>(v * (size[1] - 1) + 0.5), 0, c);
}

/// Returns the colors of a map of the Earth, smoothed, with higher opacity for land than for water.
vtkSmartPointer<vtkImageData> MakeMap(vtkImageData* earth)
{
  constexpr int enlargement = 2;
  const int* size = earth->GetDimensions();
  vtkNew<vtkImageResize> large;
  large->SetInputData(earth);
  large->SetOutputDimensions(enlargement * size[0], enlargement * size[1], 1);
  vtkNew<vtkImageGaussianSmooth> smooth;
  smooth->SetInputConnection(large->GetOutputPort());
  smooth->SetDimensionality(2);
  smooth->SetStandardDeviation(1.2 * enlargement);
  smooth->Update();
  vtkImageData* colors = smooth->GetOutput();
  return gallery::MakePaint(colors->GetDimensions()[0], colors->GetDimensions()[1],
    [colors](double u, double v)
    {
      gallery::Paint paint;
      for (int c = 0; c < 3; ++c)
      {
        paint.Color[c] = GetPixel(colors, u, v, c) / 255.0;
      }
      const double ratio = (paint.Color[0] + 0.01) / (paint.Color[2] + 0.01);
      const double land = vtkMath::ClampValue(3.0 * (ratio - 0.6), 0.0, 1.0);
      // Gray land would look like holes in the map.
      paint.Color[2] *= 1.0 - 0.7 * land;
      paint.Opacity = 0.1 + 0.6 * land;
      return paint;
    });
}

/// Returns a map whose opacity decreases toward the edge of the wake, where the \a globe is
/// parallel to the wind.
vtkSmartPointer<vtkImageData> FadeEdge(vtkImageData* map, vtkTerminationSphere* globe)
{
  return gallery::MakePaint(map->GetDimensions()[0], map->GetDimensions()[1],
    [map, globe](double u, double v)
    {
      const double uv[2] = { u, v };
      double point[3];
      globe->EvaluatePoint(0, uv, point);
      const double lee = (point[2] - globe->GetCenter()[2]) / globe->GetRadius();
      return gallery::Paint{ { GetPixel(map, u, v, 0), GetPixel(map, u, v, 1),
                               GetPixel(map, u, v, 2) },
        GetPixel(map, u, v, 3) * vtkMath::ClampValue(1.8 * lee - 0.5, 0.0, 1.0) };
    });
}

/// Returns the globe, or a smaller sphere inside it.
vtkSmartPointer<vtkTerminationSphere> MakeGlobe(double radius)
{
  auto globe = vtkSmartPointer<vtkTerminationSphere>::New();
  globe->SetCenter(0.0, 0.0, 0.8);
  globe->SetRadius(radius);
  globe->SetAxis(0.93, -0.3, -0.2);
  return globe;
}

/// Shows a globe whose colors the wind carries away, along z.
void BuildImage(gallery::Stage& stage)
{
  constexpr double time = 2.0;
  constexpr double radius = 0.36;
  const vtkSmartPointer<vtkImageData> earth =
    vtkImageData::SafeDownCast(interlume::ReadData("earth.vti"));
  // The dye starts inside the globe, which hides the cells that straddle the inflow.
  const vtkSmartPointer<vtkTerminationSphere> globe = MakeGlobe(radius);
  const vtkSmartPointer<vtkTerminationSphere> inflow = MakeGlobe(radius - 0.02);
  const vtkSmartPointer<vtkDataSet> flow =
    MakeUpdraft(inflow, { { 73, 73, 81 }, { -0.4, 0.4, -0.4, 0.4, 0.7, 2.1 } }, 1.1 * time);
  vtkNew<vtkPiecewiseFunction> fading;
  fading->AddPoint(0.0, 0.0);
  fading->AddPoint(0.5, 0.6);
  fading->AddPoint(1.0, 1.0);

  gallery::Panel& panel = stage.AddPanel("", { 0.2, 1.0, 0.1 }, { 1.0, 0.0, 0.0 });
  panel.SetBackground(gallery::DarkBackground());
  const vtkSmartPointer<vtkImageData> map = MakeMap(earth);
  const vtkSmartPointer<vtkVolume> volume =
    gallery::MakeInflowVolume(flow, FadeEdge(map, inflow), 0.05);
  vtkImplicitFlowVolumeMapper* mapper = gallery::GetInflowMapper(volume);
  mapper->SetTimeGate(fading);
  mapper->TimeGateRepeatOff();
  mapper->SetTimePeriod(time);
  mapper->SetTimePhase(1.0);
  panel.Add(volume);
  panel.Add(
    gallery::MakeTerminationActor(globe, gallery::MakeInflowTexture(map, { 0.04, 0.12, 0.25 })));
  panel.Frame(vtkBoundingBox(-0.38, 0.38, -0.1, 0.1, 0.43, 1.8));
}

/// Adds panels of colored blobs, of small dots released in pulses, and of both combined.
void BuildDual(gallery::Stage& stage)
{
  const auto blobs = [](double u, double v)
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
  };
  const auto spots = [](double u, double v)
  {
    const double x = 3.0 * u - std::floor(3.0 * u) - 0.5;
    const double y = 3.0 * v - std::floor(3.0 * v) - 0.5;
    const double inside = 0.5 + 30.0 * (0.24 - std::hypot(x, y));
    return gallery::Paint{ gallery::IntervalColor(3), 0.6 * vtkMath::ClampValue(inside, 0.0, 1.0) };
  };
  const auto combined = [blobs, spots](double u, double v)
  {
    const gallery::Paint spot = spots(u, v);
    return spot.Opacity > 0.0 ? spot : blobs(u, v);
  };
  const vtkSmartPointer<vtkImageData> broad = gallery::MakePaint(256, 256, blobs);
  const vtkSmartPointer<vtkImageData> dots = gallery::MakePaint(512, 512, spots);
  const vtkSmartPointer<vtkImageData> grounds[] = { broad, dots,
    gallery::MakePaint(512, 512, combined) };
  const vtkSmartPointer<vtkImageData> transparent =
    gallery::MakePaint(2, 2, [](double, double) { return gallery::Paint{}; });
  const vtkSmartPointer<vtkTerminationPlane> plane = MakePlane(0.45, 0.45);
  const vtkSmartPointer<vtkDataSet> flow =
    MakeUpdraft(plane, { { 49, 49, 77 }, { -0.45, 0.45, -0.45, 0.45, 0.4, 1.75 } });
  const char* captions[] = { "inflow", "detail", "both" };
  for (int i = 0; i < 3; ++i)
  {
    gallery::Panel& panel = stage.AddPanel(captions[i], { -0.12, -1.0, 0.6 });
    const vtkSmartPointer<vtkVolume> volume =
      gallery::MakeInflowVolume(flow, i == 1 ? transparent : broad, 0.05);
    if (i > 0)
    {
      vtkImplicitFlowVolumeMapper* mapper = gallery::GetInflowMapper(volume);
      mapper->SetDetailTexture(dots);
      mapper->SetDetailModeToOver();
      mapper->SetTimeGate(MakePulses(0.1, 0.0));
      mapper->SetTimeGateTargetToDetail();
      mapper->SetTimePeriod(1.25);
    }
    panel.Add(volume);
    panel.Add(gallery::MakeTerminationActor(
      plane, gallery::MakeInflowTexture(grounds[i], { 0.97, 0.97, 0.97 })));
    panel.SetAmbientOcclusion(0.0);
    panel.Frame(vtkBoundingBox(-0.41, 0.41, -0.41, 0.41, 0.38, 1.7));
  }
}

const gallery::SceneRegistration painted(
  { "inflow-painted", "4.15", "Painted text, advected through the volume",
    "Air rises from a rectangle, rotates and converges. A word is painted on the rectangle. Each "
    "point of the volume has the color at the inflow point of its streamline. The dye is released "
    "in pulses, which show how the flow turns and narrows the word.",
    {}, &BuildPainted });
const gallery::SceneRegistration image({ "inflow-image", "4.16", "An image as inflow texture",
  "Wind blows over a globe from the left, turns and converges. The inflow has the colors of an "
  "imported map of the Earth, and the wake carries them away: streaks of land are dense, those of "
  "water thin. The dissertation shows the logo of a conference.",
  { "earth.vti" }, &BuildImage });
const gallery::SceneRegistration dual(
  { "inflow-dual", "4.18", "Two inflow textures, the second in pulses",
    "Air rises from a square. A broad inflow texture, dots that are released in pulses of "
    "the advection time, and both combined.",
    {}, &BuildDual });
}
