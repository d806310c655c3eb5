// SPDX-License-Identifier: BSD-3-Clause
#include "Streams/CurvedGridSource.h"

#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"

#include <cmath>

vtkStandardNewMacro(CurvedGridSource);

void CurvedGridSource::Ring(const double part[3], double x[3])
{
  const double angle = 2.0 * vtkMath::Pi() * part[1];
  const double radius = 0.5 + 1.5 * part[0] * part[0] + 0.2 * part[0];
  x[0] = radius * std::cos(angle);
  x[1] = radius * std::sin(angle);
  x[2] = part[2] - 0.5 + 0.1 * std::sin(3.0 * part[0]);
}

void CurvedGridSource::PolarGrid(const double part[3], double x[3])
{
  const double angle = 2.0 * vtkMath::Pi() * part[1];
  x[0] = 1.3 * part[0] * std::cos(angle);
  x[1] = 1.3 * part[0] * std::sin(angle);
  x[2] = 1.6 * part[2] - 0.8 + 0.2 * part[0] * part[0];
}

void CurvedGridSource::BentBox(const double part[3], double x[3])
{
  x[0] = 2.0 * part[0] - 1.0 + 0.15 * std::sin(4.0 * part[1]);
  x[1] = 2.0 * part[1] - 1.0 + 0.2 * std::sin(3.0 * part[2] + part[0]);
  x[2] = 2.0 * part[2] - 1.0 + 0.1 * std::sin(5.0 * part[0]) * part[1];
}

int CurvedGridSource::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), this->WholeExtent, 6);
  info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  return 1;
}

int CurvedGridSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  vtkStructuredGrid* grid = vtkStructuredGrid::GetData(info);
  int extent[6];
  info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent);
  grid->SetExtent(extent);
  vtkIdType size = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    size *= extent[2 * axis + 1] - extent[2 * axis] + 1;
  }
  vtkIdType id = 0;
  vtkNew<vtkPoints> points;
  points->SetDataType(this->PointType);
  points->SetNumberOfPoints(size);
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("Velocity");
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(size);
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      for (int i = extent[0]; i <= extent[1]; ++i)
      {
        const int index[3] = { i, j, k };
        double part[3];
        for (int axis = 0; axis < 3; ++axis)
        {
          const int first = this->WholeExtent[2 * axis];
          part[axis] =
            static_cast<double>(index[axis] - first) / (this->WholeExtent[2 * axis + 1] - first);
        }
        double x[3];
        double v[3];
        this->GetPosition(part, x);
        this->Flow->Evaluate(x, v);
        points->SetPoint(id, x);
        vectors->SetTypedTuple(id++, v);
      }
    }
  }
  grid->SetPoints(points);
  grid->GetPointData()->SetVectors(vectors);
  if (!this->IsBlanked)
  {
    return 1;
  }
  vtkIdType cell = 0;
  vtkIdType point = 0;
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      for (int i = extent[0]; i <= extent[1]; ++i, ++point)
      {
        if ((7 * i + 3 * j + 5 * k) % 97 == 0)
        {
          grid->BlankPoint(point);
        }
        if (i < extent[1] && j < extent[3] && k < extent[5] && (i * j + 11 * k) % 13 == 0)
        {
          grid->BlankCell(cell);
        }
        cell += i < extent[1] && j < extent[3] && k < extent[5] ? 1 : 0;
      }
    }
  }
  return 1;
}
