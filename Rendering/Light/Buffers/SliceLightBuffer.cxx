// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/SliceLightBuffer.h"

#include "Buffers/VolumeSlices.h"
#include "Loader/OpenGLFunctions.h"
#include "Offscreen/FloatTexture.h"
#include "Plan/SlicePolygons.h"
#include "Shaders/SliceShader.h"
#include "Shaders/VolumeRenderState.h"

#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace interlume
{

SliceLightBuffer::SliceLightBuffer(int light)
  : Light(light)
{
}

SliceLightBuffer::~SliceLightBuffer() = default;

vtkIdType SliceLightBuffer::GetNumberOfSoftShadowTexels(const SlicePlan::ShadowedLight& light)
{
  return light.SoftMethod == SlicePlan::LAYERS ? EmitterSampleLayers::GetTexels(light)
    : light.SoftMethod == SlicePlan::CONVOLUTION
    ? static_cast<vtkIdType>(light.BufferSize) * light.BufferSize
    : 0;
}

Error SliceLightBuffer::Prepare(vtkOpenGLRenderWindow* window, const ImageState& image,
  const SlicePlan::Sweep& sweep, const SlicePlan::ShadowedLight& light,
  const std::vector<const SlicePolygons*>& polygons)
{
  this->Sweep = &sweep;
  this->Planned = &light;
  this->IsWide = light.IsWide;
  this->Size = light.BufferSize;
  this->Bytes = FloatTexture::Allocate(
    window, this->Texture, this->Size, this->Size, image.GetLightChannels(), image.IsSmoothLookup);
  if (this->Bytes == 0)
  {
    return Error(
      "The graphics card does not have enough memory for a light buffer. Reduce LightBufferSize.",
      ErrorCode::OutOfMemory);
  }
  if (Error error = this->PrepareSoftShadows(window, image, polygons))
  {
    return error;
  }
  this->Framebuffer->SetContext(window);
  this->Framebuffer->Bind();
  this->Framebuffer->AddColorAttachment(0, this->Texture);
  if (this->Samples)
  {
    this->Framebuffer->AddColorAttachment(1, this->Samples->GetBatch());
    // Bypass VTK's state: it caches the draw buffers of another framebuffer and would skip this
    // call.
    const std::array<GLenum, 2> both{ { GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1 } };
    glDrawBuffers(2, both.data());
  }
  else
  {
    this->Framebuffer->ActivateDrawBuffer(0);
  }
  // Resize before clearing: OpenGL clears and draws only in the area common to all attachments, and
  // the depth attachment of the last image may be smaller.
  this->Bytes += this->Occlusion.Prepare(window, this->Framebuffer, this->Size, this->Size, false);
  SliceOcclusion::Clear(window);
  // The buffer of a wide light contains optical depth.
  const float start = light.IsWide ? 0.0f : 1.0f;
  window->GetState()->vtkglClearColor(start, start, start, 1.0f);
  glClear(GL_COLOR_BUFFER_BIT);
  // At a point on a surface, lookups in the layer up to this many texels away must not be darkened
  // by the surface itself, for light at up to 60 degrees from the normal. The layer must therefore
  // end far enough in front of the surface.
  constexpr double texels = 1.5;
  constexpr double maximum = 64.0;
  this->Period = static_cast<int>(
    std::ceil(std::min(std::max(texels * light.TexelSize / sweep.Spacing, 1.0), maximum)));
  while (this->Volumes.size() > polygons.size())
  {
    Release(*this->Volumes.back(), window);
    this->Volumes.pop_back();
  }
  while (this->Volumes.size() < polygons.size())
  {
    this->Volumes.push_back(std::make_unique<Volume>());
  }
  return {};
}

Error SliceLightBuffer::PrepareVolume(
  vtkOpenGLRenderWindow* window, std::size_t volume, VolumeSlices& slices)
{
  const SlicePlan::Sweep& sweep = *this->Sweep;
  const SlicePlan::ShadowedLight& light = *this->Planned;
  Volume& own = *this->Volumes[volume];
  const VolumeRenderState& frame = slices.GetFrame();
  const bool hasLayers = slices.HasThickPart();
  own.HasLayers = hasLayers && !light.IsWide;
  own.IsLayerSet = false;
  this->Framebuffer->Bind();
  for (std::size_t i = 0; i < 2; ++i)
  {
    vtkSmartPointer<vtkTextureObject>& layer = own.Layers[i];
    if (!own.HasLayers)
    {
      if (layer)
      {
        layer->ReleaseGraphicsResources(window);
      }
      continue;
    }
    if (!layer)
    {
      layer = vtkSmartPointer<vtkTextureObject>::New();
    }
    const vtkIdType bytes = FloatTexture::Allocate(
      window, layer, this->Size, this->Size, frame.Image->GetLightChannels(), false);
    if (bytes == 0)
    {
      return Error(
        "The graphics card does not have enough memory for the layers of a light buffer. Reduce "
        "LightBufferSize.",
        ErrorCode::OutOfMemory);
    }
    this->Bytes += bytes;
    own.LayerSlabs[i] = 0;
    this->CopyTo(layer);
  }
  if (slices.IsEmpty())
  {
    return {};
  }
  if (light.IsWide)
  {
    own.WideTiles.Build(sweep, light, frame.Image->Lights[light.Light].Position,
      frame.Blocks.GetBlockGrid(), frame.Space, frame.Region.Box);
  }
  own.HasTiles = !light.IsWide && frame.HasTiles() &&
    own.Tiles.Build(sweep, light.BufferFromUnit, { { this->Size, this->Size } },
      frame.SmallBlocks.GetBlockGrid(), frame.Space, frame.Region.Box,
      VolumeSlices::GetMargin(sweep));
  const std::vector<float>& drawn = this->GetDrawn(own, slices.GetPolygons()).GetVertices();
  const bool isTiled = (light.IsWide || own.HasTiles) && !drawn.empty();
  if (isTiled)
  {
    own.TileVertices->Upload(drawn, vtkOpenGLBufferObject::ArrayBuffer);
  }
  const std::string source = SliceShader::GetLightBufferShaderSource(frame, light, hasLayers);
  const std::string markSource = SliceOcclusion::GetShaderSource(
    light.IsWide ? SliceOcclusion::DEPTH : SliceOcclusion::TRANSMITTANCE,
    frame.Image->GetLightChannels());
  vtkOpenGLBufferObject* vertices = isTiled ? own.TileVertices.Get() : slices.GetVertices();
  // The last program stays bound, and its uniforms are set below.
  if (Error error = own.Marks.Prepare(window, markSource, vertices)
                      .Then([&] { return own.Slices.Prepare(window, source, vertices); }))
  {
    return error;
  }
  vtkShaderProgram* program = own.Slices.GetProgram();
  slices.Add(program);
  SliceShader::SetLightUniforms(program, frame, sweep, light);
  return {};
}

Error SliceLightBuffer::PrepareSoftShadows(vtkOpenGLRenderWindow* window, const ImageState& image,
  const std::vector<const SlicePolygons*>& polygons)
{
  const SlicePlan::ShadowedLight& light = *this->Planned;
  const bool hasSamples = light.SoftMethod == SlicePlan::LAYERS;
  const bool isConvolved = light.SoftMethod == SlicePlan::CONVOLUTION;
  if (this->Samples && !hasSamples)
  {
    this->Samples->ReleaseGraphicsResources(window);
    this->Samples.reset();
    this->Framebuffer->ReleaseGraphicsResources(window);
  }
  if (this->Convolution && !isConvolved)
  {
    this->Convolution->ReleaseGraphicsResources(window);
    this->Convolution.reset();
  }
  if (hasSamples)
  {
    if (!this->Samples)
    {
      this->Samples = std::make_unique<EmitterSampleLayers>();
    }
    return this->Samples->Prepare(
      window, *this->Sweep, light, polygons, image.GetLightChannels(), image.Scene != nullptr);
  }
  if (isConvolved)
  {
    if (!this->Convolution)
    {
      this->Convolution = std::make_unique<SliceConvolution>();
    }
    return this->Convolution->Prepare(
      window, image.Lights[light.Light], *this->Sweep, light, image.GetLightChannels());
  }
  return {};
}

int SliceLightBuffer::GetNumberOfSampleLayers() const
{
  return this->Samples ? this->Samples->GetNumberOfLayers() : 0;
}

vtkIdType SliceLightBuffer::GetSoftShadowBytes() const
{
  return this->Samples  ? this->Samples->GetBytes()
    : this->Convolution ? this->Convolution->GetBytes()
                        : 0;
}

int SliceLightBuffer::Begin(vtkOpenGLRenderWindow* window, const AllSlices& slices, int slab)
{
  int passes = 0;
  if (this->Samples && this->Samples->Begin(window, this->Texture, slab, passes))
  {
    this->Framebuffer->Bind();
    this->Framebuffer->AddColorAttachment(1, this->Samples->GetBatch());
  }
  if (this->Convolution)
  {
    passes = this->Convolution->Begin(window, this->Texture, slab);
  }
  if (passes > 0)
  {
    // Mark the pixels from scratch: oblique light may reach positions behind pixels that were
    // opaque.
    this->Framebuffer->Bind();
    SliceOcclusion::Clear(window);
    this->Mark(window, slices, slab);
  }
  return passes;
}

void SliceLightBuffer::CopyTo(vtkTextureObject* layer)
{
  const bool wasActive = layer->GetTextureUnit() >= 0;
  layer->Activate();
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, this->Size, this->Size);
  if (!wasActive)
  {
    layer->Deactivate();
  }
}

