// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowedSliceMapper.h"

#include "Common/Error.h"
#include "Common/NamedValue.h"
#include "Draw/VolumeImage.h"
#include "Offscreen/PeelingDeferral.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderer.h"
#include "vtkSliceMedium.h"
#include "vtkVolume.h"

#include <algorithm>
#include <initializer_list>

vtkStandardNewMacro(vtkShadowedSliceMapper);

namespace
{
template <typename Member, typename Value>
void SetValue(vtkObject* mapper, Member& member, Value value)
{
  if (member != value)
  {
    member = value;
    mapper->Modified();
  }
}
}

vtkShadowedSliceMapper::vtkShadowedSliceMapper()
  : Peels(std::make_unique<interlume::PeelingDeferral>())
  , Image(std::make_unique<interlume::VolumeImage>())
{
  interlume::SliceReport().CopyTo(this->Report);
}

vtkShadowedSliceMapper::~vtkShadowedSliceMapper() = default;

int vtkShadowedSliceMapper::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port != 0)
  {
    return 0;
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

void vtkShadowedSliceMapper::SetLightBufferSize(int size)
{
  SetValue(this, this->LightBufferSize, size <= 0 ? 0 : std::clamp(size, 16, 8192));
}

void vtkShadowedSliceMapper::SetTransmissionColor(vtkColorTransferFunction* function)
{
  SetValue(this, this->TransmissionColor, function);
}

void vtkShadowedSliceMapper::SetScatteringAlbedo(vtkColorTransferFunction* function)
{
  SetValue(this, this->ScatteringAlbedo, function);
}

void vtkShadowedSliceMapper::SetPhaseTable(vtkPiecewiseFunction* function)
{
  SetValue(this, this->PhaseTable, function);
}

void vtkShadowedSliceMapper::SetMedium(vtkSliceMedium* medium)
{
  SetValue(this, this->Medium, medium);
}

void vtkShadowedSliceMapper::SetScatteringGridSize(int size)
{
  SetValue(this, this->ScatteringGridSize, size <= 0 ? 0 : std::clamp(size, 4, 128));
}

vtkMTimeType vtkShadowedSliceMapper::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (vtkObject* function : std::initializer_list<vtkObject*>{
         this->TransmissionColor, this->ScatteringAlbedo, this->PhaseTable })
  {
    time = function ? std::max(time, function->GetMTime()) : time;
  }
  return time;
}

interlume::Error vtkShadowedSliceMapper::FindScalars(
  vtkImageData* image, vtkDataArray*& scalars, bool& isOfCells)
{
  int cellFlag = 0;
  scalars = vtkAbstractMapper::GetScalars(
    image, this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, cellFlag);
  if (!scalars)
  {
    return this->ArrayAccessMode == VTK_GET_ARRAY_BY_NAME && this->ArrayName && *this->ArrayName
      ? std::string("The scalar array '") + this->ArrayName +
        "' does not exist. Select an existing array with SelectScalarArray()."
      : std::string("The input has no scalars. Set its point or cell scalars, or select an array "
                    "with SelectScalarArray().");
  }
  isOfCells = cellFlag == 1 || this->ScalarMode == VTK_SCALAR_MODE_USE_CELL_FIELD_DATA;
  const vtkIdType expected = isOfCells ? image->GetNumberOfCells() : image->GetNumberOfPoints();
  if (scalars->GetNumberOfTuples() != expected)
  {
    const std::string name = scalars->GetName() ? scalars->GetName() : "(unnamed)";
    return "The scalar array '" + name + "' has " + std::to_string(scalars->GetNumberOfTuples()) +
      " tuples, but the image has " + std::to_string(expected) +
      (isOfCells ? " cells." : " points.");
  }
  return {};
}

bool vtkShadowedSliceMapper::GetRefinementPending() const
{
  return this->Image->IsRefinementPending();
}

void vtkShadowedSliceMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  if (this->Peels->Defer(this, renderer, volume))
  {
    return;
  }
  if (!this->Image->IsInScene())
  {
    this->UpdateImage(renderer, volume).Draw(renderer, nullptr);
    this->Image->End();
  }
  if (this->Image->HasContents())
  {
    this->Image->Show(renderer);
    this->TimeToDraw = this->Image->GetReport().Seconds;
    this->ReportErrors();
  }
}

