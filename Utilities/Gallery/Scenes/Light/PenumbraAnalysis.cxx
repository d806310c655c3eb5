// SPDX-License-Identifier: BSD-3-Clause
// Widths of penumbras: of a tilted light, exact and by the virtual light of the source, and in
// pictures.

#include "Gallery/Look.h"
#include "Gallery/Scene.h"
#include "Gallery/Stage.h"
#include "Support/Pictures/HalfPlane.h"
#include "Support/Pictures/VolumeStage.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkTubeFilter.h"
#include "vtkVectorText.h"

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace
{
using Place = std::array<double, 2>;

/// Size of the light, its distance from the occluder, the receiver's from that, the occluder's half
/// width.
constexpr double LIGHT = 1.0;
constexpr double TO_OCCLUDER = 1.6;
constexpr double TO_RECEIVER = 0.9;
constexpr double HALF_OCCLUDER = 0.55;

/// An end of the light, \a side -1 or 1, of which the occluder is at height 0.
Place GetEnd(double degrees, double side)
{
  const double angle = vtkMath::RadiansFromDegrees(degrees);
  return { { 0.5 * side * LIGHT * std::cos(angle),
    TO_OCCLUDER + 0.5 * side * LIGHT * std::sin(angle) } };
}

/// Where the ray from an end of the light over the occluder's edge meets the receiver.
double GetFoot(const Place& end, double edge)
{
  return edge + (edge - end[0]) * TO_RECEIVER / end[1];
}

double GetExactWidth(double degrees, double edge)
{
  return std::abs(GetFoot(GetEnd(degrees, -1.0), edge) - GetFoot(GetEnd(degrees, 1.0), edge));
}

/// Equation 2.14, of the orthogonal projection of the light onto the slices.
double GetVirtualWidth(double degrees)
{
  return LIGHT * std::cos(vtkMath::RadiansFromDegrees(degrees)) * TO_RECEIVER / TO_OCCLUDER;
}

/// Flat drawings in the plane of x and z.
class Drawing
{
public:
  explicit Drawing(gallery::Panel& panel)
    : Panel(panel)
  {
    panel.UseParallelProjection();
    panel.SetAmbientOcclusion(0.0);
  }

  void AddLine(const std::vector<Place>& places, const vtkColor3d& colour, double width)
  {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    cells->InsertNextCell(static_cast<int>(places.size()));
    for (const Place& place : places)
    {
      cells->InsertCellPoint(points->InsertNextPoint(place[0], 0.0, place[1]));
    }
    vtkNew<vtkPolyData> line;
    line->SetPoints(points);
    line->SetLines(cells);
    vtkNew<vtkTubeFilter> tube;
    tube->SetInputData(line);
    tube->SetRadius(0.5 * width);
    tube->SetNumberOfSides(8);
    tube->CappingOn();
    tube->Update();
    this->Add(tube->GetOutput(), colour);
  }

  void AddDashes(const Place& a, const Place& b, const vtkColor3d& colour, double width)
  {
    constexpr int count = 17;
    for (int i = 0; i < count; i += 2)
    {
      const auto at = [&](int step)
      {
        const double t = static_cast<double>(step) / count;
        return Place{ { a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]) } };
      };
      this->AddLine({ at(i), at(i + 1) }, colour, width);
    }
  }

  /// \a place is the middle of the text's lower edge, or its left end.
  void AddText(
    const std::string& words, const Place& place, double height, bool isCentred, double turn = 0.0)
  {
    vtkNew<vtkVectorText> text;
    text->SetText(words.c_str());
    text->Update();
    double bounds[6];
    text->GetOutput()->GetBounds(bounds);
    vtkNew<vtkTransform> transform;
    transform->Translate(place[0], -0.1, place[1]);
    transform->RotateX(90.0);
    transform->RotateZ(turn);
    transform->Scale(height, height, height);
    transform->Translate(isCentred ? -0.5 * (bounds[0] + bounds[1]) : -bounds[0], 0.0, 0.0);
    vtkNew<vtkTransformPolyDataFilter> filter;
    filter->SetInputConnection(text->GetOutputPort());
    filter->SetTransform(transform);
    filter->Update();
    this->Add(filter->GetOutput(), gallery::Ink());
  }

private:
  void Add(vtkPolyData* shape, const vtkColor3d& colour)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(shape);
    mapper->ScalarVisibilityOff();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
    this->Panel.Add(actor);
  }

  gallery::Panel& Panel;
};

