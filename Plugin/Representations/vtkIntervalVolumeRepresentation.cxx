// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIntervalVolumeRepresentation.h"

#include "vtkConstantScalars.h"
#include "vtkDrawingPass.h"
#include "vtkGridExchange.h"
#include "vtkPieceProcesses.h"
#include "vtkSelectionIds.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkVolumeFunctions.h"

#include "vtkAlgorithmOutput.h"
#include "vtkAppendFilter.h"
#include "vtkCommand.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODVolume.h"
#include "vtkPVRenderView.h"
#include "vtkPVSession.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPVView.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkProcessModule.h"
#include "vtkRenderer.h"
#include "vtkTrivialProducer.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeRepresentationPreprocessor.h"
#include "vtkVolumeProperty.h"

#include <cstring>
#include <set>

namespace
{
const char* const MAPPER_NAME = "Interlume";
const char* const AUTOMATIC_DELTA_T = "DeltaT";
/// Arrays with more components do not contain colors; the transfer functions are used instead.
constexpr int MAXIMUM_COLOR_COMPONENTS = 4;

/// Port of the view's data for the boundary triangles.
constexpr int BOUNDARY_PORT = 1;

/// Returns a dataset, or the blocks of a composite dataset as one grid; null if there is none.
vtkSmartPointer<vtkDataSet> MergeBlocks(vtkDataObject* data)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(data);
  if (!composite)
  {
    return vtkDataSet::SafeDownCast(data);
  }
  vtkNew<vtkAppendFilter> append;
  auto blocks = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (blocks->InitTraversal(); !blocks->IsDoneWithTraversal(); blocks->GoToNextItem())
  {
    append->AddInputDataObject(blocks->GetCurrentDataObject());
  }
  append->Update();
  return append->GetOutput();
}

/// Returns true if one process has the data, renders, and is the client.
bool IsOneProcess()
{
  vtkProcessModule* module = vtkProcessModule::GetProcessModule();
  auto* session = vtkPVSession::SafeDownCast(module ? module->GetActiveSession() : nullptr);
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  return session && session->HasProcessRole(vtkPVSession::CLIENT) &&
    session->HasProcessRole(vtkPVSession::RENDER_SERVER) &&
    (!controller || controller->GetNumberOfProcesses() == 1);
}
}

vtkStandardNewMacro(vtkIntervalVolumeRepresentation);

vtkIntervalVolumeRepresentation::vtkIntervalVolumeRepresentation()
  : IsLocal(IsOneProcess())
  , Functions(std::make_unique<vtkVolumeFunctions>())
  , Constant(std::make_unique<vtkConstantScalars>())
  , SelectionIds(std::make_unique<vtkSelectionIds>())
{
  this->SetNumberOfInputPorts(2);
  this->SetMapper(vtkNew<vtkTimeWeightedTetrahedraMapper>());
  this->vtkUnstructuredGridVolumeRepresentation::SetActiveVolumeMapper(MAPPER_NAME);
}

vtkIntervalVolumeRepresentation::~vtkIntervalVolumeRepresentation()
{
  if (this->ViewRenderer)
  {
    this->ViewRenderer->RemoveObserver(this->Observer);
  }
}

void vtkIntervalVolumeRepresentation::SetMapper(vtkTimeWeightedTetrahedraMapper* mapper)
{
  this->Mapper = mapper;
  this->AddVolumeMapper(MAPPER_NAME, mapper);
}

void vtkIntervalVolumeRepresentation::SetBoundaryColor(
  int id, double red, double green, double blue, double opacity)
{
  vtkNew<vtkProperty> property;
  property->SetColor(red, green, blue);
  property->SetOpacity(opacity);
  this->Mapper->SetBoundaryProperty(id, property);
}

void vtkIntervalVolumeRepresentation::RemoveAllBoundaryColors()
{
  this->Mapper->RemoveAllBoundaryIds();
}

int vtkIntervalVolumeRepresentation::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkIntervalVolumeRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->Boundary = nullptr;
  if (inputs[1]->GetNumberOfInformationObjects() > 0)
  {
    this->Boundary = MergeBlocks(vtkDataObject::GetData(inputs[1], 0));
  }
  return this->Superclass::RequestData(request, inputs, outputs);
}

