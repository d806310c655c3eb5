// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerminationSurfaceSource.h"

#include "Common/AbortCheck.h"
#include "Common/Error.h"
#include "Common/NamedValue.h"
#include "Common/ReportValue.h"
#include "Termination/TerminationGrid.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFlowStatus.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTerminationSurface.h"

#include <algorithm>

vtkStandardNewMacro(vtkTerminationSurfaceSource);

namespace
{
void SetSourceReport(vtkInterlumeReport* report, int parts = 0, vtkIdType points = 0,
  vtkIdType borderPoints = 0, vtkIdType triangles = 0, vtkIdType flatTriangles = 0)
{
  interlume::ReportValue::Set(report,
    { { "Parts", parts }, { "Points", points }, { "BorderPoints", borderPoints },
      { "Triangles", triangles }, { "FlatTriangles", flatTriangles } });
}
}

vtkTerminationSurfaceSource::vtkTerminationSurfaceSource()
{
  SetSourceReport(this->Report);
  this->SetNumberOfInputPorts(0);
}

vtkTerminationSurfaceSource::~vtkTerminationSurfaceSource() = default;

vtkCxxSetSmartPointerMacro(vtkTerminationSurfaceSource, Surface, vtkTerminationSurface);

vtkTerminationSurface* vtkTerminationSurfaceSource::GetSurface() const
{
  return this->Surface;
}

vtkMTimeType vtkTerminationSurfaceSource::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Surface ? std::max(own, this->Surface->GetMTime()) : own;
}

int vtkTerminationSurfaceSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  SetSourceReport(this->Report);
  if (const interlume::Error error =
        this->Surface ? this->Surface->Update() : "it is null; call SetSurface")
  {
    vtkErrorMacro("The termination surface cannot be triangulated: " << error << ".");
    return 1;
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> parameters;
  parameters->SetName(vtkFlowStatus::ParametersArray());
  parameters->SetNumberOfComponents(2);
  vtkNew<vtkDoubleArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  vtkNew<vtkIntArray> ids;
  ids->SetName(vtkFlowStatus::IdArray());
  vtkNew<vtkCellArray> triangles;
  const int parts = this->Surface->GetNumberOfParts();
  vtkIdType borderPoints = 0;
  vtkIdType flatTriangles = 0;
  for (int part = 0; part < parts; ++part)
  {
    interlume::TerminationGrid grid(this->Surface, part, this->ResolutionU, this->ResolutionV);
    const double start = static_cast<double>(part) / parts;
    if (!grid.Execute(this, start, start + 1.0 / parts))
    {
      return interlume::AbortCheck::Leave(outputs);
    }
    const vtkIdType offset = points->GetNumberOfPoints();
    for (const interlume::TerminationGrid::Point& point : grid.Points)
    {
      points->InsertNextPoint(point.Position);
      parameters->InsertNextTuple(point.Parameters);
      normals->InsertNextTuple(point.Normal);
    }
    for (const auto& triangle : grid.Triangles)
    {
      triangles->InsertNextCell(
        { offset + triangle[0], offset + triangle[1], offset + triangle[2] });
      ids->InsertNextValue(std::max(this->Surface->GetId(), 0) + part);
    }
    borderPoints += grid.BorderPoints;
    flatTriangles += grid.FlatTriangles;
  }
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->SetPoints(points);
  output->SetPolys(triangles);
  output->GetPointData()->SetTCoords(parameters);
  output->GetPointData()->SetScalars(parameters);
  output->GetPointData()->SetNormals(normals);
  output->GetCellData()->AddArray(ids);
  SetSourceReport(this->Report, parts, output->GetNumberOfPoints(), borderPoints,
    output->GetNumberOfCells(), flatTriangles);
  return 1;
}

void vtkTerminationSurfaceSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  interlume::NamedValue::Print(os, indent,
    { { "Surface", this->Surface.GetPointer() }, { "ResolutionU", this->ResolutionU },
      { "ResolutionV", this->ResolutionV } });
  os << indent << "Report:\n";
  this->Report->PrintSelf(os, indent.GetNextIndent());
}
