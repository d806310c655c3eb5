// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/SlicePass.h"

#include "Loader/OpenGLFunctions.h"
#include "Offscreen/ShaderFeatures.h"

#include "InterlumeSliceVS.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkShaderProgram.h"

namespace interlume
{

SlicePass::SlicePass() = default;

SlicePass::~SlicePass() = default;

Error SlicePass::Prepare(vtkOpenGLRenderWindow* window, const std::string& source,
  vtkOpenGLBufferObject* vertices, bool isMarked)
{
  const std::string vertexSource =
    ShaderFeatures::Insert(InterlumeSliceVS, isMarked ? "MARKED" : "");
  this->IsMarked = isMarked;
  this->Program =
    window->GetShaderCache()->ReadyShaderProgram(vertexSource.c_str(), source.c_str(), "");
  if (!this->Program)
  {
    return Error("The slice shaders cannot be compiled.", ErrorCode::OpenGL);
  }
  this->Vertices->ReleaseGraphicsResources();
  this->Vertices->Bind();
  const bool isAdded = this->Vertices->AddAttributeArray(
    this->Program, vertices, "positionIn", 0, 3 * sizeof(float), VTK_FLOAT, 3, false);
  this->Vertices->Release();
  return isAdded
    ? Error()
    : Error("The slice shader has no vertex attribute 'positionIn'.", ErrorCode::OpenGL);
}

void SlicePass::Draw(vtkOpenGLRenderWindow* window, const std::vector<std::size_t>& starts,
  int slab, double entrance, int number, int volumes)
{
  window->GetShaderCache()->ReadyShaderProgram(this->Program);
  this->Program->SetUniformf("sliceEntrance", static_cast<float>(entrance));
  if (this->IsMarked)
  {
    const double slabs = static_cast<double>(starts.size()) - 1.0;
    const double fraction = (slab * volumes + number + 1.0) / (slabs * volumes + 2.0);
    this->Program->SetUniformf("sliceDepth", static_cast<float>(1.0 - 2.0 * fraction));
  }
  this->Vertices->Bind();
  glDrawArrays(GL_TRIANGLES, static_cast<GLint>(starts[slab]),
    static_cast<GLsizei>(starts[slab + 1] - starts[slab]));
  this->Vertices->Release();
}

void SlicePass::DrawPoints(
  vtkOpenGLRenderWindow* window, std::size_t first, std::size_t count, double entrance)
{
  window->GetShaderCache()->ReadyShaderProgram(this->Program);
  this->Program->SetUniformf("sliceEntrance", static_cast<float>(entrance));
  this->Vertices->Bind();
  glDrawArrays(GL_POINTS, static_cast<GLint>(first), static_cast<GLsizei>(count));
  this->Vertices->Release();
}

void SlicePass::ReleaseGraphicsResources()
{
  this->Vertices->ReleaseGraphicsResources();
  this->Program = nullptr;
}

}