vtkColor3d ExactColour()
{
  return gallery::IntervalColour(3);
}

vtkColor3d VirtualColour()
{
  return gallery::IntervalColour(0);
}

/// The light from the side, its rays over the occluder's edges, and the penumbras.
void DrawGeometry(gallery::Panel& panel)
{
  constexpr double degrees = 40.0;
  Drawing drawing(panel);
  const double half = 0.5 * LIGHT * std::cos(vtkMath::RadiansFromDegrees(degrees));
  for (double edge : { -HALF_OCCLUDER, HALF_OCCLUDER })
  {
    std::array<double, 2> exact;
    std::array<double, 2> computed;
    for (int side = 0; side < 2; ++side)
    {
      const Place end = GetEnd(degrees, 2.0 * side - 1.0);
      const Place virtualEnd = { { (2.0 * side - 1.0) * half, TO_OCCLUDER } };
      exact[side] = GetFoot(end, edge);
      computed[side] = GetFoot(virtualEnd, edge);
      drawing.AddLine({ end, { { exact[side], -TO_RECEIVER } } }, ExactColour(), 0.012);
      drawing.AddDashes(virtualEnd, { { computed[side], -TO_RECEIVER } }, VirtualColour(), 0.012);
    }
    drawing.AddLine(
      { { { exact[0], -TO_RECEIVER - 0.08 } }, { { exact[1], -TO_RECEIVER - 0.08 } } },
      ExactColour(), 0.07);
    drawing.AddLine(
      { { { computed[0], -TO_RECEIVER - 0.19 } }, { { computed[1], -TO_RECEIVER - 0.19 } } },
      VirtualColour(), 0.07);
  }
  drawing.AddLine({ GetEnd(degrees, -1.0), GetEnd(degrees, 1.0) }, ExactColour(), 0.07);
  drawing.AddLine({ { { -half, TO_OCCLUDER } }, { { half, TO_OCCLUDER } } }, VirtualColour(), 0.05);
  drawing.AddLine(
    { { { -HALF_OCCLUDER, 0.0 } }, { { HALF_OCCLUDER, 0.0 } } }, gallery::Ink(), 0.06);
  drawing.AddLine(
    { { { -1.45, -TO_RECEIVER } }, { { 1.45, -TO_RECEIVER } } }, gallery::Pencil(), 0.03);
  drawing.AddText("occluder", { { 0.0, -0.17 } }, 0.09, true);
  drawing.AddText("receiver", { { 0.0, -TO_RECEIVER - 0.14 } }, 0.09, true);
}

vtkColor3d SourceColour()
{
  return gallery::IntervalColour(2);
}

/// Axes of a chart from the origin to (3.4, 3), with grid lines and numbers.
void DrawAxes(Drawing& drawing, const std::vector<std::string>& across,
  const std::vector<std::string>& up, const std::array<std::string, 2>& titles)
{
  const auto colour = [](std::size_t i) { return i == 0 ? gallery::Ink() : gallery::Pencil(); };
  const auto width = [](std::size_t i) { return i == 0 ? 0.018 : 0.008; };
  for (std::size_t i = 0; i < up.size(); ++i)
  {
    const double z = 3.0 * static_cast<double>(i) / static_cast<double>(up.size() - 1);
    drawing.AddLine({ { { 0.0, z } }, { { 3.4, z } } }, colour(i), width(i));
    drawing.AddText(up[i], { { -0.21, z - 0.06 } }, 0.16, true);
  }
  for (std::size_t i = 0; i < across.size(); ++i)
  {
    const double x = 3.4 * static_cast<double>(i) / static_cast<double>(across.size() - 1);
    drawing.AddLine({ { { x, 0.0 } }, { { x, 3.0 } } }, colour(i), width(i));
    drawing.AddText(across[i], { { x, -0.26 } }, 0.16, true);
  }
  drawing.AddText(titles[0], { { 1.7, -0.58 } }, 0.16, true);
  drawing.AddText(titles[1], { { -0.5, 1.5 } }, 0.16, true, 90.0);
}

