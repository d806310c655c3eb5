// SPDX-License-Identifier: BSD-3-Clause
#include "vtkImplicitFlowVolumeMapper.h"

#include "Draw/FlowVolumeRenderer.h"
#include "Offscreen/PeelingDeferral.h"

#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkImplicitFlowVolumeMapper);

vtkImplicitFlowVolumeMapper::vtkImplicitFlowVolumeMapper()
  : Peels(std::make_unique<interlume::PeelingDeferral>())
  , Renderer(std::make_unique<interlume::FlowVolumeRenderer>())
{
  interlume::FlowVolumeRenderReport().CopyTo(this->Report);
}

vtkImplicitFlowVolumeMapper::~vtkImplicitFlowVolumeMapper() = default;

int vtkImplicitFlowVolumeMapper::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port != 0)
  {
    return 0;
  }
  // Accept all datasets here, because Render reports a more helpful error for other types.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  return 1;
}

void vtkImplicitFlowVolumeMapper::SetInflowTexture(int id, vtkImageData* image)
{
  if (id < ALL)
  {
    vtkErrorMacro(<< "SetInflowTexture: " << id << " is not a valid termination surface id. "
                  << "Pass ALL or a nonnegative id.");
    return;
  }
  if (this->GetInflowTexture(id) == image)
  {
    return;
  }
  if (image)
  {
    this->InflowTextures[id] = image;
  }
  else
  {
    this->InflowTextures.erase(id);
  }
  this->Modified();
}

void vtkImplicitFlowVolumeMapper::RemoveAllInflowTextures()
{
  if (!this->InflowTextures.empty())
  {
    this->InflowTextures.clear();
    this->Modified();
  }
}

vtkImageData* vtkImplicitFlowVolumeMapper::GetInflowTexture(int id) const
{
  const auto found = this->InflowTextures.find(id);
  return found != this->InflowTextures.end() ? found->second.Get() : nullptr;
}

vtkCxxSetSmartPointerMacro(vtkImplicitFlowVolumeMapper, DetailTexture, vtkImageData);

vtkCxxSetSmartPointerMacro(vtkImplicitFlowVolumeMapper, TimeGate, vtkPiecewiseFunction);

void vtkImplicitFlowVolumeMapper::SetName(std::string& member, const char* name)
{
  const std::string value = name ? name : "";
  if (value != member)
  {
    member = value;
    this->Modified();
  }
}

void vtkImplicitFlowVolumeMapper::SetLightBufferSize(int size)
{
  const int clamped = size <= 0 ? 0 : std::min(std::max(size, 16), 8192);
  if (clamped != this->LightBufferSize)
  {
    this->LightBufferSize = clamped;
    this->Modified();
  }
}

void vtkImplicitFlowVolumeMapper::SetOpacityArray(const char* name)
{
  this->SetName(this->OpacityArray, name);
}

void vtkImplicitFlowVolumeMapper::SetShadingArray(const char* name)
{
  this->SetName(this->ShadingArray, name);
}

vtkMTimeType vtkImplicitFlowVolumeMapper::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  const auto include = [&time](vtkObject* part)
  { time = part ? std::max(time, part->GetMTime()) : time; };
  for (const auto& [id, image] : this->InflowTextures)
  {
    include(image);
  }
  include(this->DetailTexture);
  include(this->TimeGate);
  return time;
}

interlume::Error vtkImplicitFlowVolumeMapper::Draw(
  vtkRenderer* renderer, vtkVolume* volume, interlume::FlowVolumeRenderReport& report)
{
  vtkDataSet* input = this->GetInput();
  if (this->BlendMode != COMPOSITE_BLEND)
  {
    return "Only the composite blend mode is supported. Call SetBlendModeToComposite().";
  }
  auto* image = vtkImageData::SafeDownCast(input);
  if (!image)
  {
    return std::string("The input is a ") + input->GetClassName() +
      ", but vtkImageData is required. Use SAMPLES_OF_IMAGE of vtkImplicitFlowField.";
  }
  return this->Renderer->Render(renderer, volume, *this, image, report);
}

bool vtkImplicitFlowVolumeMapper::GetRefinementPending() const
{
  return this->Renderer->IsRefinementPending();
}

void vtkImplicitFlowVolumeMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  if (this->Peels->Defer(this, renderer, volume))
  {
    return;
  }
  vtkDataSet* input = this->GetInput();
  interlume::FlowVolumeRenderReport report;
  report.CopyTo(this->Report);
  int size[2];
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  if (!input || input->GetNumberOfPoints() == 0 || size[0] <= 0 || size[1] <= 0)
  {
    return;
  }
  const interlume::Error error = this->Draw(renderer, volume, report);
  report.CopyTo(this->Report);
  this->TimeToDraw = report.Seconds;
  const vtkMTimeType state = std::max(input->GetMTime(), this->GetMTime());
  if (error && (state != this->ErrorTime || error.GetMessage() != this->ErrorText))
  {
    vtkErrorMacro(<< error);
    this->ErrorTime = state;
    this->ErrorText = error.GetMessage();
  }
  if (!error && report.NonFiniteSamples > 0 && input->GetMTime() != this->WarningTime)
  {
    vtkWarningMacro(
      << report.NonFiniteSamples << " samples have texture coordinates, times or array "
      << "values that are not finite. Samples without finite coordinates or times "
      << "are drawn as if they had reached no surface; other non-finite values are treated as 0.");
    this->WarningTime = input->GetMTime();
  }
}

void vtkImplicitFlowVolumeMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Renderer->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkImplicitFlowVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "InflowTextures: " << this->InflowTextures.size() << "\n";
  for (const auto& [id, image] : this->InflowTextures)
  {
    os << indent.GetNextIndent() << "InflowTexture " << id << ": " << image.Get() << "\n";
  }
  os << indent << "DefaultColor: " << this->DefaultColor[0] << ", " << this->DefaultColor[1] << ", "
     << this->DefaultColor[2] << ", " << this->DefaultColor[3] << "\n";
  os << indent << "DetailTexture: " << this->DetailTexture.Get() << "\n";
  os << indent << "DetailMode: " << this->DetailMode << "\n";
  os << indent << "DetailScale: " << this->DetailScale[0] << ", " << this->DetailScale[1] << ", "
     << this->DetailScale[2] << "\n";
  os << indent << "TimeGate: " << this->TimeGate.Get() << "\n";
  os << indent << "TimeGateTarget: " << this->TimeGateTarget << "\n";
  os << indent << "TimeGateRepeat: " << this->TimeGateRepeat << "\n";
  os << indent << "TimePeriod: " << this->TimePeriod << "\n";
  os << indent << "TimePhase: " << this->TimePhase << "\n";
  os << indent << "OpacityArray: " << this->OpacityArray << "\n";
  os << indent << "ShadingArray: " << this->ShadingArray << "\n";
  os << indent << "Shadows: " << this->Shadows << "\n";
  os << indent << "LightBufferSize: " << this->LightBufferSize << "\n";
  os << indent << "TextureFilter: " << this->TextureFilter << "\n";
  os << indent << "MaximumTextureSamples: " << this->MaximumTextureSamples << "\n";
  os << indent << "SampleDistance: " << this->SampleDistance << "\n";
  os << indent << "ImageSampleDistance: " << this->ImageSampleDistance << "\n";
  os << indent << "ProgressiveRendering: " << this->ProgressiveRendering << "\n";
  os << indent << "MaximumTextureMemory: " << this->MaximumTextureMemory << "\n";
  os << indent << "Report:\n";
  this->Report->PrintSelf(os, indent.GetNextIndent());
}
