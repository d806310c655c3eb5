// SPDX-License-Identifier: BSD-3-Clause
#include "PainterWindow.h"

#include "PaintStyle.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkCoordinate.h>
#include <vtkImageData.h>
#include <vtkImageProperty.h>
#include <vtkImageSlice.h>
#include <vtkImageSliceMapper.h>
#include <vtkImplicitFlowVolumeMapper.h>
#include <vtkMath.h>
#include <vtkOutlineFilter.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkSliderRepresentation2D.h>
#include <vtkSliderWidget.h>
#include <vtkTerminationSurface.h>
#include <vtkTerminationSurfaceSource.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkTexture.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace
{
constexpr int WindowWidth = 1200;
constexpr int WindowHeight = 600;
/// Position of the divider between the page and the flow view, as a fraction of the window width.
constexpr double Border = 0.46;
constexpr double Ink[3] = { 0.2, 0.22, 0.26 };
constexpr double SmallestBrush = 1.0;
constexpr double LargestBrush = 60.0;

double GetValue(vtkSliderWidget* slider)
{
  return static_cast<vtkSliderRepresentation*>(slider->GetRepresentation())->GetValue();
}

void SetValue(vtkSliderWidget* slider, double value)
{
  static_cast<vtkSliderRepresentation*>(slider->GetRepresentation())->SetValue(value);
}
}

PainterWindow::PainterWindow(
  vtkImageData* flow, vtkTerminationSurface* surface, int columns, int rows)
  : Canvas(columns, rows)
{
  this->Left->SetViewport(0.0, 0.0, Border, 1.0);
  this->Left->SetBackground(0.86, 0.87, 0.88);
  this->Right->SetViewport(Border, 0.0, 1.0, 1.0);
  this->Right->SetBackground(0.925, 0.929, 0.933);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(WindowWidth, WindowHeight);
  this->Window->SetWindowName("Inflow painter");
  this->Window->AddRenderer(this->Left);
  this->Window->AddRenderer(this->Right);
  this->Interactor->SetRenderWindow(this->Window);
  vtkNew<PaintStyle> style;
  style->SetPainter(this);
  this->Interactor->SetInteractorStyle(style);
  this->ShowPage();
  this->ShowFlow(flow, surface);
  this->PlacePage(columns, rows, surface);
  this->ShowText();
  this->ShowSlider(this->Size, "brush", 0.05, SmallestBrush, LargestBrush, this->Brush.Radius);
  this->ShowSlider(this->Opacity, "opacity", 0.37, 0.0, 1.0, this->Brush.Color[3]);
  this->ShowSlider(this->Hue, "hue", 0.69, 0.0, 1.0, 0.0);
  this->SetBrushHue(0.0);
}

PainterWindow::~PainterWindow() = default;

void PainterWindow::ShowPage()
{
  vtkNew<vtkImageSliceMapper> mapper;
  mapper->SetInputData(this->Canvas.GetPage());
  vtkNew<vtkImageSlice> page;
  page->SetMapper(mapper);
  page->GetProperty()->SetInterpolationTypeToNearest();
  page->GetProperty()->SetColorWindow(255.0);
  page->GetProperty()->SetColorLevel(127.5);
  this->Left->AddViewProp(page);
}

void PainterWindow::PlacePage(int columns, int rows, vtkTerminationSurface* surface)
{
  // Rotate the page by a multiple of 90 degrees to match the orientation of the termination surface
  // in the right view.
  double corners[3][3];
  const double parameters[3][2] = { { 0.5, 0.5 }, { 0.51, 0.5 }, { 0.5, 0.51 } };
  for (int i = 0; i < 3; ++i)
  {
    surface->EvaluatePoint(0, parameters[i], corners[i]);
  }
  double up[2];
  double right[2];
  vtkCamera* rightCamera = this->Right->GetActiveCamera();
  double across[3];
  vtkMath::Cross(rightCamera->GetDirectionOfProjection(), rightCamera->GetViewUp(), across);
  for (int axis = 0; axis < 2; ++axis)
  {
    double edge[3];
    vtkMath::Subtract(corners[axis + 1], corners[0], edge);
    vtkMath::Normalize(edge);
    up[axis] = vtkMath::Dot(edge, rightCamera->GetViewUp());
    right[axis] = vtkMath::Dot(edge, across);
  }
  const bool isRotated = std::abs(up[0]) > std::abs(up[1]);
  const int level = isRotated ? 1 : 0;
  const double upward = up[1 - level] < 0.0 ? -1.0 : 1.0;
  const double rightward = right[level] < 0.0 ? -1.0 : 1.0;

  // Make the page as large as possible above the sliders.
  constexpr double aspect = Border * WindowWidth / WindowHeight;
  const double size[2] = { static_cast<double>(isRotated ? rows : columns),
    static_cast<double>(isRotated ? columns : rows) };
  const double height = std::max(1.3 * size[1], 1.08 * size[0] / aspect);
  double focus[3] = { 0.5 * (columns - 1), 0.5 * (rows - 1), 0.0 };
  focus[1 - level] -= upward * (0.46 * height - 0.5 * size[1]);
  double viewUp[3] = { 0.0, 0.0, 0.0 };
  viewUp[1 - level] = upward;
  double viewRight[3] = { 0.0, 0.0, 0.0 };
  viewRight[level] = rightward;
  double from[3];
  vtkMath::Cross(viewRight, viewUp, from);
  vtkCamera* camera = this->Left->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.5 * height);
  camera->SetFocalPoint(focus);
  camera->SetPosition(focus[0] + 10.0 * from[0], focus[1] + 10.0 * from[1], 10.0 * from[2]);
  camera->SetViewUp(viewUp);
  camera->SetClippingRange(1.0, 100.0);
}

