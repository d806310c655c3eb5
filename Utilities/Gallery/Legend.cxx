// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/Legend.h"

#include "Gallery/Look.h"

#include "vtkActor2D.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkTextRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <cstdio>

namespace gallery
{
namespace
{
/// Collects single-colored rectangles, in pixel coordinates, and draws them as one actor.
class Rectangles
{
public:
  Rectangles()
  {
    this->Colors->SetNumberOfComponents(3);
    this->Data->SetPoints(this->Points);
    this->Data->SetPolys(this->Cells);
    this->Data->GetCellData()->SetScalars(this->Colors);
  }

  void Add(double x, double y, double width, double height, const vtkColor3d& color)
  {
    const std::array<vtkIdType, 4> corners = { { this->Points->InsertNextPoint(x, y, 0.0),
      this->Points->InsertNextPoint(x + width, y, 0.0),
      this->Points->InsertNextPoint(x + width, y + height, 0.0),
      this->Points->InsertNextPoint(x, y + height, 0.0) } };
    this->Cells->InsertNextCell(4, corners.data());
    this->Colors->InsertNextTuple3(255.0 * color[0], 255.0 * color[1], 255.0 * color[2]);
  }

  void DrawInto(vtkRenderer* overlay)
  {
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(this->Data);
    vtkNew<vtkActor2D> actor;
    actor->SetMapper(mapper);
    overlay->AddViewProp(actor);
  }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Cells;
  vtkNew<vtkUnsignedCharArray> Colors;
  vtkNew<vtkPolyData> Data;
};

std::string NumberLabel(double value, double span)
{
  std::array<char, 32> text;
  // Rounding error may turn zero into 1e-17.
  std::snprintf(text.data(), text.size(), "%.4g", std::abs(value) < 1e-9 * span ? 0.0 : value);
  return text.data();
}

void SetStyle(vtkTextProperty* style, int fontSize, bool bold)
{
  const vtkColor3d ink = TextColor();
  style->SetFontFamilyToArial();
  style->SetFontSize(fontSize);
  style->SetBold(bold);
  style->SetColor(ink[0], ink[1], ink[2]);
  style->SetVerticalJustificationToCentered();
}

double TextWidth(const std::string& text, int fontSize)
{
  vtkNew<vtkTextProperty> style;
  SetStyle(style, fontSize, false);
  std::array<int, 4> box = { { 0, 0, 0, 0 } };
  const int screenResolution = 72;
  vtkTextRenderer::GetInstance()->GetBoundingBox(style, text, box.data(), screenResolution);
  return box[1] - box[0];
}
}

void AddText(vtkRenderer* overlay, const std::string& text, double x, double y, int fontSize,
  Align align, bool bold)
{
  vtkNew<vtkTextActor> actor;
  actor->SetTextScaleModeToNone();
  actor->SetInput(text.c_str());
  vtkTextProperty* style = actor->GetTextProperty();
  SetStyle(style, fontSize, bold);
  style->SetJustification(align == Align::Left ? VTK_TEXT_LEFT : VTK_TEXT_CENTERED);
  actor->SetPosition(x, y);
  overlay->AddViewProp(actor);
}

void AddColorBar(vtkRenderer* overlay, const std::string& title, vtkScalarsToColors* colors,
  double lower, double upper, double x, double y, double width, int fontSize)
{
  const int strips = 256;
  const double height = 0.75 * fontSize;
  const double left = x - 0.5 * width;
  const double tick = fontSize / 9.0;
  Rectangles rectangles;
  for (int i = 0; i < strips; ++i)
  {
    vtkColor3d color;
    colors->GetColor(lower + (upper - lower) * (i + 0.5) / strips, color.GetData());
    rectangles.Add(left + width * i / strips, y, width / strips, height, color);
  }
  const int labels = 5;
  for (int i = 0; i < labels; ++i)
  {
    const double fraction = static_cast<double>(i) / (labels - 1);
    rectangles.Add(
      left + fraction * width - 0.5 * tick, y - 0.3 * fontSize, tick, 0.3 * fontSize, TextColor());
    AddText(overlay, NumberLabel(lower + fraction * (upper - lower), upper - lower),
      left + fraction * width, y - 0.9 * fontSize, fontSize);
  }
  rectangles.DrawInto(overlay);
  AddText(overlay, title, x, y + height + 0.8 * fontSize, fontSize);
}

void AddColorKey(vtkRenderer* overlay, const std::string& title,
  const std::vector<ColorEntry>& entries, double x, double y, int fontSize)
{
  const double patch = 1.1 * fontSize;
  const double gap = 0.5 * fontSize;
  const double space = 1.6 * fontSize;
  double total = -space;
  for (const ColorEntry& entry : entries)
  {
    total += patch + gap + TextWidth(entry.second, fontSize) + space;
  }
  double left = x - 0.5 * total;
  Rectangles rectangles;
  for (const ColorEntry& entry : entries)
  {
    rectangles.Add(left, y - 0.5 * patch, patch, patch, entry.first);
    AddText(overlay, entry.second, left + patch + gap, y, fontSize, Align::Left);
    left += patch + gap + TextWidth(entry.second, fontSize) + space;
  }
  rectangles.DrawInto(overlay);
  if (!title.empty())
  {
    AddText(overlay, title, x, y + 1.7 * fontSize, fontSize);
  }
}
}
