// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowedScenePass.h"

#include "Common/Error.h"
#include "Common/NamedValue.h"
#include "Draw/VolumeImage.h"
#include "Receivers/SceneRenderer.h"

#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProp.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkVolume.h"
#include "vtkVolumeCollection.h"

#include <algorithm>
#include <set>

vtkStandardNewMacro(vtkShadowedScenePass);
vtkCxxSetObjectMacro(vtkShadowedScenePass, DelegatePass, vtkRenderPass);
vtkInformationKeyMacro(vtkShadowedScenePass, CASTS_SHADOWS, Integer);
vtkInformationKeyMacro(vtkShadowedScenePass, RECEIVES_SHADOWS, Integer);
vtkInformationKeyMacro(vtkShadowedScenePass, CASTS_SHADOWS_WHEN_INVISIBLE, Integer);

namespace
{
void SetKey(vtkProp* prop, vtkInformationIntegerKey* key, bool isOn, bool isOnByDefault)
{
  if (!prop)
  {
    return;
  }
  if (vtkInformation* keys = prop->GetPropertyKeys())
  {
    isOn == isOnByDefault ? keys->Remove(key) : keys->Set(key, isOn ? 1 : 0);
  }
  else if (isOn != isOnByDefault)
  {
    vtkNew<vtkInformation> newKeys;
    newKeys->Set(key, isOn ? 1 : 0);
    prop->SetPropertyKeys(newKeys);
  }
}

interlume::VolumeImage& UpdateImage(vtkRenderer* renderer, vtkVolume* volume)
{
  return vtkShadowedSliceMapper::SafeDownCast(volume->GetMapper())->UpdateImage(renderer, volume);
}

bool GetKey(vtkProp* prop, vtkInformationIntegerKey* key, bool isOnByDefault)
{
  vtkInformation* keys = prop ? prop->GetPropertyKeys() : nullptr;
  return prop && (keys && keys->Has(key) ? keys->Get(key) != 0 : isOnByDefault);
}
}

vtkShadowedScenePass::vtkShadowedScenePass()
  : Renderer(std::make_unique<interlume::SceneRenderer>())
  , Together(std::make_shared<interlume::SliceRenderer>())
{
  interlume::SceneReport().CopyTo(this->Report);
}

vtkShadowedScenePass::~vtkShadowedScenePass()
{
  this->SetDelegatePass(nullptr);
}

void vtkShadowedScenePass::SetCastsShadows(vtkProp* prop, bool casts)
{
  SetKey(prop, CASTS_SHADOWS(), casts, true);
}

bool vtkShadowedScenePass::GetCastsShadows(vtkProp* prop)
{
  return GetKey(prop, CASTS_SHADOWS(), true);
}

void vtkShadowedScenePass::SetReceivesShadows(vtkProp* prop, bool receives)
{
  SetKey(prop, RECEIVES_SHADOWS(), receives, true);
}

bool vtkShadowedScenePass::GetReceivesShadows(vtkProp* prop)
{
  return GetKey(prop, RECEIVES_SHADOWS(), true);
}

void vtkShadowedScenePass::SetCastsShadowsWhenInvisible(vtkProp* prop, bool casts)
{
  SetKey(prop, CASTS_SHADOWS_WHEN_INVISIBLE(), casts, false);
}

bool vtkShadowedScenePass::GetCastsShadowsWhenInvisible(vtkProp* prop)
{
  return GetKey(prop, CASTS_SHADOWS_WHEN_INVISIBLE(), false);
}

void vtkShadowedScenePass::DrawAll(const vtkRenderState* state)
{
  if (this->DelegatePass)
  {
    this->DelegatePass->Render(state);
    this->NumberOfRenderedProps = this->DelegatePass->GetNumberOfRenderedProps();
    return;
  }
  vtkRenderer* renderer = state->GetRenderer();
  this->UpdateCamera(renderer);
  this->UpdateLightGeometry(renderer);
  this->UpdateLights(renderer);
  this->UpdateGeometry(renderer, state->GetFrameBuffer());
  this->NumberOfRenderedProps = renderer->GetNumberOfPropsRendered();
}

