// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/FlowVolumeRenderer.h"

#include "Common/ArrayCheck.h"
#include "Draw/FlowRenderFrame.h"
#include "Draw/FlowShader.h"
#include "Draw/FlowSlices.h"
#include "Draw/FlowSources.h"
#include "Draw/FlowTextures.h"
#include "Draw/FlowUniforms.h"
#include "Loader/ScopedGLState.h"
#include "Loader/SoftwareOpenGL.h"
#include "Offscreen/FloatTexture.h"
#include "Offscreen/ImageQuad.h"
#include "Offscreen/PropSelection.h"
#include "Offscreen/SceneDepth.h"
#include "Refinement/RenderProgress.h"

#include "vtkDataArray.h"
#include "vtkImplicitFlowVolumeMapper.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSMPTools.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkTimerLog.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace interlume
{

namespace
{
/// Estimated time per view ray sample, of software OpenGL with one thread, and of a GPU.
constexpr double SOFTWARE_SECONDS = 1e-7;
constexpr double GPU_SECONDS = 1e-9;
/// Time between two checks whether a progressive image is aborted.
constexpr double BAND_SECONDS = 0.05;
/// Minimum number of rows of a band.
constexpr double BAND_ROWS = 8.0;
}

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

  /// Releases the image buffers of ray casting. This may leave no framebuffer bound.
  void ReleaseImageBuffers(vtkWindow* window)
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

Error FlowVolumeRenderer::FindArrays(FlowRenderFrame& pass)
{
  vtkImplicitFlowVolumeMapper& mapper = pass.Mapper;
  const auto find = [&](const char* name, vtkDataArray*& array)
  {
    array = pass.Image->GetPointData()->GetArray(name);
    return ArrayCheck::MakeSentence(ArrayCheck::FindPointError(pass.Image, "input", name, 0));
  };
  FlowShader::Parts& parts = pass.Parts;
  if (*mapper.GetOpacityArray())
  {
    if (Error error = find(mapper.GetOpacityArray(), pass.OpacityValues))
    {
      return error;
    }
    if (Error error =
          ArrayCheck::MakeSentence(ArrayCheck::FindPointError(pass.Image, pass.OpacityValues, 1)))
    {
      return error;
    }
    parts.HasTransfer = true;
  }
  if (pass.Volume->GetProperty()->GetShade() != 0 && *mapper.GetShadingArray())
  {
    if (Error error = find(mapper.GetShadingArray(), pass.ShadingValues))
    {
      return error;
    }
    const int components = pass.ShadingValues->GetNumberOfComponents();
    if (components != 1 && components != 3)
    {
      return ArrayCheck::MakeSentence(ArrayCheck::Describe(pass.ShadingValues) + " has " +
        ArrayCheck::Count(components, "component") + ", but ShadingArray requires 1 or 3");
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

Error FlowVolumeRenderer::Update(FlowRenderFrame& pass)
{
  if (Error error = this->UpdateGrid(pass.Image).Then([&] { return this->FindArrays(pass); }))
  {
    return error;
  }
  if (Error error =
        this->Scene.View.Set(pass.Renderer, pass.Image, pass.Volume->GetMatrix(), &pass.Mapper))
  {
    return error;
  }
  vtkImplicitFlowVolumeMapper& mapper = pass.Mapper;
  FlowVolumeRenderReport& report = pass.Report;
  this->Scene.Paints.Assign(mapper.GetInflowTextures(), this->Scene.Grid);
  // llvmpipe terminates the loops of a shader after 65,535 iterations in total.
  const double maximumSamples = 60000.0 / (mapper.GetMaximumTextureSamples() + 5);
  pass.SampleDistance = std::max(pass.Coarseness *
      (mapper.GetSampleDistance() > 0.0 ? mapper.GetSampleDistance()
                                        : 0.5 * this->Scene.View.Spacing),
    this->Scene.View.Diagonal / maximumSamples);
  report.SampleDistance = pass.SampleDistance;
  report.ImageSampleDistance = mapper.GetImageSampleDistance() * pass.Coarseness;
  report.Surfaces = static_cast<int>(this->Scene.Grid.Ids.size());
  report.SurfacesWithoutTexture = this->Scene.Paints.WithoutTexture;
  report.UniformCells = this->Scene.Grid.UniformCells;
  report.SplitCells = this->Scene.Grid.SplitCells + this->Scene.Grid.SeamCells;
  report.EmptyCells = this->Scene.Grid.EmptyCells;
  pass.Parts.IsSoftware = SoftwareOpenGL::IsUsed(pass.Window);
  pass.Parts.HasSplitCells = this->Scene.Grid.SplitCells > 0;
  pass.Parts.HasSeamCells = this->Scene.Grid.SeamCells > 0;
  pass.Parts.HasEmptyCells = this->Scene.Grid.EmptyCells > 0;
  if (pass.Parts.IsShaded && !pass.HasShadows)
  {
    const glm::dvec3 centerVoxel = 0.5 *
      glm::dvec3(
        this->Scene.Grid.Size[0] - 1, this->Scene.Grid.Size[1] - 1, this->Scene.Grid.Size[2] - 1);
    this->Scene.Lights.Gather(
      pass.Renderer, glm::dvec3(this->Scene.View.WorldFromVoxels * glm::dvec4(centerVoxel, 1.0)));
    pass.Parts.Lights = this->Scene.Lights.GetNumber();
  }
  return {};
}

void FlowVolumeRenderer::ReleaseSlices(vtkOpenGLRenderWindow* window, bool hasShadows)
{
  if (!this->Slices)
  {
    return;
  }
  // Releasing a framebuffer unbinds the current framebuffer.
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  this->Slices->ReleaseGraphicsResources(hasShadows ? window : nullptr);
  state->PopFramebufferBindings();
  if (!hasShadows)
  {
    this->Slices.reset();
  }
}

Error FlowVolumeRenderer::DrawSlices(FlowRenderFrame& pass, WindowResources& resources)
{
  vtkOpenGLState* state = pass.Window->GetState();
  state->PushFramebufferBindings();
  resources.ReleaseImageBuffers(pass.Window);
  state->PopFramebufferBindings();
  if (!this->Slices)
  {
    this->Slices = std::make_unique<FlowSlices>();
  }
  return this->Slices->Draw(pass, this->Scene, resources.Textures);
}

Error FlowVolumeRenderer::Draw(FlowRenderFrame& pass, WindowResources& resources)
{
  vtkOpenGLRenderWindow* window = pass.Window;
  vtkTextureObject* depth = resources.OpaqueDepth;
  if (SceneDepth::MayOcclude(pass.Renderer, pass.Volume))
  {
    depth->SetContext(window);
    pass.Parts.HasOpaqueDepth = SceneDepth::CopyTo(pass.Renderer, depth);
  }
  else
  {
    depth->ReleaseGraphicsResources(window);
  }
  const FlowShader shader(pass.Mapper, pass.Parts, this->Scene.Paints, this->Scene.View);
  pass.Report.Features = shader.GetNames();
  pass.Report.ImageBufferBytes =
    FloatTexture::Allocate(window, resources.Image, pass.Size[0], pass.Size[1], 4, true);
  if (pass.Report.ImageBufferBytes == 0)
  {
    return {
      "The GPU does not have enough memory for the image buffer. Reduce the size of the window or "
      "increase ImageSampleDistance.",
      ErrorCode::OutOfMemory
    };
  }
  if (!this->DrawRays(pass, resources, shader))
  {
    return {};
  }
  pass.Report.Passes = 1;
  if (pass.Renderer->GetSelector())
  {
    resources.Selection.Show(pass.Renderer->GetSelector(), window, resources.Image);
  }
  else
  {
    resources.ShowQuad.Draw(window, resources.Image);
  }
  return {};
}

bool FlowVolumeRenderer::DrawRays(
  FlowRenderFrame& pass, WindowResources& resources, const FlowShader& shader)
{
  vtkOpenGLRenderWindow* window = pass.Window;
  vtkTextureObject* bound = resources.OpaqueDepth;
  if (!pass.Parts.HasOpaqueDepth)
  {
    // The quad requires a texture, although the shader does not use it.
    FloatTexture::Allocate(window, resources.NoDepth, 1, 1, 1, false);
    bound = resources.NoDepth;
  }
  RenderProgress progress(window, &pass.Mapper);
  bool isAborted = false;
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  {
    const ScopedGLState scoped(state);
    state->vtkglDisable(GL_CULL_FACE);
    state->vtkglDisable(GL_SCISSOR_TEST);
    resources.Framebuffer->SetContext(window);
    resources.Framebuffer->Bind();
    resources.Framebuffer->AddColorAttachment(0, resources.Image);
    resources.Framebuffer->ActivateDrawBuffer(0);
    state->vtkglViewport(0, 0, pass.Size[0], pass.Size[1]);
    state->vtkglClearColor(0.0F, 0.0F, 0.0F, 0.0F);
    state->vtkglClear(GL_COLOR_BUFFER_BIT);
    for (int band = 0; band < pass.Bands && !isAborted; ++band)
    {
      if (pass.Bands > 1)
      {
        const int bottom = band * pass.Size[1] / pass.Bands;
        state->vtkglEnable(GL_SCISSOR_TEST);
        state->vtkglScissor(
          0, bottom, pass.Size[0], (band + 1) * pass.Size[1] / pass.Bands - bottom);
      }
      resources.RayQuad.DrawWithShader(window, bound, shader.GetSource(),
        [&](vtkShaderProgram* program)
        {
          resources.Textures.Activate(program);
          FlowUniforms::Set(program, this->Scene, pass);
        });
      resources.Textures.Deactivate();
      if (pass.Bands > 1)
      {
        glFinish();
        isAborted = progress.IsAborted((band + 1.0) / pass.Bands);
      }
    }
  }
  state->PopFramebufferBindings();
  return !isAborted;
}

bool FlowVolumeRenderer::BeginPass(FlowRenderFrame& pass)
{
  const int* dimensions = pass.Image->GetDimensions();
  const double samples =
    2.0 * *std::max_element(dimensions, dimensions + 3) * pass.Size[0] * pass.Size[1];
  const double estimate = samples *
    (SoftwareOpenGL::IsUsed(pass.Window)
        ? SOFTWARE_SECONDS / vtkSMPTools::GetEstimatedNumberOfThreads()
        : GPU_SECONDS);
  const double final = this->Times.GetFinalSeconds(pass.Size, estimate);
  const double seconds = this->Refinement.Begin(pass.Renderer, pass.Volume,
    ImageKey(pass.Renderer, pass.Volume, &pass.Mapper), final,
    pass.Volume->GetAllocatedRenderTime());
  if (seconds == ImageRefinement::REUSED)
  {
    return false;
  }
  pass.Coarseness = this->Times.Choose(seconds);
  for (int& size : pass.Size)
  {
    size = std::max(static_cast<int>(std::lround(size / pass.Coarseness)), 1);
  }
  const double bands = final / std::pow(pass.Coarseness, 3.0) / BAND_SECONDS;
  pass.Bands = static_cast<int>(std::clamp(bands, 1.0, std::max(1.0, pass.Size[1] / BAND_ROWS)));
  return true;
}

Error FlowVolumeRenderer::Render(vtkRenderer* renderer, vtkVolume* volume,
  vtkImplicitFlowVolumeMapper& mapper, vtkImageData* image, FlowVolumeRenderReport& report)
{
  const double start = vtkTimerLog::GetUniversalTime();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window)
  {
    return { "The render window is not a vtkOpenGLRenderWindow. Use an OpenGL window.",
      ErrorCode::OpenGL };
  }
  window->MakeCurrent();
  if (!HasOpenGL32())
  {
    return { "OpenGL 3.2 is required, but the render window has an older version.",
      ErrorCode::OpenGL };
  }
  std::unique_ptr<WindowResources>& resources = this->Windows[window];
  if (!resources)
  {
    resources = std::make_unique<WindowResources>();
  }
  FlowRenderFrame pass{ renderer, window, volume, mapper, image, report };
  // Selection does not use lights.
  const bool isSelection = renderer->GetSelector() != nullptr;
  pass.HasShadows = mapper.GetShadows() && !isSelection && FlowSlices::HasShadowLight(renderer);
  if (!pass.HasShadows && !isSelection)
  {
    this->ReleaseSlices(window, mapper.GetShadows());
  }
  int size[2];
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  for (int i = 0; i < 2; ++i)
  {
    pass.Size[i] =
      std::max(static_cast<int>(std::lround(size[i] / mapper.GetImageSampleDistance())), 1);
  }
  const Error error = this->DrawPass(pass, *resources);
  report.Seconds = vtkTimerLog::GetUniversalTime() - start;
  return error;
}

Error FlowVolumeRenderer::DrawPass(FlowRenderFrame& pass, WindowResources& resources)
{
  const bool isSelection = pass.Renderer->GetSelector() != nullptr;
  const bool isRefined = pass.Mapper.GetProgressiveRendering() && !pass.HasShadows && !isSelection;
  this->HasSlices = isSelection ? this->HasSlices : pass.HasShadows;
  if (isSelection)
  {
    // The selection overwrites the image.
    this->Refinement.DropImage();
  }
  else if (!isRefined)
  {
    this->Refinement.Clear();
  }
  else if (!this->BeginPass(pass))
  {
    pass.Report = this->PassReport;
    resources.ShowQuad.Draw(pass.Window, resources.Image);
    return {};
  }
  Error error = this->Update(pass).Then(
    [&] { return FlowSources::Update(pass, this->Scene, resources.Textures); });
  const double start = vtkTimerLog::GetUniversalTime();
  if (!error && !this->Scene.Grid.Ids.empty())
  {
    error = pass.HasShadows ? this->DrawSlices(pass, resources) : this->Draw(pass, resources);
  }
  if (error || this->Scene.Grid.Ids.empty())
  {
    this->Refinement.Clear();
  }
  else if (isRefined && pass.Report.Passes > 0)
  {
    this->EndPass(pass, start);
  }
  return error;
}

void FlowVolumeRenderer::EndPass(const FlowRenderFrame& pass, double start)
{
  glFinish();
  this->Times.Add(pass.Coarseness, vtkTimerLog::GetUniversalTime() - start);
  this->Refinement.End(pass.Coarseness == 1.0);
  // If the image is shown again, nothing is drawn or uploaded.
  this->PassReport = pass.Report;
  this->PassReport.Passes = 0;
  this->PassReport.UploadedBytes = 0;
}

bool FlowVolumeRenderer::IsRefinementPending() const
{
  return this->HasSlices ? this->Slices && this->Slices->IsRefinementPending()
                         : this->Refinement.IsPending();
}

void FlowVolumeRenderer::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Refinement.DropImage();
  if (this->Slices)
  {
    this->Slices->ReleaseGraphicsResources(window);
  }
  for (auto& [owner, resources] : this->Windows)
  {
    if (!window || owner == window)
    {
      resources->Textures.ReleaseGraphicsResources(owner);
      resources->ReleaseImageBuffers(owner);
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
