// SPDX-License-Identifier: BSD-3-Clause
#include "Receivers/SceneRenderer.h"

#include "Lights/LightSources.h"
#include "Loader/OpenGLFunctions.h"
#include "Offscreen/SceneDepth.h"
#include "Space/UnitSpace.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace interlume
{

namespace
{
bool HasBounds(vtkProp* prop)
{
  const double* bounds = prop->GetBounds();
  return bounds && vtkMath::AreBoundsInitialized(bounds) &&
    std::all_of(bounds, bounds + 6, [](double value) { return std::isfinite(value); });
}

// Returns true if render passes can change the prop's shaders.
bool HasSurfaces(vtkProp* prop)
{
  return prop->IsA("vtkActor") || prop->IsA("vtkAssembly") || prop->IsA("vtkLODProp3D");
}

// Returns true if a prop for which HasSurfaces is false can hide a volume.
bool MayOcclude(vtkProp* prop)
{
  return prop->IsA("vtkProp3D") && !prop->IsA("vtkVolume") && prop->HasOpaqueGeometry();
}

// Returns a unit space that contains all boxes.
UnitSpace MakeSpace(const std::vector<ShadowMapView::Box>& boxes)
{
  if (boxes.empty())
  {
    return {};
  }
  glm::dvec3 lower(VTK_DOUBLE_MAX);
  glm::dvec3 upper(-VTK_DOUBLE_MAX);
  for (const ShadowMapView::Box& box : boxes)
  {
    lower = glm::min(lower, glm::dvec3(box[0], box[2], box[4]));
    upper = glm::max(upper, glm::dvec3(box[1], box[3], box[5]));
  }
  UnitSpace space;
  space.Center = 0.5 * (lower + upper);
  const double radius = 0.5 * Vectors::SafeLength(upper - lower);
  space.Radius = radius > 0.0 && std::isfinite(1.0 / radius) ? radius : 1.0;
  return space;
}
}

SceneRenderer::SceneRenderer() = default;

SceneRenderer::~SceneRenderer() = default;

bool SceneRenderer::SortProps(vtkRenderer* renderer, Boxes& boxes)
{
  this->Props.clear();
  this->Opaque.clear();
  this->Translucent.clear();
  this->Occluders.clear();
  this->TranslucentOccluders.clear();
  this->Unsliced.clear();
  std::vector<vtkProp*> nonReceivers;
  bool hasOthers = false;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator iterator;
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    const bool isVisible = prop->GetVisibility() != 0;
    if (!HasSurfaces(prop) || !(isVisible || this->Settings.CastsWhenInvisible(prop)))
    {
      hasOthers = hasOthers || (isVisible && MayOcclude(prop));
      continue;
    }
    this->Props.push_back(prop);
    const bool casts = this->Settings.Casts(prop);
    this->Report.NonCastingActors += casts ? 0 : 1;
    if (!this->Settings.Receives(prop))
    {
      nonReceivers.push_back(prop);
    }
    if (!HasBounds(prop))
    {
      continue;
    }
    ShadowMapView::Box box{};
    std::copy_n(prop->GetBounds(), 6, box.begin());
    boxes.All.push_back(box);
    const auto add = [&](std::vector<vtkProp*>& all, std::vector<vtkProp*>& occluders,
                       std::vector<ShadowMapView::Box>& occluderBoxes)
    {
      if (isVisible)
      {
        all.push_back(prop);
      }
      if (casts)
      {
        occluders.push_back(prop);
        occluderBoxes.push_back(box);
      }
    };
    if (prop->HasOpaqueGeometry())
    {
      add(this->Opaque, this->Occluders, boxes.Opaque);
    }
    if (prop->HasTranslucentPolygonalGeometry())
    {
      if (LayerShader::CanDraw(prop))
      {
        add(this->Translucent, this->TranslucentOccluders, boxes.Translucent);
      }
      else
      {
        this->Unsliced.push_back(prop);
      }
    }
  }
  this->Report.NonReceivingActors = static_cast<int>(nonReceivers.size());
  if (nonReceivers != this->NonReceivers)
  {
    this->NonReceivers = std::move(nonReceivers);
    this->ShaderTime.Modified();
  }
  return hasOthers;
}

