// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/FlowSlices.h"

#include "Draw/FlowPicture.h"
#include "Draw/FlowShader.h"
#include "Draw/FlowTextures.h"
#include "Draw/FlowUniforms.h"

#include "vtkImplicitFlowVolumeMapper.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkSliceMedium.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <type_traits>

namespace interlume
{

/// What is painted in the image that is being drawn.
class FlowSlices::Medium : public vtkSliceMedium
{
public:
  static Medium* New() { VTK_STANDARD_NEW_BODY(Medium); }
  vtkTypeMacro(Medium, vtkSliceMedium);

  std::string GetSource() override
  {
    return FlowShader(
      this->Picture->Mapper, this->Picture->Parts, this->Scene->Paints, this->Scene->View)
      .GetSource();
  }
  bool HasReflection() override { return this->Picture->Parts.IsShaded; }
  void Activate(vtkShaderProgram* program) override
  {
    this->Textures->Activate(program);
    FlowUniforms::SetMedium(program, *this->Scene, *this->Picture);
  }
  void Deactivate() override { this->Textures->Deactivate(); }
  void ReportError(const std::string& text) override { this->Reported = text; }

  Error Reported;
  FlowPicture* Picture = nullptr;
  const FlowScene* Scene = nullptr;
  FlowTextures* Textures = nullptr;
};

FlowSlices::FlowSlices()
{
  this->Mapper->SetMedium(this->Painted);
  this->Mapper->AutoAdjustSampleDistancesOff();
  this->Volume->SetMapper(this->Mapper);
  // A ramp: opacity that jumps would be looked for within slabs.
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(1.0, 0.5);
  this->Volume->GetProperty()->SetScalarOpacity(opacity);
}

FlowSlices::~FlowSlices() = default;

bool FlowSlices::IsAsked(vtkRenderer* renderer)
{
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator iterator;
  lights->InitTraversal(iterator);
  while (vtkLight* light = lights->GetNextLight(iterator))
  {
    if (light->GetSwitch() && light->GetShadowAttenuation() > 0.0F)
    {
      return true;
    }
  }
  return false;
}

void FlowSlices::MakeReached(const FlowPicture& picture, const FlowScene& scene)
{
  const FlowGrid& grid = scene.Grid;
  this->Reached->CopyStructure(picture.Image);
  vtkNew<vtkUnsignedCharArray> reached;
  reached->SetName("Reached");
  reached->SetNumberOfValues(this->Reached->GetNumberOfPoints());
  for (vtkIdType i = 0; i < reached->GetNumberOfValues(); ++i)
  {
    const bool isReached =
      grid.Groups.empty() || grid.Groups[static_cast<std::size_t>(i)] >= FlowGrid::Ways;
    reached->SetValue(i, isReached ? 1 : 0);
  }
  this->Reached->GetPointData()->SetScalars(reached);
  this->ReachedVersion = scene.GridVersion;
  this->Mapper->SetInputData(this->Reached);
}

void FlowSlices::Set(const FlowPicture& picture, const FlowScene& scene)
{
  vtkImplicitFlowVolumeMapper& settings = picture.Mapper;
  vtkShadowedSliceMapper* mapper = this->Mapper;
  mapper->SetLightBufferSize(settings.GetLightBufferSize());
  // Edges of paint are sharper than voxels: slices half as far apart as those of a volume.
  mapper->SetSliceSpacing(
    settings.GetSampleDistance() > 0.0 ? settings.GetSampleDistance() : 0.25 * scene.View.Spacing);
  mapper->SetImageSampleDistance(settings.GetImageSampleDistance());
  const vtkIdType most = settings.GetMaximumTextureMemory();
  mapper->SetMaximumTextureMemory(
    most > 0 ? std::max<vtkIdType>(most - picture.Report.TextureBytes, 1) : 0);
  mapper->SetClippingPlanes(settings.GetClippingPlanes());
  mapper->SetCropping(settings.GetCropping());
  mapper->SetCroppingRegionPlanes(settings.GetCroppingRegionPlanes());
  mapper->SetCroppingRegionFlags(settings.GetCroppingRegionFlags());
  vtkVolumeProperty* from = picture.Volume->GetProperty();
  vtkVolumeProperty* to = this->Volume->GetProperty();
  to->SetShade(from->GetShade());
  to->SetAmbient(from->GetAmbient());
  to->SetDiffuse(from->GetDiffuse());
  to->SetSpecular(from->GetSpecular());
  to->SetSpecularPower(from->GetSpecularPower());
  this->Volume->SetUserMatrix(picture.Volume->GetMatrix());
}

Error FlowSlices::Draw(FlowPicture& picture, const FlowScene& scene, FlowTextures& textures)
{
  this->Painted->Picture = &picture;
  this->Painted->Scene = &scene;
  this->Painted->Textures = &textures;
  this->Painted->Reported = {};
  picture.Parts.IsMedium = true;
  if (this->ReachedVersion != scene.GridVersion)
  {
    this->MakeReached(picture, scene);
  }
  this->Set(picture, scene);
  this->Mapper->Render(picture.Renderer, this->Volume);
  vtkInterlumeReport* drawn = this->Mapper->GetReport();
  FlowVolumeRenderReport& report = picture.Report;
  const std::string own =
    FlowShader(picture.Mapper, picture.Parts, scene.Paints, scene.View).GetNames();
  report.Features = drawn->GetText("Features") + (own.empty() ? "" : " ") + own;
  const auto copy = [drawn](const char* name, auto& value)
  { value = static_cast<std::decay_t<decltype(value)>>(drawn->GetNumber(name)); };
  copy("ImageBufferBytes", report.ImageBufferBytes);
  copy("ShadowedLights", report.ShadowedLights);
  copy("Slices", report.Slices);
  copy("Sweeps", report.Sweeps);
  copy("SliceSpacing", report.SliceSpacing);
  copy("LightBuffers", report.LightBuffers);
  copy("LightBufferSize", report.LightBufferSize);
  copy("LightBufferBytes", report.LightBufferBytes);
  return this->Painted->Reported;
}

void FlowSlices::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Mapper->ReleaseGraphicsResources(window);
}

}