bool SliceLightBuffer::UpdateLayer(int slab, bool isEmpty, std::size_t volume)
{
  Volume& own = *this->Volumes[volume];
  const std::array<int, 2> before = own.LayerSlabs;
  if (isEmpty)
  {
    // An empty slab does not attenuate, so a layer that ends in front of it is also valid behind
    // it.
    for (int& layer : own.LayerSlabs)
    {
      layer += layer == slab ? 1 : 0;
    }
  }
  else if (slab - own.LayerSlabs[1] >= this->Period)
  {
    std::swap(own.Layers[0], own.Layers[1]);
    own.LayerSlabs = { { own.LayerSlabs[1], slab } };
    this->Framebuffer->Bind(GL_READ_FRAMEBUFFER);
    this->CopyTo(own.Layers[1]);
  }
  const bool isChanged = !own.IsLayerSet || own.LayerSlabs != before;
  own.IsLayerSet = true;
  return isChanged;
}

const SlabTriangles& SliceLightBuffer::GetDrawn(
  const Volume& volume, const SlicePolygons& polygons) const
{
  const SlabTriangles& planes =
    volume.HasTiles ? static_cast<const SlabTriangles&>(volume.Tiles) : polygons;
  return this->IsWide ? volume.WideTiles : planes;
}

int SliceLightBuffer::Draw(
  vtkOpenGLRenderWindow* window, const SlicePolygons& polygons, int slab, std::size_t volume)
{
  Volume& own = *this->Volumes[volume];
  const SlabTriangles& drawn = this->GetDrawn(own, polygons);
  if (drawn.IsEmpty(slab))
  {
    return 0;
  }
  const std::vector<std::size_t>& starts = drawn.GetStarts();
  vtkOpenGLState* state = window->GetState();
  this->Framebuffer->Bind(GL_DRAW_FRAMEBUFFER);
  state->vtkglViewport(0, 0, this->Size, this->Size);
  if (this->IsWide)
  {
    state->vtkglBlendFunc(GL_ONE, GL_ONE);
  }
  else
  {
    state->vtkglBlendFuncSeparate(GL_ZERO, GL_SRC_COLOR, GL_ZERO, GL_ONE);
  }
  const double entrance = this->Sweep->First + slab * this->Sweep->Spacing;
  state->vtkglEnable(GL_DEPTH_TEST);
  own.Slices.Draw(window, starts, slab, entrance);
  state->vtkglDisable(GL_DEPTH_TEST);
  int passes = 1;
  for (const std::unique_ptr<Volume>& other : this->Volumes)
  {
    if (other.get() == &own || !other->HasLayers)
    {
      continue;
    }
    this->LayerFramebuffer->SetContext(window);
    for (vtkTextureObject* layer : other->Layers)
    {
      this->LayerFramebuffer->Bind(GL_DRAW_FRAMEBUFFER);
      this->LayerFramebuffer->AddColorAttachment(0, layer);
      this->LayerFramebuffer->ActivateDrawBuffer(0);
      own.Slices.Draw(window, starts, slab, entrance);
      ++passes;
    }
  }
  return passes;
}

