// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowedSliceMapper.h"

#include "Draw/SliceGroup.h"
#include "Draw/SliceRenderer.h"
#include "Receivers/SliceScene.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDepthPeels.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderer.h"
#include "vtkSliceMatter.h"
#include "vtkVolume.h"

#include <algorithm>
#include <initializer_list>

vtkStandardNewMacro(vtkShadowedSliceMapper);

vtkShadowedSliceMapper::vtkShadowedSliceMapper()
  : Peels(std::make_unique<vtkDepthPeels>())
  , Renderer(std::make_unique<interlume::SliceRenderer>())
{
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
  const int clamped = size <= 0 ? 0 : std::min(std::max(size, 16), 8192);
  if (clamped != this->LightBufferSize)
  {
    this->LightBufferSize = clamped;
    this->Modified();
  }
}

void vtkShadowedSliceMapper::SetTransmissionColor(vtkColorTransferFunction* function)
{
  if (function != this->TransmissionColor)
  {
    this->TransmissionColor = function;
    this->Modified();
  }
}

void vtkShadowedSliceMapper::SetScatteringAlbedo(vtkColorTransferFunction* function)
{
  if (function != this->ScatteringAlbedo)
  {
    this->ScatteringAlbedo = function;
    this->Modified();
  }
}

void vtkShadowedSliceMapper::SetPhaseTable(vtkPiecewiseFunction* function)
{
  if (function != this->PhaseTable)
  {
    this->PhaseTable = function;
    this->Modified();
  }
}

void vtkShadowedSliceMapper::SetMatter(vtkSliceMatter* matter)
{
  if (matter != this->Matter)
  {
    this->Matter = matter;
    this->Modified();
  }
}

void vtkShadowedSliceMapper::SetScatteringGridSize(int size)
{
  const int clamped = size <= 0 ? 0 : std::min(std::max(size, 4), 128);
  if (clamped != this->ScatteringGridSize)
  {
    this->ScatteringGridSize = clamped;
    this->Modified();
  }
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

std::string vtkShadowedSliceMapper::FindScalars(
  vtkImageData* image, vtkDataArray*& scalars, bool& isOfCells)
{
  int cellFlag = 0;
  scalars = vtkAbstractMapper::GetScalars(
    image, this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, cellFlag);
  if (!scalars)
  {
    return this->ArrayAccessMode == VTK_GET_ARRAY_BY_NAME && this->ArrayName && *this->ArrayName
      ? std::string("there is no array ") + this->ArrayName + " to draw"
      : std::string("there are no scalars to draw");
  }
  isOfCells = cellFlag == 1 || this->ScalarMode == VTK_SCALAR_MODE_USE_CELL_FIELD_DATA;
  const vtkIdType expected = isOfCells ? image->GetNumberOfCells() : image->GetNumberOfPoints();
  if (scalars->GetNumberOfTuples() != expected)
  {
    const std::string name = scalars->GetName() ? scalars->GetName() : "without a name";
    return "the array " + name + " has " + std::to_string(scalars->GetNumberOfTuples()) +
      " tuples instead of " + std::to_string(expected);
  }
  return {};
}

void vtkShadowedSliceMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  if (this->Peels->Defer(this, renderer, volume))
  {
    return;
  }
  if (this->Peels->TakeNews())
  {
    vtkWarningMacro(<< "UseDepthPeelingForVolumes is not supported: the volume is drawn over "
                       "translucent polygons, as without it");
  }
  if (this->Scene && this->Scene->Show)
  {
    this->Scene->Show();
    return;
  }
  if (this->Scene)
  {
    this->ShowAhead(renderer);
    return;
  }
  this->Draw(renderer, volume, nullptr);
}

void vtkShadowedSliceMapper::DrawAhead(
  vtkRenderer* renderer, vtkVolume* volume, interlume::SliceScene* scene)
{
  this->Draw(renderer, volume, scene);
  this->Scene = scene;
}

void vtkShadowedSliceMapper::ShowAhead(vtkRenderer* renderer)
{
  if (this->Group)
  {
    this->Group->Show(renderer);
    return;
  }
  this->Renderer->ShowLast(renderer);
}

void vtkShadowedSliceMapper::Join(
  vtkRenderer* renderer, vtkVolume* volume, interlume::SliceGroup* group)
{
  this->Draw(renderer, volume, nullptr, group);
}

bool vtkShadowedSliceMapper::TakeShare(
  const std::shared_ptr<interlume::SliceGroup>& group, interlume::SliceScene* scene)
{
  const interlume::SliceGroup::Share* share = group->Find(this->Renderer.get());
  if (!share)
  {
    return false;
  }
  this->Group = group;
  this->Scene = scene;
  this->RenderReport = share->Report;
  this->TimeToDraw = this->RenderReport.Seconds;
  auto* image = vtkImageData::SafeDownCast(this->GetInput());
  vtkDataArray* scalars = nullptr;
  bool isOfCells = false;
  this->ReportFaults(image, scalars, this->FindScalars(image, scalars, isOfCells), share->Warnings);
  return true;
}

