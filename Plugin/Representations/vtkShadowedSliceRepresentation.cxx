// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowedSliceRepresentation.h"

#include "vtkConstantScalars.h"
#include "vtkImageBlocks.h"
#include "vtkImageComponent.h"
#include "vtkPieceProcesses.h"
#include "vtkPieceSliceMapper.h"
#include "vtkSceneShadows.h"
#include "vtkVolumeFunctions.h"

#include "vtkColorTransferFunction.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODVolume.h"
#include "vtkPVRenderView.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderer.h"
#include "vtkTrivialProducer.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <vector>

vtkStandardNewMacro(vtkShadowedSliceRepresentation);

vtkShadowedSliceRepresentation::vtkShadowedSliceRepresentation()
  : Component(std::make_unique<vtkImageComponent>())
  , Functions(std::make_unique<vtkVolumeFunctions>())
  , Constant(std::make_unique<vtkConstantScalars>())
{
  this->SetMapper(vtkNew<vtkPieceSliceMapper>());
  this->Property->SetInterpolationTypeToLinear();
  this->Property->SetShade(true);
}

vtkShadowedSliceRepresentation::~vtkShadowedSliceRepresentation()
{
  this->ViewRenderer = nullptr;
  this->UpdateSceneShadows();
}

void vtkShadowedSliceRepresentation::SetMapper(vtkPieceSliceMapper* mapper)
{
  this->Mapper = mapper;
  this->VolumeMapper = mapper;
}

void vtkShadowedSliceRepresentation::SetColor(vtkColorTransferFunction* color)
{
  this->Functions->SetColor(color);
  // The superclass reads the vector component from this function when it combines the color and
  // opacity arrays, before the first rendering.
  this->Property->SetColor(color);
}

void vtkShadowedSliceRepresentation::SetScalarOpacity(vtkPiecewiseFunction* opacity)
{
  this->Functions->SetScalarOpacity(opacity);
}

void vtkShadowedSliceRepresentation::SetOpacity(double opacity)
{
  this->Functions->SetOpacity(opacity);
}

void vtkShadowedSliceRepresentation::SetSolidColor(double red, double green, double blue)
{
  this->Functions->SetSolidColor(red, green, blue);
}

void vtkShadowedSliceRepresentation::AddScatteringAlbedoPoint(
  double scalar, double red, double green, double blue)
{
  this->Albedo->AddRGBPoint(scalar, red, green, blue);
}

void vtkShadowedSliceRepresentation::RemoveAllScatteringAlbedoPoints()
{
  this->Albedo->RemoveAllPoints();
}

void vtkShadowedSliceRepresentation::AddPhaseTablePoint(double cosine, double value)
{
  this->PhaseTable->AddPoint(cosine, value);
  this->Mapper->SetPhaseTable(this->PhaseTable);
}

void vtkShadowedSliceRepresentation::RemoveAllPhaseTablePoints()
{
  this->PhaseTable->RemoveAllPoints();
  this->Mapper->SetPhaseTable(nullptr);
}

void vtkShadowedSliceRepresentation::SetColoredShadows(bool colored)
{
  this->ColoredShadows = colored;
}

void vtkShadowedSliceRepresentation::SetSceneShadows(bool shadows)
{
  this->HasSceneShadows = shadows;
  this->UpdateSceneShadows();
}

void vtkShadowedSliceRepresentation::SetSceneDepthMapResolution(int resolution)
{
  this->SceneDepthMapResolution = resolution;
  this->UpdateSceneShadows();
}

void vtkShadowedSliceRepresentation::SetSceneDepthBias(double bias)
{
  this->SceneDepthBias = bias;
  this->UpdateSceneShadows();
}

void vtkShadowedSliceRepresentation::SetViewLightAngle(double angle)
{
  this->ViewLightAngle = std::clamp(angle, 0.0, 90.0);
  this->UpdateSceneShadows();
}

void vtkShadowedSliceRepresentation::SetViewLightScale(double scale)
{
  this->ViewLightScale = std::clamp(scale, 0.0, 1.0);
  this->UpdateSceneShadows();
}

void vtkShadowedSliceRepresentation::SetShadowGridResolution(int resolution)
{
  this->ShadowGridResolution = std::clamp(resolution, 0, 256);
}

int vtkShadowedSliceRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* input, vtkInformation* output)
{
  const int result = this->Superclass::ProcessViewRequest(request, input, output);
  if (result && request == vtkPVView::REQUEST_RENDER())
  {
    this->GatherPieces(input->Has(vtkPVRenderView::USE_LOD()) != 0);
  }
  return result;
}

