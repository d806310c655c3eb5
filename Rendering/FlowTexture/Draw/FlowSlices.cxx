// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/FlowSlices.h"

#include "Draw/FlowRenderFrame.h"
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

/// The textured flow of the current frame, as a medium for the slice mapper.
class FlowSlices::Medium : public vtkSliceMedium
{
public:
  static Medium* New() { VTK_STANDARD_NEW_BODY(Medium); }
  vtkTypeMacro(Medium, vtkSliceMedium);

  std::string GetSource() override
  {
    return FlowShader(this->Pass->Mapper, this->Pass->Parts, this->Scene->Paints, this->Scene->View)
      .GetSource();
  }
  bool HasReflection() override { return this->Pass->Parts.IsShaded; }
  void Activate(vtkShaderProgram* program) override
  {
    this->Textures->Activate(program);
    FlowUniforms::SetMedium(program, *this->Scene, *this->Pass);
  }
  void Deactivate() override { this->Textures->Deactivate(); }
  void ReportError(const std::string& text) override { this->Reported = text; }

  Error Reported;
  FlowRenderFrame* Pass = nullptr;
  const FlowRenderState* Scene = nullptr;
  FlowTextures* Textures = nullptr;
};

FlowSlices::FlowSlices()
{
  this->Mapper->SetMedium(this->Painted);
  this->Mapper->AutoAdjustSampleDistancesOff();
  this->Volume->SetMapper(this->Mapper);
  // Use a ramp. With a step, the slice mapper would search the slabs between slices for sharp
  // surfaces.
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(1.0, 0.5);
  this->Volume->GetProperty()->SetScalarOpacity(opacity);
}

FlowSlices::~FlowSlices() = default;

bool FlowSlices::HasShadowLight(vtkRenderer* renderer)
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

void FlowSlices::MakeReachedImage(const FlowRenderFrame& pass, const FlowRenderState& scene)
{
  const FlowGrid& grid = scene.Grid;
  this->Reached->CopyStructure(pass.Image);
  vtkNew<vtkUnsignedCharArray> reached;
  reached->SetName("Reached");
  reached->SetNumberOfValues(this->Reached->GetNumberOfPoints());
  for (vtkIdType i = 0; i < reached->GetNumberOfValues(); ++i)
  {
    const bool isReached =
      grid.Groups.empty() || grid.Groups[static_cast<std::size_t>(i)] >= FlowGrid::NumberOfSides;
    reached->SetValue(i, isReached ? 1 : 0);
  }
  this->Reached->GetPointData()->SetScalars(reached);
  this->ReachedVersion = scene.GridVersion;
  this->Mapper->SetInputData(this->Reached);
}

void FlowSlices::Set(const FlowRenderFrame& pass, const FlowRenderState& scene)
{
  vtkImplicitFlowVolumeMapper& settings = pass.Mapper;
  vtkShadowedSliceMapper* mapper = this->Mapper;
  mapper->SetLightBufferSize(settings.GetLightBufferSize());
  // Textures have sharper edges than voxel data, so use half the slice spacing of other volumes.
  mapper->SetSliceSpacing(
    settings.GetSampleDistance() > 0.0 ? settings.GetSampleDistance() : 0.25 * scene.View.Spacing);
  mapper->SetImageSampleDistance(settings.GetImageSampleDistance());
  mapper->SetProgressiveRendering(settings.GetProgressiveRendering());
  const vtkIdType maximum = settings.GetMaximumTextureMemory();
  mapper->SetMaximumTextureMemory(
    maximum > 0 ? std::max<vtkIdType>(maximum - pass.Report.TextureBytes, 1) : 0);
  mapper->SetClippingPlanes(settings.GetClippingPlanes());
  mapper->SetCropping(settings.GetCropping());
  mapper->SetCroppingRegionPlanes(settings.GetCroppingRegionPlanes());
  mapper->SetCroppingRegionFlags(settings.GetCroppingRegionFlags());
  vtkVolumeProperty* from = pass.Volume->GetProperty();
  vtkVolumeProperty* to = this->Volume->GetProperty();
  to->SetShade(from->GetShade());
  to->SetAmbient(from->GetAmbient());
  to->SetDiffuse(from->GetDiffuse());
  to->SetSpecular(from->GetSpecular());
  to->SetSpecularPower(from->GetSpecularPower());
  this->Volume->SetUserMatrix(pass.Volume->GetMatrix());
  const std::tuple<const void*, const void*, vtkMTimeType> state(
    from, pass.Image, std::max({ settings.GetMTime(), from->GetMTime(), pass.Image->GetMTime() }));
  if (this->MediumState != state)
  {
    this->MediumState = state;
    this->Painted->Modified();
  }
}

Error FlowSlices::Draw(FlowRenderFrame& pass, const FlowRenderState& scene, FlowTextures& textures)
{
  this->Painted->Pass = &pass;
  this->Painted->Scene = &scene;
  this->Painted->Textures = &textures;
  this->Painted->Reported = {};
  pass.Parts.IsMedium = true;
  if (this->ReachedVersion != scene.GridVersion)
  {
    this->MakeReachedImage(pass, scene);
  }
  this->Set(pass, scene);
  this->Volume->SetAllocatedRenderTime(pass.Volume->GetAllocatedRenderTime(), pass.Renderer);
  this->Mapper->Render(pass.Renderer, this->Volume);
  vtkInterlumeReport* drawn = this->Mapper->GetReport();
  FlowVolumeRenderReport& report = pass.Report;
  const std::string own = FlowShader(pass.Mapper, pass.Parts, scene.Paints, scene.View).GetNames();
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

bool FlowSlices::IsRefinementPending() const
{
  return this->Mapper->GetRefinementPending();
}

void FlowSlices::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Mapper->ReleaseGraphicsResources(window);
}

}