void vtkShadowedScenePass::Render(const vtkRenderState* state)
{
  vtkRenderer* renderer = state->GetRenderer();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  this->NumberOfRenderedProps = 0;
  if (!window || !this->Shadows || renderer->GetSelector())
  {
    interlume::SceneReport().CopyTo(this->Report);
    this->DrawAll(state);
    return;
  }
  window->MakeCurrent();
  // Update the headlights and the default light before the pass uses them.
  this->UpdateLightGeometry(renderer);
  this->UpdateLights(renderer);
  interlume::SceneRenderer& scene = *this->Renderer;
  const interlume::SceneRenderer::Request request{ this->MaximumNumberOfShadowLights,
    this->DepthMapResolution, this->DepthBias, this->NumberOfLightSamples,
    this->MaximumNumberOfLayers, GetCastsShadows, GetReceivesShadows,
    GetCastsShadowsWhenInvisible };
  this->FindVolumes(renderer);
  if (!scene.Begin(renderer, request, static_cast<int>(this->Volumes.size())))
  {
    scene.GetReport().CopyTo(this->Report);
    scene.ReleaseGraphicsResources(window);
    this->Together->ReleaseGraphicsResources(window);
    this->DrawAll(state);
    return;
  }
  vtkRenderState surfaces(renderer);
  surfaces.SetPropArrayAndCount(scene.GetProps().data(), static_cast<int>(scene.GetProps().size()));
  this->PreRender(&surfaces);
  const interlume::Error error = this->DrawShadows(renderer);
  if (error)
  {
    vtkErrorMacro(<< "The scene is drawn without shadows: " << error);
  }
  scene.UpdatePropShaders(renderer, !error);
  scene.GetReport().CopyTo(this->Report);
  scene.Activate();
  this->DrawAll(state);
  scene.End(renderer);
  for (interlume::VolumeImage* image : this->Images)
  {
    image->End();
  }
  this->PostRender(&surfaces);
  this->WarnAboutUnsupportedActors();
}

void vtkShadowedScenePass::FindVolumes(vtkRenderer* renderer)
{
  this->Volumes.clear();
  this->Images.clear();
  vtkVolumeCollection* volumes = renderer->GetVolumes();
  vtkCollectionSimpleIterator iterator;
  volumes->InitTraversal(iterator);
  while (vtkVolume* volume = volumes->GetNextVolume(iterator))
  {
    auto* mapper = vtkShadowedSliceMapper::SafeDownCast(volume->GetMapper());
    if (volume->GetVisibility() && mapper && mapper->GetShadows() && mapper->GetDataObjectInput())
    {
      this->Volumes.push_back(volume);
    }
  }
}

interlume::Error vtkShadowedScenePass::DrawShadows(vtkRenderer* renderer)
{
  interlume::SceneRenderer& scene = *this->Renderer;
  interlume::Error error = scene.DrawShadowMaps(renderer);
  if (error || !scene.HasVolumes())
  {
    return error;
  }
  int channels = 1;
  for (vtkVolume* volume : this->Volumes)
  {
    auto* mapper = vtkShadowedSliceMapper::SafeDownCast(volume->GetMapper());
    channels = mapper->GetTransmissionColor() ? 3 : channels;
  }
  error = scene.DrawEyeDepth(renderer, channels);
  if (error)
  {
    return error;
  }
  scene.GetReport().Volumes = static_cast<int>(this->Volumes.size());
  return scene.DrawInDepthOrder(
    renderer, [&]() { this->DrawVolumes(renderer); }, [&]() { this->ShowVolumes(renderer); });
}

