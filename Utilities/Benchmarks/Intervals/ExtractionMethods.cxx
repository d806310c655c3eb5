// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Intervals/ExtractionMethods.h"

#include "vtkIntervalVolume.h"
#include "vtkIsotableContour.h"

#include "vtkContour3DLinearGrid.h"
#include "vtkDataSetTriangleFilter.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkTableBasedClipDataSet.h"

namespace methods
{
vtkSmartPointer<vtkIntervalVolume> NewIntervalVolume(vtkDataSet* data, double lower, double upper)
{
  auto filter = vtkSmartPointer<vtkIntervalVolume>::New();
  filter->SetInputData(data);
  filter->SetInterval(0, lower, upper);
  return filter;
}

vtkSmartPointer<vtkUnstructuredGrid> IntervalVolume(vtkDataSet* data, double lower, double upper)
{
  auto filter = NewIntervalVolume(data, lower, upper);
  filter->Update();
  return filter->GetOutput();
}

vtkSmartPointer<vtkUnstructuredGrid> ClipTwice(
  vtkDataSet* data, double lower, double upper, int precision)
{
  vtkNew<vtkTableBasedClipDataSet> above;
  above->SetInputData(data);
  above->SetValue(lower);
  above->SetOutputPointsPrecision(precision);
  vtkNew<vtkTableBasedClipDataSet> below;
  below->SetInputConnection(above->GetOutputPort());
  below->SetValue(upper);
  below->InsideOutOn();
  below->SetOutputPointsPrecision(precision);
  below->Update();
  return below->GetOutput();
}

vtkSmartPointer<vtkUnstructuredGrid> ToTetrahedra(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkDataSetTriangleFilter> filter;
  filter->SetInputData(grid);
  filter->TetrahedraOnlyOn();
  filter->Update();
  return filter->GetOutput();
}

vtkSmartPointer<vtkUnstructuredGrid> IsotableContour(
  vtkDataSet* data, double value, bool mergePoints)
{
  vtkNew<vtkIsotableContour> filter;
  filter->SetInputData(data);
  filter->SetNumberOfContours(1);
  filter->SetValue(0, value);
  filter->SetMergePoints(mergePoints);
  filter->Update();
  return filter->GetOutput();
}

vtkSmartPointer<vtkPolyData> Contour3DLinearGrid(
  vtkUnstructuredGrid* grid, double value, bool mergePoints)
{
  vtkNew<vtkContour3DLinearGrid> filter;
  filter->SetInputData(grid);
  filter->SetValue(0, value);
  filter->SetMergePoints(mergePoints);
  filter->InterpolateAttributesOff();
  filter->ComputeNormalsOff();
  filter->Update();
  return vtkPolyData::SafeDownCast(filter->GetOutput());
}

vtkSmartPointer<vtkPolyData> FlyingEdges(vtkImageData* image, double value)
{
  vtkNew<vtkFlyingEdges3D> filter;
  filter->SetInputData(image);
  filter->SetValue(0, value);
  filter->ComputeNormalsOff();
  filter->ComputeGradientsOff();
  filter->Update();
  return filter->GetOutput();
}
}