void vtkShadowedSliceRepresentation::GatherPieces(bool isReduced)
{
  if (vtkMultiProcessController* controller = vtkPieceProcesses::Find(this->GetView(), isReduced))
  {
    const int resolution = this->Mapper->GetShadows() ? this->ShadowGridResolution : 0;
    this->Mapper->GatherPieces(this->Property, resolution, controller);
  }
}

void vtkShadowedSliceRepresentation::SetVisibility(bool visible)
{
  this->Superclass::SetVisibility(visible);
  this->UpdateSceneShadows();
}

bool vtkShadowedSliceRepresentation::AddToView(vtkView* view)
{
  if (!this->Superclass::AddToView(view))
  {
    return false;
  }
  this->ViewRenderer = vtkPVRenderView::SafeDownCast(view)->GetRenderer();
  this->UpdateSceneShadows();
  return true;
}

bool vtkShadowedSliceRepresentation::RemoveFromView(vtkView* view)
{
  this->ViewRenderer = nullptr;
  this->UpdateSceneShadows();
  return this->Superclass::RemoveFromView(view);
}

void vtkShadowedSliceRepresentation::UpdateSceneShadows()
{
  if (this->SceneShadows)
  {
    this->SceneShadows->RemoveRequest(this);
  }
  const double scale = this->IsAreaLightOn() ? this->ViewLightScale : 1.0;
  const bool isNeeded = this->HasSceneShadows || this->ViewLightAngle > 0.0 || scale < 1.0;
  if (!isNeeded || !this->GetVisibility() || !this->ViewRenderer)
  {
    this->SceneShadows = nullptr;
    return;
  }
  this->SceneShadows = vtkSceneShadows::GetOrCreate(this->ViewRenderer);
  this->SceneShadows->SetRequest(this,
    { this->HasSceneShadows, this->Mapper, this->SceneDepthMapResolution, this->SceneDepthBias,
      this->ViewLightAngle, scale });
}

int vtkShadowedSliceRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = GetInput(inputVector);
  if (!input || vtkImageData::SafeDownCast(input))
  {
    return this->ShowImage(vtkImageData::SafeDownCast(input), request, inputVector, outputVector);
  }
  std::vector<vtkDataSet*> parts;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    parts = vtkCompositeDataSet::GetDataSets(composite);
  }
  else
  {
    parts.push_back(vtkDataSet::SafeDownCast(input));
  }
  const vtkImageBlocks blocks(parts);
  vtkNew<vtkImageData> emptyImage;
  vtkImageData* image = blocks.GetImage() ? blocks.GetImage() : emptyImage.Get();
  if (!blocks.GetImage() && !parts.empty())
  {
    vtkErrorMacro("Shadowed Slices requires an image, but the input is a "
      << input->GetClassName() << " with " << parts.size() << " datasets (the first: "
      << (parts[0] ? parts[0]->GetClassName() : "null") << "). Resample the input to an image.");
  }
  else if (blocks.GetNumberOfSkippedDatasets() > 0)
  {
    vtkWarningMacro(
      "Shadowed Slices renders one image, or several images on one grid that together fill a box. "
      << blocks.GetNumberOfSkippedDatasets() << " of the " << parts.size()
      << " input datasets are not rendered. Resample the input to one image.");
  }
  return this->ShowImage(image, request, inputVector, outputVector);
}

int vtkShadowedSliceRepresentation::ShowImage(vtkImageData* image, vtkInformation* request,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // To use an opacity array, the superclass requires that both it and the color array exist.
  const bool hasOpacityArray = this->UseSeparateOpacityArray;
  this->UseSeparateOpacityArray = hasOpacityArray && this->CanCombineArrays(image);
  if (hasOpacityArray && !this->UseSeparateOpacityArray && image && this->FindColors(image))
  {
    vtkWarningMacro("The opacity array '" << this->OpacityArrayName
                                          << "' is ignored, because it does not exist or because "
                                             "only one of the opacity and color arrays "
                                             "is a point array. Select another Opacity Array.");
  }
  const int result = image ? this->RequestDataOf(image, request, inputVector, outputVector)
                           : this->Superclass::RequestData(request, inputVector, outputVector);
  this->UseSeparateOpacityArray = hasOpacityArray;
  return result;
}

vtkDataArray* vtkShadowedSliceRepresentation::FindColors(vtkDataSet* data)
{
  vtkInformation* array = this->GetInputArrayInformation(0);
  const char* name = array ? array->Get(vtkDataObject::FIELD_NAME()) : nullptr;
  const int association = name ? array->Get(vtkDataObject::FIELD_ASSOCIATION()) : -1;
  const bool isOfData = association == vtkDataObject::FIELD_ASSOCIATION_POINTS ||
    association == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  return isOfData && *name ? data->GetAttributes(association)->GetArray(name) : nullptr;
}