/// Widths against the angle of the light.
void DrawAngles(gallery::Panel& panel)
{
  Drawing drawing(panel);
  constexpr double largest = 0.8;
  const auto place = [](double degrees, double width) {
    return Place{ { 3.4 * degrees / 45.0, 3.0 * width / largest } };
  };
  DrawAxes(drawing, { "0", "15", "30", "45" }, { "0", "0.2", "0.4", "0.6", "0.8" },
    { { "angle of the light [degrees]", "width / size of the light" } });
  const auto plot = [&](const std::function<double(double)>& width, const vtkColor3d& colour)
  {
    std::vector<Place> places;
    for (int degrees = 0; degrees <= 45; ++degrees)
    {
      places.push_back(place(degrees, width(degrees) / LIGHT));
    }
    drawing.AddLine(places, colour, 0.035);
  };
  plot([](double degrees) { return GetExactWidth(degrees, HALF_OCCLUDER); }, ExactColour());
  plot([](double degrees) { return GetExactWidth(degrees, -HALF_OCCLUDER); }, ExactColour());
  plot(GetVirtualWidth, VirtualColour());
  drawing.AddText("right edge", place(30.0, 0.64), 0.16, true);
  drawing.AddText("left edge", place(24.0, 0.33), 0.16, true);
}

/// The penumbra of a half plane in a picture, over the exact one.
double MeasureWidth(reference::VolumeStage& stage, double ratio, int method)
{
  constexpr double exact = 0.2;
  const reference::ShadowScene scene = reference::MakeHalfPlane(ratio, exact);
  vtkNew<vtkShadowedSliceMapper> mapper;
  mapper->SetInputData(scene.Image);
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetSoftShadowMethod(method);
  mapper->SetLightBufferSize(128);
  stage.SetVolume(mapper, scene.Property);
  stage.SetLights(scene.Lights);
  stage.SetCamera(scene.Camera);
  const double width = reference::GetRampWidth(reference::GetPenumbra(stage.Capture()));
  mapper->ReleaseGraphicsResources(stage.GetWindow());
  return width / exact;
}

/// Widths in pictures, over the exact ones, against the distances' ratio from 0.05 to 5.
void DrawMeasured(gallery::Panel& panel)
{
  Drawing drawing(panel);
  constexpr double largest = 1.2;
  const auto place = [](double ratio, double width) {
    return Place{ { 1.7 * std::log10(ratio / 0.05), 3.0 * width / largest } };
  };
  DrawAxes(drawing, { "0.05", "0.5", "5" }, { "0", "0.4", "0.8", "1.2" },
    { { "receiver's distance / light's", "width / exact width" } });
  drawing.AddLine({ place(0.05, 1.0), place(5.0, 1.0) }, ExactColour(), 0.035);
  reference::VolumeStage stage(reference::MakeHalfPlane(1.0, 0.2).Size);
  const std::vector<std::pair<int, vtkColor3d>> methods = {
    { vtkShadowedSliceMapper::ACCUMULATED_CONVOLUTION, SourceColour() },
    { vtkShadowedSliceMapper::SAMPLE_LAYERS, gallery::Ink() }
  };
  for (const auto& method : methods)
  {
    std::vector<Place> places;
    for (const double ratio : { 0.05, 0.16, 0.5, 1.6, 5.0 })
    {
      places.push_back(place(ratio, MeasureWidth(stage, ratio, method.first)));
      const Place& at = places.back();
      drawing.AddLine(
        { { { at[0] - 0.045, at[1] } }, { { at[0] + 0.045, at[1] } } }, method.second, 0.09);
    }
    drawing.AddLine(places, method.second, 0.02);
  }
}

void Build(gallery::Stage& stage)
{
  DrawGeometry(stage.AddPanel("a light at 40 degrees to the slices"));
  DrawAngles(stage.AddPanel("penumbras of both edges"));
  DrawMeasured(stage.AddPanel("in pictures of a half plane"));
  stage.SetColourKey("",
    { { ExactColour(), "exact" }, { VirtualColour(), "virtual light, equation 2.14" },
      { gallery::Ink(), "default method" }, { SourceColour(), "accumulated convolution" } });
}

const gallery::SceneRegistration registration({ "penumbra-analysis", "2.32",
  "Penumbras, exact, of a virtual light, and in pictures",
  "The source puts a virtual light that is parallel to the slices in place of a tilted one, so "
  "that both edges of an occluder get penumbras of the same width. The exact ones differ: at 45 "
  "degrees, here, one is 41 % wider than that and the other 31 % narrower. Samples of the light "
  "itself have no such error. At the right, widths measured in pictures of a half plane: those of "
  "the default are within 5 % of the exact ones, while convolutions of one buffer, slice by slice, "
  "add up to too little.",
  {}, &Build });
}
