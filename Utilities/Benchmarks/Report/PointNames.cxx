// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Report/PointNames.h"

#include "vtkAxis.h"
#include "vtkChartXY.h"
#include "vtkContext2D.h"
#include "vtkObjectFactory.h"
#include "vtkTextProperty.h"

#include <cmath>

vtkStandardNewMacro(PointNames);

namespace
{
/// Right of a point and above it, in pixels.
constexpr float Offset[2] = { 11.0f, 5.0f };

/// Where a number of a chart's axis is drawn.
double PlaceOf(double number, vtkAxis* axis, int component)
{
  const double scaled = axis->GetLogScaleActive() ? std::log10(number) : number;
  const double share = (scaled - axis->GetMinimum()) / (axis->GetMaximum() - axis->GetMinimum());
  const double first = axis->GetPoint1()[component];
  return first + share * (axis->GetPoint2()[component] - first);
}
}

bool PointNames::Paint(vtkContext2D* painter)
{
  auto* chart = vtkChartXY::SafeDownCast(this->GetParent());
  if (!chart)
  {
    return false;
  }
  painter->GetTextProp()->SetFontSize(14);
  painter->GetTextProp()->SetColor(0.25, 0.25, 0.25);
  painter->GetTextProp()->SetOpacity(1.0);
  painter->GetTextProp()->SetOrientation(0.0);
  painter->GetTextProp()->SetJustificationToLeft();
  painter->GetTextProp()->SetVerticalJustificationToBottom();
  for (const BenchPlot::Series& series : this->Plot.AllSeries)
  {
    for (std::size_t i = 0; i < series.Names.size(); ++i)
    {
      if (!series.Names[i].empty())
      {
        painter->DrawString(
          static_cast<float>(PlaceOf(series.X[i], chart->GetAxis(vtkAxis::BOTTOM), 0)) + Offset[0],
          static_cast<float>(PlaceOf(series.Y[i], chart->GetAxis(vtkAxis::LEFT), 1)) + Offset[1],
          series.Names[i].c_str());
      }
    }
  }
  return true;
}
