// SPDX-License-Identifier: BSD-3-Clause
// Pieces and subextents have the same values and points as the full output. Float values are the
// rounded double values, and the output is bit-identical for any number of threads.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceThreads.h"
#include "Support/TimeVarying/ReferenceTemporalSource.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredData.h"
#include "vtkStructuredGrid.h"

#include <algorithm>
#include <array>
#include <string>

namespace
{

using namespace reference;
using Extent = std::array<int, 6>;

Extent GetExtent(vtkDataSet* data)
{
  Extent extent;
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    image->GetExtent(extent.data());
  }
  else
  {
    vtkStructuredGrid::SafeDownCast(data)->GetExtent(extent.data());
  }
  return extent;
}

vtkSmartPointer<vtkDataSet> Copy(vtkDataSet* data)
{
  auto copy = vtk::TakeSmartPointer(data->NewInstance());
  copy->DeepCopy(data);
  return copy;
}

// Checks that every point of the subextent equals the same point of the full output. Returns the
// number of points.
vtkIdType ComparePart(vtkDataSet* part, vtkDataSet* whole, Check& check)
{
  Extent extent = GetExtent(part);
  Extent all = GetExtent(whole);
  vtkDataArray* values = part->GetPointData()->GetScalars();
  vtkDataArray* expected = whole->GetPointData()->GetScalars();
  vtkIdType differing = 0;
  vtkIdType point = 0;
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      for (int i = extent[0]; i <= extent[1]; ++i, ++point)
      {
        int ijk[3] = { i, j, k };
        const vtkIdType same = vtkStructuredData::ComputePointIdForExtent(all.data(), ijk);
        double a[3];
        double b[3];
        part->GetPoint(point, a);
        whole->GetPoint(same, b);
        differing +=
          values->GetTuple1(point) != expected->GetTuple1(same) || !std::equal(a, a + 3, b);
      }
    }
  }
  check.Equal(point, part->GetNumberOfPoints(), "points of the subextent");
  check.Equal(differing, 0, "points that differ from the full output");
  return point;
}

// Checks a subextent and pieces. Without Modified(), the pipeline would reuse the full output for
// each of them.
void CheckParts(const TemporalSource& source, vtkDataSet* whole, Check& check)
{
  const Extent all = GetExtent(whole);
  const Extent part = { { all[0] + 2, all[1] - 3, all[2] + 1, all[2] + 1, all[4], all[5] - 1 } };
  check.SetContext(source.Name + ", a subextent");
  source.Algorithm->Modified();
  source.Algorithm->UpdateExtent(part.data());
  check.That(GetExtent(source.GetOutput()) == part, "the output has the requested subextent");
  ComparePart(source.GetOutput(), whole, check);
  for (int ghosts : { 0, 1 })
  {
    vtkIdType cells = 0;
    vtkIdType points = 0;
    for (int piece = 0; piece < 5; ++piece)
    {
      check.SetContext(source.Name + ", piece " + std::to_string(piece));
      source.Algorithm->Modified();
      source.Algorithm->UpdatePiece(piece, 5, ghosts);
      points += ComparePart(source.GetOutput(), whole, check);
      for (vtkIdType cell = 0; cell < source.GetOutput()->GetNumberOfCells(); ++cell)
      {
        vtkUnsignedCharArray* marks = source.GetOutput()->GetCellGhostArray();
        cells += !marks || marks->GetComponent(cell, 0) == 0;
      }
    }
    check.SetContext(source.Name);
    check.Equal(cells, whole->GetNumberOfCells(), "cells of all pieces that are not ghosts");
    check.That(points > whole->GetNumberOfPoints(), "pieces share points");
  }
}

void CheckTypes(const TemporalSource& source, Check& check)
{
  check.SetContext(source.Name);
  source.Algorithm->UpdateWholeExtent();
  const auto single = Copy(source.GetOutput());
  source.SetOutputScalarType(VTK_DOUBLE);
  source.Algorithm->UpdateWholeExtent();
  vtkDataArray* values = single->GetPointData()->GetScalars();
  vtkDataArray* exact = source.GetValues();
  check.Equal(values->GetDataType(), VTK_FLOAT, "type");
  check.Equal(exact->GetDataType(), VTK_DOUBLE, "type with double precision");
  vtkIdType differing = 0;
  for (vtkIdType i = 0; i < exact->GetNumberOfTuples(); ++i)
  {
    differing += values->GetTuple1(i) != static_cast<float>(exact->GetTuple1(i));
  }
  check.Equal(differing, 0, "float values that differ from the rounded double values");
  if (auto* grid = vtkStructuredGrid::SafeDownCast(source.GetOutput()))
  {
    check.Equal(
      grid->GetPoints()->GetDataType(), VTK_DOUBLE, "type of the points with double precision");
  }
}

std::string GetBytes(vtkDataArray* array)
{
  return std::string(static_cast<const char*>(array->GetVoidPointer(0)),
    array->GetNumberOfValues() * array->GetDataTypeSize());
}

std::string GetBytes(const TemporalSource& source)
{
  auto* grid = vtkStructuredGrid::SafeDownCast(source.GetOutput());
  return GetBytes(source.GetValues()) + (grid ? GetBytes(grid->GetPoints()->GetData()) : "");
}

void CheckThreads(Check& check)
{
  std::vector<std::string> expected;
  for (int threads : { 1, 2, 8 })
  {
    SetThreads(threads);
    std::size_t i = 0;
    for (const TemporalSource& source : MakeTemporalSources())
    {
      check.SetContext(source.Name + ", " + std::to_string(threads) + " threads");
      source.Algorithm->UpdateTimeStep(0.7);
      if (threads == 1)
      {
        expected.push_back(GetBytes(source));
      }
      check.That(GetBytes(source) == expected[i++], "the output is bit-identical");
    }
  }
}

}

int TestTemporalSourceParts(int, char*[])
{
  Check check;
  vtkSMPTools::SetBackend("STDThread");
  for (const TemporalSource& source : MakeTemporalSources())
  {
    source.Algorithm->UpdateWholeExtent();
    CheckParts(source, Copy(source.GetOutput()), check);
    CheckTypes(source, check);
  }
  CheckThreads(check);
  return check.Result();
}