bool SceneRenderer::Begin(vtkRenderer* renderer, const Request& request, int volumes)
{
  this->Settings = request;
  this->Report = SceneReport();
  this->Lights.clear();
  this->Reached.clear();
  this->Failed.clear();
  this->Scene = SliceScene();
  this->Fields.ClearTextures();
  this->Transmittance.Clear(0, 0, 1, {});
  Boxes boxes;
  const bool hasOthers = this->SortProps(renderer, boxes);
  // Do not draw volumes ahead of the scene if props without surfaces can hide them: these props
  // have not written their depth yet.
  const bool isGroup = volumes > 1 && !hasOthers;
  if (this->Props.empty() && !isGroup)
  {
    return false;
  }
  const UnitSpace space = MakeSpace(boxes.All);
  // Ignore warnings about skipped lights, since drawing the scene without this pass does not report
  // them either.
  std::vector<std::string> warnings;
  std::vector<vtkLight*> skipped;
  this->Lights = LightSources::Gather(
    renderer, space, { true, request.MaximumNumberOfShadowLights }, warnings, &skipped);
  for (LightSource& light : this->Lights)
  {
    // With one sample, an area light is treated as a light at its center.
    light.Area = request.Samples > 1 ? light.Area : nullptr;
  }
  this->Maps.Fit(this->Lights, space, boxes.Opaque, request.Resolution, request.Samples);
  // For attenuation by translucent surfaces, area lights are treated as lights at their centers.
  std::vector<LightSource> centers = this->Lights;
  for (LightSource& light : centers)
  {
    light.Area = nullptr;
  }
  this->TranslucentViews.Fit(centers, space, boxes.Translucent, request.Resolution);
  this->Screens.Gather(this->Lights, skipped, space);
  const bool hasShadows = std::any_of(this->Lights.begin(), this->Lights.end(),
    [](const LightSource& light) { return light.ShadowStrength > 0.0; });
  // If VTK draws volumes between its own depth peels, this class cannot draw them in segments.
  const bool isPeeled =
    renderer->GetUseDepthPeeling() != 0 && renderer->GetUseDepthPeelingForVolumes();
  this->IsLayered =
    !this->Translucent.empty() && volumes > 0 && !isPeeled && (!this->Opaque.empty() || !hasOthers);
  // If no translucent prop is visible, any translucent occluders are invisible props.
  const bool hasTranslucent = !this->Translucent.empty() || !this->TranslucentOccluders.empty();
  const bool hasOccluders = !this->Opaque.empty() || !this->Occluders.empty() ||
    (this->Translucent.empty() && hasTranslucent);
  this->IsMixed = (volumes > 0 && hasShadows && (hasOccluders || isGroup)) || this->IsLayered;
  if (this->Layering.Enable(hasTranslucent))
  {
    this->ShaderTime.Modified();
  }
  return this->Maps.HasViews() || this->IsMixed || !this->Screens.IsEmpty() ||
    (!this->TranslucentOccluders.empty() && !this->TranslucentViews.GetViews().empty());
}

Error SceneRenderer::UpdateContext(vtkOpenGLRenderWindow* window)
{
  if (!HasOpenGL32())
  {
    return Error(
      "The OpenGL version is too old. OpenGL 3.2 or newer is required.", ErrorCode::OpenGL);
  }
  if (this->Window != window)
  {
    this->ReleaseGraphicsResources(this->Window);
    this->Window = window;
  }
  float texel = 1.0F;
  this->Placeholder->SetContext(window);
  const bool isMade = this->Placeholder->GetHandle() != 0 ||
    this->Placeholder->Create2DFromRaw(1, 1, 1, VTK_FLOAT, &texel);
  return isMade
    ? Error()
    : Error("The graphics card does not have enough memory for a texture.", ErrorCode::OutOfMemory);
}

