// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIntervalVolumeRepresentation.h"

#include "vtkConstantScalars.h"
#include "vtkDrawingPass.h"
#include "vtkGridExchange.h"
#include "vtkPieceProcesses.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkVolumeFunctions.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODVolume.h"
#include "vtkPVRenderView.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPVView.h"
#include "vtkPolyDataMapper.h"
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
/// The largest number of components that are colours: with more, they are drawn by the functions.
constexpr int MOST_COLOR_COMPONENTS = 4;
}

vtkStandardNewMacro(vtkIntervalVolumeRepresentation);

vtkIntervalVolumeRepresentation::vtkIntervalVolumeRepresentation()
  : Functions(std::make_unique<vtkVolumeFunctions>())
  , Constant(std::make_unique<vtkConstantScalars>())
{
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

bool vtkIntervalVolumeRepresentation::AddToView(vtkView* view)
{
  if (!this->Superclass::AddToView(view))
  {
    return false;
  }
  this->ViewRenderer = vtkPVRenderView::SafeDownCast(view)->GetRenderer();
  this->Observer = this->ViewRenderer->AddObserver(
    vtkCommand::StartEvent, this, &vtkIntervalVolumeRepresentation::StartPicture);
  return true;
}

bool vtkIntervalVolumeRepresentation::RemoveFromView(vtkView* view)
{
  if (this->ViewRenderer)
  {
    this->ViewRenderer->RemoveObserver(this->Observer);
    this->ViewRenderer = nullptr;
  }
  return this->Superclass::RemoveFromView(view);
}

void vtkIntervalVolumeRepresentation::StartPicture()
{
  if (this->IsOnePicture && this->GetVisibility())
  {
    vtkDrawingPass(this->ViewRenderer).DrawEverywhere();
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
  if (!this->Superclass::ProcessViewRequest(request, inInfo, outInfo))
  {
    return 0;
  }
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    this->KeepPieces(inInfo);
  }
  if (request != vtkPVView::REQUEST_RENDER())
  {
    return 1;
  }
  const bool isReduced = inInfo->Has(vtkPVRenderView::USE_LOD()) != 0;
  if (!this->Actor->GetMapper() && vtkPieceProcesses::Find(this->GetView(), isReduced))
  {
    // A process without data takes part in the picture.
    vtkNew<vtkUnstructuredGrid> nothing;
    this->Mapper->SetInputData(nothing);
    this->Actor->SetMapper(this->Mapper);
  }
  if (this->Actor->GetMapper())
  {
    vtkDataArray* scalars = this->FindScalars();
    this->Functions->Apply(this->Property, scalars != nullptr);
    if (scalars && scalars->GetNumberOfComponents() > MOST_COLOR_COMPONENTS)
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
  }
  this->GatherPieces(isReduced);
  return 1;
}

void vtkIntervalVolumeRepresentation::KeepPieces(vtkInformation* view)
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  if (!controller || controller->GetNumberOfProcesses() == 1)
  {
    return;
  }
  auto* piece = vtkDataSet::SafeDownCast(this->Preprocessor->GetOutputDataObject(0));
  this->AreInTime = vtkPieceProcesses::IsAnywhere(controller, this->Mapper->HasExtentInTime(piece));
  this->AreApart = vtkPieceProcesses::AreApart(controller, this->DataBounds);
  const int blend = this->Mapper->GetBlendMode();
  const bool isOrdered = blend == vtkUnstructuredGridVolumeMapper::COMPOSITE_BLEND ||
    (blend == vtkTimeWeightedTetrahedraMapper::AUTOMATIC_BLEND && !this->AreInTime);
  if (this->AreApart || !vtkGridExchange::IsPossible())
  {
    vtkPVRenderView::SetOrderedCompositingConfiguration(
      view, this, vtkPVRenderView::USE_BOUNDS_FOR_REDISTRIBUTION, this->DataBounds);
  }
  else if (!isOrdered || this->AreInTime)
  {
    // Surfaces are put in order, pieces stay: ParaView would make points one that are at the same
    // place at different times.
    vtkPVRenderView::SetOrderedCompositingConfiguration(
      view, this, vtkPVRenderView::USE_DATA_FOR_LOAD_BALANCING);
  }
}

void vtkIntervalVolumeRepresentation::GatherPieces(bool isReduced)
{
  vtkMultiProcessController* controller = vtkPieceProcesses::Find(this->GetView(), isReduced);
  const bool hasDisplays = vtkPieceProcesses::HaveDisplays();
  auto* view = vtkPVRenderView::SafeDownCast(this->GetView());
  this->IsOnePicture = this->Mapper->GatherPieces(
    hasDisplays ? nullptr : controller, view ? view->GetRenderWindow() : nullptr);
  if (!controller || this->IsOnePicture)
  {
    return;
  }
  const int blend = this->Mapper->GetBlendMode();
  if (blend != vtkUnstructuredGridVolumeMapper::COMPOSITE_BLEND && hasDisplays)
  {
    this->WarnOnce(
      "On tiled displays and in caves each process draws its own cells: in blend modes "
      "other than Composite, colours before each other are wrong where cells of several "
      "processes lie on a line of sight.");
  }
  else if (blend == vtkUnstructuredGridVolumeMapper::COMPOSITE_BLEND && this->AreInTime)
  {
    this->WarnOnce("Tetrahedra with an extent in time overlap and have no order, so that the blend "
                   "mode Composite gives another picture for every number of processes. Automatic "
                   "and Optical Depth give the same.");
  }
  else if (!this->AreApart && !vtkGridExchange::IsPossible())
  {
    this->WarnOnce(
      "These processes cannot send each other grids: VTK before 9.3 (ParaView before 5.12) does "
      "not "
      "read them with the expat library that is installed (VTK issue 19258). In the blend mode "
      "Composite, Interval Volume draws the cells of each process where they are, one process "
      "after "
      "the other from back to front: where boxes around the cells of two processes overlap, "
      "colours "
      "there may be in the wrong order.");
  }
}

void vtkIntervalVolumeRepresentation::WarnOnce(const std::string& text)
{
  static std::set<std::string> said;
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  if (controller->GetLocalProcessId() == 0 && said.insert(text).second)
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
