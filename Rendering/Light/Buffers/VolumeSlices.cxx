// SPDX-License-Identifier: BSD-3-Clause
#include "Buffers/VolumeSlices.h"

#include "Loader/OpenGLFunctions.h"
#include "Shaders/SliceShader.h"
#include "Shaders/SliceTextures.h"
#include "Shaders/VolumeRenderState.h"

#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace interlume
{

namespace
{
// GetMargin is large enough for view and light rays whose cosine with the slice normal is at least
// this.
constexpr double MINIMUM_COSINE = 0.35;
}

VolumeSlices::VolumeSlices() = default;

VolumeSlices::~VolumeSlices() = default;

void VolumeSlices::Set(const VolumeRenderState& frame, SliceTextures& textures)
{
  this->Frame = &frame;
  this->Textures = &textures;
}

double VolumeSlices::GetMargin(const SlicePlan::Sweep& sweep)
{
  return 0.5 * sweep.Spacing / MINIMUM_COSINE;
}

vtkIdType VolumeSlices::Cut(const SlicePlan::Sweep& sweep)
{
  const VolumeRenderState& frame = *this->Frame;
  this->Polygons.Build(
    sweep, frame.Blocks.GetBlockGrid(), frame.Space, frame.Region.Box, GetMargin(sweep));
  const std::vector<float>& vertices = this->Polygons.GetVertices();
  this->HasTiles = false;
  if (vertices.empty())
  {
    return 0;
  }
  this->Vertices->Upload(vertices, vtkOpenGLBufferObject::ArrayBuffer);
  std::size_t coordinates = vertices.size();
  if (frame.HasTiles() && !frame.Image->NearPlane.IsCutting &&
    this->Tiles.Build(sweep, frame.Image->Camera.ClipFromUnit, frame.Image->Size,
      frame.SmallBlocks.GetBlockGrid(), frame.Space, frame.Region.Box, GetMargin(sweep)))
  {
    this->HasTiles = true;
    coordinates += this->Tiles.GetVertices().size();
    if (!this->Tiles.GetVertices().empty())
    {
      this->TileVertices->Upload(this->Tiles.GetVertices(), vtkOpenGLBufferObject::ArrayBuffer);
    }
  }
  return static_cast<vtkIdType>(sizeof(float)) * static_cast<vtkIdType>(coordinates);
}

const SlabTriangles& VolumeSlices::GetSeen() const
{
  return this->HasTiles ? static_cast<const SlabTriangles&>(this->Tiles) : this->Polygons;
}

Error VolumeSlices::Prepare(vtkOpenGLRenderWindow* window, std::size_t sweep, bool isOccluded,
  bool isMarked, const std::function<void(vtkShaderProgram*)>& activate)
{
  this->Programs.clear();
  this->IsThick = false;
  if (this->IsEmpty())
  {
    return {};
  }
  this->IsThick = SliceShader::HasThickPart(*this->Frame, sweep);
  const bool isProbed = SliceShader::HasEmptyPart(*this->Frame, sweep);
  this->IsSplit = this->IsThick || isProbed;
  this->IsThin = !isProbed && SliceShader::HasThinPart(*this->Frame, sweep);
  this->IsMarked = isMarked;
  const bool hasTileVertices = this->HasTiles && !this->Tiles.GetVertices().empty();
  vtkOpenGLBufferObject* vertices = hasTileVertices ? this->TileVertices : this->Vertices;
  const auto prepare = [&](SlicePass& pass, SliceShader::Parts part)
  {
    const std::string source =
      SliceShader::GetImageShaderSource(*this->Frame, sweep, isOccluded, part);
    Error error = pass.Prepare(window, source, vertices, isMarked);
    if (!error)
    {
      activate(pass.GetProgram());
      this->Add(pass.GetProgram());
      SliceShader::SetImageUniforms(pass.GetProgram(), *this->Frame, sweep);
    }
    return error;
  };
  Error error = prepare(this->FirstPass,
    !this->IsSplit   ? SliceShader::ALL
      : this->IsThin ? SliceShader::THIN
                     : SliceShader::EMPTY);
  if (!error && this->IsSplit)
  {
    error = prepare(this->SecondPass, this->IsThick ? SliceShader::THICK : SliceShader::ALL);
  }
  // Back to front, no pixels are marked.
  return error || !this->Frame->Image->Plan.Sweeps[sweep].IsFrontToBack
    ? error
    : this->MarkPass.Prepare(
        window, SliceOcclusion::GetShaderSource(SliceOcclusion::OPACITY, 1), vertices);
}

void VolumeSlices::Add(vtkShaderProgram* program)
{
  this->Textures->Activate(program);
  this->Programs.push_back(program);
}

void VolumeSlices::Draw(
  vtkOpenGLRenderWindow* window, const SlicePlan::Sweep& sweep, int slab, int number, int volumes)
{
  vtkOpenGLState* state = window->GetState();
  if (sweep.IsFrontToBack)
  {
    state->vtkglBlendFunc(GL_ONE_MINUS_DST_ALPHA, GL_ONE);
  }
  else
  {
    state->vtkglBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  }
  if (sweep.IsFrontToBack || this->IsMarked)
  {
    state->vtkglEnable(GL_DEPTH_TEST);
  }
  // A slab may lie partly between the camera's clipping planes even if its middle plane does not.
  glEnable(GL_DEPTH_CLAMP);
  const std::vector<std::size_t>& starts = this->GetSeen().GetStarts();
  const double entrance = sweep.First + slab * sweep.Spacing;
  if (this->IsSplit)
  {
    // The first pass writes no depth for the fragments that it discards. The second pass then draws
    // only these fragments.
    state->vtkglDepthMask(GL_TRUE);
    const GLboolean hasColor = this->IsThin ? GL_TRUE : GL_FALSE;
    state->vtkglColorMask(hasColor, hasColor, hasColor, hasColor);
    this->FirstPass.Draw(window, starts, slab, entrance, number, volumes);
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    state->vtkglDepthMask(GL_FALSE);
    this->SecondPass.Draw(window, starts, slab, entrance, number, volumes);
  }
  else
  {
    this->FirstPass.Draw(window, starts, slab, entrance, number, volumes);
  }
  glDisable(GL_DEPTH_CLAMP);
  state->vtkglDisable(GL_DEPTH_TEST);
}

void VolumeSlices::MarkOpaquePixels(
  vtkOpenGLRenderWindow* window, SliceOcclusion& occlusion, vtkTextureObject* image, int slab)
{
  occlusion.Mark(window, image, this->Frame->Image->Camera.ClipFromUnit, this->MarkPass,
    this->GetSeen().GetStarts(), slab);
}

void VolumeSlices::Resume(vtkOpenGLRenderWindow* window)
{
  if (this->Textures->Resume())
  {
    return;
  }
  for (vtkShaderProgram* program : this->Programs)
  {
    window->GetShaderCache()->ReadyShaderProgram(program);
    this->Textures->Activate(program);
  }
}

void VolumeSlices::Suspend()
{
  this->Textures->Suspend();
}

void VolumeSlices::End()
{
  this->Textures->Deactivate();
  this->Programs.clear();
}

void VolumeSlices::ReleaseGraphicsResources()
{
  this->FirstPass.ReleaseGraphicsResources();
  this->SecondPass.ReleaseGraphicsResources();
  this->MarkPass.ReleaseGraphicsResources();
  this->Vertices->ReleaseGraphicsResources();
  this->TileVertices->ReleaseGraphicsResources();
}

}