bool vtkShadowedSliceRepresentation::CanCombineArrays(vtkDataObject* data)
{
  auto* image = vtkImageData::SafeDownCast(data);
  vtkDataArray* colors = image ? this->FindColors(image) : nullptr;
  const int association = this->OpacityArrayFieldAssociation;
  if (!colors ||
    (association != vtkDataObject::FIELD_ASSOCIATION_POINTS &&
      association != vtkDataObject::FIELD_ASSOCIATION_CELLS))
  {
    return false;
  }
  vtkDataArray* opacities =
    image->GetAttributes(association)->GetArray(this->OpacityArrayName.c_str());
  return opacities && opacities->GetNumberOfTuples() == colors->GetNumberOfTuples();
}

void vtkShadowedSliceRepresentation::UpdateMapperParameters()
{
  // The superclass cannot combine the opacity array with a missing color array.
  const bool hasOpacityArray = this->UseSeparateOpacityArray;
  this->UseSeparateOpacityArray = hasOpacityArray && this->CanCombineArrays(this->Cache);
  this->Superclass::UpdateMapperParameters();
  this->UseSeparateOpacityArray = hasOpacityArray;
  this->Actor->SetVisibility(this->GetVisibility());
  this->UpdateScalars();
}

void vtkShadowedSliceRepresentation::UpdateScalars()
{
  auto* image = vtkImageData::SafeDownCast(this->Mapper->GetInputDataObject(0, 0));
  if (!image)
  {
    return;
  }
  int isOfCells = 0;
  const char* name = this->Mapper->GetArrayName();
  vtkDataArray* scalars =
    name && *name && this->Mapper->GetScalarMode() != VTK_SCALAR_MODE_USE_FIELD_DATA
    ? vtkAbstractMapper::GetScalars(image, this->Mapper->GetScalarMode(),
        this->Mapper->GetArrayAccessMode(), this->Mapper->GetArrayId(), name, isOfCells)
    : nullptr;
  this->Functions->Apply(this->Property, scalars != nullptr);
  if (!scalars)
  {
    this->Mapper->SetInputConnection(this->Constant->Update(image)->GetOutputPort());
    this->Mapper->SetScalarModeToUsePointFieldData();
    this->Mapper->SelectScalarArray(vtkConstantScalars::GetArrayName());
  }
  int components = scalars ? scalars->GetNumberOfComponents() : 1;
  if (components == 3 || components > 4)
  {
    // Three components, or more than four, are not treated as colors. The transfer functions are
    // used instead.
    this->Property->SetIndependentComponents(true);
  }
  vtkColorTransferFunction* colors = this->Property->GetRGBTransferFunction(0);
  if (components > 1 && this->Property->GetIndependentComponents())
  {
    const bool isMagnitude = colors->GetVectorMode() != vtkScalarsToColors::COMPONENT;
    const int component = isMagnitude ? -1 : colors->GetVectorComponent() % components;
    this->Mapper->SetInputConnection(
      this->Component->Update(image, scalars, isOfCells == 0, component)->GetOutputPort());
    components = 1;
  }
  const bool isColored = this->ColoredShadows && components <= 2;
  this->Mapper->SetTransmissionColor(isColored ? colors : nullptr);
  const bool hasAlbedo = this->Albedo->GetSize() > 0 && components <= 2;
  this->Mapper->SetScatteringAlbedo(hasAlbedo ? this->Albedo.Get() : nullptr);
}

void vtkShadowedSliceRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ColoredShadows: " << this->ColoredShadows << "\n";
  os << indent << "SceneShadows: " << this->HasSceneShadows << "\n";
  os << indent << "SceneDepthMapResolution: " << this->SceneDepthMapResolution << "\n";
  os << indent << "SceneDepthBias: " << this->SceneDepthBias << "\n";
  if (this->SceneShadows)
  {
    this->SceneShadows->PrintSelf(os, indent.GetNextIndent());
  }
  os << indent << "ViewLightAngle: " << this->ViewLightAngle << "\n";
  os << indent << "ViewLightScale: " << this->ViewLightScale << "\n";
  os << indent << "ShadowGridResolution: " << this->ShadowGridResolution << "\n";
  os << indent << "Mapper:\n";
  this->Mapper->PrintSelf(os, indent.GetNextIndent());
}
