// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Intervals/ReferenceExtraction.h"

#include "Support/Checks/ReferenceMessages.h"

#include "vtkDataSet.h"
#include "vtkIntervalVolume.h"
#include "vtkIsotableContour.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

namespace reference
{

namespace
{

vtkUnstructuredGrid* GetGrid(vtkAlgorithm* filter, int port)
{
  return vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(port));
}

}

Extraction ExtractIntervals(
  vtkDataSet* data, const std::vector<Interval>& intervals, int surfaceCells)
{
  vtkNew<vtkIntervalVolume> filter;
  filter->SetInputData(data);
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  filter->GenerateBoundariesOn();
  filter->SetSurfaceCells(surfaceCells);
  filter->SetNumberOfIntervals(static_cast<int>(intervals.size()));
  for (size_t i = 0; i < intervals.size(); ++i)
  {
    filter->SetInterval(static_cast<int>(i), intervals[i][0], intervals[i][1]);
  }
  UpdateAndCheckWarnings(filter);
  return { GetGrid(filter, 0), GetGrid(filter, 1), filter->GetReport() };
}

ContourExtraction ExtractContours(vtkDataSet* data, const std::vector<double>& values)
{
  vtkNew<vtkIsotableContour> filter;
  filter->SetInputData(data);
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  filter->SetNumberOfContours(static_cast<int>(values.size()));
  for (size_t i = 0; i < values.size(); ++i)
  {
    filter->SetValue(static_cast<int>(i), values[i]);
  }
  UpdateAndCheckWarnings(filter);
  return { GetGrid(filter, 0), filter->GetReport() };
}

}
