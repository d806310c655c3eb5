#include "vtkPVImplicitFlowField.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFlowStatus.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTerminationMesh.h"
#include "vtkTerminationSurfaceSource.h"
#include "vtkTerminationTube.h"

vtkStandardNewMacro(vtkPVImplicitFlowField);

namespace
{
constexpr int SurfacesPort = 2;
// Of the outputs.
constexpr int DrawingPort = 1;

// Appends the points and triangles of a drawn surface, whose ids are moved to start at \a id.
void Append(vtkPolyData* drawn, int id, vtkPolyData* output)
{
  const vtkIdType before = output->GetNumberOfPoints();
  vtkIdType number = 0;
  const vtkIdType* corners = nullptr;
  const auto cells = vtk::TakeSmartPointer(drawn->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    cells->GetCurrentCell(number, corners);
    output->GetPolys()->InsertNextCell(
      { before + corners[0], before + corners[1], before + corners[2] });
  }
  vtkPointData* from = drawn->GetPointData();
  vtkPointData* to = output->GetPointData();
  for (vtkIdType p = 0; p < drawn->GetNumberOfPoints(); ++p)
  {
    output->GetPoints()->InsertNextPoint(drawn->GetPoint(p));
    to->GetTCoords()->InsertNextTuple(p, from->GetTCoords());
    to->GetNormals()->InsertNextTuple(p, from->GetNormals());
  }
  vtkDataArray* parts = drawn->GetCellData()->GetArray(vtkFlowStatus::IdArray());
  vtkDataArray* ids = output->GetCellData()->GetArray(vtkFlowStatus::IdArray());
  const double first = parts->GetNumberOfTuples() > 0 ? parts->GetComponent(0, 0) : 0.0;
  for (vtkIdType c = 0; c < parts->GetNumberOfTuples(); ++c)
  {
    ids->InsertNextTuple1(id + parts->GetComponent(c, 0) - first);
  }
}
}

//------------------------------------------------------------------------------
vtkPVImplicitFlowField::vtkPVImplicitFlowField()
{
  this->SetNumberOfInputPorts(SurfacesPort + 1);
  this->SetNumberOfOutputPorts(DrawingPort + 1);
}

//------------------------------------------------------------------------------
vtkPVImplicitFlowField::~vtkPVImplicitFlowField() = default;

//------------------------------------------------------------------------------
void vtkPVImplicitFlowField::RemoveAllSurfaceInputs()
{
  this->SetInputConnection(SurfacesPort, nullptr);
}

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
int vtkPVImplicitFlowField::FillOutputPortInformation(int port, vtkInformation* info)
{
  if (port != DrawingPort)
  {
    return this->Superclass::FillOutputPortInformation(port, info);
  }
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkPVImplicitFlowField::RequestDataObject(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (!vtkPolyData::GetData(outputs, DrawingPort))
  {
    vtkNew<vtkPolyData> drawing;
    outputs->GetInformationObject(DrawingPort)->Set(vtkDataObject::DATA_OBJECT(), drawing);
  }
  return this->Superclass::RequestDataObject(request, inputs, outputs);
}

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
int vtkPVImplicitFlowField::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const SurfaceList surfaces = this->MakeSurfaces(inputs[SurfacesPort]);
  for (const auto& surface : surfaces)
  {
    this->AddTerminationSurface(surface);
  }
  const int result = this->Superclass::RequestData(request, inputs, outputs);
  vtkInformation* drawing = outputs->GetInformationObject(DrawingPort);
  if (drawing->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) == 0)
  {
    this->DrawSurfaces(vtkPolyData::GetData(drawing));
  }
  for (const auto& surface : surfaces)
  {
    this->RemoveTerminationSurface(surface);
  }
  return result;
}

//------------------------------------------------------------------------------
void vtkPVImplicitFlowField::DrawSurfaces(vtkPolyData* output) const
{
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
  output->SetPoints(points);
  output->SetPolys(vtkNew<vtkCellArray>());
  output->GetPointData()->SetTCoords(parameters);
  output->GetPointData()->SetScalars(parameters);
  output->GetPointData()->SetNormals(normals);
  output->GetCellData()->AddArray(ids);
  for (int i = 0; i < this->GetNumberOfUsedSurfaces(); ++i)
  {
    vtkNew<vtkTerminationSurfaceSource> source;
    source->SetSurface(this->GetUsedSurface(i));
    source->Update();
    if (source->GetOutput()->GetNumberOfPoints() > 0)
    {
      Append(source->GetOutput(), this->GetUsedSurfaceId(i), output);
    }
  }
}

//------------------------------------------------------------------------------
vtkPVImplicitFlowField::SurfaceList vtkPVImplicitFlowField::MakeSurfaces(
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

//------------------------------------------------------------------------------
void vtkPVImplicitFlowField::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TubeRadius: " << this->TubeRadius << "\n";
  os << indent << "MeshPeriodicU: " << this->MeshPeriodicU << "\n";
  os << indent << "MeshPeriodicV: " << this->MeshPeriodicV << "\n";
}
