// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/SliceConvolution.h"

#include "Loader/OpenGLFunctions.h"
#include "Offscreen/FloatTexture.h"
#include "Space/UnitVector.h"

#include "InterlumeSliceBoxFS.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <cmath>

namespace interlume
{

namespace
{

// Penumbra width, in texels, above which the buffer is convolved.
constexpr double MinimumWidth = 2.0;

// Returns the width of the penumbra that an occluder in the plane at \a last casts on the plane at
// \a height, in texels along each axis of the buffer.
std::array<double, 2> GetWidths(const LightSource& source, const SlicePlan::ShadowedLight& light,
  const glm::dvec3& normal, double last, double height)
{
  const double apex = source.IsPositional ? glm::dot(source.Position, normal) : 0.0;
  const double distance = source.IsPositional ? last - apex : glm::dot(source.Direction, normal);
  const glm::dmat4& view = light.BufferFromUnit;
  const auto getRow = [&view](int row) { return UnitVector::GetRow(view, row); };
  // In a perspective projection, the width depends on the position; a position on the buffer's axis
  // is used. In a parallel projection, the width is the same everywhere.
  const bool isPerspective = getRow(3) != glm::dvec3(0.0);
  const glm::dvec3 position = isPerspective
    ? source.Position + getRow(3) * ((height - apex) / glm::dot(getRow(3), normal))
    : normal * height;
  const double depth = glm::dot(getRow(3), position) + view[3][3];
  std::array<double, 2> squares{};
  for (const glm::dvec3& emitter : source.EmitterAxes)
  {
    const glm::dvec3 across =
      (emitter - glm::dot(emitter, normal) * normal) * ((height - last) / distance);
    for (int i = 0; i < 2; ++i)
    {
      const double seen = (glm::dot(getRow(i), position) + view[3][i]) / depth;
      const double change =
        (glm::dot(getRow(i), across) - seen * glm::dot(getRow(3), across)) / depth;
      squares[i] += change * change;
    }
  }
  const double texels = 0.5 * light.BufferSize;
  return { { std::sqrt(squares[0]) * texels, std::sqrt(squares[1]) * texels } };
}

}

SliceConvolution::SliceConvolution() = default;

SliceConvolution::~SliceConvolution() = default;

Error SliceConvolution::Prepare(vtkOpenGLRenderWindow* window, const LightSource& source,
  const SlicePlan::Sweep& sweep, const SlicePlan::ShadowedLight& light, int channels)
{
  this->Source = source;
  this->Sweep = &sweep;
  this->Planned = &light;
  this->Slab = -1;
  this->Remainder = {};
  this->Bytes = FloatTexture::Allocate(
    window, this->Temporary, light.BufferSize, light.BufferSize, channels, false);
  if (this->Bytes == 0)
  {
    return Error(
      "The graphics card does not have enough memory for the soft shadows of an area light. Reduce "
      "LightBufferSize.",
      ErrorCode::OutOfMemory);
  }
  this->Framebuffer->SetContext(window);
  if (!this->Quad)
  {
    this->Quad =
      std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, InterlumeSliceBoxFS, nullptr);
  }
  return this->Quad->Program
    ? Error()
    : Error(
        "The shader for the soft shadows of an area light cannot be compiled.", ErrorCode::OpenGL);
}

int SliceConvolution::Begin(vtkOpenGLRenderWindow* window, vtkTextureObject* buffer, int slab)
{
  const auto getHeight = [this](int number)
  { return this->Sweep->First + number * this->Sweep->Spacing; };
  if (this->Slab < 0)
  {
    this->Last.fill(getHeight(slab));
    this->Slab = slab;
  }
  int passes = 0;
  // Penumbras also widen in empty slabs.
  for (; this->Slab < slab; ++this->Slab)
  {
    passes += this->WidenPenumbra(window, buffer, getHeight(this->Slab + 1));
  }
  return passes;
}

int SliceConvolution::WidenPenumbra(
  vtkOpenGLRenderWindow* window, vtkTextureObject* buffer, double height)
{
  int passes = 0;
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    const double width = this->Remainder[axis] +
      GetWidths(this->Source, *this->Planned, this->Sweep->Normal, this->Last[axis], height)[axis];
    if (width > MinimumWidth)
    {
      const int boxWidth = static_cast<int>(std::min(width, 2.0 * this->Planned->BufferSize));
      this->Convolve(window, buffer, axis, boxWidth);
      this->Remainder[axis] = width - boxWidth;
      this->Last[axis] = height;
      ++passes;
    }
  }
  return passes;
}

void SliceConvolution::Convolve(
  vtkOpenGLRenderWindow* window, vtkTextureObject* buffer, std::size_t axis, int width)
{
  vtkOpenGLState* state = window->GetState();
  this->Framebuffer->Bind();
  this->Framebuffer->AddColorAttachment(0, this->Temporary);
  this->Framebuffer->ActivateDrawBuffer(0);
  this->Framebuffer->ActivateReadBuffer(0);
  const auto size = static_cast<GLsizei>(buffer->GetWidth());
  state->vtkglViewport(0, 0, size, size);
  state->vtkglBlendFunc(GL_ONE, GL_ZERO);
  vtkShaderProgram* program = this->Quad->Program;
  window->GetShaderCache()->ReadyShaderProgram(program);
  // Do not deactivate an active light buffer: it keeps its texture unit for the whole sweep.
  const bool wasActive = buffer->GetTextureUnit() >= 0;
  buffer->Activate();
  const int direction[2] = { axis == 0 ? 1 : 0, axis == 0 ? 0 : 1 };
  program->SetUniformi("map", buffer->GetTextureUnit());
  program->SetUniform2i("axis", direction);
  program->SetUniformi("width", width);
  this->Quad->Render();
  buffer->Activate();
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, size, size);
  if (!wasActive)
  {
    buffer->Deactivate();
  }
}

void SliceConvolution::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Temporary->ReleaseGraphicsResources(window);
  this->Framebuffer->ReleaseGraphicsResources(window);
  if (this->Quad)
  {
    this->Quad->ReleaseGraphicsResources(window);
    this->Quad.reset();
  }
  this->Bytes = 0;
}

}
