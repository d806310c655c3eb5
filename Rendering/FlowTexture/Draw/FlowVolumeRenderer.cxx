// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/FlowVolumeRenderer.h"

#include "Common/ArrayCheck.h"
#include "Draw/FlowPicture.h"
#include "Draw/FlowShader.h"
#include "Draw/FlowSlices.h"
#include "Draw/FlowSources.h"
#include "Draw/FlowTextures.h"
#include "Draw/FlowUniforms.h"
#include "Loader/ScopedState.h"
#include "Loader/SoftwareOpenGL.h"
#include "Offscreen/FloatTexture.h"
#include "Offscreen/ImageQuad.h"
#include "Offscreen/PropSelection.h"
#include "Offscreen/SceneDepth.h"

#include "vtkDataArray.h"
#include "vtkImplicitFlowVolumeMapper.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkTimerLog.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace interlume
{

struct FlowVolumeRenderer::WindowResources
{
  FlowTextures Textures;
  vtkNew<vtkTextureObject> Image;
  vtkNew<vtkTextureObject> OpaqueDepth;
  vtkNew<vtkTextureObject> NoDepth;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  ImageQuad RayQuad;
  ImageQuad ShowQuad;
  PropSelection Selection;

  /// Frees what lines of sight are drawn into; afterwards no framebuffer may be bound.
  void ReleasePicture(vtkWindow* window)
  {
    for (vtkTextureObject* texture :
      { this->Image.Get(), this->OpaqueDepth.Get(), this->NoDepth.Get() })
    {
      texture->ReleaseGraphicsResources(window);
    }
    this->Framebuffer->ReleaseGraphicsResources(window);
  }
};

FlowVolumeRenderer::FlowVolumeRenderer() = default;

FlowVolumeRenderer::~FlowVolumeRenderer() = default;

Error FlowVolumeRenderer::UpdateGrid(vtkImageData* image)
{
  const std::pair<const void*, vtkMTimeType> stamp(image, image->GetMTime());
  if (this->GridStamp != stamp)
  {
    this->GridError = this->Scene.Grid.Build(image);
    this->GridStamp = stamp;
    ++this->Scene.GridVersion;
  }
  return this->GridError;
}

Error FlowVolumeRenderer::FindArrays(FlowPicture& picture)
{
  vtkImplicitFlowVolumeMapper& mapper = picture.Mapper;
  const auto find = [&](const char* name, vtkDataArray*& array)
  {
    array = picture.Image->GetPointData()->GetArray(name);
    return ArrayCheck::FindPointError(picture.Image, "input", name, 0);
  };
  FlowShader::Parts& parts = picture.Parts;
  if (*mapper.GetOpacityArray())
  {
    if (Error error = find(mapper.GetOpacityArray(), picture.OpacityValues))
    {
      return error;
    }
    if (Error error = ArrayCheck::FindPointError(picture.Image, picture.OpacityValues, 1))
    {
      return error;
    }
    parts.HasTransfer = true;
  }
  if (picture.Volume->GetProperty()->GetShade() != 0 && *mapper.GetShadingArray())
  {
    if (Error error = find(mapper.GetShadingArray(), picture.ShadingValues))
    {
      return error;
    }
    const int components = picture.ShadingValues->GetNumberOfComponents();
    if (components != 1 && components != 3)
    {
      return ArrayCheck::Describe(picture.ShadingValues) + " has " +
        ArrayCheck::Count(components, "component") + "; 1 or 3 are needed to shade by";
    }
    parts.IsShaded = true;
    parts.IsShadedByVectors = components == 3;
  }
  if (mapper.GetDetailTexture())
  {
    int size[3];
    mapper.GetDetailTexture()->GetDimensions(size);
    parts.DetailDimensions = size[0] > 1 && size[1] > 1 && size[2] > 1 ? 3 : 2;
  }
  return {};
}

Error FlowVolumeRenderer::Update(FlowPicture& picture)
{
  if (Error error = this->UpdateGrid(picture.Image).Then([&] { return this->FindArrays(picture); }))
  {
    return error;
  }
  if (Error error = this->Scene.View.Set(
        picture.Renderer, picture.Image, picture.Volume->GetMatrix(), &picture.Mapper))
  {
    return error;
  }
  vtkImplicitFlowVolumeMapper& mapper = picture.Mapper;
  FlowVolumeRenderReport& report = picture.Report;
  this->Scene.Paints.Assign(mapper.GetInflowTextures(), this->Scene.Grid);
  // llvmpipe ends a shader's loops after 65,535 rounds of all of them.
  const double mostSamples = 60000.0 / (mapper.GetMaximumPaintSamples() + 5);
  picture.SampleDistance = std::max(
    mapper.GetSampleDistance() > 0.0 ? mapper.GetSampleDistance() : 0.5 * this->Scene.View.Spacing,
    this->Scene.View.Diagonal / mostSamples);
  report.SampleDistance = picture.SampleDistance;
  report.ImageSampleDistance = mapper.GetImageSampleDistance();
  report.Surfaces = static_cast<int>(this->Scene.Grid.Ids.size());
  report.SurfacesWithoutTexture = this->Scene.Paints.WithoutTexture;
  report.UniformCells = this->Scene.Grid.UniformCells;
  report.SplitCells = this->Scene.Grid.SplitCells + this->Scene.Grid.SeamCells;
  report.EmptyCells = this->Scene.Grid.EmptyCells;
  report.NonFiniteSamples = this->Scene.Grid.NonFinite;
  picture.Parts.IsSoftware = SoftwareOpenGL::IsUsed(picture.Window);
  picture.Parts.HasSplitCells = this->Scene.Grid.SplitCells > 0;
  picture.Parts.HasSeamCells = this->Scene.Grid.SeamCells > 0;
  picture.Parts.HasEmptyCells = this->Scene.Grid.EmptyCells > 0;
  if (picture.Parts.IsShaded && !picture.HasShadows)
  {
    const glm::dvec3 middle = 0.5 *
      glm::dvec3(
        this->Scene.Grid.Size[0] - 1, this->Scene.Grid.Size[1] - 1, this->Scene.Grid.Size[2] - 1);
    this->Scene.Lights.Gather(
      picture.Renderer, glm::dvec3(this->Scene.View.WorldFromVoxels * glm::dvec4(middle, 1.0)));
    picture.Parts.Lights = this->Scene.Lights.GetNumber();
  }
  return {};
}

void FlowVolumeRenderer::ReleaseSlices(vtkOpenGLRenderWindow* window, bool isAsked)
{
  if (!this->Slices)
  {
    return;
  }
  // Where a framebuffer is released none is bound any more.
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  this->Slices->ReleaseGraphicsResources(isAsked ? window : nullptr);
  state->PopFramebufferBindings();
  if (!isAsked)
  {
    this->Slices.reset();
  }
}

Error FlowVolumeRenderer::DrawSlices(FlowPicture& picture, WindowResources& resources)
{
  vtkOpenGLState* state = picture.Window->GetState();
  state->PushFramebufferBindings();
  resources.ReleasePicture(picture.Window);
  state->PopFramebufferBindings();
  if (!this->Slices)
  {
    this->Slices = std::make_unique<FlowSlices>();
  }
  return this->Slices->Draw(picture, this->Scene, resources.Textures);
}

Error FlowVolumeRenderer::Draw(FlowPicture& picture, WindowResources& resources)
{
  vtkOpenGLRenderWindow* window = picture.Window;
  vtkTextureObject* depth = resources.OpaqueDepth;
  if (SceneDepth::MayOcclude(picture.Renderer, picture.Volume))
  {
    depth->SetContext(window);
    picture.Parts.HasOpaqueDepth = SceneDepth::CopyTo(picture.Renderer, depth);
  }
  else
  {
    depth->ReleaseGraphicsResources(window);
  }
  const FlowShader shader(picture.Mapper, picture.Parts, this->Scene.Paints, this->Scene.View);
  picture.Report.Features = shader.GetNames();
  picture.Report.ImageBufferBytes =
    FloatTexture::Allocate(window, resources.Image, picture.Size[0], picture.Size[1], 4, true);
  if (picture.Report.ImageBufferBytes == 0)
  {
    return { "the graphics card has no memory for a picture of floats", ErrorCode::OutOfMemory };
  }
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  {
    const ScopedState scoped(state);
    state->vtkglDisable(GL_CULL_FACE);
    state->vtkglDisable(GL_SCISSOR_TEST);
    resources.Framebuffer->SetContext(window);
    resources.Framebuffer->Bind();
    resources.Framebuffer->AddColorAttachment(0, resources.Image);
    resources.Framebuffer->ActivateDrawBuffer(0);
    state->vtkglViewport(0, 0, picture.Size[0], picture.Size[1]);
    state->vtkglClearColor(0.0F, 0.0F, 0.0F, 0.0F);
    state->vtkglClear(GL_COLOR_BUFFER_BIT);
    vtkTextureObject* bound = depth;
    if (!picture.Parts.HasOpaqueDepth)
    {
      // The quad binds a texture; this one is not in the shader.
      FloatTexture::Allocate(window, resources.NoDepth, 1, 1, 1, false);
      bound = resources.NoDepth;
    }
    resources.RayQuad.DrawWith(window, bound, shader.GetSource(),
      [&](vtkShaderProgram* program)
      {
        resources.Textures.Activate(program);
        FlowUniforms::Set(program, this->Scene, picture);
      });
    resources.Textures.Deactivate();
  }
  state->PopFramebufferBindings();
  picture.Report.Passes = 1;
  if (picture.Renderer->GetSelector())
  {
    resources.Selection.Show(picture.Renderer->GetSelector(), window, resources.Image);
  }
  else
  {
    resources.ShowQuad.Draw(window, resources.Image);
  }
  return {};
}

Error FlowVolumeRenderer::Render(vtkRenderer* renderer, vtkVolume* volume,
  vtkImplicitFlowVolumeMapper& mapper, vtkImageData* image, FlowVolumeRenderReport& report)
{
  const double start = vtkTimerLog::GetUniversalTime();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window)
  {
    return { "the render window is not an OpenGL one", ErrorCode::OpenGL };
  }
  window->MakeCurrent();
  if (!HasOpenGL32())
  {
    return { "OpenGL is older than 3.2", ErrorCode::OpenGL };
  }
  std::unique_ptr<WindowResources>& resources = this->Windows[window];
  if (!resources)
  {
    resources = std::make_unique<WindowResources>();
  }
  FlowPicture picture{ renderer, window, volume, mapper, image, report };
  // The selection of a volume has no light.
  const bool isSelection = renderer->GetSelector() != nullptr;
  picture.HasShadows = mapper.GetShadows() && !isSelection && FlowSlices::IsAsked(renderer);
  if (!picture.HasShadows && !isSelection)
  {
    this->ReleaseSlices(window, mapper.GetShadows());
  }
  int size[2];
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  for (int i = 0; i < 2; ++i)
  {
    picture.Size[i] =
      std::max(static_cast<int>(std::lround(size[i] / mapper.GetImageSampleDistance())), 1);
  }
  Error error = this->Update(picture).Then(
    [&] { return FlowSources::Keep(picture, this->Scene, resources->Textures); });
  if (!error && !this->Scene.Grid.Ids.empty())
  {
    error =
      picture.HasShadows ? this->DrawSlices(picture, *resources) : this->Draw(picture, *resources);
  }
  report.Seconds = vtkTimerLog::GetUniversalTime() - start;
  return error;
}

void FlowVolumeRenderer::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Slices)
  {
    this->Slices->ReleaseGraphicsResources(window);
  }
  for (auto& [owner, resources] : this->Windows)
  {
    if (!window || owner == window)
    {
      resources->Textures.ReleaseGraphicsResources(owner);
      resources->ReleasePicture(owner);
      resources->RayQuad.ReleaseGraphicsResources(owner);
      resources->ShowQuad.ReleaseGraphicsResources(owner);
      resources->Selection.ReleaseGraphicsResources(owner);
    }
  }
  if (window)
  {
    this->Windows.erase(window);
  }
  else
  {
    this->Windows.clear();
  }
}

}
