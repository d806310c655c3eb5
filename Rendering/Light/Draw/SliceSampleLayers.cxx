// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/SliceSampleLayers.h"

#include "Loader/OpenGLFunctions.h"
#include "Plan/PlaneView.h"

#include "InterlumeSliceLayerFS.h"
#include "vtkFloatTarget.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderFeatures.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>

namespace interlume
{

namespace
{

// The most slabs of a batch, whose own matter casts the shadows of a light without extent in it.
constexpr int LongestBatch = 64;

// How far the shadows of a sample and of the centre may go apart within a batch, in texels.
constexpr double Apart = 0.75;

// The most layers of a texture, whose homographies are uniforms of one program.
constexpr int MostLayers = 16;

std::unique_ptr<vtkOpenGLQuadHelper> MakeQuad(vtkOpenGLRenderWindow* window, const char* feature)
{
  const std::string source = vtkShaderFeatures::Insert(
    InterlumeSliceLayerFS, "MOST_LAYERS=" + std::to_string(MostLayers) + feature);
  return std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, source.c_str(), nullptr);
}

// Returns the plane n.x = height of a sweep.
std::array<double, 4> GetPlane(const SlicePlan::Sweep& sweep, double slab)
{
  return { { sweep.Normal.x, sweep.Normal.y, sweep.Normal.z,
    -(sweep.First + slab * sweep.Spacing) } };
}

}

SliceSampleLayers::SliceSampleLayers() = default;

SliceSampleLayers::~SliceSampleLayers() = default;

std::string SliceSampleLayers::Prepare(vtkOpenGLRenderWindow* window, const SlicePlan::Sweep& sweep,
  const SlicePlan::ShadowedLight& light, int channels)
{
  this->Bytes = 0;
  this->NumberOfLayers = static_cast<int>(light.Samples.size());
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  const int most = std::min(std::max(limit / light.BufferSize, 1), MostLayers);
  const auto stacks = static_cast<std::size_t>((this->NumberOfLayers + most - 1) / most);
  while (this->Stacks.size() > stacks)
  {
    this->Stacks.back().Texture->ReleaseGraphicsResources(window);
    this->Stacks.pop_back();
  }
  this->Framebuffer->SetContext(window);
  const auto prepare = [&](vtkTextureObject* texture, int layers)
  {
    const vtkIdType bytes = vtkFloatTarget::Allocate(
      window, texture, light.BufferSize, layers * light.BufferSize, channels, true);
    this->Bytes += bytes;
    if (bytes > 0)
    {
      this->Clear(window, texture);
    }
    return bytes > 0;
  };
  bool hasMemory = prepare(this->Batch, 1);
  for (std::size_t i = 0; i < stacks && hasMemory; ++i)
  {
    if (i == this->Stacks.size())
    {
      this->Stacks.push_back({ vtkSmartPointer<vtkTextureObject>::New(), 0, 0 });
    }
    Stack& stack = this->Stacks[i];
    stack.First = i * most;
    stack.Layers = std::min(this->NumberOfLayers - static_cast<int>(stack.First), most);
    hasMemory = prepare(stack.Texture, stack.Layers);
  }
  if (!hasMemory)
  {
    return "the graphics card has no memory for the layers of an area light";
  }
  if (!this->Fill)
  {
    this->Fill = MakeQuad(window, "");
    this->Mean = MakeQuad(window, " MEAN");
  }
  if (!this->Fill->Program || !this->Mean->Program)
  {
    return "the shader of an area light's layers cannot be compiled";
  }
  const double apart = light.Spread * sweep.Spacing;
  this->Period =
    apart * LongestBatch > Apart ? std::max(static_cast<int>(Apart / apart), 1) : LongestBatch;
  this->First = 0;
  this->Last = -1;
  return {};
}

void SliceSampleLayers::Clear(vtkOpenGLRenderWindow* window, vtkTextureObject* texture)
{
  this->Framebuffer->Bind();
  this->Framebuffer->AddColorAttachment(0, texture);
  this->Framebuffer->ActivateDrawBuffer(0);
  window->GetState()->vtkglClearColor(1.0f, 1.0f, 1.0f, 1.0f);
  glClear(GL_COLOR_BUFFER_BIT);
}

void SliceSampleLayers::Draw(vtkOpenGLRenderWindow* window, vtkOpenGLQuadHelper& quad,
  vtkTextureObject* target, vtkTextureObject* map, const std::vector<glm::dmat3>& homographies)
{
  std::vector<float> columns;
  for (const glm::dmat3& homography : homographies)
  {
    const glm::mat3 single(homography);
    columns.insert(columns.end(), glm::value_ptr(single), glm::value_ptr(single) + 9);
  }
  const auto layers = static_cast<int>(homographies.size());
  this->Framebuffer->AddColorAttachment(0, target);
  // The light's buffer has its texture unit for the whole sweep.
  const bool wasActive = map->GetTextureUnit() >= 0;
  map->Activate();
  quad.Program->SetUniformi("map", map->GetTextureUnit());
  quad.Program->SetUniformi("layers", layers);
  quad.Program->SetUniform3fv("mapFromTarget", 3 * layers, columns.data());
  window->GetState()->vtkglViewport(
    0, 0, static_cast<int>(target->GetWidth()), static_cast<int>(target->GetHeight()));
  quad.Render();
  if (!wasActive)
  {
    map->Deactivate();
  }
}