int SliceLightBuffer::MarkOccluded(vtkOpenGLRenderWindow* window, const AllSlices& slices, int slab)
{
  return this->Samples || this->Convolution ? 0 : this->Mark(window, slices, slab);
}

int SliceLightBuffer::Mark(vtkOpenGLRenderWindow* window, const AllSlices& slices, int slab)
{
  int passes = 0;
  for (std::size_t i = 0; i < slices.size(); ++i)
  {
    const SlabTriangles& drawn = this->GetDrawn(*this->Volumes[i], slices[i]->GetPolygons());
    if (!slices[i]->IsEmpty() && !drawn.IsEmpty(slab))
    {
      this->Occlusion.Mark(window, this->Texture, SliceShader::GetBufferMatrix(*this->Planned),
        this->Volumes[i]->Marks, drawn.GetStarts(), slab);
      ++passes;
    }
  }
  return passes;
}

std::vector<float> SliceLightBuffer::Read(vtkOpenGLRenderWindow* window, int& size, int& channels)
{
  if (!this->IsUsed() || this->IsWide)
  {
    return {};
  }
  window->MakeCurrent();
  size = this->Size;
  channels = this->Texture->GetComponents();
  std::vector<float> texels(static_cast<std::size_t>(size) * static_cast<std::size_t>(size) *
    static_cast<std::size_t>(channels));
  this->Texture->Activate();
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTexImage(GL_TEXTURE_2D, 0, channels == 1 ? GL_RED : GL_RGB, GL_FLOAT, texels.data());
  this->Texture->Deactivate();
  return texels;
}

void SliceLightBuffer::Release(Volume& volume, vtkWindow* window)
{
  for (vtkTextureObject* layer : volume.Layers)
  {
    if (layer)
    {
      layer->ReleaseGraphicsResources(window);
    }
  }
  volume.Slices.ReleaseGraphicsResources();
  volume.Marks.ReleaseGraphicsResources();
  volume.TileVertices->ReleaseGraphicsResources();
}

void SliceLightBuffer::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  for (const std::unique_ptr<Volume>& volume : this->Volumes)
  {
    Release(*volume, window);
  }
  this->Volumes.clear();
  if (this->Samples)
  {
    this->Samples->ReleaseGraphicsResources(window);
  }
  if (this->Convolution)
  {
    this->Convolution->ReleaseGraphicsResources(window);
  }
  this->Framebuffer->ReleaseGraphicsResources(window);
  this->LayerFramebuffer->ReleaseGraphicsResources(window);
  this->Occlusion.ReleaseGraphicsResources(window);
}

}
