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
  while (this->Layers.size() > light.Samples.size())
  {
    this->Layers.back()->ReleaseGraphicsResources(window);
    this->Layers.pop_back();
  }
  while (this->Layers.size() < light.Samples.size())
  {
    this->Layers.push_back(vtkSmartPointer<vtkTextureObject>::New());
  }
  this->Framebuffer->SetContext(window);
  const auto prepare = [&](vtkTextureObject* texture)
  {
    const vtkIdType bytes =
      vtkFloatTarget::Allocate(window, texture, light.BufferSize, light.BufferSize, channels, true);
    this->Bytes += bytes;
    if (bytes > 0)
    {
      this->Clear(window, texture);
    }
    return bytes > 0;
  };
  if (!prepare(this->Batch) ||
    !std::all_of(this->Layers.begin(), this->Layers.end(),
      [&prepare](vtkTextureObject* layer) { return prepare(layer); }))
  {
    return "the graphics card has no memory for the layers of an area light";
  }
  if (!this->Quad)
  {
    this->Quad =
      std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, InterlumeSliceLayerFS, nullptr);
  }
  if (!this->Quad->Program)
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

void SliceSampleLayers::Draw(vtkOpenGLRenderWindow* window, vtkTextureObject* target,
  vtkTextureObject* map, const std::array<double, 16>& targetFromUnit,
  const std::array<double, 16>& mapFromUnit, const std::array<double, 4>& plane, double factor)
{
  const glm::dmat3 homography = PlaneView::GetHomography(targetFromUnit, mapFromUnit, plane);
  float columns[9];
  std::transform(glm::value_ptr(homography), glm::value_ptr(homography) + 9, columns,
    [](double value) { return static_cast<float>(value); });
  vtkShaderProgram* program = this->Quad->Program;
  window->GetShaderCache()->ReadyShaderProgram(program);
  this->Framebuffer->AddColorAttachment(0, target);
  // The light's buffer has its texture unit for the whole sweep.
  const bool wasActive = map->GetTextureUnit() >= 0;
  map->Activate();
  program->SetUniformi("map", map->GetTextureUnit());
  program->SetUniformMatrix3x3("mapFromTarget", columns);
  program->SetUniformf("factor", static_cast<float>(factor));
  this->Quad->Render();
  if (!wasActive)
  {
    map->Deactivate();
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
  vtkOpenGLState* state = window->GetState();
  this->Framebuffer->Bind();
  this->Framebuffer->ActivateDrawBuffer(0);
  state->vtkglViewport(0, 0, light.BufferSize, light.BufferSize);
  const std::array<double, 4> drawn = GetPlane(sweep, 0.5 * (this->First + this->Last + 1));
  state->vtkglBlendFuncSeparate(GL_ZERO, GL_SRC_COLOR, GL_ZERO, GL_ONE);
  for (std::size_t i = 0; i < this->Layers.size(); ++i)
  {
    this->Draw(window, this->Layers[i], this->Batch, light.Samples[i].LayerFromUnit,
      light.BufferFromUnit, drawn, 1.0);
  }
  const std::array<double, 4> next = GetPlane(sweep, slab + 0.5 * this->Period);
  for (std::size_t i = 0; i < this->Layers.size(); ++i)
  {
    state->vtkglBlendFunc(GL_ONE, i == 0 ? GL_ZERO : GL_ONE);
    this->Draw(window, buffer, this->Layers[i], light.BufferFromUnit,
      light.Samples[i].LayerFromUnit, next, light.Samples[i].Weight);
  }
  this->Clear(window, this->Batch);
  this->First = slab;
  this->Last = slab;
  return 2 * this->GetNumberOfLayers();
}

void SliceSampleLayers::ReleaseGraphicsResources(vtkWindow* window)
{
  for (vtkTextureObject* layer : this->Layers)
  {
    layer->ReleaseGraphicsResources(window);
  }
  this->Layers.clear();
  this->Batch->ReleaseGraphicsResources(window);
  this->Framebuffer->ReleaseGraphicsResources(window);
  if (this->Quad)
  {
    this->Quad->ReleaseGraphicsResources(window);
    this->Quad.reset();
  }
  this->Bytes = 0;
}

}
