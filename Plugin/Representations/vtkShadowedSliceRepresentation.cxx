#include "vtkShadowedSliceRepresentation.h"

#include "vtkImageComponent.h"
#include "vtkProjectiveLight.h"
#include "vtkShadowedSliceMapper.h"

#include "vtkColorTransferFunction.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkTexture.h"
#include "vtkTrivialProducer.h"
#include "vtkVolumeProperty.h"

#include <vector>

vtkStandardNewMacro(vtkShadowedSliceRepresentation);

//------------------------------------------------------------------------------
vtkShadowedSliceRepresentation::vtkShadowedSliceRepresentation()
  : Component(std::make_unique<vtkImageComponent>())
{
  this->Mapper->SetMaximumNumberOfShadows(1);
  this->Property->SetInterpolationTypeToLinear();
  this->Property->SetShade(true);
  this->VolumeMapper = this->Mapper;
  this->UpdateLight();
}

//------------------------------------------------------------------------------
vtkShadowedSliceRepresentation::~vtkShadowedSliceRepresentation() = default;

//------------------------------------------------------------------------------
void vtkShadowedSliceRepresentation::SetShadows(bool shadows)
{
  this->Mapper->SetShadows(shadows);
}

//------------------------------------------------------------------------------
void vtkShadowedSliceRepresentation::SetMaximumNumberOfShadows(int number)
{
  this->Mapper->SetMaximumNumberOfShadows(number);
}

//------------------------------------------------------------------------------
void vtkShadowedSliceRepresentation::SetSliceSpacing(double spacing)
{
  this->Mapper->SetSliceSpacing(spacing);
}

//------------------------------------------------------------------------------
void vtkShadowedSliceRepresentation::SetLightBufferSize(int size)
{
  this->Mapper->SetLightBufferSize(size);
}

//------------------------------------------------------------------------------
void vtkShadowedSliceRepresentation::SetLightLookup(int lookup)
{
  this->Mapper->SetLightLookup(lookup);
}

//------------------------------------------------------------------------------
void vtkShadowedSliceRepresentation::SetImageSampleDistance(double distance)
{
  this->Mapper->SetImageSampleDistance(distance);
}

//------------------------------------------------------------------------------
void vtkShadowedSliceRepresentation::SetAutoAdjustSampleDistances(bool adjust)
{
  this->Mapper->SetAutoAdjustSampleDistances(adjust);
}

//------------------------------------------------------------------------------
void vtkShadowedSliceRepresentation::SetColoredShadows(bool colored)
{
  this->ColoredShadows = colored;
}

//------------------------------------------------------------------------------
void vtkShadowedSliceRepresentation::SetProjectiveLight(bool shines)
{
  this->LightShines = shines;
  this->UpdateLight();
}

//------------------------------------------------------------------------------
void vtkShadowedSliceRepresentation::SetProjectiveLightPositional(bool positional)
{
  this->Light->SetPositional(positional);
}

//------------------------------------------------------------------------------
void vtkShadowedSliceRepresentation::SetProjectiveLightPosition(double x, double y, double z)
{
  this->Light->SetPosition(x, y, z);
}

//------------------------------------------------------------------------------
void vtkShadowedSliceRepresentation::SetProjectiveLightFocalPoint(double x, double y, double z)
{
  this->Light->SetFocalPoint(x, y, z);
}

//------------------------------------------------------------------------------
void vtkShadowedSliceRepresentation::SetProjectiveLightViewUp(double x, double y, double z)
{
  this->Light->SetViewUp(x, y, z);
}

//------------------------------------------------------------------------------
void vtkShadowedSliceRepresentation::SetProjectiveLightScreenWidth(double width)
{
  this->Light->SetScreenSize(width, this->Light->GetScreenSize()[1]);
}

//------------------------------------------------------------------------------
void vtkShadowedSliceRepresentation::SetProjectiveLightScreenHeight(double height)
{
  this->Light->SetScreenSize(this->Light->GetScreenSize()[0], height);
}

//------------------------------------------------------------------------------
void vtkShadowedSliceRepresentation::SetProjectiveLightEdgeWidth(double width)
{
  this->Light->SetEdgeWidth(width);
}

//------------------------------------------------------------------------------
void vtkShadowedSliceRepresentation::SetProjectiveLightColor(double red, double green, double blue)
{
  this->Light->SetColor(red, green, blue);
}

//------------------------------------------------------------------------------
void vtkShadowedSliceRepresentation::SetProjectiveLightIntensity(double intensity)
{
  this->Light->SetIntensity(intensity);
}

//------------------------------------------------------------------------------
void vtkShadowedSliceRepresentation::SetProjectiveLightImage(vtkTexture* texture)
{
  this->LightImage = texture;
}