void PainterWindow::ShowFlow(vtkImageData* flow, vtkTerminationSurface* surface)
{
  this->Mapper->SetInputData(flow);
  this->Mapper->SetInflowTexture(vtkImplicitFlowVolumeMapper::ALL, this->Canvas.GetPaint());
  vtkNew<vtkVolume> volume;
  volume->SetMapper(this->Mapper);
  // The opacity of the paint is defined for a distance of a twentieth of the field's diagonal.
  volume->GetProperty()->SetScalarOpacityUnitDistance(0.05 * flow->GetLength());
  this->Right->AddVolume(volume);

  vtkNew<vtkTerminationSurfaceSource> source;
  source->SetSurface(surface);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  mapper->ScalarVisibilityOff();
  vtkNew<vtkTexture> texture;
  texture->SetInputData(this->Canvas.GetPage());
  texture->InterpolateOn();
  vtkNew<vtkActor> painted;
  painted->SetMapper(mapper);
  painted->SetTexture(texture);
  painted->GetProperty()->LightingOff();
  this->Right->AddActor(painted);

  vtkNew<vtkOutlineFilter> outline;
  outline->SetInputData(flow);
  vtkNew<vtkPolyDataMapper> lines;
  lines->SetInputConnection(outline->GetOutputPort());
  vtkNew<vtkActor> box;
  box->SetMapper(lines);
  box->GetProperty()->SetColor(Ink[0], Ink[1], Ink[2]);
  this->Right->AddActor(box);

  // View the surface obliquely from upstream, so that both the page and the flow downstream of it
  // are visible.
  double foot[3];
  const double parameters[2] = { 0.5, 0.5 };
  surface->EvaluatePoint(0, parameters, foot);
  double normal[3];
  surface->EvaluateNormal(foot, normal);
  double center[3];
  flow->GetCenter(center);
  double away[3];
  vtkMath::Subtract(center, foot, away);
  const double side = vtkMath::Dot(away, normal) < 0.0 ? -1.0 : 1.0;
  const bool isLevel = std::abs(normal[2]) < 0.7;
  const double up[3] = { 0.0, isLevel ? 0.0 : 1.0, isLevel ? 1.0 : 0.0 };
  double across[3];
  vtkMath::Cross(up, normal, across);
  vtkMath::Normalize(across);
  double position[3];
  for (int i = 0; i < 3; ++i)
  {
    position[i] = center[i] - side * (0.8 * normal[i] + across[i]) + 0.5 * up[i];
  }
  vtkCamera* camera = this->Right->GetActiveCamera();
  camera->SetFocalPoint(center);
  camera->SetPosition(position);
  camera->SetViewUp(up);
  this->Right->ResetCamera();
}

void PainterWindow::ShowText()
{
  vtkNew<vtkTextActor> help;
  help->SetInput("1-6 color   k black   x eraser   [ ] brush   z undo   c clear   s save   l load");
  help->GetTextProperty()->SetFontSize(14);
  help->GetTextProperty()->SetColor(Ink[0], Ink[1], Ink[2]);
  help->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  help->GetPositionCoordinate()->SetValue(0.02, 0.02);
  this->Right->AddViewProp(help);
}

