// SPDX-License-Identifier: BSD-3-Clause
#include "Receivers/SceneRenderer.h"

#include "Lights/LightSources.h"
#include "Loader/OpenGLFunctions.h"
#include "Space/UnitSpace.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkSceneDepth.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>

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

// Returns whether render passes can change the prop's shaders.
bool HasSurfaces(vtkProp* prop)
{
  return prop->IsA("vtkActor") || prop->IsA("vtkAssembly") || prop->IsA("vtkLODProp3D");
}

// Returns whether a prop that is none of these can hide a volume.
bool MayOcclude(vtkProp* prop)
{
  return prop->IsA("vtkProp3D") && !prop->IsA("vtkVolume") && prop->HasOpaqueGeometry();
}

// Returns coordinates of size 1 around all boxes.
UnitSpace MakeSpace(const std::vector<CasterView::Box>& boxes)
{
  if (boxes.empty())
  {
    return {};
  }
  glm::dvec3 lower(VTK_DOUBLE_MAX);
  glm::dvec3 upper(-VTK_DOUBLE_MAX);
  for (const CasterView::Box& box : boxes)
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

bool SceneRenderer::Begin(vtkRenderer* renderer, const Request& request, int volumes)
{
  this->Settings = request;
  this->Props.clear();
  this->Casters.clear();
  this->Lights.clear();
  this->Reached.clear();
  this->Failed.clear();
  this->Scene = SliceScene();
  this->Transmittance.Clear(0, 0, 1, {});
  std::vector<CasterView::Box> boxes;
  bool hasOthers = false;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator iterator;
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    if (!prop->GetVisibility() || !HasSurfaces(prop))
    {
      hasOthers = hasOthers || (prop->GetVisibility() && MayOcclude(prop));
      continue;
    }
    this->Props.push_back(prop);
    if (prop->HasOpaqueGeometry() && HasBounds(prop))
    {
      this->Casters.push_back(prop);
      boxes.emplace_back();
      std::copy_n(prop->GetBounds(), 6, boxes.back().begin());
    }
  }
  // Props of other kinds have no depth yet when volumes are drawn ahead.
  const bool isGroup = volumes > 1 && !hasOthers;
  if (this->Props.empty() && !isGroup)
  {
    return false;
  }
  const UnitSpace space = boxes.empty() ? UnitSpace() : MakeSpace(boxes);
  // Whoever draws the scene without this pass says nothing of such lights either.
  std::vector<std::string> faults;
  this->Lights =
    LightSources::Gather(renderer, space, { true, request.MaximumNumberOfShadows }, faults);
  for (LightSource& light : this->Lights)
  {
    // One sample is the light's centre.
    light.Area = request.Samples > 1 ? light.Area : nullptr;
  }
  this->Maps.Fit(this->Lights, space, boxes, request.Resolution, request.Samples);
  this->Screens.Gather(this->Lights, space);
  const bool hasShadows = std::any_of(this->Lights.begin(), this->Lights.end(),
    [](const LightSource& light) { return light.ShadowStrength > 0.0; });
  this->IsMixed = volumes > 0 && hasShadows && (!this->Casters.empty() || isGroup);
  return this->Maps.HasViews() || this->IsMixed || !this->Screens.IsEmpty();
}

std::string SceneRenderer::UpdateContext(vtkOpenGLRenderWindow* window)
{
  if (!HasOpenGL32())
  {
    return "OpenGL is older than 3.2";
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
  return isMade ? "" : "the graphics card has no memory for a texture";
}

std::string SceneRenderer::DrawMaps(vtkRenderer* renderer, vtkShadowedSceneReport& report)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  std::string error = this->UpdateContext(window);
  if (!this->Maps.HasViews() || !error.empty())
  {
    this->Maps.ReleaseGraphicsResources(window);
    return error;
  }
  this->IsOfDepths = true;
  this->Placeholder->Activate();
  error = this->Maps.Draw(
    renderer, this->Casters, this->Settings.Resolution, this->Settings.Bias, report);
  this->Placeholder->Deactivate();
  this->IsOfDepths = false;
  return error;
}