interlume::VolumeImage& vtkShadowedSliceMapper::UpdateImage(
  vtkRenderer* renderer, vtkVolume* volume)
{
  auto* image = vtkImageData::SafeDownCast(this->GetInput());
  interlume::VolumeResources::Request request;
  request.Volume = volume;
  request.Image = image;
  request.Settings = *this;
  request.Medium = this->Medium;
  request.Cuts.Planes = this->ClippingPlanes;
  request.Cuts.IsCropped = this->Cropping != 0;
  std::copy_n(this->CroppingRegionPlanes, 6, request.Cuts.CroppingPlanes.begin());
  request.Cuts.CroppingFlags = this->CroppingRegionFlags;
  request.Report = this->Report;
  int width = 0;
  int height = 0;
  int left = 0;
  int bottom = 0;
  renderer->GetTiledSizeAndOrigin(&width, &height, &left, &bottom);
  interlume::Error error;
  if (image && image->GetNumberOfPoints() > 0 && width > 0 && height > 0)
  {
    error = this->BlendMode == COMPOSITE_BLEND
      ? this->FindScalars(image, request.Scalars, request.IsOfCells)
      : "Only the composite blend mode is supported. Call SetBlendModeToComposite().";
  }
  this->Image->Begin(request, error);
  return *this->Image;
}

void vtkShadowedSliceMapper::ReportErrors()
{
  const interlume::VolumeResources::Request& request = this->Image->GetRequest();
  const interlume::VolumeResources::Result& result = this->Image->GetResult();
  std::string text = result.Error.GetMessage();
  for (const std::string& warning : result.Warnings)
  {
    text += (text.empty() ? "" : "\n") + warning;
  }
  // Report an error once for each state of the input and the mapper, not for every frame.
  const vtkMTimeType state = std::max(request.Image->GetMTime(), this->GetMTime());
  if (!text.empty() && (state != this->ErrorTime || text != this->ErrorText))
  {
    if (this->Medium)
    {
      this->Medium->ReportError(text);
    }
    else
    {
      vtkErrorMacro(<< text);
    }
    this->ErrorTime = state;
    this->ErrorText = text;
  }
  const vtkIdType nonFinite = this->Image->GetReport().NonFiniteVoxels;
  if (!result.Error && nonFinite > 0 && request.Scalars->GetMTime() != this->WarningTime)
  {
    const char* name = request.Scalars->GetName();
    vtkWarningMacro(<< "The scalar array '" << (name ? name : "(unnamed)")
                    << "' has NaN or infinite values in " << nonFinite
                    << " voxels, which are rendered as transparent.");
    this->WarningTime = request.Scalars->GetMTime();
  }
}

bool vtkShadowedSliceMapper::ReadLightBuffer(
  vtkRenderer* renderer, vtkLight* light, vtkImageData* image)
{
  if (!renderer || !light || !image)
  {
    return false;
  }
  return this->Image->ReadLightBuffer(renderer, light, image);
}

void vtkShadowedSliceMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Image->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkShadowedSliceMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  interlume::NamedValue::Print(os, indent,
    { { "Shadows", this->Shadows },
      { "MaximumNumberOfShadowLights", this->MaximumNumberOfShadowLights },
      { "SliceSpacing", this->SliceSpacing }, { "LightBufferSize", this->LightBufferSize },
      { "LightLookup", this->LightLookup }, { "ImageSampleDistance", this->ImageSampleDistance },
      { "AutoAdjustSampleDistances", this->AutoAdjustSampleDistances },
      { "ProgressiveRendering", this->ProgressiveRendering },
      { "SurfaceGradient", this->SurfaceGradient }, { "TwoSidedLighting", this->TwoSidedLighting },
      { "SoftShadowMethod", this->SoftShadowMethod },
      { "NumberOfLightSamples", this->NumberOfLightSamples },
      { "TransmissionColor", this->TransmissionColor.Get() },
      { "ScatteringMode", this->ScatteringMode },
      { "ScatteringAlbedo", this->ScatteringAlbedo.Get() },
      { "PhaseFunction", this->PhaseFunction }, { "Anisotropy", this->Anisotropy },
      { "PhaseTable", this->PhaseTable.Get() },
      { "ScatteringBrightness", this->ScatteringBrightness },
      { "ForwardSpread", this->ForwardSpread }, { "BackwardLayers", this->BackwardLayers },
      { "ScatteringGridSize", this->ScatteringGridSize },
      { "MaximumTextureMemory", this->MaximumTextureMemory } });
  os << indent << "Report:\n";
  this->Report->PrintSelf(os, indent.GetNextIndent());
}