Error SceneRenderer::DrawShadowMaps(vtkRenderer* renderer)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  Error error =
    this->UpdateContext(window).Then([&] { return this->DrawTranslucentShadowMaps(renderer); });
  if (!this->Maps.HasViews() || error)
  {
    this->Maps.ReleaseGraphicsResources(window);
    return error;
  }
  this->IsDepthOnly = true;
  this->Placeholder->Activate();
  error = this->Maps.Draw(
    renderer, this->Occluders, this->Settings.Resolution, this->Settings.Bias, this->Report);
  this->Placeholder->Deactivate();
  this->IsDepthOnly = false;
  return error;
}

Error SceneRenderer::DrawEyeDepth(vtkRenderer* renderer, int channels)
{
  this->Scene.Occluders = &this->Maps;
  this->Scene.Blockers = this->Occluders;
  this->Scene.TranslucentMaps = &this->TranslucentMaps;
  if (this->Opaque.empty() && !this->IsLayered && !renderer->GetPreserveDepthBuffer())
  {
    return {};
  }
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  int left = 0;
  int bottom = 0;
  std::array<int, 2>& size = this->Scene.Size;
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &left, &bottom);
  if (size[0] <= 0 || size[1] <= 0 || !this->CameraDepth.Allocate(window, size[0], size[1]))
  {
    return Error("The graphics card does not have enough memory for the depth buffer of the "
                 "actors, or the viewport is empty.",
      ErrorCode::OutOfMemory);
  }
  // Surfaces that other renderers have drawn also hide volumes.
  const bool isPreserved = renderer->GetPreserveDepthBuffer() &&
    SceneDepth::CopyTo(renderer, this->CameraDepth.GetTexture());
  this->IsDepthOnly = true;
  this->Placeholder->Activate();
  this->CameraDepth.Draw(window, !isPreserved,
    [&]() {
      PropDepths::DrawProps(renderer, this->Opaque, { { 0, 0, size[0], size[1] } });
    });
  this->Placeholder->Deactivate();
  this->IsDepthOnly = false;
  this->CameraDepth.Read(window, this->Scene.CameraDepths);
  this->OpaqueDepths.clear();
  this->Scene.CameraDepth = this->CameraDepth.GetTexture();
  std::vector<vtkLight*> lights;
  for (const LightSource& light : this->Lights)
  {
    if (light.ShadowStrength > 0.0)
    {
      lights.push_back(light.Light);
    }
  }
  this->Transmittance.Clear(size[0], size[1], channels, lights);
  this->LayerLight.Clear(size[0], size[1], channels, lights);
  this->Scene.Transmittance = &this->Transmittance;
  this->Report.CameraDepthPasses = 1;
  this->Report.CameraDepthBytes = this->CameraDepth.GetBytes();
  return {};
}

Error SceneRenderer::DrawTranslucentShadowMaps(vtkRenderer* renderer)
{
  const int views = static_cast<int>(this->TranslucentViews.GetViews().size());
  this->Report.TranslucentActors = static_cast<int>(this->Translucent.size());
  if (this->TranslucentOccluders.empty() || views == 0)
  {
    this->TranslucentMaps.Clear(renderer->GetRenderWindow());
    return {};
  }
  const int resolution =
    std::min(this->Settings.Resolution, SurfaceShadowMaps::GetLargestResolution(views, 16384));
  this->IsDepthOnly = true;
  this->Placeholder->Activate();
  Error error = this->TranslucentMaps.Draw(renderer, this->TranslucentViews,
    this->TranslucentOccluders, resolution, this->Settings.Bias,
    static_cast<std::size_t>(this->Settings.Layers), this->Layering);
  this->Placeholder->Deactivate();
  this->IsDepthOnly = false;
  this->Report.LightLayers = this->TranslucentMaps.GetLayers();
  this->Report.LightLayerBytes = this->TranslucentMaps.GetBytes();
  return error;
}

