// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Report/MarkedLine.h"

#include "Benchmarks/Report/PlotMarks.h"

#include "vtkContext2D.h"
#include "vtkObjectFactory.h"
#include "vtkPen.h"
#include "vtkPoints2D.h"

vtkStandardNewMacro(MarkedLine);

namespace
{
/// Pixels along an edge of a mark.
constexpr float MarkPixels = 21.0f;
}

void MarkedLine::SetLook(std::size_t mark, const std::array<unsigned char, 3>& colour)
{
  this->SetColor(colour[0], colour[1], colour[2], 255);
  this->SetMarkerStyle(vtkPlotPoints::NONE);
  this->Mark = MakeMark(mark, colour);
}

void MarkedLine::SetPen(vtkContext2D* painter)
{
  // White leaves the mark's own colours.
  painter->GetPen()->SetColor(255, 255, 255, 255);
  painter->GetPen()->SetWidth(MarkPixels);
}

bool MarkedLine::Paint(vtkContext2D* painter)
{
  if (!this->Superclass::Paint(painter))
  {
    return false;
  }
  if (this->Mark)
  {
    this->SetPen(painter);
    painter->DrawPointSprites(this->Mark, this->Points);
  }
  return true;
}

bool MarkedLine::PaintLegend(vtkContext2D* painter, const vtkRectf& rect, int legendIndex)
{
  if (!this->Superclass::PaintLegend(painter, rect, legendIndex))
  {
    return false;
  }
  if (this->Mark)
  {
    this->SetPen(painter);
    float middle[] = { rect[0] + 0.5f * rect[2], rect[1] + 0.5f * rect[3] };
    painter->DrawPointSprites(this->Mark, middle, 1);
  }
  return true;
}