void vtkIntervalVolumeRepresentation::UpdateBoundary(vtkInformation* view)
{
  auto* boundary =
    vtkDataSet::SafeDownCast(vtkPVRenderView::GetDeliveredPiece(view, this, BOUNDARY_PORT));
  const bool isEmpty = !boundary || boundary->GetNumberOfCells() == 0;
  vtkDataObject* before = this->Mapper->GetNumberOfInputConnections(1) > 0
    ? this->Mapper->GetInputDataObject(1, 0)
    : nullptr;
  if (before != (isEmpty ? nullptr : boundary))
  {
    this->Mapper->SetBoundaryData(isEmpty ? nullptr : boundary);
  }
  for (const int id : this->Mapper->GetBoundaryIds())
  {
    this->Mapper->GetBoundaryProperty(id)->SetSpecular(
      this->Mapper->GetBoundaryProperty()->GetSpecular());
  }
}

bool vtkIntervalVolumeRepresentation::AddToView(vtkView* view)
{
  if (!this->Superclass::AddToView(view))
  {
    return false;
  }
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  renderView->RegisterPropForHardwareSelection(this, this->Actor);
  this->ViewRenderer = renderView->GetRenderer();
  this->Observer = this->ViewRenderer->AddObserver(
    vtkCommand::StartEvent, this, &vtkIntervalVolumeRepresentation::OnRenderStart);
  return true;
}

bool vtkIntervalVolumeRepresentation::RemoveFromView(vtkView* view)
{
  if (this->ViewRenderer)
  {
    this->ViewRenderer->RemoveObserver(this->Observer);
    this->ViewRenderer = nullptr;
    vtkPVRenderView::SafeDownCast(view)->UnRegisterPropForHardwareSelection(this, this->Actor);
  }
  return this->Superclass::RemoveFromView(view);
}

void vtkIntervalVolumeRepresentation::SetActiveAssembly(const char* name)
{
  this->SelectionIds->GetPreprocessor()->SetAssemblyName(name);
  this->Superclass::SetActiveAssembly(name);
}

void vtkIntervalVolumeRepresentation::AddBlockSelector(const char* selector)
{
  this->SelectionIds->GetPreprocessor()->AddSelector(selector);
  this->Superclass::AddBlockSelector(selector);
}

void vtkIntervalVolumeRepresentation::RemoveAllBlockSelectors()
{
  this->SelectionIds->GetPreprocessor()->ClearSelectors();
  this->Superclass::RemoveAllBlockSelectors();
}

void vtkIntervalVolumeRepresentation::UpdateSelectionIds()
{
  auto* drawn = vtkUnstructuredGrid::SafeDownCast(this->Mapper->GetDataSetInput());
  auto* made = vtkUnstructuredGrid::SafeDownCast(this->Preprocessor->GetOutputDataObject(0));
  vtkDataObject* input =
    this->GetNumberOfInputConnections(0) > 0 ? this->GetInputDataObject(0, 0) : nullptr;
  if (input && drawn && made && drawn->GetCells() == made->GetCells())
  {
    this->Mapper->SetSelectionIds(this->SelectionIds->Update(input, made));
    return;
  }
  // The tetrahedra are from other processes and their ids are unknown. Select nothing.
  vtkNew<vtkUnstructuredGrid> unknown;
  this->Mapper->SetSelectionIds(unknown);
}

void vtkIntervalVolumeRepresentation::OnRenderStart()
{
  if (this->ViewRenderer->GetSelector() && this->GetVisibility())
  {
    this->UpdateSelectionIds();
  }
  if (this->IsSingleImage && this->GetVisibility())
  {
    vtkDrawingPass(this->ViewRenderer).RenderOnAllProcesses();
  }
}

void vtkIntervalVolumeRepresentation::SetColor(vtkColorTransferFunction* color)
{
  this->Functions->SetColor(color);
}

void vtkIntervalVolumeRepresentation::SetScalarOpacity(vtkPiecewiseFunction* opacity)
{
  this->Functions->SetScalarOpacity(opacity);
}