Error SceneRenderer::PeelLayers(vtkRenderer* renderer)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  const std::array<int, 2>& size = this->Scene.Size;
  // Allocate both textures first, so that the layers and the final image use the same shader
  // programs.
  if (!this->Transmittance.Make(window) || !this->LayerLight.Make(window))
  {
    return Error("The graphics card does not have enough memory for the lighting of translucent "
                 "surfaces. Reduce the size of the window.",
      ErrorCode::OutOfMemory);
  }
  this->UpdateShader(renderer, true);
  this->IsDepthOnly = true;
  this->Placeholder->Activate();
  Error error = this->Layers.GetDepths().Peel(window, size[0], this->OpaqueDepths,
    static_cast<std::size_t>(this->Settings.Layers), this->Layering,
    [&]() {
      LayerShader::DrawProps(renderer, this->Translucent, { { 0, 0, size[0], size[1] } });
    });
  this->Placeholder->Deactivate();
  this->IsDepthOnly = false;
  if (!error && this->Layers.GetNumber() > 0 && !this->Layers.Clear(window, size[0], size[1]))
  {
    error = Error("The graphics card does not have enough memory for the image of translucent "
                  "surfaces. Reduce the size of the window.",
      ErrorCode::OutOfMemory);
  }
  this->Report.CameraLayers = static_cast<int>(this->Layers.GetNumber());
  this->Report.CameraLayerBytes = this->Layers.GetBytes();
  return error;
}

void SceneRenderer::BeginSegment(std::size_t segment)
{
  const std::vector<DepthLayers::Layer>& layers = this->Layers.GetDepths().Get();
  this->Scene.FrontDepth = segment > 0 ? layers[segment - 1].Texture.Get() : nullptr;
  if (segment == layers.size())
  {
    return;
  }
  const DepthLayers::Layer& behind = layers[segment];
  this->Scene.CameraDepth = behind.Texture;
  // Light is required only at the surfaces of the layer, not at surfaces behind it.
  this->Scene.CameraDepths.resize(this->OpaqueDepths.size());
  std::transform(behind.Depths.begin(), behind.Depths.end(), this->OpaqueDepths.begin(),
    this->Scene.CameraDepths.begin(),
    [](float depth, float opaque) { return depth < opaque ? depth : 1.0F; });
  this->Scene.Transmittance = &this->LayerLight;
}

void SceneRenderer::ShadeLayer(vtkRenderer* renderer, std::size_t layer)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkTextureObject* depth = this->Layers.GetDepths().Get()[layer].Texture;
  this->Activate();
  this->LayerLight.GetTexture()->Activate();
  depth->Activate();
  this->Shader.SetSurfaceTextures(this->LayerLight, depth, false);
  this->Layers.Shade(window, layer, this->Layering,
    [&]()
    {
      LayerShader::DrawProps(
        renderer, this->Translucent, { { 0, 0, this->Scene.Size[0], this->Scene.Size[1] } });
    });
  depth->Deactivate();
  this->LayerLight.GetTexture()->Deactivate();
  this->Deactivate();
}