void vtkShadowedSliceMapper::Draw(vtkRenderer* renderer, vtkVolume* volume,
  interlume::SliceScene* scene, interlume::SliceGroup* group)
{
  auto* image = vtkImageData::SafeDownCast(this->GetInput());
  int width = 0;
  int height = 0;
  int left = 0;
  int bottom = 0;
  renderer->GetTiledSizeAndOrigin(&width, &height, &left, &bottom);
  this->RenderReport = vtkShadowedSliceReport();
  if (!image || image->GetNumberOfPoints() == 0 || width <= 0 || height <= 0)
  {
    return;
  }
  interlume::SliceRenderer::Request request;
  request.Image = image;
  request.Settings = *this;
  request.Matter = this->Matter;
  request.Cuts.Planes = this->ClippingPlanes;
  request.Cuts.IsCropped = this->Cropping != 0;
  std::copy_n(this->CroppingRegionPlanes, 6, request.Cuts.CroppingPlanes.begin());
  request.Cuts.CroppingFlags = this->CroppingRegionFlags;
  request.Scene = scene;
  std::vector<std::string> warnings;
  std::string error = this->BlendMode == COMPOSITE_BLEND
    ? this->FindScalars(image, request.Scalars, request.IsOfCells)
    : std::string("blend modes other than composite are not supported");
  if (group)
  {
    if (error.empty())
    {
      group->Add(this->Renderer.get(), volume, request);
    }
    return;
  }
  this->Group.reset();
  if (error.empty())
  {
    error = this->Renderer->Render(renderer, volume, request, warnings, this->RenderReport);
  }
  else if (!scene)
  {
    this->Renderer->ShowLast(renderer);
  }
  this->TimeToDraw = this->RenderReport.Seconds;
  this->ReportFaults(image, request.Scalars, error, warnings);
}

void vtkShadowedSliceMapper::ReportFaults(vtkImageData* image, vtkDataArray* scalars,
  const std::string& error, const std::vector<std::string>& warnings)
{
  std::string text = error;
  for (const std::string& warning : warnings)
  {
    text += (text.empty() ? "" : "; ") + warning;
  }
  // An error is given once for one state of the input and of the mapper, not for every picture.
  const vtkMTimeType state = std::max(image->GetMTime(), this->GetMTime());
  if (!text.empty() && (state != this->ErrorTime || text != this->ErrorText))
  {
    if (this->Matter)
    {
      this->Matter->ReportFault(text);
    }
    else
    {
      vtkErrorMacro(<< text);
    }
    this->ErrorTime = state;
    this->ErrorText = text;
  }
  if (error.empty() && this->RenderReport.NonFiniteVoxels > 0 &&
    scalars->GetMTime() != this->WarningTime)
  {
    const char* name = scalars->GetName() ? scalars->GetName() : "without a name";
    vtkWarningMacro(<< "the array " << name << " has " << this->RenderReport.NonFiniteVoxels
                    << " voxels with NaN or infinity, which are transparent");
    this->WarningTime = scalars->GetMTime();
  }
}

bool vtkShadowedSliceMapper::ReadLightBuffer(
  vtkRenderer* renderer, vtkLight* light, vtkImageData* image)
{
  if (!renderer || !light || !image)
  {
    return false;
  }
  return this->Group ? this->Group->ReadLightBuffer(renderer, light, image)
                     : this->Renderer->ReadLightBuffer(renderer, light, image);
}

void vtkShadowedSliceMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Renderer->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkShadowedSliceMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Shadows: " << this->Shadows << "\n";
  os << indent << "MaximumNumberOfShadows: " << this->MaximumNumberOfShadows << "\n";
  os << indent << "SliceSpacing: " << this->SliceSpacing << "\n";
  os << indent << "LightBufferSize: " << this->LightBufferSize << "\n";
  os << indent << "LightLookup: " << this->LightLookup << "\n";
  os << indent << "ImageSampleDistance: " << this->ImageSampleDistance << "\n";
  os << indent << "AutoAdjustSampleDistances: " << this->AutoAdjustSampleDistances << "\n";
  os << indent << "SurfaceGradient: " << this->SurfaceGradient << "\n";
  os << indent << "TwoSidedLighting: " << this->TwoSidedLighting << "\n";
  os << indent << "SoftShadowMethod: " << this->SoftShadowMethod << "\n";
  os << indent << "NumberOfLightSamples: " << this->NumberOfLightSamples << "\n";
  os << indent << "TransmissionColor: " << this->TransmissionColor.Get() << "\n";
  os << indent << "MultipleScattering: " << this->MultipleScattering << "\n";
  os << indent << "ScatteringAlbedo: " << this->ScatteringAlbedo.Get() << "\n";
  os << indent << "PhaseFunction: " << this->PhaseFunction << "\n";
  os << indent << "Anisotropy: " << this->Anisotropy << "\n";
  os << indent << "PhaseTable: " << this->PhaseTable.Get() << "\n";
  os << indent << "ScatteringBrightness: " << this->ScatteringBrightness << "\n";
  os << indent << "ForwardSpread: " << this->ForwardSpread << "\n";
  os << indent << "BackwardLayers: " << this->BackwardLayers << "\n";
  os << indent << "ScatteringGridSize: " << this->ScatteringGridSize << "\n";
  os << indent << "MaximumTextureMemory: " << this->MaximumTextureMemory << "\n";
  os << indent << "Report:\n";
  this->RenderReport.Print(os, indent.GetNextIndent());
}