interlume::Error vtkShadowedScenePass::DrawTogether(vtkRenderer* renderer)
{
  this->Images.clear();
  for (vtkVolume* volume : this->Volumes)
  {
    // vtkVolume does the same before it renders.
    volume->Update();
    volume->GetProperty();
    this->Images.push_back(&UpdateImage(renderer, volume));
  }
  const std::set<interlume::VolumeImage*> images(this->Images.begin(), this->Images.end());
  return images.size() < this->Images.size()
    ? "A mapper draws several volumes. Use a separate mapper for each volume."
    : interlume::VolumeImage::DrawTogether(
        renderer, this->Images, this->Together, this->Renderer->GetScene());
}

void vtkShadowedScenePass::DrawVolumes(vtkRenderer* renderer)
{
  interlume::SliceScene& scene = this->Renderer->GetScene();
  interlume::SceneReport& report = this->Renderer->GetReport();
  scene.Fields.clear();
  report.SeparateVolumesReason = this->DrawTogether(renderer).GetMessage();
  const auto together = std::count_if(this->Images.begin(), this->Images.end(),
    [](const interlume::VolumeImage* image) { return image->IsRenderedTogether(); });
  if (together == 0)
  {
    this->Together->ReleaseGraphicsResources(renderer->GetRenderWindow());
  }
  report.VolumesInSharedSlices = together > 1 ? static_cast<int>(together) : 0;
  for (std::size_t i = 0; i < this->Images.size(); ++i)
  {
    if (!this->Images[i]->IsRenderedTogether())
    {
      // A mapper shared by several volumes holds only the last volume's request, so set it again.
      UpdateImage(renderer, this->Volumes[i]).Draw(renderer, &scene);
    }
  }
}

void vtkShadowedScenePass::ShowVolumes(vtkRenderer* renderer)
{
  for (interlume::VolumeImage* image : this->Images)
  {
    if (image->HasContents())
    {
      image->Show(renderer);
    }
  }
}

void vtkShadowedScenePass::WarnAboutUnsupportedActors()
{
  for (vtkProp* prop : this->Renderer->PopUnshadowedActors())
  {
    vtkWarningMacro(
      << prop->GetClassName() << " (" << static_cast<void*>(prop)
      << ") is drawn without shadows, because its mapper ignores render passes or its custom "
         "fragment shader lacks VTK's lighting code.");
  }
  for (vtkProp* prop : this->Renderer->PopNonPeelableActors())
  {
    vtkWarningMacro(
      << prop->GetClassName() << " (" << static_cast<void*>(prop)
      << ") is translucent. It casts no shadow and is drawn before the volumes, because "
         "its mapper is not a polygon or glyph mapper, or its custom fragment shader lacks VTK's "
         "depth peeling code.");
  }
}

bool vtkShadowedScenePass::PreReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  interlume::SceneRenderer::Mark(fragmentShader);
  return true;
}

bool vtkShadowedScenePass::PostReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp* prop)
{
  this->Renderer->Replace(fragmentShader, prop);
  return true;
}

bool vtkShadowedScenePass::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  this->Renderer->SetUniforms(program, prop);
  return true;
}

vtkMTimeType vtkShadowedScenePass::GetShaderStageMTime()
{
  return this->Renderer->GetShaderTime();
}

void vtkShadowedScenePass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Renderer->ReleaseGraphicsResources(window);
  this->Together->ReleaseGraphicsResources(window);
  if (this->DelegatePass)
  {
    this->DelegatePass->ReleaseGraphicsResources(window);
  }
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkShadowedScenePass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  interlume::NamedValue::Print(os, indent,
    { { "DelegatePass", this->DelegatePass }, { "Shadows", this->Shadows },
      { "MaximumNumberOfShadowLights", this->MaximumNumberOfShadowLights },
      { "DepthMapResolution", this->DepthMapResolution }, { "DepthBias", this->DepthBias },
      { "NumberOfLightSamples", this->NumberOfLightSamples },
      { "MaximumNumberOfLayers", this->MaximumNumberOfLayers } });
  os << indent << "Report:\n";
  this->Report->PrintSelf(os, indent.GetNextIndent());
}