Error SceneRenderer::DrawInDepthOrder(vtkRenderer* renderer,
  const std::function<void()>& drawVolumes, const std::function<void()>& showVolumes)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!this->IsLayered)
  {
    this->Layers.ReleaseGraphicsResources(window);
    this->LayerLight.ReleaseGraphicsResources(window);
    drawVolumes();
    return {};
  }
  this->OpaqueDepths = this->Scene.CameraDepths;
  if (Error error = this->PeelLayers(renderer))
  {
    return error;
  }
  const std::size_t layers = this->Layers.GetNumber();
  const std::vector<vtkLight*> lights = this->Transmittance.GetLights();
  for (std::size_t i = 0; i <= layers; ++i)
  {
    const std::size_t segment = layers - i;
    this->BeginSegment(segment);
    drawVolumes();
    if (i == 0)
    {
      this->Fields.Set(this->Scene.Fields);
      this->UpdateShader(renderer, true);
    }
    if (segment < layers)
    {
      this->ShadeLayer(renderer, segment);
      // Start again with full light for the next layer.
      this->LayerLight.Clear(
        this->Scene.Size[0], this->Scene.Size[1], this->Transmittance.GetChannels(), lights);
      this->LayerLight.Make(window);
    }
    if (layers > 0)
    {
      this->Layers.Composite(window, showVolumes);
    }
  }
  this->Report.SlicedSegments = static_cast<int>(layers) + 1;
  if (layers > 0)
  {
    this->Scene.Show = [this, window]() { this->Layers.Show(window); };
    this->Layering.Begin(LayerShader::HIDE);
  }
  this->Shader.SetSurfaceTextures(this->Transmittance, this->CameraDepth.GetTexture(), true);
  return {};
}

void SceneRenderer::UpdatePropShaders(vtkRenderer* renderer, bool isShadowed)
{
  this->Report.PixelsInFrontOfVolumes = this->Scene.PixelsInFront;
  this->Report.PixelsInsideVolumes = this->Scene.PixelsInside;
  this->Report.PixelsBehindVolumes = this->Scene.PixelsBehind;
  this->Report.ReceiverPasses = this->Scene.ReceiverPasses;
  this->Report.TransmittanceBytes = this->Transmittance.GetBytes();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (this->Report.CameraDepthPasses == 0)
  {
    this->CameraDepth.ReleaseGraphicsResources(window);
  }
  if (!this->Transmittance.IsUsed())
  {
    this->Transmittance.ReleaseGraphicsResources(window);
  }
  this->Fields.Set(isShadowed ? this->Scene.Fields : std::vector<ScatteredLightTexture>());
  this->ReportScattering();
  this->UpdateShader(renderer, isShadowed);
  this->Report.Images = this->Screens.GetNumber();
}

void SceneRenderer::ReportScattering()
{
  const std::vector<ScatteredLightTexture>& fields = this->Fields.Get();
  for (const ScatteredLightTexture& field : fields)
  {
    this->Report.ScatteringBlockedCells += field.BlockedCells;
  }
  this->Report.SeparateScatteringVolumes = fields.size() > 1 ? static_cast<int>(fields.size()) : 0;
  const auto receives = [&](vtkProp* prop)
  {
    auto* actor = vtkActor::SafeDownCast(prop);
    const bool isLit = !actor || actor->GetProperty()->GetLighting();
    return !fields.empty() && isLit && this->Settings.Receives(prop);
  };
  std::set<vtkProp*> props(this->Opaque.begin(), this->Opaque.end());
  if (this->IsLayered)
  {
    props.insert(this->Translucent.begin(), this->Translucent.end());
  }
  this->Report.ScatteringReceivers +=
    static_cast<int>(std::count_if(props.begin(), props.end(), receives));
}

void SceneRenderer::UpdateShader(vtkRenderer* renderer, bool isShadowed)
{
  this->Screens.Upload(vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()));
  const bool isNew = isShadowed
    ? this->Shader.Update(renderer, this->Lights, this->Maps, this->Transmittance,
        this->TranslucentMaps, this->Screens, this->Fields)
    : this->Shader.Clear();
  this->Shader.SetSurfaceTextures(this->Transmittance, this->CameraDepth.GetTexture(), true);
  if (isNew)
  {
    this->ShaderTime.Modified();
  }
}

