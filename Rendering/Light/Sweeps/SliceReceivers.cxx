// SPDX-License-Identifier: BSD-3-Clause
#include "Sweeps/SliceReceivers.h"

#include "Buffers/EmitterSampleLayers.h"
#include "Buffers/SliceLightBuffer.h"
#include "Buffers/VolumeSlices.h"
#include "Loader/OpenGLFunctions.h"
#include "Receivers/LightTransmittance.h"
#include "Receivers/SliceScene.h"
#include "Shaders/SliceShader.h"
#include "Shaders/VolumeRenderState.h"
#include "Space/UnitVector.h"

#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkSMPTools.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>

namespace interlume
{

namespace
{
// Box of a volume's medium. Tests whether it intersects rays from a point to the lights of a sweep
// and to the samples of its area lights.
class MediumBox
{
public:
  MediumBox(const VolumeRenderState& frame, const SlicePlan::Sweep& sweep)
    : TextureFromUnit(frame.Space.TextureFromUnit)
    , Box(frame.Region.Box)
  {
    for (const SlicePlan::ShadowedLight& light : sweep.Lights)
    {
      this->Sources.push_back(frame.Image->Lights[light.Light].GetHomogeneousPosition());
    }
    for (const SlicePlan::ShadowedLight& light : sweep.Lights)
    {
      for (const SlicePlan::SampleView& sample : light.Samples)
      {
        this->Sources.push_back(sample.Source);
      }
    }
  }

  /// Returns true if light passes through the box on its way to a position in unit space.
  bool IsReachedByLight(const glm::dvec3& position) const
  {
    const glm::dvec3 from = UnitVector::TransformPoint(this->TextureFromUnit, position);
    return std::any_of(this->Sources.begin(), this->Sources.end(),
      [&](const glm::dvec4& source)
      {
        const glm::dvec3 direction = glm::dvec3(source) - source.w * position;
        return this->IsIntersected(
          from, UnitVector::TransformVector(this->TextureFromUnit, direction), source.w > 0.0);
      });
  }

private:
  bool IsIntersected(const glm::dvec3& from, const glm::dvec3& direction, bool isPositional) const
  {
    double first = 0.0;
    double last = isPositional ? 1.0 : VTK_DOUBLE_MAX;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double lower = this->Box[axis][0] - from[axis];
      const double upper = this->Box[axis][1] - from[axis];
      if (direction[axis] == 0.0)
      {
        last = lower > 0.0 || upper < 0.0 ? -1.0 : last;
        continue;
      }
      first = std::max(first, std::min(lower / direction[axis], upper / direction[axis]));
      last = std::min(last, std::max(lower / direction[axis], upper / direction[axis]));
    }
    return first < last;
  }

  const glm::dmat4& TextureFromUnit;
  const std::array<std::array<double, 2>, 3>& Box;
  /// Positions of positional lights and samples, with w = 1, and directions toward directional
  /// ones, with w = 0.
  std::vector<glm::dvec4> Sources;
};
}

SliceReceivers::SliceReceivers() = default;

SliceReceivers::~SliceReceivers() = default;

void SliceReceivers::Sort(const std::vector<std::unique_ptr<VolumeSlices>>& volumes)
{
  const VolumeRenderState& frame = volumes[0]->GetFrame();
  const SlicePlan::Sweep& sweep = *this->Sweep;
  const SliceScene& scene = *this->Scene;
  const std::vector<float>& depths = scene.CameraDepths;
  const glm::dmat4 unitFromClip = glm::inverse(frame.Image->Camera.ClipFromUnit);
  const int width = scene.Size[0];
  const int height = scene.Size[1];
  std::vector<MediumBox> boxes;
  for (const std::unique_ptr<VolumeSlices>& volume : volumes)
  {
    boxes.emplace_back(volume->GetFrame(), sweep);
  }
  // Position and slab of each pixel. The slab is -1 if no light reaches the position through the
  // medium, and -2 if the pixel shows no surface.
  std::vector<std::array<float, 3>> positions(depths.size());
  std::vector<int> slabs(depths.size(), -2);
  vtkSMPTools::For(0, height,
    [&](vtkIdType first, vtkIdType last)
    {
      for (std::size_t i = static_cast<std::size_t>(first) * width;
           i < static_cast<std::size_t>(last) * width; ++i)
      {
        if (!(depths[i] < 1.0F))
        {
          continue;
        }
        const glm::dvec4 homogeneous = unitFromClip *
          glm::dvec4(2.0 * (i % width + 0.5) / width - 1.0, 2.0 * (i / width + 0.5) / height - 1.0,
            2.0 * depths[i] - 1.0, 1.0);
        const glm::dvec3 position = glm::dvec3(homogeneous) / homogeneous.w;
        positions[i] = { { static_cast<float>(position.x), static_cast<float>(position.y),
          static_cast<float>(position.z) } };
        const double slab =
          std::floor((glm::dot(position, sweep.Normal) - sweep.First) / sweep.Spacing);
        slabs[i] = std::any_of(boxes.begin(), boxes.end(),
                     [&position](const MediumBox& box) { return box.IsReachedByLight(position); })
          ? static_cast<int>(std::min(std::max(slab, -1.0), static_cast<double>(sweep.Slabs)))
          : -1;
      }
    });
  this->Starts.assign(static_cast<std::size_t>(sweep.Slabs) + 2, 0);
  for (const int slab : slabs)
  {
    this->Scene->PixelsInFront += slab == -1 ? 1 : 0;
    if (slab >= 0)
    {
      ++this->Starts[static_cast<std::size_t>(slab) + 1];
    }
  }
  for (std::size_t i = 1; i < this->Starts.size(); ++i)
  {
    this->Starts[i] += this->Starts[i - 1];
  }
  const std::size_t behind = this->Starts[static_cast<std::size_t>(sweep.Slabs)];
  this->Scene->PixelsInside += static_cast<vtkIdType>(behind);
  this->Scene->PixelsBehind += static_cast<vtkIdType>(this->Starts.back() - behind);
  this->Positions.resize(3 * this->Starts.back());
  std::vector<std::size_t> next(this->Starts.begin(), this->Starts.end() - 1);
  for (std::size_t i = 0; i < slabs.size(); ++i)
  {
    if (slabs[i] >= 0)
    {
      std::copy_n(positions[i].begin(), 3,
        this->Positions.begin() + static_cast<std::ptrdiff_t>(3 * next[slabs[i]]++));
    }
  }
}

