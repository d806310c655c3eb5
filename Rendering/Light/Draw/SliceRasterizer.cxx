// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/SliceRasterizer.h"

#include "Draw/SliceShader.h"
#include "Casters/SceneCasters.h"
#include "Loader/ScopedState.h"
#include "Receivers/SliceScene.h"
#include "Translucent/PaneMaps.h"

#include "vtkFloatTarget.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkProjectiveLight.h"
#include "vtkRenderer.h"
#include "vtkSceneDepth.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>

namespace interlume
{

namespace
{
using Sweep = SlicePlan::Sweep;

}

SliceRasterizer::SliceRasterizer() = default;

SliceRasterizer::~SliceRasterizer() = default;

std::string SliceRasterizer::FindFault(vtkOpenGLRenderWindow* window)
{
  window->MakeCurrent();
  return HasOpenGL32() ? std::string() : std::string("OpenGL is older than 3.2");
}

std::string SliceRasterizer::PrepareImage(
  vtkOpenGLRenderWindow* window, const SliceFrame& frame, vtkShadowedSliceReport& report)
{
  const int width = frame.Size[0];
  const int height = frame.Size[1];
  vtkIdType bytes = vtkFloatTarget::Allocate(window, this->Image, width, height, 4, true);
  if (bytes == 0)
  {
    return "the graphics card has no memory for a picture of floats";
  }
  report.ImageBuffers = 1;
  report.ImageBufferBytes = bytes;
  if (frame.Plan.HasFurtherPictures())
  {
    bytes = vtkFloatTarget::Allocate(window, this->SweepImage, width, height, 4, false);
    if (bytes == 0)
    {
      return "the graphics card has no memory for a second picture of floats";
    }
    ++report.ImageBuffers;
    report.ImageBufferBytes += bytes;
  }
  else
  {
    this->SweepImage->ReleaseGraphicsResources(window);
  }
  if (this->HasOpaqueDepth && !frame.Scene)
  {
    ++report.ImageBuffers;
    report.ImageBufferBytes += static_cast<vtkIdType>(sizeof(float)) *
      static_cast<vtkIdType>(this->OpaqueDepth->GetWidth()) *
      static_cast<vtkIdType>(this->OpaqueDepth->GetHeight());
  }
  this->ImageFramebuffer->SetContext(window);
  ++report.ImageBuffers;
  report.ImageBufferBytes +=
    this->Occlusion.Prepare(window, this->ImageFramebuffer, width, height, true);
  this->ImageFramebuffer->Bind();
  this->ImageFramebuffer->AddColorAttachment(0, this->Image);
  this->ImageFramebuffer->ActivateDrawBuffer(0);
  const char* status = nullptr;
  return vtkOpenGLFramebufferObject::GetFrameBufferStatus(GL_DRAW_FRAMEBUFFER, status)
    ? std::string()
    : std::string("a framebuffer of floats cannot be drawn to");
}

SliceLightBuffer& SliceRasterizer::GetLightBuffer(int light)
{
  const auto found = std::find_if(this->Lights.begin(), this->Lights.end(),
    [light](const std::unique_ptr<SliceLightBuffer>& buffer)
    { return buffer->GetLight() == light; });
  if (found != this->Lights.end())
  {
    return **found;
  }
  this->Lights.push_back(std::make_unique<SliceLightBuffer>(light));
  return *this->Lights.back();
}

std::string SliceRasterizer::PrepareLights(
  vtkOpenGLRenderWindow* window, const SliceFrame& frame, std::size_t sweepIndex)
{
  const Sweep& sweep = frame.Plan.Sweeps[sweepIndex];
  std::vector<const SlicePolygons*> polygons;
  for (const std::unique_ptr<SlicePart>& part : this->Parts)
  {
    polygons.push_back(&part->GetPolygons());
  }
  for (const SlicePlan::ShadowedLight& light : sweep.Lights)
  {
    // A light of several sweeps has its buffer in each in turn.
    std::string error =
      this->GetLightBuffer(light.Light).Prepare(window, frame, sweep, light, polygons);
    if (!error.empty())
    {
      return error;
    }
  }
  return {};
}

void SliceRasterizer::ReleaseUnusedLights(vtkWindow* window)
{
  for (const std::unique_ptr<SliceLightBuffer>& buffer : this->Lights)
  {
    if (!buffer->IsUsed())
    {
      buffer->ReleaseGraphicsResources(window);
    }
  }
  this->Lights.erase(
    std::remove_if(this->Lights.begin(), this->Lights.end(),
      [](const std::unique_ptr<SliceLightBuffer>& buffer) { return !buffer->IsUsed(); }),
    this->Lights.end());
}

std::string SliceRasterizer::Draw(vtkRenderer* renderer, const std::vector<Volume>& volumes,
  const std::function<bool()>& isAborted, vtkShadowedSliceReport& report)
{
  const SliceFrame& frame = *volumes[0].Frame;
  while (this->Parts.size() > volumes.size())
  {
    this->Parts.back()->ReleaseGraphicsResources();
    this->Parts.pop_back();
  }
  for (std::size_t i = 0; i < volumes.size(); ++i)
  {
    if (i == this->Parts.size())
    {
      this->Parts.push_back(std::make_unique<SlicePart>());
    }
    this->Parts[i]->Set(*volumes[i].Frame, *volumes[i].Textures);
  }
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkOpenGLState* state = window->GetState();
  this->HasOpaqueDepth = false;
  if (frame.Scene)
  {
    this->HasOpaqueDepth = frame.Scene->EyeDepth != nullptr;
    this->OpaqueDepth->ReleaseGraphicsResources(window);
  }
  else if (frame.MayBeOccluded)
  {
    this->OpaqueDepth->SetContext(window);
    this->HasOpaqueDepth = vtkSceneDepth::CopyTo(renderer, this->OpaqueDepth);
  }
  else
  {
    this->OpaqueDepth->ReleaseGraphicsResources(window);
  }
  vtkTextureObject* surfaces = frame.Scene ? frame.Scene->EyeDepth : this->OpaqueDepth.Get();
  this->Coarse.SetDepths(this->HasOpaqueDepth ? surfaces : nullptr,
    frame.Scene ? frame.Scene->FrontDepth : nullptr, glm::inverse(frame.Eye.ClipFromUnit));
  report.Features = SliceShader::GetNames(frame, this->HasOpaqueDepth);
  for (const std::unique_ptr<SliceLightBuffer>& buffer : this->Lights)
  {
    buffer->SetUnused();
  }
  this->HasImage = false;
  std::string error;
  state->PushFramebufferBindings();
  {
    const ScopedState scoped(state);
    state->vtkglDisable(GL_CULL_FACE);
    state->vtkglDisable(GL_SCISSOR_TEST);
    state->vtkglDisable(GL_DEPTH_TEST);
    state->vtkglEnable(GL_BLEND);
    state->vtkglDepthMask(GL_FALSE);
    state->vtkglDepthFunc(GL_LESS);
    error = this->PrepareImage(window, frame, report);
    for (std::size_t i = 0; i < frame.Plan.Sweeps.size() && error.empty(); ++i)
    {
      error = this->DrawSweep(window, frame, i, isAborted, report);
      if (error.empty() && frame.Plan.IsLastOfPicture(i) && !frame.Plan.IsOfFirstPicture(i))
      {
        this->AddSweep(window, frame);
      }
    }
  }
  state->PopFramebufferBindings();
  this->ReleaseUnusedLights(window);
  for (const std::unique_ptr<SliceLightBuffer>& buffer : this->Lights)
  {
    ++report.LightBuffers;
    report.LightBufferBytes += buffer->GetBytes();
    report.LightLayers += buffer->GetNumberOfSampleLayers();
    report.SoftShadowBytes += buffer->GetSoftBytes();
    report.LightBufferSize =
      std::max(report.LightBufferSize, static_cast<int>(buffer->GetTexture()->GetWidth()));
    report.LightChannels = buffer->GetTexture()->GetComponents();
  }
  this->HasImage = error.empty();
  return error;
}

void SliceRasterizer::ActivateTextures(vtkOpenGLRenderWindow* window, const SliceFrame& frame,
  std::size_t sweepIndex, vtkShaderProgram* program, vtkShadowedSliceReport& report)
{
  window->GetShaderCache()->ReadyShaderProgram(program);
  const auto activate = [&](vtkTextureObject* texture, const std::string& name)
  {
    texture->Activate();
    program->SetUniformi(name.c_str(), texture->GetTextureUnit());
    this->Active.push_back(texture);
  };
  if (this->HasOpaqueDepth)
  {
    activate(frame.Scene ? frame.Scene->EyeDepth : this->OpaqueDepth.Get(), "opaqueDepth");
  }
  if (frame.Scene)
  {
    for (const auto& [name, texture] : frame.Scene->Casters->GetTextures())
    {
      if (program->IsUniformUsed(name))
      {
        activate(texture, name);
      }
    }
  }
  if (program->IsUniformUsed("paneLayers"))
  {
    activate(frame.Scene->Panes->GetTexture(), "paneLayers");
  }
  if (program->IsUniformUsed("frontDepth"))
  {
    activate(frame.Scene->FrontDepth, "frontDepth");
  }
  const std::size_t shadowed = frame.Plan.Sweeps[sweepIndex].Lights.size();
  std::size_t number = 0;
  for (int light : SliceShader::GetLightsOf(frame, sweepIndex))
  {
    const std::string suffix = "_" + std::to_string(number);
    if (number < shadowed)
    {
      activate(this->GetLightBuffer(light).GetTexture(), "buffer" + suffix);
    }
    vtkProjectiveLight* projective = frame.Lights[light].Projective;
    if (projective && projective->GetImage())
    {
      activate(
        this->Parts[0]->GetTextures().GetScreens().Get(window, projective, report.UploadedBytes),
        "image" + suffix);
    }
    ++number;
  }
}

void SliceRasterizer::DeactivateTextures()
{
  for (const std::unique_ptr<SlicePart>& part : this->Parts)
  {
    part->End();
  }
  for (vtkTextureObject* texture : this->Active)
  {
    texture->Deactivate();
  }
  this->Active.clear();
}

void SliceRasterizer::BeginSweep(vtkOpenGLRenderWindow* window, const SliceFrame& frame,
  std::size_t sweepIndex, vtkShadowedSliceReport& report)
{
  vtkOpenGLState* state = window->GetState();
  this->ImageFramebuffer->Bind();
  this->ImageFramebuffer->AddColorAttachment(
    0, frame.Plan.IsOfFirstPicture(sweepIndex) ? this->Image.Get() : this->SweepImage.Get());
  this->ImageFramebuffer->ActivateDrawBuffer(0);
  state->vtkglViewport(0, 0, frame.Size[0], frame.Size[1]);
  SliceOcclusion::Clear(window);
  if (frame.Plan.Sweeps[sweepIndex].IsBehind)
  {
    this->MarkPicture(window);
    ++report.OcclusionPasses;
    return;
  }
  state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  glClear(GL_COLOR_BUFFER_BIT);
}

void SliceRasterizer::MarkPicture(vtkOpenGLRenderWindow* window)
{
  this->Occlusion.Mark(
    window, this->ImageFramebuffer->GetColorAttachmentAsTextureObject(0), SliceOcclusion::OPACITY);
}

std::string SliceRasterizer::PreparePart(vtkOpenGLRenderWindow* window, const SliceFrame& frame,
  std::size_t sweepIndex, std::size_t number, vtkShadowedSliceReport& report)
{
  const Sweep& sweep = frame.Plan.Sweeps[sweepIndex];
  SlicePart& part = *this->Parts[number];
  std::string error = part.Prepare(window, sweepIndex, this->HasOpaqueDepth, this->HasMarks,
    [&](vtkShaderProgram* program)
    { this->ActivateTextures(window, frame, sweepIndex, program, report); });
  std::vector<SliceLightBuffer*> buffers;
  for (const SlicePlan::ShadowedLight& light : sweep.Lights)
  {
    SliceLightBuffer& buffer = this->GetLightBuffer(light.Light);
    buffers.push_back(&buffer);
    if (error.empty())
    {
      error = buffer.PrepareVolume(window, sweep, light, number, part, part.HasThickPart());
    }
  }
  if (error.empty() && this->HasReceivers)
  {
    error = this->Receivers.Prepare(window, part, buffers);
  }
  return error;
}

std::string SliceRasterizer::PrepareParts(vtkOpenGLRenderWindow* window, const SliceFrame& frame,
  std::size_t sweepIndex, vtkShadowedSliceReport& report)
{
  std::vector<SlicePlan::Matter> matter;
  this->HasThickPart = false;
  this->HasMarks = false;
  this->IsDense = false;
  for (const std::unique_ptr<SlicePart>& part : this->Parts)
  {
    const SliceFrame& own = part->GetFrame();
    this->IsDense = this->IsDense ||
      (!own.Matter &&
        SliceShader::GetLargestExtinction(own) * frame.Plan.Sweeps[sweepIndex].Spacing >
          SlicePlan::DenseDepth);
    matter.push_back({ &own.Space, own.Region.Box, 0.0 });
    this->HasThickPart = this->HasThickPart || SliceShader::HasThickPart(own, sweepIndex);
    // Depths of a slab's middle behind the far plane would not pass the test.
    this->HasMarks = this->HasMarks || this->HasThickPart ||
      SliceShader::HasEmptyPart(own, sweepIndex) || own.FarPlane.IsCutting;
  }
  this->Order.Find(frame.Plan.Sweeps[sweepIndex], frame.Eye, frame.Lights, matter);
  this->HasReceivers = frame.Scene && frame.Scene->EyeDepth;
  if (this->HasReceivers)
  {
    this->Receivers.Begin(this->Parts, sweepIndex);
  }
  std::string error = this->PrepareLights(window, frame, sweepIndex);
  if (!error.empty())
  {
    return error;
  }
  for (const SlicePlan::ShadowedLight& light : frame.Plan.Sweeps[sweepIndex].Lights)
  {
    // Surfaces ask for them also where the first volume draws nothing.
    this->Active.push_back(this->GetLightBuffer(light.Light).GetTexture());
    this->Active.back()->Activate();
  }
  for (std::size_t i = 0; i < this->Parts.size() && error.empty(); ++i)
  {
    error = this->PreparePart(window, frame, sweepIndex, i, report);
    this->Bound = i;
    if (i + 1 < this->Parts.size())
    {
      this->Parts[i]->Suspend();
    }
  }
  return error;
}

bool SliceRasterizer::IsEmpty(int slab) const
{
  return std::all_of(this->Parts.begin(), this->Parts.end(),
    [slab](const std::unique_ptr<SlicePart>& part) { return part->IsEmpty(slab); });
}

std::string SliceRasterizer::DrawSweep(vtkOpenGLRenderWindow* window, const SliceFrame& frame,
  std::size_t sweepIndex, const std::function<bool()>& isAborted, vtkShadowedSliceReport& report)
{
  const Sweep& sweep = frame.Plan.Sweeps[sweepIndex];
  for (const std::unique_ptr<SlicePart>& part : this->Parts)
  {
    report.TriangleBytes += part->Cut(sweep);
  }
  report.Slices += sweep.Slabs;
  if (std::all_of(this->Parts.begin(), this->Parts.end(),
        [](const std::unique_ptr<SlicePart>& part) { return part->IsEmpty(); }))
  {
    this->BeginSweep(window, frame, sweepIndex, report);
    return {};
  }

  const std::string error = this->PrepareParts(window, frame, sweepIndex, report);
  if (!error.empty())
  {
    this->DeactivateTextures();
    return error;
  }
  this->BeginSweep(window, frame, sweepIndex, report);
  const int interval =
    this->HasThickPart ? SliceOcclusion::ThickInterval : SliceOcclusion::Interval;
  const int pictureInterval = this->IsDense ? SliceOcclusion::ThickInterval : interval;
  int drawn = 0;
  for (int slab = 0; slab < sweep.Slabs && !isAborted(); ++slab)
  {
    const bool isEmpty = this->IsEmpty(slab);
    for (std::size_t i = 0; i < sweep.Lights.size() && !isEmpty; ++i)
    {
      const SlicePlan::ShadowedLight& light = sweep.Lights[i];
      report.SoftShadowPasses +=
        this->GetLightBuffer(light.Light).Begin(window, sweep, light, slab);
    }
    if (this->HasThickPart)
    {
      this->KeepLayers(window, sweep, slab);
    }
    if (isEmpty)
    {
      continue;
    }
    this->DrawSlab(window, frame, sweep, slab, report);
    ++drawn;
    if (sweep.IsFrontToBack && drawn % pictureInterval == 0)
    {
      this->MarkPicture(window);
      ++report.OcclusionPasses;
    }
    for (std::size_t i = 0; i < sweep.Lights.size() && drawn % interval == 0; ++i)
    {
      this->GetLightBuffer(sweep.Lights[i].Light).MarkOccluded(window);
      ++report.OcclusionPasses;
    }
  }
  this->DrawReceivers(window, sweep.Slabs, report);
  this->DeactivateTextures();
  report.SlicesDrawn += drawn;
  return {};
}

void SliceRasterizer::BindPart(vtkOpenGLRenderWindow* window, std::size_t number)
{
  if (this->Bound != number)
  {
    this->Parts[this->Bound]->Suspend();
    this->Parts[number]->Resume(window);
    this->Bound = number;
  }
}

void SliceRasterizer::DrawReceivers(
  vtkOpenGLRenderWindow* window, int slab, vtkShadowedSliceReport& report)
{
  if (!this->HasReceivers || !this->Receivers.IsLeft(slab))
  {
    return;
  }
  for (std::size_t i = 0; i < this->Parts.size(); ++i)
  {
    this->BindPart(window, i);
    report.SoftShadowPasses += this->Receivers.Draw(window, slab, i);
  }
  this->Receivers.Pass(slab);
}

void SliceRasterizer::DrawSlab(vtkOpenGLRenderWindow* window, const SliceFrame& frame,
  const Sweep& sweep, int slab, vtkShadowedSliceReport& report)
{
  this->DrawReceivers(window, slab, report);
  int number = 0;
  for (const std::size_t volume : this->Order.Get(slab))
  {
    SlicePart& part = *this->Parts[volume];
    if (part.IsEmpty(slab))
    {
      continue;
    }
    this->BindPart(window, volume);
    if (!part.IsOutOfView(slab))
    {
      this->ImageFramebuffer->Bind(GL_DRAW_FRAMEBUFFER);
      window->GetState()->vtkglViewport(0, 0, frame.Size[0], frame.Size[1]);
      part.Draw(window, sweep, slab, number, static_cast<int>(this->Parts.size()));
      ++report.EyePasses;
    }
    for (const SlicePlan::ShadowedLight& light : sweep.Lights)
    {
      report.LightPasses +=
        this->GetLightBuffer(light.Light).Draw(window, sweep, part.GetPolygons(), slab, volume);
    }
    ++number;
  }
}

void SliceRasterizer::KeepLayers(vtkOpenGLRenderWindow* window, const Sweep& sweep, int slab)
{
  for (std::size_t volume = 0; volume < this->Parts.size(); ++volume)
  {
    const SlicePart& part = *this->Parts[volume];
    for (std::size_t i = 0; i < sweep.Lights.size() && part.HasThickPart(); ++i)
    {
      SliceLightBuffer& buffer = this->GetLightBuffer(sweep.Lights[i].Light);
      if (sweep.Lights[i].IsWide || !buffer.KeepLayer(slab, part.IsEmpty(slab), volume))
      {
        continue;
      }
      const std::string suffix = "_" + std::to_string(i);
      vtkTextureObject* layer = buffer.GetLayer(volume);
      layer->Activate();
      if (std::find(this->Active.begin(), this->Active.end(), layer) == this->Active.end())
      {
        this->Active.push_back(layer);
      }
      vtkShaderProgram* program = part.GetThickProgram();
      window->GetShaderCache()->ReadyShaderProgram(program);
      program->SetUniformi(("layer" + suffix).c_str(), layer->GetTextureUnit());
      program->SetUniformf(("layerEntrance" + suffix).c_str(),
        static_cast<float>(sweep.First + buffer.GetLayerSlab(volume) * sweep.Spacing));
    }
  }
}

void SliceRasterizer::AddSweep(vtkOpenGLRenderWindow* window, const SliceFrame& frame)
{
  // Every sweep has the same opacity; the colours are those of different lights.
  this->ImageFramebuffer->Bind();
  this->ImageFramebuffer->AddColorAttachment(0, this->Image);
  this->ImageFramebuffer->ActivateDrawBuffer(0);
  window->GetState()->vtkglViewport(0, 0, frame.Size[0], frame.Size[1]);
  this->SumQuad.Draw(window, this->SweepImage, "SUM");
}

bool SliceRasterizer::Show(vtkOpenGLRenderWindow* window)
{
  if (this->HasImage && !this->Coarse.Show(window, this->Image))
  {
    this->Quad.Draw(window, this->Image);
  }
  return this->HasImage;
}

void SliceRasterizer::ShowSelection(vtkHardwareSelector* selector, vtkOpenGLRenderWindow* window)
{
  this->Selection.Show(selector, window, this->HasImage ? this->Image.Get() : nullptr);
}

std::vector<float> SliceRasterizer::ReadLightBuffer(
  vtkOpenGLRenderWindow* window, int light, int& size, int& channels)
{
  for (const std::unique_ptr<SliceLightBuffer>& buffer : this->Lights)
  {
    if (buffer->GetLight() == light)
    {
      return buffer->Read(window, size, channels);
    }
  }
  return {};
}

void SliceRasterizer::ReleaseGraphicsResources(vtkWindow* window)
{
  this->HasImage = false;
  for (vtkTextureObject* texture :
    { this->Image.Get(), this->SweepImage.Get(), this->OpaqueDepth.Get() })
  {
    texture->ReleaseGraphicsResources(window);
  }
  this->ImageFramebuffer->ReleaseGraphicsResources(window);
  this->Occlusion.ReleaseGraphicsResources(window);
  for (const std::unique_ptr<SliceLightBuffer>& buffer : this->Lights)
  {
    buffer->ReleaseGraphicsResources(window);
  }
  this->Lights.clear();
  for (const std::unique_ptr<SlicePart>& part : this->Parts)
  {
    part->ReleaseGraphicsResources();
  }
  this->Parts.clear();
  this->Receivers.ReleaseGraphicsResources();
  this->Quad.ReleaseGraphicsResources(window);
  this->SumQuad.ReleaseGraphicsResources(window);
  this->Coarse.ReleaseGraphicsResources(window);
  this->Selection.ReleaseGraphicsResources(window);
}

}
