// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerminationSurfaceSource.h"

#include "Common/AbortCheck.h"
#include "Common/Error.h"
#include "Common/NamedValue.h"
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

vtkTerminationSurfaceSource::vtkTerminationSurfaceSource()
{
  this->SetNumberOfInputPorts(0);
}

vtkTerminationSurfaceSource::~vtkTerminationSurfaceSource() = default;

void vtkTerminationSurfaceSource::SetSurface(vtkTerminationSurface* surface)
{
  if (this->Surface != surface)
  {
    this->Surface = surface;
    this->Modified();
  }
}

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
  this->Report = {};
  vtkTerminationSurfaceSourceReport report;
  if (const interlume::Error error =
        this->Surface ? this->Surface->Update() : "there is none; call SetSurface")
  {
    vtkErrorMacro("The termination surface cannot be drawn: " << error << ".");
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
  report.Parts = this->Surface->GetNumberOfParts();
  for (int part = 0; part < report.Parts; ++part)
  {
    interlume::TerminationGrid grid(this->Surface, part, this->ResolutionU, this->ResolutionV);
    const double start = static_cast<double>(part) / report.Parts;
    if (!grid.Execute(this, start, start + 1.0 / report.Parts))
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
    report.BorderPoints += grid.BorderPoints;
    report.FlatTriangles += grid.FlatTriangles;
  }
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->SetPoints(points);
  output->SetPolys(triangles);
  output->GetPointData()->SetTCoords(parameters);
  output->GetPointData()->SetScalars(parameters);
  output->GetPointData()->SetNormals(normals);
  output->GetCellData()->AddArray(ids);
  report.Points = output->GetNumberOfPoints();
  report.Triangles = output->GetNumberOfCells();
  this->Report = report;
  return 1;
}

void vtkTerminationSurfaceSourceReport::Print(std::ostream& os, vtkIndent indent) const
{
  interlume::NamedValue::Print(os, indent,
    { { "Parts", this->Parts }, { "Points", this->Points }, { "BorderPoints", this->BorderPoints },
      { "Triangles", this->Triangles }, { "FlatTriangles", this->FlatTriangles } });
}

void vtkTerminationSurfaceSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  interlume::NamedValue::Print(os, indent,
    { { "Surface", this->Surface.GetPointer() }, { "ResolutionU", this->ResolutionU },
      { "ResolutionV", this->ResolutionV } });
  os << indent << "Report:\n";
  this->Report.Print(os, indent.GetNextIndent());
}