std::string SceneRenderer::DrawEyeDepth(
  vtkRenderer* renderer, int channels, vtkShadowedSceneReport& report)
{
  this->Scene.Casters = &this->Maps;
  if (this->Casters.empty() && !renderer->GetPreserveDepthBuffer())
  {
    return {};
  }
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  int left = 0;
  int bottom = 0;
  std::array<int, 2>& size = this->Scene.Size;
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &left, &bottom);
  if (size[0] <= 0 || size[1] <= 0 || !this->EyeDepth.Allocate(window, size[0], size[1]))
  {
    return "the graphics card has no memory for the depth of actors";
  }
  // What other renderers have left occludes as well.
  const bool isKept = renderer->GetPreserveDepthBuffer() &&
    vtkSceneDepth::CopyTo(renderer, this->EyeDepth.GetTexture());
  this->IsOfDepths = true;
  this->Placeholder->Activate();
  this->EyeDepth.Draw(window, !isKept,
    [&]() {
      PropDepths::DrawProps(renderer, this->Casters, { { 0, 0, size[0], size[1] } });
    });
  this->Placeholder->Deactivate();
  this->IsOfDepths = false;
  this->EyeDepth.Read(window, this->Scene.EyeDepths);
  this->Scene.EyeDepth = this->EyeDepth.GetTexture();
  std::vector<vtkLight*> lights;
  for (const LightSource& light : this->Lights)
  {
    if (light.ShadowStrength > 0.0)
    {
      lights.push_back(light.Light);
    }
  }
  this->Transmittance.Clear(size[0], size[1], channels, lights);
  this->Scene.Transmittance = &this->Transmittance;
  report.EyeDepthPasses = 1;
  report.EyeDepthBytes = this->EyeDepth.GetBytes();
  return {};
}

void SceneRenderer::MakeShader(
  vtkRenderer* renderer, bool isShadowed, vtkShadowedSceneReport& report)
{
  report.PixelsBefore = this->Scene.PixelsBefore;
  report.PixelsWithin = this->Scene.PixelsWithin;
  report.PixelsBehind = this->Scene.PixelsBehind;
  report.ReceiverPasses = this->Scene.ReceiverPasses;
  report.TransmittanceBytes = this->Transmittance.GetBytes();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (report.EyeDepthPasses == 0)
  {
    this->EyeDepth.ReleaseGraphicsResources(window);
  }
  if (!this->Transmittance.IsUsed())
  {
    this->Transmittance.ReleaseGraphicsResources(window);
  }
  report.Images = this->Screens.Upload(window);
  const bool isNew = isShadowed ? this->Shader.Update(renderer, this->Lights, this->Maps,
                                    this->Transmittance, this->Screens, this->EyeDepth.GetTexture())
                                : this->Shader.Clear();
  if (isNew)
  {
    this->ShaderTime.Modified();
  }
}

void SceneRenderer::Activate()
{
  std::vector<vtkTextureObject*> textures = this->Screens.GetTextures();
  textures.insert(
    textures.end(), { this->EyeDepth.GetTexture(), this->Transmittance.GetTexture() });
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

void SceneRenderer::End()
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
  // Views of the eye and of lights take turns: VTK would keep what it knows of the last camera
  // where none has been modified since.
  program->SetUniformGroupUpdateTime(vtkShaderProgram::LightingGroup, 0);
  this->Shader.SetUniforms(
    program, prop->HasTranslucentPolygonalGeometry() == 0, this->IsOfDepths, this->Placeholder);
}

std::vector<vtkProp*> SceneRenderer::TakeUnreached()
{
  std::vector<vtkProp*> unreached;
  for (vtkProp* prop : this->Casters)
  {
    auto* actor = vtkActor::SafeDownCast(prop);
    vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
    // An actor with levels of detail draws by others of its own, and VTK's mappers of polygons ask
    // for shaders wherever they have something to draw.
    const bool isForeign = mapper && !mapper->IsA("vtkOpenGLPolyDataMapper") &&
      !prop->IsA("vtkLODActor") && this->Reached.count(prop) == 0;
    if ((isForeign || this->Failed.count(prop) > 0) && this->Named.insert(prop).second)
    {
      unreached.push_back(prop);
    }
  }
  return unreached;
}

void SceneRenderer::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Maps.ReleaseGraphicsResources(window);
  this->EyeDepth.ReleaseGraphicsResources(window);
  this->Transmittance.ReleaseGraphicsResources(window);
  this->Screens.ReleaseGraphicsResources(window);
  this->Placeholder->ReleaseGraphicsResources(window);
}

}