//------------------------------------------------------------------------------
void vtkShadowedSliceRepresentation::SetProjectiveLightShadows(bool shadows)
{
  this->Light->SetShadowAttenuation(shadows ? 1.0f : 0.0f);
}

//------------------------------------------------------------------------------
void vtkShadowedSliceRepresentation::SetVisibility(bool visible)
{
  this->Superclass::SetVisibility(visible);
  this->UpdateLight();
}

//------------------------------------------------------------------------------
void vtkShadowedSliceRepresentation::UpdateLight()
{
  this->Light->SetSwitch(this->LightShines && this->GetVisibility());
}

//------------------------------------------------------------------------------
bool vtkShadowedSliceRepresentation::AddToView(vtkView* view)
{
  if (!this->Superclass::AddToView(view))
  {
    return false;
  }
  vtkPVRenderView::SafeDownCast(view)->AddLight(this->Light);
  return true;
}

//------------------------------------------------------------------------------
bool vtkShadowedSliceRepresentation::RemoveFromView(vtkView* view)
{
  if (auto* renderView = vtkPVRenderView::SafeDownCast(view))
  {
    renderView->RemoveLight(this->Light);
  }
  return this->Superclass::RemoveFromView(view);
}

//------------------------------------------------------------------------------
int vtkShadowedSliceRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // Processes that only show the outline have no input.
  vtkDataObject* input = inputVector[0]->GetNumberOfInformationObjects() == 1
    ? vtkDataObject::GetData(inputVector[0], 0)
    : nullptr;
  if (!input || vtkImageData::SafeDownCast(input))
  {
    return this->Superclass::RequestData(request, inputVector, outputVector);
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
  vtkNew<vtkImageData> nothing;
  vtkImageData* image = nothing;
  if (parts.size() == 1 && vtkImageData::SafeDownCast(parts[0]))
  {
    image = vtkImageData::SafeDownCast(parts[0]);
  }
  else if (!parts.empty())
  {
    vtkErrorMacro("Shadowed Slices draws one image; the input is a "
      << input->GetClassName() << " of " << parts.size() << " datasets, the first a "
      << (parts[0] ? parts[0]->GetClassName() : "null") << ". Resample it to an image.");
  }
  vtkNew<vtkInformation> information;
  information->Copy(inputVector[0]->GetInformationObject(0));
  information->Set(vtkDataObject::DATA_OBJECT(), image);
  vtkNew<vtkInformationVector> imageVector;
  imageVector->Append(information);
  vtkInformationVector* imageVectors[] = { imageVector };
  return this->Superclass::RequestData(request, imageVectors, outputVector);
}

//------------------------------------------------------------------------------
void vtkShadowedSliceRepresentation::UpdateMapperParameters()
{
  this->Superclass::UpdateMapperParameters();
  this->UpdateScalars();
  if (this->LightImage && this->LightImage->GetInputAlgorithm())
  {
    this->LightImage->GetInputAlgorithm()->Update();
  }
  this->Light->SetImage(this->LightImage ? this->LightImage->GetInput() : nullptr);
}

//------------------------------------------------------------------------------
void vtkShadowedSliceRepresentation::UpdateScalars()
{
  auto* image = vtkImageData::SafeDownCast(this->Mapper->GetInputDataObject(0, 0));
  int isOfCells = 0;
  vtkDataArray* scalars = image
    ? vtkAbstractMapper::GetScalars(image, this->Mapper->GetScalarMode(),
        this->Mapper->GetArrayAccessMode(), this->Mapper->GetArrayId(),
        this->Mapper->GetArrayName(), isOfCells)
    : nullptr;
  if (!scalars)
  {
    return;
  }
  int components = scalars->GetNumberOfComponents();
  vtkColorTransferFunction* colors = this->Property->GetRGBTransferFunction(0);
  if (components > 1 && this->Property->GetIndependentComponents())
  {
    const bool isMagnitude = colors->GetVectorMode() != vtkScalarsToColors::COMPONENT;
    const int component = isMagnitude ? -1 : colors->GetVectorComponent() % components;
    this->Mapper->SetInputConnection(
      this->Component->Update(image, scalars, isOfCells == 0, component)->GetOutputPort());
    components = 1;
  }
  const bool isTinted = this->ColoredShadows && components <= 2;
  this->Mapper->SetTransmissionColor(isTinted ? colors : nullptr);
}

//------------------------------------------------------------------------------
void vtkShadowedSliceRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ColoredShadows: " << this->ColoredShadows << "\n";
  os << indent << "ProjectiveLight: " << this->LightShines << "\n";
  os << indent << "Light:\n";
  this->Light->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Mapper:\n";
  this->Mapper->PrintSelf(os, indent.GetNextIndent());
}