void SceneRenderer::Activate()
{
  std::vector<vtkTextureObject*> textures = this->Screens.GetTextures();
  textures.insert(textures.end(),
    { this->CameraDepth.GetTexture(), this->Transmittance.GetTexture(),
      this->TranslucentMaps.GetTexture() });
  for (const ScatteredLightTexture& field : this->Fields.Get())
  {
    if (field.Texture)
    {
      textures.push_back(field.Texture);
    }
  }
  if (this->Layering.IsOn())
  {
    textures.push_back(this->Placeholder);
  }
  for (const auto& map : this->Maps.GetTextures())
  {
    textures.push_back(map.second);
  }
  for (vtkTextureObject* texture : textures)
  {
    if (texture->GetHandle() != 0)
    {
      texture->Activate();
      this->Active.push_back(texture);
    }
  }
}

void SceneRenderer::End(vtkRenderer* renderer)
{
  if (this->Scene.Show)
  {
    // If all volumes are out of view, none of them has shown the image.
    this->Layers.Show(vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()));
    this->Scene.Show = nullptr;
  }
  this->Layering.Begin(LayerShader::SHOW);
  this->Deactivate();
}

void SceneRenderer::Deactivate()
{
  for (vtkTextureObject* texture : this->Active)
  {
    texture->Deactivate();
  }
  this->Active.clear();
}

void SceneRenderer::SetUniforms(vtkShaderProgram* program, vtkProp* prop)
{
  this->Reached.insert(prop);
  // The camera alternates between the viewer and the lights. VTK would otherwise reuse the light
  // uniforms of the last camera if no light has been modified.
  program->SetUniformGroupUpdateTime(vtkShaderProgram::LightingGroup, 0);
  const bool isSeen = prop->HasTranslucentPolygonalGeometry() == 0 || this->Layering.IsShading();
  this->Shader.SetUniforms(program, isSeen, this->IsDepthOnly, this->Placeholder);
  this->Layering.SetUniforms(program, prop, this->Placeholder);
}

void SceneRenderer::Mark(std::string& fragmentShader)
{
  ActorShader::Mark(fragmentShader);
  LayerShader::Mark(fragmentShader);
}

void SceneRenderer::Replace(std::string& fragmentShader, vtkProp* prop)
{
  if (!this->Shader.Replace(fragmentShader, this->Settings.Receives(prop)))
  {
    this->Failed.insert(prop);
  }
  this->Layering.Replace(fragmentShader);
}

std::vector<vtkProp*> SceneRenderer::PopNonPeelableActors()
{
  std::vector<vtkProp*> unsliced;
  std::copy_if(this->Unsliced.begin(), this->Unsliced.end(), std::back_inserter(unsliced),
    [this](vtkProp* prop) { return this->Reported.insert(prop).second; });
  return unsliced;
}

std::vector<vtkProp*> SceneRenderer::PopUnshadowedActors()
{
  std::vector<vtkProp*> unreached;
  for (vtkProp* prop : this->Opaque)
  {
    auto* actor = vtkActor::SafeDownCast(prop);
    vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
    // A vtkLODActor draws with internal mappers. VTK's polygon mappers request shaders whenever
    // they draw something.
    const bool isForeign = mapper && !mapper->IsA("vtkOpenGLPolyDataMapper") &&
      !mapper->IsA("vtkCompositePolyDataMapper") && !prop->IsA("vtkLODActor") &&
      this->Reached.count(prop) == 0;
    if ((isForeign || this->Failed.count(prop) > 0) && this->Reported.insert(prop).second)
    {
      unreached.push_back(prop);
    }
  }
  return unreached;
}

void SceneRenderer::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Maps.ReleaseGraphicsResources(window);
  this->CameraDepth.ReleaseGraphicsResources(window);
  this->Transmittance.ReleaseGraphicsResources(window);
  this->Screens.ReleaseGraphicsResources(window);
  this->TranslucentMaps.ReleaseGraphicsResources(window);
  this->Layers.ReleaseGraphicsResources(window);
  this->LayerLight.ReleaseGraphicsResources(window);
  this->Placeholder->ReleaseGraphicsResources(window);
}

}
