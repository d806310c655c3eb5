// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVImplicitFlowField.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFlowStatus.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTerminationMesh.h"
#include "vtkTerminationSurfaceSource.h"
#include "vtkTerminationTube.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

vtkStandardNewMacro(vtkPVImplicitFlowField);

namespace
{
constexpr int SurfacesPort = 2;
// Output port for the triangulated termination surfaces.
constexpr int SurfaceOutputPort = 1;

// Triangulates \a surface. The ids of its parts start at \a id, which the filter may have assigned
// automatically; the surface does not store such an id.
vtkSmartPointer<vtkPolyData> CreateTriangles(vtkTerminationSurface* surface, int id)
{
  vtkNew<vtkTerminationSurfaceSource> source;
  source->SetSurface(surface);
  source->Update();
  vtkPolyData* triangles = source->GetOutput();
  vtkDataArray* ids = triangles->GetCellData()->GetArray(vtkFlowStatus::IdArray());
  if (ids && ids->GetNumberOfTuples() > 0)
  {
    const double offset = id - ids->GetComponent(0, 0);
    for (vtkIdType c = 0; c < ids->GetNumberOfTuples(); ++c)
    {
      ids->SetComponent(c, 0, ids->GetComponent(c, 0) + offset);
    }
  }
  return triangles;
}

// Hides the cells of which no corner has reached a surface, unless those are all cells.
void HideCells(vtkDataSet* samples)
{
  vtkDataArray* statuses = samples->GetPointData()->GetArray(vtkFlowStatus::StatusArray());
  vtkUnsignedCharArray* before = samples->GetCellGhostArray();
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(samples->GetNumberOfCells());
  vtkNew<vtkIdList> points;
  bool isAnyHidden = false;
  bool isAnyReached = false;
  for (vtkIdType cell = 0; statuses && cell < samples->GetNumberOfCells(); ++cell)
  {
    samples->GetCellPoints(cell, points);
    const bool isReached = std::any_of(points->begin(), points->end(),
      [statuses](vtkIdType point)
      { return statuses->GetComponent(point, 0) == vtkFlowStatus::REACHED_SURFACE; });
    const int hidden = isReached ? 0 : vtkDataSetAttributes::HIDDENCELL;
    ghosts->SetValue(
      cell, static_cast<unsigned char>(hidden | (before ? before->GetValue(cell) : 0)));
    isAnyHidden = isAnyHidden || !isReached;
    isAnyReached = isAnyReached || isReached;
  }
  if (isAnyHidden && isAnyReached)
  {
    samples->GetCellData()->AddArray(ghosts);
  }
}
}

vtkPVImplicitFlowField::vtkPVImplicitFlowField()
{
  this->SetNumberOfInputPorts(SurfacesPort + 1);
  this->SetNumberOfOutputPorts(SurfaceOutputPort + 1);
}

vtkPVImplicitFlowField::~vtkPVImplicitFlowField() = default;

void vtkPVImplicitFlowField::RemoveAllSurfaceInputs()
{
  this->SetInputConnection(SurfacesPort, nullptr);
}

int vtkPVImplicitFlowField::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port != SurfacesPort)
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  return 1;
}

int vtkPVImplicitFlowField::FillOutputPortInformation(int port, vtkInformation* info)
{
  if (port != SurfaceOutputPort)
  {
    return this->Superclass::FillOutputPortInformation(port, info);
  }
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPolyData");
  return 1;
}

int vtkPVImplicitFlowField::RequestDataObject(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (!vtkPolyData::GetData(outputs, SurfaceOutputPort))
  {
    vtkNew<vtkPolyData> triangles;
    outputs->GetInformationObject(SurfaceOutputPort)->Set(vtkDataObject::DATA_OBJECT(), triangles);
  }
  return this->Superclass::RequestDataObject(request, inputs, outputs);
}

int vtkPVImplicitFlowField::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  for (int i = 0; i < inputs[SurfacesPort]->GetNumberOfInformationObjects(); ++i)
  {
    vtkInformation* surface = inputs[SurfacesPort]->GetInformationObject(i);
    surface->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
    surface->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
    surface->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  }
  return this->Superclass::RequestUpdateExtent(request, inputs, outputs);
}

int vtkPVImplicitFlowField::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const SurfaceList surfaces = this->CreateSurfaces(inputs[SurfacesPort]);
  for (const auto& surface : surfaces)
  {
    this->AddTerminationSurface(surface);
  }
  const int result = this->Superclass::RequestData(request, inputs, outputs);
  vtkInformation* triangles = outputs->GetInformationObject(SurfaceOutputPort);
  if (triangles->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) == 0)
  {
    this->FillSurfaceOutput(vtkPolyData::GetData(triangles));
  }
  for (const auto& surface : surfaces)
  {
    this->RemoveTerminationSurface(surface);
  }
  if (this->HideUnreached)
  {
    HideCells(vtkDataSet::GetData(outputs));
  }
  return result;
}

void vtkPVImplicitFlowField::FillSurfaceOutput(vtkPolyData* output) const
{
  vtkNew<vtkAppendPolyData> append;
  for (int i = 0; i < this->GetNumberOfUsedSurfaces(); ++i)
  {
    append->AddInputData(CreateTriangles(this->GetUsedSurface(i), this->GetUsedSurfaceId(i)));
  }
  if (append->GetNumberOfInputConnections(0) > 0)
  {
    append->Update();
    output->ShallowCopy(append->GetOutput());
    output->GetPointData()->SetActiveScalars(vtkFlowStatus::ParametersArray());
  }
}

vtkPVImplicitFlowField::SurfaceList vtkPVImplicitFlowField::CreateSurfaces(
  vtkInformationVector* inputs) const
{
  SurfaceList surfaces;
  vtkNew<vtkIdList> points;
  for (int i = 0; i < inputs->GetNumberOfInformationObjects(); ++i)
  {
    vtkPolyData* data = vtkPolyData::GetData(inputs, i);
    if (data->GetNumberOfPolys() + data->GetNumberOfStrips() > 0)
    {
      vtkNew<vtkTerminationMesh> mesh;
      mesh->SetMesh(data);
      mesh->SetPeriodicU(this->MeshPeriodicU);
      mesh->SetPeriodicV(this->MeshPeriodicV);
      surfaces.emplace_back(mesh);
    }
    for (vtkIdType line = 0; line < data->GetNumberOfLines(); ++line)
    {
      data->GetLines()->GetCellAtId(line, points);
      vtkNew<vtkTerminationTube> tube;
      tube->SetRadius(this->TubeRadius);
      for (vtkIdType p = 0; p < points->GetNumberOfIds(); ++p)
      {
        const double* x = data->GetPoint(points->GetId(p));
        tube->AddPoint(x[0], x[1], x[2]);
      }
      surfaces.emplace_back(tube);
    }
  }
  return surfaces;
}

void vtkPVImplicitFlowField::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TubeRadius: " << this->TubeRadius << "\n";
  os << indent << "MeshPeriodicU: " << this->MeshPeriodicU << "\n";
  os << indent << "MeshPeriodicV: " << this->MeshPeriodicV << "\n";
  os << indent << "HideUnreached: " << this->HideUnreached << "\n";
}
