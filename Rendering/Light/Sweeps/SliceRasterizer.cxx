// SPDX-License-Identifier: BSD-3-Clause
#include "Sweeps/SliceRasterizer.h"

#include "ShadowMaps/SceneOccluders.h"
#include "Common/Vectors.h"
#include "Loader/ScopedGLState.h"
#include "Offscreen/FloatTexture.h"
#include "Offscreen/SceneDepth.h"
#include "Refinement/RenderProgress.h"
#include "Receivers/SliceScene.h"
#include "Shaders/SliceShader.h"
#include "Space/UnitSpace.h"
#include "Sweeps/SliceReport.h"
#include "Translucent/TranslucentShadowMaps.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkPointData.h"
#include "vtkProjectiveLight.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <numeric>

namespace interlume
{

namespace
{
using Sweep = SlicePlan::Sweep;
}

SliceRasterizer::SliceRasterizer() = default;

SliceRasterizer::~SliceRasterizer() = default;

Error SliceRasterizer::FindError(vtkOpenGLRenderWindow* window)
{
  if (!window)
  {
    return Error("The render window is not a vtkOpenGLRenderWindow.", ErrorCode::OpenGL);
  }
  window->MakeCurrent();
  return HasOpenGL32()
    ? Error()
    : Error("The OpenGL version is too old. OpenGL 3.2 or newer is required.", ErrorCode::OpenGL);
}

Error SliceRasterizer::PrepareImage()
{
  vtkOpenGLRenderWindow* window = this->Window;
  SliceReport& report = *this->Report;
  const auto [width, height] = this->State->Size;
  vtkIdType bytes = FloatTexture::Allocate(window, this->Image, width, height, 4, true);
  if (bytes == 0)
  {
    return Error(
      "The graphics card does not have enough memory for the floating-point image of the slices. "
      "Reduce the size of the window.",
      ErrorCode::OutOfMemory);
  }
  report.ImageBuffers = 1;
  report.ImageBufferBytes = bytes;
  if (this->State->Plan.HasMultipleImages())
  {
    bytes = FloatTexture::Allocate(window, this->SweepImage, width, height, 4, false);
    if (bytes == 0)
    {
      return Error("The graphics card does not have enough memory for a second floating-point "
                   "image of the slices. Reduce the size of the window.",
        ErrorCode::OutOfMemory);
    }
    ++report.ImageBuffers;
    report.ImageBufferBytes += bytes;
  }
  else
  {
    this->SweepImage->ReleaseGraphicsResources(window);
  }
  if (this->Opaque && !this->State->Scene)
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
    ? Error()
    : Error("The graphics card cannot render to a floating-point framebuffer.", ErrorCode::OpenGL);
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

Error SliceRasterizer::PrepareLights(const Sweep& sweep)
{
  std::vector<const SlicePolygons*> polygons;
  for (const std::unique_ptr<VolumeSlices>& slices : this->Slices)
  {
    polygons.push_back(&slices->GetPolygons());
  }
  for (const SlicePlan::ShadowedLight& light : sweep.Lights)
  {
    // If a light is in several sweeps, they use the same buffer in turn.
    if (Error error = this->GetLightBuffer(light.Light)
                        .Prepare(this->Window, *this->State, sweep, light, polygons))
    {
      return error;
    }
  }
  return {};
}

void SliceRasterizer::ReleaseUnusedLights()
{
  for (const std::unique_ptr<SliceLightBuffer>& buffer : this->Lights)
  {
    if (!buffer->IsUsed())
    {
      buffer->ReleaseGraphicsResources(this->Window);
    }
  }
  this->Lights.erase(
    std::remove_if(this->Lights.begin(), this->Lights.end(),
      [](const std::unique_ptr<SliceLightBuffer>& buffer) { return !buffer->IsUsed(); }),
    this->Lights.end());
}

void SliceRasterizer::SetVolumes(const std::vector<Volume>& volumes)
{
  while (this->Slices.size() > volumes.size())
  {
    this->Slices.back()->ReleaseGraphicsResources();
    this->Slices.pop_back();
  }
  for (std::size_t i = 0; i < volumes.size(); ++i)
  {
    if (i == this->Slices.size())
    {
      this->Slices.push_back(std::make_unique<VolumeSlices>());
    }
    this->Slices[i]->Set(*volumes[i].State, *volumes[i].Textures);
  }
}

void SliceRasterizer::UpdateOpaqueDepth(vtkRenderer* renderer)
{
  const SliceScene* scene = this->State->Scene;
  this->Opaque = scene ? scene->CameraDepth : nullptr;
  if (scene || !this->State->MayBeOccluded)
  {
    this->OpaqueDepth->ReleaseGraphicsResources(this->Window);
  }
  else
  {
    this->OpaqueDepth->SetContext(this->Window);
    this->Opaque =
      SceneDepth::CopyTo(renderer, this->OpaqueDepth) ? this->OpaqueDepth.Get() : nullptr;
  }
  this->Upsampler.SetDepths(this->Opaque, scene ? scene->FrontDepth : nullptr,
    glm::inverse(this->State->Camera.ClipFromUnit));
}

Error SliceRasterizer::DrawSweeps()
{
  vtkOpenGLState* state = this->Window->GetState();
  const ScopedGLState scoped(state);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_BLEND);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglDepthFunc(GL_LESS);
  const SlicePlan& plan = this->State->Plan;
  Error error = this->PrepareImage();
  for (std::size_t i = 0; i < plan.Sweeps.size() && !error && !this->IsAborted; ++i)
  {
    error = this->DrawSweep(i);
    if (!error && plan.IsLastInImage(i) && !plan.IsInFirstImage(i))
    {
      this->AddSweepImage();
    }
  }
  return error;
}

Error SliceRasterizer::Draw(vtkRenderer* renderer, const ImageState& image,
  const std::vector<Volume>& volumes, RenderProgress& progress, SliceReport& report)
{
  this->Window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  this->State = &image;
  this->Progress = &progress;
  this->Report = &report;
  this->Slabs = std::accumulate(image.Plan.Sweeps.begin(), image.Plan.Sweeps.end(), 0,
    [](int sum, const Sweep& sweep) { return sum + sweep.Slabs; });
  this->CompleteSlabs = 0;
  this->IsAborted = false;
  this->SetVolumes(volumes);
  this->UpdateOpaqueDepth(renderer);
  for (const std::unique_ptr<SliceLightBuffer>& buffer : this->Lights)
  {
    buffer->SetUnused();
  }
  this->HasImage = false;
  vtkOpenGLState* state = this->Window->GetState();
  state->PushFramebufferBindings();
  Error error = this->DrawSweeps();
  state->PopFramebufferBindings();
  this->ReleaseUnusedLights();
  for (const std::unique_ptr<SliceLightBuffer>& buffer : this->Lights)
  {
    ++report.LightBuffers;
    report.LightBufferBytes += buffer->GetBytes();
    report.LightLayers += buffer->GetNumberOfSampleLayers();
    report.SoftShadowBytes += buffer->GetSoftShadowBytes();
    report.LightBufferSize =
      std::max(report.LightBufferSize, static_cast<int>(buffer->GetTexture()->GetWidth()));
    report.LightChannels = buffer->GetTexture()->GetComponents();
  }
  this->HasImage = !error && !this->IsAborted;
  return error;
}

void SliceRasterizer::ActivateTextures(std::size_t sweepIndex, vtkShaderProgram* program)
{
  const SliceScene* scene = this->State->Scene;
  this->Window->GetShaderCache()->ReadyShaderProgram(program);
  const auto activate = [&](vtkTextureObject* texture, const std::string& name)
  {
    texture->Activate();
    program->SetUniformi(name.c_str(), texture->GetTextureUnit());
    this->Active.push_back(texture);
  };
  if (this->Opaque)
  {
    activate(this->Opaque, "opaqueDepth");
  }
  if (scene)
  {
    for (const auto& [name, texture] : scene->Occluders->GetTextures())
    {
      if (program->IsUniformUsed(name))
      {
        activate(texture, name);
      }
    }
  }
  if (program->IsUniformUsed("translucentLayers"))
  {
    activate(scene->TranslucentMaps->GetTexture(), "translucentLayers");
  }
  if (program->IsUniformUsed("frontDepth"))
  {
    activate(scene->FrontDepth, "frontDepth");
  }
  const std::size_t shadowed = this->State->Plan.Sweeps[sweepIndex].Lights.size();
  std::size_t number = 0;
  for (int light : SliceShader::GetSweepLights(this->Slices[0]->GetFrame(), sweepIndex))
  {
    const std::string suffix = "_" + std::to_string(number);
    if (number < shadowed)
    {
      activate(this->GetLightBuffer(light).GetTexture(), "buffer" + suffix);
    }
    vtkProjectiveLight* projective = this->State->Lights[light].Projective;
    if (projective && projective->GetImage())
    {
      activate(this->Slices[0]->GetTextures().GetScreens().Get(
                 this->Window, projective, this->Report->UploadedBytes),
        "image" + suffix);
    }
    ++number;
  }
}

void SliceRasterizer::DeactivateTextures()
{
  for (const std::unique_ptr<VolumeSlices>& slices : this->Slices)
  {
    slices->End();
  }
  for (vtkTextureObject* texture : this->Active)
  {
    texture->Deactivate();
  }
  this->Active.clear();
}

void SliceRasterizer::BeginSweep(std::size_t sweepIndex)
{
  vtkOpenGLState* state = this->Window->GetState();
  const SlicePlan& plan = this->State->Plan;
  this->BindImage(plan.IsInFirstImage(sweepIndex) ? this->Image : this->SweepImage);
  SliceOcclusion::Clear(this->Window);
  if (!plan.Sweeps[sweepIndex].IsBehind)
  {
    state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glClear(GL_COLOR_BUFFER_BIT);
  }
}

void SliceRasterizer::BindImage(vtkTextureObject* image)
{
  this->ImageFramebuffer->Bind();
  this->ImageFramebuffer->AddColorAttachment(0, image);
  this->ImageFramebuffer->ActivateDrawBuffer(0);
  this->Window->GetState()->vtkglViewport(0, 0, this->State->Size[0], this->State->Size[1]);
}

void SliceRasterizer::MarkOpaquePixels(int slab)
{
  for (const std::unique_ptr<VolumeSlices>& slices : this->Slices)
  {
    if (!slices->IsEmpty(slab) && !slices->IsOutOfView(slab))
    {
      slices->MarkOpaquePixels(this->Window, this->Occlusion,
        this->ImageFramebuffer->GetColorAttachmentAsTextureObject(0), slab);
      ++this->Report->OcclusionPasses;
    }
  }
}

Error SliceRasterizer::PrepareVolume(std::size_t sweepIndex, std::size_t number)
{
  const Sweep& sweep = this->State->Plan.Sweeps[sweepIndex];
  VolumeSlices& slices = *this->Slices[number];
  Error error = slices.Prepare(this->Window, sweepIndex, this->IsOccluded(), this->HasMarks,
    [&](vtkShaderProgram* program) { this->ActivateTextures(sweepIndex, program); });
  std::vector<SliceLightBuffer*> buffers;
  for (const SlicePlan::ShadowedLight& light : sweep.Lights)
  {
    buffers.push_back(&this->GetLightBuffer(light.Light));
    error = error ? error : buffers.back()->PrepareVolume(this->Window, number, slices);
  }
  return error || !this->HasReceivers ? error
                                      : this->Receivers.Prepare(this->Window, slices, buffers);
}

void SliceRasterizer::FindOrder(std::size_t sweepIndex)
{
  const Sweep& sweep = this->State->Plan.Sweeps[sweepIndex];
  std::vector<SlicePlan::SlicedVolume> volumes;
  this->HasThickPart = false;
  // If the far plane cuts the volumes, draw each slab at a separate depth. Otherwise, slabs whose
  // middle is behind the far plane would fail the depth test.
  this->HasMarks = this->State->FarPlane.IsCutting;
  this->IsDense = false;
  for (const std::unique_ptr<VolumeSlices>& slices : this->Slices)
  {
    const VolumeRenderState& own = slices->GetFrame();
    this->IsDense = this->IsDense ||
      (!own.Medium &&
        SliceShader::GetLargestExtinction(own) * sweep.Spacing > SlicePlan::DenseDepth);
    volumes.push_back({ &own.Space, own.Region.Box, 0.0 });
    this->HasThickPart = this->HasThickPart || SliceShader::HasThickPart(own, sweepIndex);
    this->HasMarks =
      this->HasMarks || this->HasThickPart || SliceShader::HasEmptyPart(own, sweepIndex);
  }
  this->Order.Find(sweep, this->State->Camera, this->State->Lights, volumes);
}

Error SliceRasterizer::PrepareVolumes(std::size_t sweepIndex)
{
  const Sweep& sweep = this->State->Plan.Sweeps[sweepIndex];
  this->FindOrder(sweepIndex);
  this->HasReceivers = this->State->Scene && this->State->Scene->CameraDepth;
  if (this->HasReceivers)
  {
    this->Receivers.Begin(this->Slices, sweepIndex);
  }
  Error error = this->PrepareLights(sweep);
  if (error)
  {
    return error;
  }
  for (const SlicePlan::ShadowedLight& light : sweep.Lights)
  {
    // Activate the buffers here too, since the surfaces of the scene require them even if the first
    // volume is empty.
    this->Active.push_back(this->GetLightBuffer(light.Light).GetTexture());
    this->Active.back()->Activate();
  }
  for (std::size_t i = 0; i < this->Slices.size() && !error; ++i)
  {
    error = this->PrepareVolume(sweepIndex, i);
    this->Bound = i;
    if (i + 1 < this->Slices.size())
    {
      this->Slices[i]->Suspend();
    }
  }
  return error;
}

bool SliceRasterizer::IsEmpty(int slab) const
{
  return std::all_of(this->Slices.begin(), this->Slices.end(),
    [slab](const std::unique_ptr<VolumeSlices>& slices) { return slices->IsEmpty(slab); });
}

bool SliceRasterizer::CheckAbort()
{
  const double fraction = static_cast<double>(this->CompleteSlabs) / this->Slabs;
  ++this->CompleteSlabs;
  this->IsAborted = this->Progress->IsAborted(fraction);
  return this->IsAborted;
}

Error SliceRasterizer::DrawSweep(std::size_t sweepIndex)
{
  const Sweep& sweep = this->State->Plan.Sweeps[sweepIndex];
  SliceReport& report = *this->Report;
  for (const std::unique_ptr<VolumeSlices>& slices : this->Slices)
  {
    report.TriangleBytes += slices->Cut(sweep);
  }
  report.Slices += sweep.Slabs;
  if (std::all_of(this->Slices.begin(), this->Slices.end(),
        [](const std::unique_ptr<VolumeSlices>& slices) { return slices->IsEmpty(); }))
  {
    this->BeginSweep(sweepIndex);
    return {};
  }

  if (Error error = this->PrepareVolumes(sweepIndex))
  {
    this->DeactivateTextures();
    return error;
  }
  this->BeginSweep(sweepIndex);
  const int interval =
    this->HasThickPart || this->IsDense ? SliceOcclusion::ThickInterval : SliceOcclusion::Interval;
  int drawn = 0;
  for (int slab = 0; slab < sweep.Slabs && !this->CheckAbort(); ++slab)
  {
    const bool isEmpty = this->IsEmpty(slab);
    for (std::size_t i = 0; i < sweep.Lights.size() && !isEmpty; ++i)
    {
      const SlicePlan::ShadowedLight& light = sweep.Lights[i];
      report.SoftShadowPasses +=
        this->GetLightBuffer(light.Light).Begin(this->Window, this->Slices, slab);
    }
    if (this->HasThickPart)
    {
      this->UpdateLayers(sweep, slab);
    }
    if (isEmpty)
    {
      continue;
    }
    const bool hasImage = drawn > 0 || sweep.IsBehind;
    if (sweep.IsFrontToBack && hasImage && drawn % interval == 0)
    {
      this->MarkOpaquePixels(slab);
    }
    for (std::size_t i = 0; i < sweep.Lights.size() && drawn > 0 && drawn % interval == 0; ++i)
    {
      report.OcclusionPasses +=
        this->GetLightBuffer(sweep.Lights[i].Light).MarkOccluded(this->Window, this->Slices, slab);
    }
    this->DrawSlab(sweep, slab);
    ++drawn;
  }
  this->DrawReceivers(sweep.Slabs);
  this->DeactivateTextures();
  report.SlicesDrawn += drawn;
  return {};
}

void SliceRasterizer::BindVolume(std::size_t number)
{
  if (this->Bound != number)
  {
    this->Slices[this->Bound]->Suspend();
    this->Slices[number]->Resume(this->Window);
    this->Bound = number;
  }
}

void SliceRasterizer::DrawReceivers(int slab)
{
  if (!this->HasReceivers || !this->Receivers.HasRemainingPoints(slab))
  {
    return;
  }
  for (std::size_t i = 0; i < this->Slices.size(); ++i)
  {
    this->BindVolume(i);
    this->Report->SoftShadowPasses += this->Receivers.Draw(this->Window, slab, i);
  }
  this->Receivers.Pass(slab);
}

void SliceRasterizer::DrawSlab(const Sweep& sweep, int slab)
{
  this->DrawReceivers(slab);
  int number = 0;
  for (const std::size_t volume : this->Order.Get(slab))
  {
    VolumeSlices& slices = *this->Slices[volume];
    if (slices.IsEmpty(slab))
    {
      continue;
    }
    this->BindVolume(volume);
    if (!slices.IsOutOfView(slab))
    {
      this->ImageFramebuffer->Bind(GL_DRAW_FRAMEBUFFER);
      this->Window->GetState()->vtkglViewport(0, 0, this->State->Size[0], this->State->Size[1]);
      slices.Draw(this->Window, sweep, slab, number, static_cast<int>(this->Slices.size()));
      ++this->Report->ImagePasses;
    }
    for (const SlicePlan::ShadowedLight& light : sweep.Lights)
    {
      this->Report->LightPasses +=
        this->GetLightBuffer(light.Light).Draw(this->Window, slices.GetPolygons(), slab, volume);
    }
    ++number;
  }
}

void SliceRasterizer::UpdateLayers(const Sweep& sweep, int slab)
{
  for (std::size_t volume = 0; volume < this->Slices.size(); ++volume)
  {
    const VolumeSlices& slices = *this->Slices[volume];
    for (std::size_t i = 0; i < sweep.Lights.size() && slices.HasThickPart(); ++i)
    {
      SliceLightBuffer& buffer = this->GetLightBuffer(sweep.Lights[i].Light);
      if (sweep.Lights[i].IsWide || !buffer.UpdateLayer(slab, slices.IsEmpty(slab), volume))
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
      vtkShaderProgram* program = slices.GetThickProgram();
      this->Window->GetShaderCache()->ReadyShaderProgram(program);
      program->SetUniformi(("layer" + suffix).c_str(), layer->GetTextureUnit());
      program->SetUniformf(("layerEntrance" + suffix).c_str(),
        static_cast<float>(sweep.First + buffer.GetLayerSlab(volume) * sweep.Spacing));
    }
  }
}

void SliceRasterizer::AddSweepImage()
{
  // Add only the colors: each image contains the contributions of different lights, but all images
  // have the same opacity.
  this->BindImage(this->Image);
  this->SumQuad.Draw(this->Window, this->SweepImage, "SUM");
}

void SliceRasterizer::Show(vtkRenderer* renderer)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkTextureObject* image = this->HasImage ? this->Image.Get() : nullptr;
  if (renderer->GetSelector())
  {
    this->Selection.Show(renderer->GetSelector(), window, image);
  }
  else if (image && !this->Upsampler.Show(window, image))
  {
    this->Quad.Draw(window, image);
  }
}