void SliceSampleLayers::FillLayers(vtkOpenGLRenderWindow* window, const SlicePlan::Sweep& sweep,
  const SlicePlan::ShadowedLight& light)
{
  this->Framebuffer->Bind();
  this->Framebuffer->ActivateDrawBuffer(0);
  const std::array<double, 4> drawn = GetPlane(sweep, 0.5 * (this->First + this->Last + 1));
  window->GetState()->vtkglBlendFuncSeparate(GL_ZERO, GL_SRC_COLOR, GL_ZERO, GL_ONE);
  vtkShaderProgram* program = this->Fill->Program;
  window->GetShaderCache()->ReadyShaderProgram(program);
  const glm::mat3x4 points(PlaneView::GetPoints(light.BufferFromUnit, drawn));
  program->SetUniform4fv("pointFromMap", 3, glm::value_ptr(points));
  program->SetUniform3f("sliceNormal", glm::value_ptr(glm::vec3(sweep.Normal)));
  program->SetUniform4f("center", glm::value_ptr(glm::vec4(light.Center)));
  std::vector<glm::dmat3> homographies;
  for (const Stack& stack : this->Stacks)
  {
    homographies.clear();
    std::vector<float> sources;
    for (int i = 0; i < stack.Layers; ++i)
    {
      const SlicePlan::SampleView& sample = light.Samples[stack.First + i];
      homographies.push_back(
        PlaneView::GetHomography(sample.LayerFromUnit, light.BufferFromUnit, drawn));
      const glm::vec4 source(sample.Source);
      sources.insert(sources.end(), glm::value_ptr(source), glm::value_ptr(source) + 4);
    }
    program->SetUniform4fv("sources", stack.Layers, sources.data());
    this->Draw(window, *this->Fill, stack.Texture, this->Batch, homographies);
  }
}

int SliceSampleLayers::Begin(vtkOpenGLRenderWindow* window, const SlicePlan::Sweep& sweep,
  const SlicePlan::ShadowedLight& light, vtkTextureObject* buffer, int slab)
{
  if (this->Last < 0)
  {
    this->First = slab;
  }
  if (slab - this->First < this->Period)
  {
    this->Last = slab;
    return 0;
  }
  this->FillLayers(window, sweep, light);
  vtkOpenGLState* state = window->GetState();
  const std::array<double, 4> next = GetPlane(sweep, slab + 0.5 * this->Period);
  vtkShaderProgram* program = this->Mean->Program;
  window->GetShaderCache()->ReadyShaderProgram(program);
  program->SetUniformf("margin", static_cast<float>(0.5 / light.BufferSize));
  for (const Stack& stack : this->Stacks)
  {
    std::vector<glm::dmat3> homographies;
    std::vector<float> weights;
    for (int i = 0; i < stack.Layers; ++i)
    {
      const SlicePlan::SampleView& sample = light.Samples[stack.First + i];
      homographies.push_back(
        PlaneView::GetHomography(light.BufferFromUnit, sample.LayerFromUnit, next));
      weights.push_back(static_cast<float>(sample.Weight));
    }
    program->SetUniform1fv("weights", stack.Layers, weights.data());
    state->vtkglBlendFunc(GL_ONE, stack.First == 0 ? GL_ZERO : GL_ONE);
    this->Draw(window, *this->Mean, buffer, stack.Texture, homographies);
  }
  this->Clear(window, this->Batch);
  this->First = slab;
  this->Last = slab;
  return 2 * static_cast<int>(this->Stacks.size());
}

int SliceSampleLayers::Finish(vtkOpenGLRenderWindow* window, const SlicePlan::Sweep& sweep,
  const SlicePlan::ShadowedLight& light)
{
  if (this->Last < 0)
  {
    return 0;
  }
  this->FillLayers(window, sweep, light);
  this->Last = -1;
  return static_cast<int>(this->Stacks.size());
}

void SliceSampleLayers::ReleaseGraphicsResources(vtkWindow* window)
{
  for (const Stack& stack : this->Stacks)
  {
    stack.Texture->ReleaseGraphicsResources(window);
  }
  this->Stacks.clear();
  this->Batch->ReleaseGraphicsResources(window);
  this->Framebuffer->ReleaseGraphicsResources(window);
  for (std::unique_ptr<vtkOpenGLQuadHelper>* quad : { &this->Fill, &this->Mean })
  {
    if (*quad)
    {
      (*quad)->ReleaseGraphicsResources(window);
      quad->reset();
    }
  }
  this->Bytes = 0;
}

}