void vtkIntervalVolumeRepresentation::SetOpacity(double opacity)
{
  this->Functions->SetOpacity(opacity);
}

void vtkIntervalVolumeRepresentation::SetSolidColor(double red, double green, double blue)
{
  this->Functions->SetSolidColor(red, green, blue);
}

void vtkIntervalVolumeRepresentation::SetDeltaTArrayName(const char* name)
{
  const bool isAutomatic = name && std::strcmp(name, AUTOMATIC_DELTA_T) == 0;
  this->Mapper->SetDeltaTArrayName(isAutomatic ? nullptr : name ? name : "");
}

vtkAlgorithmOutput* vtkIntervalVolumeRepresentation::GetInternalOutputPort(int port, int connection)
{
  vtkAlgorithmOutput* output = this->Superclass::GetInternalOutputPort(port, connection);
  auto* partitions = output ? vtkPartitionedDataSet::SafeDownCast(
                                output->GetProducer()->GetOutputDataObject(output->GetIndex()))
                            : nullptr;
  if (!partitions)
  {
    return output;
  }
  vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetPartitionedDataSet(0, partitions);
  this->Collection->SetOutput(collection);
  return this->Collection->GetOutputPort();
}

int vtkIntervalVolumeRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (request == vtkPVView::REQUEST_UPDATE_LOD() && this->DrawsSubsets())
  {
    // The superclass would extract and simplify the surface of all tetrahedra.
    vtkNew<vtkPolyData> noSurface;
    vtkPVRenderView::SetPieceLOD(inInfo, this, noSurface);
    return this->vtkVolumeRepresentation::ProcessViewRequest(request, inInfo, outInfo);
  }
  if (!this->Superclass::ProcessViewRequest(request, inInfo, outInfo))
  {
    return 0;
  }
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    // The view keeps a piece until another replaces it.
    const vtkSmartPointer<vtkDataSet> none = vtkSmartPointer<vtkPolyData>::New();
    vtkPVRenderView::SetPiece(
      inInfo, this, this->Boundary ? this->Boundary : none, 0, BOUNDARY_PORT);
    this->ConfigureCompositing(inInfo);
  }
  if (request != vtkPVView::REQUEST_RENDER())
  {
    return 1;
  }
  const bool isReduced = inInfo->Has(vtkPVRenderView::USE_LOD()) != 0;
  if (!this->Actor->GetMapper() && vtkPieceProcesses::Find(this->GetView(), isReduced))
  {
    // A process without data participates in the compositing with an empty grid.
    vtkNew<vtkUnstructuredGrid> emptyGrid;
    this->Mapper->SetInputData(emptyGrid);
    this->Actor->SetMapper(this->Mapper);
  }
  this->UpdateBoundary(inInfo);
  if (this->Actor->GetMapper())
  {
    vtkDataArray* scalars = this->FindScalars();
    this->Functions->Apply(this->Property, scalars != nullptr);
    if (scalars && scalars->GetNumberOfComponents() > MAXIMUM_COLOR_COMPONENTS)
    {
      this->Property->SetIndependentComponents(true);
    }
    if (!scalars)
    {
      this->Mapper->SetInputConnection(
        this->Constant->Update(this->Mapper->GetDataSetInput())->GetOutputPort());
      this->Mapper->SetScalarModeToUsePointFieldData();
      this->Mapper->SelectScalarArray(vtkConstantScalars::GetArrayName());
      this->LODMapper->SetScalarVisibility(0);
    }
    if (this->DrawsSubsets())
    {
      this->Actor->SetEnableLOD(0);
    }
  }
  this->GatherPieces(isReduced);
  return 1;
}

bool vtkIntervalVolumeRepresentation::DrawsSubsets() const
{
  return this->IsLocal && this->Mapper->GetAutoAdjustLevelOfDetail();
}