bool SliceRasterizer::ReadLightBuffer(vtkOpenGLRenderWindow* window, const ImageState& state,
  const UnitSpace& space, vtkLight* light, vtkImageData* image)
{
  for (const SlicePlan::Sweep& sweep : state.Plan.Sweeps)
  {
    for (const SlicePlan::ShadowedLight& shadowed : sweep.Lights)
    {
      if (state.Lights[shadowed.Light].Light != light)
      {
        continue;
      }
      int size = 0;
      int channels = 0;
      const std::vector<float> texels =
        this->GetLightBuffer(shadowed.Light).Read(window, size, channels);
      if (texels.empty())
      {
        return false;
      }
      image->Initialize();
      image->SetDimensions(size, size, 1);
      vtkNew<vtkFloatArray> values;
      values->SetName("Transmittance");
      values->SetNumberOfComponents(channels);
      values->SetNumberOfTuples(static_cast<vtkIdType>(size) * size);
      std::copy(texels.begin(), texels.end(), values->GetPointer(0));
      image->GetPointData()->SetScalars(values);

      // The matrix transforms world coordinates to unit space, to the light's clip coordinates, and
      // to texture coordinates.
      glm::dmat4 texture(glm::dmat3(0.5));
      texture[3] = glm::dvec4(0.5, 0.5, 0.5, 1.0);
      vtkNew<vtkDoubleArray> matrix;
      matrix->SetName("BufferFromWorld");
      matrix->SetNumberOfTuples(16);
      const glm::dmat4 rows =
        glm::transpose(texture * (shadowed.BufferFromUnit * space.GetUnitFromWorld()));
      std::copy_n(glm::value_ptr(rows), 16, matrix->GetPointer(0));
      image->GetFieldData()->AddArray(matrix);
      return true;
    }
  }
  return false;
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
  for (const std::unique_ptr<VolumeSlices>& slices : this->Slices)
  {
    slices->ReleaseGraphicsResources();
  }
  this->Slices.clear();
  this->Receivers.ReleaseGraphicsResources();
  this->Quad.ReleaseGraphicsResources(window);
  this->SumQuad.ReleaseGraphicsResources(window);
  this->Upsampler.ReleaseGraphicsResources(window);
  this->Selection.ReleaseGraphicsResources(window);
}

}
