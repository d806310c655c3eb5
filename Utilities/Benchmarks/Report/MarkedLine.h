// SPDX-License-Identifier: BSD-3-Clause
#ifndef MarkedLine_h
#define MarkedLine_h

#include "vtkImageData.h"
#include "vtkPlotLine.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstddef>

/**
 * A line of a chart whose points have one of the marks of PlotMarks.h, in its legend too.
 */
class MarkedLine : public vtkPlotLine
{
public:
  static MarkedLine* New();
  vtkTypeMacro(MarkedLine, vtkPlotLine);

  /// Sets the line's colour and its points' mark.
  void SetLook(std::size_t mark, const std::array<unsigned char, 3>& colour);

  /// The picture that is drawn at the points.
  vtkImageData* GetMark() const { return this->Mark; }

  bool Paint(vtkContext2D* painter) override;
  bool PaintLegend(vtkContext2D* painter, const vtkRectf& rect, int legendIndex) override;

protected:
  MarkedLine() = default;

private:
  void SetPen(vtkContext2D* painter);

  vtkSmartPointer<vtkImageData> Mark;
};

#endif
