// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/FlowUniforms.h"

#include "Draw/FlowRenderFrame.h"

#include "vtkImplicitFlowVolumeMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkShaderProgram.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

namespace interlume
{

namespace
{
void SetValue(vtkShaderProgram* program, const char* name, const glm::dvec3& v)
{
  program->SetUniform3f(name, glm::value_ptr(glm::vec3(v)));
}

void SetValue(vtkShaderProgram* program, const char* name, double x, double y)
{
  program->SetUniform2f(name, glm::value_ptr(glm::vec2(x, y)));
}

void SetValue(vtkShaderProgram* program, const char* name, double x, double y, double z, double w)
{
  program->SetUniform4f(name, glm::value_ptr(glm::vec4(x, y, z, w)));
}

void SetValue(vtkShaderProgram* program, const char* name, const glm::dmat3& m)
{
  glm::mat3 values(m);
  program->SetUniformMatrix3x3(name, glm::value_ptr(values));
}

void SetView(vtkShaderProgram* program, const FlowRenderState& scene, const FlowRenderFrame& pass)
{
  const FlowViewRays& view = scene.View;
  SetValue(program, "rayOrigin", view.Origin);
  SetValue(program, "rayOriginX", view.OriginX);
  SetValue(program, "rayOriginY", view.OriginY);
  SetValue(program, "rayDirection", view.Direction);
  SetValue(program, "rayDirectionX", view.DirectionX);
  SetValue(program, "rayDirectionY", view.DirectionY);
  SetValue(program, "worldFromVoxels", glm::dmat3(view.WorldFromVoxels));
  SetValue(program, "nearFar", view.NearFar[0], view.NearFar[1]);
  program->SetUniformf("centerDistance", static_cast<float>(view.CenterDistance));
  SetValue(program, "boxLower", view.BoxLower);
  SetValue(program, "boxUpper", view.BoxUpper);
  SetValue(program, "pixelSize", 2.0 / pass.Size[0], 2.0 / pass.Size[1]);
  if (!view.ClippingPlanes.empty())
  {
    const std::vector<glm::vec4> planes(view.ClippingPlanes.begin(), view.ClippingPlanes.end());
    program->SetUniform4fv("clippingPlanes", static_cast<int>(planes.size()),
      reinterpret_cast<const float(*)[4]>(planes.data()));
  }
  if (view.Regions.HasGaps())
  {
    view.Regions.SetUniforms(program);
  }
}
}

void FlowUniforms::Set(
  vtkShaderProgram* program, const FlowRenderState& scene, const FlowRenderFrame& pass)
{
  SetView(program, scene, pass);
  program->SetUniformf("sampleDistance", static_cast<float>(pass.SampleDistance));
  SetMedium(program, scene, pass);
  if (pass.Parts.IsShaded)
  {
    vtkVolumeProperty* property = pass.Volume->GetProperty();
    SetValue(program, "material",
      { property->GetAmbient(), property->GetDiffuse(), property->GetSpecular() });
    const glm::dvec3 size(scene.Grid.Size[0], scene.Grid.Size[1], scene.Grid.Size[2]);
    const glm::dmat3 axes(scene.View.WorldFromVoxels);
    SetValue(program, "worldOrigin", -(axes * (0.5 * (size - 1.0))));
    scene.Lights.SetUniforms(program);
  }
}

void FlowUniforms::SetMedium(
  vtkShaderProgram* program, const FlowRenderState& scene, const FlowRenderFrame& pass)
{
  vtkImplicitFlowVolumeMapper& mapper = pass.Mapper;
  vtkVolumeProperty* property = pass.Volume->GetProperty();
  const glm::dvec3 size(scene.Grid.Size[0], scene.Grid.Size[1], scene.Grid.Size[2]);
  SetValue(program, "lastCell", size - 2.0);
  program->SetUniformf(
    "inverseUnitDistance", static_cast<float>(1.0 / property->GetScalarOpacityUnitDistance(0)));
  const auto clamped = [&mapper](int channel)
  { return std::min(std::max(mapper.GetDefaultColor()[channel], 0.0), 1.0); };
  const double alpha = clamped(3);
  SetValue(
    program, "defaultColor", clamped(0) * alpha, clamped(1) * alpha, clamped(2) * alpha, alpha);
  std::array<double, 2> largest{ { 1.0, 1.0 } };
  for (const SurfacePaintTextures::Paint& paint : scene.Paints.Paints)
  {
    const std::array<double, 2> texel{ { 1.0 / paint.Size[0], 1.0 / paint.Size[1] } };
    SetValue(program, ("paintFrame_" + paint.Name).c_str(), 1.0 - texel[0], 1.0 - texel[1],
      0.5 * texel[0], 0.5 * texel[1]);
    for (int i = 0; i < 2; ++i)
    {
      largest[i] = std::max(largest[i], static_cast<double>(paint.Size[i]));
    }
  }
  if (pass.Parts.DetailDimensions > 0)
  {
    const glm::dvec3 detail(pass.DetailSize[0], pass.DetailSize[1], pass.DetailSize[2]);
    SetValue(program, "detailScale", glm::make_vec3(mapper.GetDetailScale()));
    SetValue(program, "detailSize", detail);
    for (int i = 0; i < 2; ++i)
    {
      largest[i] = std::max(largest[i], detail[i] * std::abs(mapper.GetDetailScale()[i]));
    }
  }
  SetValue(program, "paintSize", largest[0], largest[1]);
  program->SetUniformi("largestPieces", mapper.GetMaximumTextureSamples());
  program->SetUniformf("timePeriod", static_cast<float>(mapper.GetTimePeriod()));
  // Drop whole periods of a repeating gate, to keep the precision of large phases.
  const bool isPeriodic = mapper.GetTimeGateRepeat() && pass.Parts.DetailDimensions != 3;
  const double phase =
    mapper.GetTimePhase() - (isPeriodic ? std::floor(mapper.GetTimePhase()) : 0.0);
  program->SetUniformf("timePhase", static_cast<float>(phase));
  if (mapper.GetTimeGate())
  {
    const double* range = mapper.GetTimeGate()->GetRange();
    SetValue(program, "gateRange", range[0], std::max(range[1] - range[0], 1e-30));
  }
  SetValue(program, "transferRange", pass.TransferRange[0],
    1.0 / (pass.TransferRange[1] - pass.TransferRange[0]));
  SetValue(program, "voxels", size);
  SetValue(program, "voxelSize", 1.0 / size);
  if (pass.Parts.IsShaded)
  {
    SetValue(program, "shadingVoxels", size);
    program->SetUniformf("power", static_cast<float>(property->GetSpecularPower()));
    const glm::dmat3 axes(scene.View.WorldFromVoxels);
    SetValue(program, "worldFromVoxels", axes);
    const glm::dmat3 fromVolume = axes * glm::inverse(glm::dmat3(scene.View.VolumeFromVoxels));
    SetValue(program, "worldFromVolume", fromVolume);
  }
}

}