void vtkIntervalVolumeRepresentation::ConfigureCompositing(vtkInformation* view)
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  if (!controller || controller->GetNumberOfProcesses() == 1)
  {
    return;
  }
  auto* piece = vtkDataSet::SafeDownCast(this->Preprocessor->GetOutputDataObject(0));
  this->HaveExtentInTime =
    vtkPieceProcesses::IsAnywhere(controller, this->Mapper->HasExtentInTime(piece));
  this->AreBoundsDisjoint = vtkPieceProcesses::AreDisjoint(controller, this->DataBounds);
  const int blend = this->Mapper->GetBlendMode();
  const bool isOrdered = blend == vtkUnstructuredGridVolumeMapper::COMPOSITE_BLEND ||
    (blend == vtkTimeWeightedTetrahedraMapper::AUTOMATIC_BLEND && !this->HaveExtentInTime);
  if (this->AreBoundsDisjoint || !vtkGridExchange::IsPossible())
  {
    vtkPVRenderView::SetOrderedCompositingConfiguration(
      view, this, vtkPVRenderView::USE_BOUNDS_FOR_REDISTRIBUTION, this->DataBounds);
  }
  else if (!isOrdered || this->HaveExtentInTime)
  {
    // Do not redistribute the cells. Either the blend mode does not depend on their order, or they
    // have an extent in time, and redistribution would merge points that have equal positions but
    // different times.
    vtkPVRenderView::SetOrderedCompositingConfiguration(
      view, this, vtkPVRenderView::USE_DATA_FOR_LOAD_BALANCING);
  }
}

void vtkIntervalVolumeRepresentation::GatherPieces(bool isReduced)
{
  vtkMultiProcessController* controller = vtkPieceProcesses::Find(this->GetView(), isReduced);
  const bool hasDisplays = vtkPieceProcesses::HaveDisplays();
  auto* view = vtkPVRenderView::SafeDownCast(this->GetView());
  this->IsSingleImage = this->Mapper->GatherPieces(
    hasDisplays ? nullptr : controller, view ? view->GetRenderWindow() : nullptr);
  if (!controller || this->IsSingleImage)
  {
    return;
  }
  const int blend = this->Mapper->GetBlendMode();
  if (blend != vtkUnstructuredGridVolumeMapper::COMPOSITE_BLEND && hasDisplays)
  {
    this->WarnOnce(
      "On tiled displays and in caves, each process renders its own cells only. With a BlendMode "
      "other than Composite, colors are wrong where cells of several processes overlap in the "
      "image. Use "
      "Composite, or render with one process.");
  }
  else if (blend == vtkUnstructuredGridVolumeMapper::COMPOSITE_BLEND && this->HaveExtentInTime)
  {
    this->WarnOnce(
      "Tetrahedra with an extent in time overlap and have no order. With the BlendMode "
      "Composite, the image therefore depends on the number of processes. Use "
      "Automatic or Optical Depth instead.");
  }
  else if (!this->AreBoundsDisjoint && !vtkGridExchange::IsPossible())
  {
    this->WarnOnce(
      "These processes cannot send each other grids, because VTK before 9.3 (ParaView before 5.12) "
      "does not read them with the installed expat library (VTK issue 19258). Interval Volume "
      "renders the cells of each process in place, and composites the processes from back to "
      "front. With the BlendMode Composite, colors may be in the wrong order where the bounds of "
      "two processes overlap. Use another BlendMode, or a newer ParaView.");
  }
}

void vtkIntervalVolumeRepresentation::WarnOnce(const std::string& text)
{
  static std::set<std::string> issued;
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  if (controller->GetLocalProcessId() == 0 && issued.insert(text).second)
  {
    vtkWarningMacro(<< text);
  }
}

vtkDataArray* vtkIntervalVolumeRepresentation::FindScalars()
{
  vtkDataSet* grid = this->Mapper->GetDataSetInput();
  const char* name = this->Mapper->GetArrayName();
  if (!grid || !name || !*name || this->Mapper->GetScalarMode() == VTK_SCALAR_MODE_USE_FIELD_DATA)
  {
    return nullptr;
  }
  int isOfCells = 0;
  return vtkAbstractMapper::GetScalars(grid, this->Mapper->GetScalarMode(),
    this->Mapper->GetArrayAccessMode(), this->Mapper->GetArrayId(), name, isOfCells);
}

void vtkIntervalVolumeRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mapper:\n";
  this->Mapper->PrintSelf(os, indent.GetNextIndent());
}
