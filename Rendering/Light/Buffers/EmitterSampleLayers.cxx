// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/EmitterSampleLayers.h"

#include "Loader/OpenGLFunctions.h"
#include "Offscreen/FloatTexture.h"
#include "Offscreen/ShaderFeatures.h"
#include "Plan/PlaneView.h"
#include "Plan/SlicePolygons.h"

#include "InterlumeSliceLayerFS.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace interlume
{

namespace
{

// Number of light buffer texels along the edge of a layer's texel. Layers can be coarse because
// they are sampled only for wide penumbras.
constexpr int Coarseness = 2;

// Maximum number of layers in a texture. Their homographies are uniforms of one program.
constexpr int MaximumLayers = 16;

// Returns the middle plane of a batch.
std::array<double, 4> GetPlane(const SlicePlan::Sweep& sweep, const LayerBatches::Batch& batch)
{
  const double slab = 0.5 * (batch.First + batch.Last + 1);
  return { { sweep.Normal.x, sweep.Normal.y, sweep.Normal.z,
    -(sweep.First + slab * sweep.Spacing) } };
}

// Returns the matrix that maps a point (x, y, 1) in a view of a plane to the vector from the
// corresponding point of the plane to a light. \a points is the result of PlaneView::GetPoints.
glm::mat3 GetLightVectors(const glm::dmat3x4& points, const glm::dvec4& light)
{
  glm::dmat3 vectors;
  for (int column = 0; column < 3; ++column)
  {
    vectors[column] = glm::dvec3(light) * points[column].w - light.w * glm::dvec3(points[column]);
  }
  return glm::mat3(vectors);
}

}

EmitterSampleLayers::EmitterSampleLayers() = default;

EmitterSampleLayers::~EmitterSampleLayers() = default;

int EmitterSampleLayers::GetLayerSize(const SlicePlan::ShadowedLight& light)
{
  return light.BufferSize / Coarseness;
}

vtkIdType EmitterSampleLayers::GetTexels(const SlicePlan::ShadowedLight& light)
{
  const vtkIdType layer = GetLayerSize(light);
  const vtkIdType buffer = light.BufferSize;
  return (PendingBatches + 1) * buffer * buffer +
    (static_cast<vtkIdType>(light.Samples.size()) + 1) * layer * layer;
}

Error EmitterSampleLayers::Prepare(vtkOpenGLRenderWindow* window, const SlicePlan::Sweep& sweep,
  const SlicePlan::ShadowedLight& light, const std::vector<const SlicePolygons*>& polygons,
  int channels, bool isSampledOutside)
{
  if (Error error = this->Allocate(window, light, channels))
  {
    return error;
  }
  this->Sweep = &sweep;
  this->Planned = &light;
  this->Plan.Build(sweep, light, polygons, isSampledOutside);
  this->Tiles->Upload(this->Plan.GetVertices(), vtkOpenGLBufferObject::ArrayBuffer);
  this->Current = 0;
  this->Begun = 0;
  this->HasLayers = false;
  for (Batch& batch : this->Batches)
  {
    batch.Number = -1;
  }
  return this->Compile(window, channels);
}

Error EmitterSampleLayers::Allocate(
  vtkOpenGLRenderWindow* window, const SlicePlan::ShadowedLight& light, int channels)
{
  this->Bytes = 0;
  this->NumberOfLayers = static_cast<int>(light.Samples.size());
  this->LayerSize = GetLayerSize(light);
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  const int maximum = std::min(std::max(limit / this->LayerSize, 1), MaximumLayers);
  const auto stacks = static_cast<std::size_t>((this->NumberOfLayers + maximum - 1) / maximum);
  while (this->Stacks.size() > stacks)
  {
    this->Stacks.back()->Texture->ReleaseGraphicsResources(window);
    this->Stacks.back()->Mean.ReleaseGraphicsResources();
    this->Stacks.pop_back();
  }
  this->Framebuffer->SetContext(window);
  const auto prepare = [&](vtkTextureObject* texture, int size, int layers)
  {
    const vtkIdType bytes =
      FloatTexture::Allocate(window, texture, size, layers * size, channels, true);
    this->Bytes += bytes;
    if (bytes > 0)
    {
      this->Clear(window, texture);
    }
    return bytes > 0;
  };
  bool hasMemory = prepare(this->Sum, this->LayerSize, 1);
  for (Batch& batch : this->Batches)
  {
    hasMemory = hasMemory && prepare(batch.Texture, light.BufferSize, 1);
  }
  for (std::size_t i = 0; i < stacks && hasMemory; ++i)
  {
    if (i == this->Stacks.size())
    {
      this->Stacks.push_back(std::make_unique<Stack>());
      this->Stacks.back()->Texture = vtkSmartPointer<vtkTextureObject>::New();
    }
    Stack& stack = *this->Stacks[i];
    stack.First = i * maximum;
    stack.Layers = std::min(this->NumberOfLayers - static_cast<int>(stack.First), maximum);
    hasMemory = prepare(stack.Texture, this->LayerSize, stack.Layers);
  }
  return hasMemory
    ? Error()
    : Error("The graphics card does not have enough memory for the sample layers of an area "
            "light. Reduce NumberOfLightSamples or LightBufferSize.",
        ErrorCode::OutOfMemory);
}

Error EmitterSampleLayers::Compile(vtkOpenGLRenderWindow* window, int channels)
{
  const std::string light = channels == 1 ? "COLOR=float CHANNELS=r" : "COLOR=vec3 CHANNELS=rgb";
  const auto prepare = [&](SlicePass& pass, const std::string& features)
  {
    return pass.Prepare(
      window, ShaderFeatures::Insert(InterlumeSliceLayerFS, light + features), this->Tiles);
  };
  Error error = prepare(this->Fill, "").Then([&] { return prepare(this->Join, " JOIN"); });
  for (const std::unique_ptr<Stack>& stack : this->Stacks)
  {
    error = error ? error : prepare(stack->Mean, " MEAN LAYERS=" + std::to_string(stack->Layers));
  }
  return error;
}

void EmitterSampleLayers::Bind(vtkOpenGLRenderWindow* window, vtkTextureObject* target)
{
  this->Framebuffer->Bind();
  this->Framebuffer->AddColorAttachment(0, target);
  this->Framebuffer->ActivateDrawBuffer(0);
  window->GetState()->vtkglViewport(
    0, 0, static_cast<int>(target->GetWidth()), static_cast<int>(target->GetHeight()));
}

void EmitterSampleLayers::Clear(vtkOpenGLRenderWindow* window, vtkTextureObject* texture)
{
  this->Bind(window, texture);
  window->GetState()->vtkglClearColor(1.0f, 1.0f, 1.0f, 1.0f);
  glClear(GL_COLOR_BUFFER_BIT);
}

void EmitterSampleLayers::DrawTiles(vtkOpenGLRenderWindow* window, SlicePass& pass,
  vtkTextureObject* map, const glm::dmat3& targetFromBuffer, int number)
{
  glm::mat4 clip(0.0F);
  for (int column = 0; column < 3; ++column)
  {
    const glm::vec3 from(targetFromBuffer[column]);
    clip[column < 2 ? column : 3] = glm::vec4(from.x, from.y, 0.0F, from.z);
  }
  pass.GetProgram()->SetUniformMatrix4x4("clipFromUnit", glm::value_ptr(clip));
  pass.GetProgram()->SetUniformi("map", map->GetTextureUnit());
  pass.Draw(window, this->Plan.GetStarts(), number, 0.0);
}

int EmitterSampleLayers::MultiplyIntoLayers(vtkOpenGLRenderWindow* window, Batch& batch)
{
  if (batch.Number < 0)
  {
    return 0;
  }
  const SlicePlan::ShadowedLight& light = *this->Planned;
  vtkOpenGLState* state = window->GetState();
  state->vtkglBlendFuncSeparate(GL_ZERO, GL_SRC_COLOR, GL_ZERO, GL_ONE);
  const std::array<double, 4> plane =
    GetPlane(*this->Sweep, this->Plan.Get()[static_cast<std::size_t>(batch.Number)]);
  const glm::dmat3x4 points = PlaneView::GetPoints(light.BufferFromUnit, plane);
  vtkShaderProgram* program = this->Fill.GetProgram();
  window->GetShaderCache()->ReadyShaderProgram(program);
  batch.Texture->Activate();
  program->SetUniform3f("sliceNormal", glm::value_ptr(glm::vec3(this->Sweep->Normal)));
  glm::mat3 vectors = GetLightVectors(points, light.Center);
  program->SetUniformMatrix3x3("vectorToCenter", glm::value_ptr(vectors));
  for (const std::unique_ptr<Stack>& stack : this->Stacks)
  {
    this->Bind(window, stack->Texture);
    for (int i = 0; i < stack->Layers; ++i)
    {
      const SlicePlan::SampleView& sample = light.Samples[stack->First + i];
      vectors = GetLightVectors(points, sample.Source);
      program->SetUniformMatrix3x3("vectorToSample", glm::value_ptr(vectors));
      state->vtkglViewport(0, i * this->LayerSize, this->LayerSize, this->LayerSize);
      this->DrawTiles(window, this->Fill, batch.Texture,
        PlaneView::GetHomography(light.BufferFromUnit, sample.LayerFromUnit, plane), batch.Number);
    }
  }
  batch.Texture->Deactivate();
  this->Clear(window, batch.Texture);
  batch.Number = -1;
  return static_cast<int>(this->Stacks.size());
}

int EmitterSampleLayers::DrawMean(
  vtkOpenGLRenderWindow* window, vtkTextureObject* buffer, int number)
{
  const SlicePlan::ShadowedLight& light = *this->Planned;
  vtkOpenGLState* state = window->GetState();
  const std::array<double, 4> plane =
    GetPlane(*this->Sweep, this->Plan.Get()[static_cast<std::size_t>(number)]);
  this->Bind(window, this->Sum);
  for (const std::unique_ptr<Stack>& stack : this->Stacks)
  {
    std::vector<float> columns;
    std::vector<float> weights;
    for (int i = 0; i < stack->Layers; ++i)
    {
      const SlicePlan::SampleView& sample = light.Samples[stack->First + i];
      const glm::mat3 seen(
        PlaneView::GetHomography(light.BufferFromUnit, sample.LayerFromUnit, plane));
      columns.insert(columns.end(), glm::value_ptr(seen), glm::value_ptr(seen) + 9);
      weights.push_back(static_cast<float>(sample.Weight));
    }
    vtkShaderProgram* program = stack->Mean.GetProgram();
    window->GetShaderCache()->ReadyShaderProgram(program);
    program->SetUniform3fv("layerFromBuffer", 3 * stack->Layers, columns.data());
    program->SetUniform1fv("weights", stack->Layers, weights.data());
    program->SetUniformf("margin", static_cast<float>(0.5 / this->LayerSize));
    state->vtkglBlendFunc(GL_ONE, stack->First == 0 ? GL_ZERO : GL_ONE);
    stack->Texture->Activate();
    this->DrawTiles(window, stack->Mean, stack->Texture, glm::dmat3(1.0), number);
    stack->Texture->Deactivate();
  }
  this->Bind(window, buffer);
  state->vtkglBlendFunc(GL_ONE, GL_ZERO);
  window->GetShaderCache()->ReadyShaderProgram(this->Join.GetProgram());
  this->Sum->Activate();
  // Skip the new batch, which is still empty.
  for (std::size_t i = 1; i < this->Batches.size(); ++i)
  {
    vtkTextureObject* batch = this->Batches[(this->Current + i) % this->Batches.size()].Texture;
    batch->Activate();
    this->Join.GetProgram()->SetUniformi(
      ("batch" + std::to_string(i)).c_str(), batch->GetTextureUnit());
  }
  this->DrawTiles(window, this->Join, this->Sum, glm::dmat3(1.0), number);
  for (std::size_t i = 1; i < this->Batches.size(); ++i)
  {
    this->Batches[(this->Current + i) % this->Batches.size()].Texture->Deactivate();
  }
  this->Sum->Deactivate();
  return static_cast<int>(this->Stacks.size()) + 1;
}

bool EmitterSampleLayers::Begin(
  vtkOpenGLRenderWindow* window, vtkTextureObject* buffer, int slab, int& passes)
{
  const std::vector<LayerBatches::Batch>& batches = this->Plan.Get();
  const int next = this->Begun;
  if (next == static_cast<int>(batches.size()) ||
    slab < batches[static_cast<std::size_t>(next)].First)
  {
    return false;
  }
  ++this->Begun;
  // The new batch takes the slot of the oldest batch. First, multiply the oldest batch and all
  // batches before a wide gap into the layers.
  this->Current = static_cast<std::size_t>(next) % this->Batches.size();
  int drawn = 0;
  for (Batch& batch : this->Batches)
  {
    const bool isOld = batch.Number >= 0 &&
      this->Plan.AreSeparated(batches[static_cast<std::size_t>(batch.Number)],
        batches[static_cast<std::size_t>(next)], PendingBatches);
    if (isOld || &batch == &this->Batches[this->Current])
    {
      drawn += this->MultiplyIntoLayers(window, batch);
    }
  }
  this->HasLayers = this->HasLayers || drawn > 0;
  passes += drawn;
  passes += this->HasLayers ? this->DrawMean(window, buffer, next) : 0;
  this->Batches[this->Current].Number = next;
  return true;
}

int EmitterSampleLayers::Finish(vtkOpenGLRenderWindow* window)
{
  int passes = 0;
  for (Batch& batch : this->Batches)
  {
    passes += this->MultiplyIntoLayers(window, batch);
  }
  return passes;
}

void EmitterSampleLayers::ReleaseGraphicsResources(vtkWindow* window)
{
  for (const std::unique_ptr<Stack>& stack : this->Stacks)
  {
    stack->Texture->ReleaseGraphicsResources(window);
    stack->Mean.ReleaseGraphicsResources();
  }
  this->Stacks.clear();
  for (Batch& batch : this->Batches)
  {
    batch.Texture->ReleaseGraphicsResources(window);
  }
  this->Sum->ReleaseGraphicsResources(window);
  this->Framebuffer->ReleaseGraphicsResources(window);
  this->Fill.ReleaseGraphicsResources();
  this->Join.ReleaseGraphicsResources();
  this->Tiles->ReleaseGraphicsResources();
  this->Bytes = 0;
}

}
