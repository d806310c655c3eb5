// SPDX-License-Identifier: BSD-3-Clause
#ifndef StripedQuad_h
#define StripedQuad_h

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <vector>

namespace reference
{

/// Edge length of the window in pixels.
constexpr int WINDOW = 512;
/// An unlit quad with texture coordinates from 0 to the given maxima. Initially it fills the
/// window.
class StripedQuad
{
public:
  StripedQuad(double sCoordinate, double tCoordinate,
    const vtkSmartPointer<vtkPolyDataMapper>& mapper = vtkSmartPointer<vtkPolyDataMapper>::New())
  {
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(-0.5, -0.5, 0.0);
    plane->SetPoint1(0.5, -0.5, 0.0);
    plane->SetPoint2(-0.5, 0.5, 0.0);
    plane->Update();
    this->Data = plane->GetOutput();
    vtkDataArray* coordinates = this->Data->GetPointData()->GetTCoords();
    for (vtkIdType i = 0; i < coordinates->GetNumberOfTuples(); ++i)
    {
      coordinates->SetTuple2(i, sCoordinate * coordinates->GetComponent(i, 0),
        tCoordinate * coordinates->GetComponent(i, 1));
    }
    mapper->SetInputData(this->Data);
    this->Actor->SetMapper(mapper);
    this->Actor->GetProperty()->LightingOff();
    this->Renderer->AddActor(this->Actor);
    this->Renderer->SetBackground(0.0, 0.0, 0.0);
    this->Window->OffScreenRenderingOn();
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(WINDOW, WINDOW);
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->GetActiveCamera()->ParallelProjectionOn();
    this->SetPixels(WINDOW);
  }

  /// Sets the side length of the quad in pixels.
  void SetPixels(double pixels)
  {
    this->Renderer->GetActiveCamera()->SetParallelScale(0.5 * WINDOW / pixels);
    this->Renderer->ResetCameraClippingRange();
  }

  using Row = std::vector<std::array<double, 4>>;
  /// Renders, and returns the pixels of the center row or column with values in [0, 1].
  Row Draw(bool isColumn = false)
  {
    this->Window->Render();
    const int center = WINDOW / 2;
    vtkNew<vtkFloatArray> pixels;
    this->Window->GetRGBAPixelData(isColumn ? center : 0, isColumn ? 0 : center,
      isColumn ? center : WINDOW - 1, isColumn ? WINDOW - 1 : center, 0, pixels);
    Row row;
    for (vtkIdType i = 0; i < pixels->GetNumberOfTuples(); ++i)
    {
      std::array<double, 4> pixel;
      pixels->GetTuple(i, pixel.data());
      row.push_back(pixel);
    }
    return row;
  }

  vtkSmartPointer<vtkPolyData> Data;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};

/// Positions at which a row of pixels changes from bright to dark, and the row's range of values.
struct Lines
{
  std::vector<int> Positions;
  double Darkest = 1.0;
  double Lightest = 0.0;
};
inline Lines FindLines(const StripedQuad::Row& row, int first, int last)
{
  Lines lines;
  for (int i = first; i <= last; ++i)
  {
    lines.Darkest = std::min(lines.Darkest, row[i][0]);
    lines.Lightest = std::max(lines.Lightest, row[i][0]);
    if (i > first && row[i - 1][0] >= 0.5 && row[i][0] < 0.5)
    {
      lines.Positions.push_back(i);
    }
  }
  return lines;
}

}

#endif