void SliceReceivers::Begin(
  const std::vector<std::unique_ptr<VolumeSlices>>& volumes, std::size_t sweepIndex)
{
  const VolumeRenderState& frame = volumes[0]->GetFrame();
  this->Frame = &frame;
  this->Scene = frame.Image->Scene;
  this->Sweep = &frame.Image->Plan.Sweeps[sweepIndex];
  this->Lights.clear();
  this->Next = 0;
  this->Positions.clear();
  if (this->Sweep->Lights.empty())
  {
    this->Starts.assign(static_cast<std::size_t>(this->Sweep->Slabs) + 2, 0);
    return;
  }
  this->Sort(volumes);
  if (!this->Positions.empty())
  {
    this->Vertices->Upload(this->Positions, vtkOpenGLBufferObject::ArrayBuffer);
  }
}

Error SliceReceivers::Prepare(vtkOpenGLRenderWindow* window, VolumeSlices& slices,
  const std::vector<SliceLightBuffer*>& buffers)
{
  this->Lights.emplace_back();
  if (this->Positions.empty())
  {
    return {};
  }
  const VolumeRenderState& frame = slices.GetFrame();
  for (std::size_t i = 0; i < this->Sweep->Lights.size(); ++i)
  {
    const SlicePlan::ShadowedLight& shadowed = this->Sweep->Lights[i];
    Light light;
    light.Tile = this->Scene->Transmittance->GetTile(frame.Image->Lights[shadowed.Light].Light);
    if (light.Tile < 0)
    {
      continue;
    }
    light.Pass = std::make_unique<SlicePass>();
    if (Error error = light.Pass->Prepare(
          window, SliceShader::GetReceiverShaderSource(frame, shadowed), this->Vertices))
    {
      return error;
    }
    vtkShaderProgram* program = light.Pass->GetProgram();
    slices.Add(program);
    program->SetUniformi("buffer_0", buffers[i]->GetTexture()->GetTextureUnit());
    SliceShader::SetReceiverUniforms(program, frame, *this->Sweep, shadowed);
    light.Planned = &shadowed;
    light.Buffer = buffers[i];
    const EmitterSampleLayers* layers = buffers[i]->GetSampleLayers();
    if (layers && frame.Number == 0)
    {
      light.Behind = std::make_unique<AreaLightReceivers>();
      if (Error error = light.Behind->Prepare(window, frame, shadowed, *layers, this->Vertices))
      {
        return error;
      }
    }
    this->Lights.back().push_back(std::move(light));
  }
  return {};
}

bool SliceReceivers::HasRemainingPoints(int slab) const
{
  return this->Next < this->Starts[static_cast<std::size_t>(slab) + 1];
}

int SliceReceivers::Draw(vtkOpenGLRenderWindow* window, int slab, std::size_t volume)
{
  const std::size_t first = this->Next;
  const std::size_t end = this->Starts[static_cast<std::size_t>(slab) + 1];
  const bool isBehind = slab == this->Sweep->Slabs;
  // Behind all slabs, the light buffers contain the attenuation of all volumes, so draw the
  // surfaces only once.
  if (this->Lights[volume].empty() || (isBehind && volume > 0))
  {
    return 0;
  }
  int passes = 0;
  for (const Light& light : this->Lights[volume])
  {
    passes += isBehind && light.Behind ? light.Buffer->GetSampleLayers()->Finish(window) : 0;
  }
  if (!this->Scene->Transmittance->Bind(window))
  {
    return passes;
  }
  vtkOpenGLState* state = window->GetState();
  state->vtkglBlendFunc(GL_ZERO, GL_SRC_COLOR);
  // Actors drawn as lines or points may have changed the point size.
  state->vtkglPointSize(1.0F);
  glEnable(GL_DEPTH_CLAMP);
  for (const Light& light : this->Lights[volume])
  {
    const std::array<int, 2> origin = this->Scene->Transmittance->GetOrigin(light.Tile);
    state->vtkglViewport(origin[0], origin[1], this->Scene->Size[0], this->Scene->Size[1]);
    if (isBehind && light.Behind)
    {
      light.Behind->Draw(
        window, *this->Frame, *light.Planned, *light.Buffer->GetSampleLayers(), first, end - first);
    }
    else
    {
      light.Pass->DrawPoints(
        window, first, end - first, this->Sweep->First + slab * this->Sweep->Spacing);
    }
    ++this->Scene->ReceiverPasses;
  }
  glDisable(GL_DEPTH_CLAMP);
  return passes;
}

void SliceReceivers::ReleaseGraphicsResources()
{
  for (const std::vector<Light>& lights : this->Lights)
  {
    for (const Light& light : lights)
    {
      light.Pass->ReleaseGraphicsResources();
      if (light.Behind)
      {
        light.Behind->ReleaseGraphicsResources();
      }
    }
  }
  this->Lights.clear();
  this->Vertices->ReleaseGraphicsResources();
}

}