void PainterWindow::ShowSlider(
  vtkSliderWidget* slider, const char* title, double from, double lower, double upper, double value)
{
  vtkNew<vtkSliderRepresentation2D> bar;
  constexpr double length = 0.26;
  constexpr double level = 0.1;
  bar->GetPoint1Coordinate()->SetCoordinateSystemToNormalizedViewport();
  bar->GetPoint1Coordinate()->SetValue(from, level);
  bar->GetPoint2Coordinate()->SetCoordinateSystemToNormalizedViewport();
  bar->GetPoint2Coordinate()->SetValue(from + length, level);
  bar->SetMinimumValue(lower);
  bar->SetMaximumValue(upper);
  bar->SetValue(value);
  bar->SetTitleText(title);
  bar->SetLabelFormat(upper > 1.0 ? "%.0f" : "%.2f");
  bar->SetTitleHeight(0.028);
  bar->SetLabelHeight(0.026);
  bar->SetSliderLength(0.03);
  bar->SetSliderWidth(0.04);
  bar->SetTubeWidth(0.012);
  bar->SetEndCapLength(0.006);
  bar->SetEndCapWidth(0.02);
  for (vtkTextProperty* text : { bar->GetTitleProperty(), bar->GetLabelProperty() })
  {
    text->SetColor(Ink[0], Ink[1], Ink[2]);
    text->ShadowOff();
    text->BoldOff();
    text->ItalicOff();
  }
  bar->GetTubeProperty()->SetColor(0.65, 0.67, 0.7);
  bar->GetCapProperty()->SetColor(0.65, 0.67, 0.7);
  slider->SetInteractor(this->Interactor);
  slider->SetCurrentRenderer(this->Left);
  slider->SetRepresentation(bar);
  slider->SetAnimationModeToJump();
  slider->EnabledOn();
  slider->AddObserver(vtkCommand::InteractionEvent, this, &PainterWindow::ReadSliders);
}

void PainterWindow::ReadSliders()
{
  this->Brush.Radius = GetValue(this->Size);
  this->Brush.Color[3] = GetValue(this->Opacity);
  this->SetBrushHue(GetValue(this->Hue));
}

void PainterWindow::SetBrushHue(double hue)
{
  if (hue >= 0.0)
  {
    const double hsv[3] = { hue, 0.85, 0.9 };
    vtkMath::HSVToRGB(hsv, this->Brush.Color.data());
    SetValue(this->Hue, hue);
  }
  SetValue(this->Size, this->Brush.Radius);
  SetValue(this->Opacity, this->Brush.Color[3]);
  auto* bar = static_cast<vtkSliderRepresentation2D*>(this->Hue->GetRepresentation());
  bar->GetSliderProperty()->SetColor(this->Brush.Color.data());
  bar->GetSelectedProperty()->SetColor(this->Brush.Color.data());
}

bool PainterWindow::IsOverPage(int x) const
{
  return x < Border * this->Window->GetSize()[0];
}

PaintCanvas::Position PainterWindow::FindCanvasPosition(int x, int y) const
{
  this->Left->SetDisplayPoint(x, y, 0.0);
  this->Left->DisplayToWorld();
  const double* world = this->Left->GetWorldPoint();
  return { { world[0] / world[3], world[1] / world[3] } };
}

void PainterWindow::BeginStroke(int x, int y)
{
  this->Canvas.SaveState();
  this->Painting = true;
  this->Last = this->FindCanvasPosition(x, y);
  this->ContinueStroke(x, y);
}

void PainterWindow::ContinueStroke(int x, int y)
{
  const PaintCanvas::Position position = this->FindCanvasPosition(x, y);
  this->Canvas.Stroke(this->Last, position, this->Brush);
  this->Last = position;
  this->Window->Render();
}

bool PainterWindow::HandleKey(char key)
{
  std::string error;
  switch (key)
  {
    case '1':
    case '2':
    case '3':
    case '4':
    case '5':
    case '6':
      this->Brush.Color[3] = std::max(this->Brush.Color[3], 0.05);
      this->SetBrushHue((key - '1') / 6.0);
      break;
    case 'k':
      std::fill_n(this->Brush.Color.begin(), 3, 0.0);
      this->SetBrushHue(-1.0);
      break;
    case 'x':
      this->Brush.Color[3] = 0.0;
      this->SetBrushHue(-1.0);
      break;
    case '[':
    case ']':
      this->Brush.Radius =
        std::clamp(this->Brush.Radius * (key == '[' ? 0.8 : 1.25), SmallestBrush, LargestBrush);
      this->SetBrushHue(-1.0);
      break;
    case 'z':
      this->Canvas.Undo();
      break;
    case 'c':
      this->Canvas.SaveState();
      this->Canvas.Clear();
      break;
    case 's':
      error = this->Canvas.Save(this->File);
      break;
    case 'l':
      this->Canvas.SaveState();
      error = this->Canvas.Load(this->File);
      break;
    default:
      return false;
  }
  if (!error.empty())
  {
    std::cerr << error << "\n";
  }
  return true;
}

void PainterWindow::SetReducedResolution(bool isCoarse)
{
  constexpr double coarse = 3.0;
  this->Mapper->SetImageSampleDistance(isCoarse ? coarse : 1.0);
}
