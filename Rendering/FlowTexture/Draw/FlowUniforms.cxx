// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/FlowUniforms.h"

#include "Draw/FlowPicture.h"

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
std::array<float, 3> ToFloats(const glm::dvec3& v)
{
  return { { static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z) } };
}

void SetValue(vtkShaderProgram* program, const char* name, const glm::dvec3& v)
{
  program->SetUniform3f(name, ToFloats(v).data());
}

void SetValue(vtkShaderProgram* program, const char* name, double x, double y)
{
  const float values[2] = { static_cast<float>(x), static_cast<float>(y) };
  program->SetUniform2f(name, values);
}

void SetValue(vtkShaderProgram* program, const char* name, double x, double y, double z, double w)
{
  const float values[4] = { static_cast<float>(x), static_cast<float>(y), static_cast<float>(z),
    static_cast<float>(w) };
  program->SetUniform4f(name, values);
}

void SetValue(vtkShaderProgram* program, const char* name, const glm::dmat3& m)
{
  float values[9];
  std::copy_n(glm::value_ptr(m), 9, values);
  program->SetUniformMatrix3x3(name, values);
}

void SetView(vtkShaderProgram* program, const FlowScene& scene, const FlowPicture& picture)
{
  const FlowView& view = scene.View;
  SetValue(program, "rayOrigin", view.Origin);
  SetValue(program, "rayOriginX", view.OriginX);
  SetValue(program, "rayOriginY", view.OriginY);
  SetValue(program, "rayDirection", view.Direction);
  SetValue(program, "rayDirectionX", view.DirectionX);
  SetValue(program, "rayDirectionY", view.DirectionY);
  SetValue(program, "worldFromVoxels", glm::dmat3(view.WorldFromVoxels));
  SetValue(program, "nearFar", view.NearFar[0], view.NearFar[1]);
  program->SetUniformf("middle", static_cast<float>(view.Middle));
  SetValue(program, "boxLower", view.BoxLower);
  SetValue(program, "boxUpper", view.BoxUpper);
  SetValue(program, "pixelSize", 2.0 / picture.Size[0], 2.0 / picture.Size[1]);
  if (!view.ClippingPlanes.empty())
  {
    std::vector<std::array<float, 4>> planes;
    for (const glm::dvec4& plane : view.ClippingPlanes)
    {
      planes.push_back({ { static_cast<float>(plane.x), static_cast<float>(plane.y),
        static_cast<float>(plane.z), static_cast<float>(plane.w) } });
    }
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
  vtkShaderProgram* program, const FlowScene& scene, const FlowPicture& picture)
{
  SetView(program, scene, picture);
  program->SetUniformf("sampleDistance", static_cast<float>(picture.SampleDistance));
  SetMatter(program, scene, picture);
  if (picture.Parts.IsShaded)
  {
    vtkVolumeProperty* property = picture.Volume->GetProperty();
    SetValue(program, "material",
      { property->GetAmbient(), property->GetDiffuse(), property->GetSpecular() });
    const glm::dvec3 size(scene.Grid.Size[0], scene.Grid.Size[1], scene.Grid.Size[2]);
    const glm::dmat3 axes(scene.View.WorldFromVoxels);
    SetValue(program, "worldOrigin", -(axes * (0.5 * (size - 1.0))));
    scene.Lights.SetUniforms(program);
  }
}

void FlowUniforms::SetMatter(
  vtkShaderProgram* program, const FlowScene& scene, const FlowPicture& picture)
{
  const vtkImplicitFlowVolumeSettings& settings = picture.Asked.Settings;
  vtkVolumeProperty* property = picture.Volume->GetProperty();
  const glm::dvec3 size(scene.Grid.Size[0], scene.Grid.Size[1], scene.Grid.Size[2]);
  SetValue(program, "lastCell", size - 2.0);
  program->SetUniformf(
    "unitShare", static_cast<float>(1.0 / property->GetScalarOpacityUnitDistance(0)));
  const double alpha = settings.DefaultColor[3];
  const float color[4] = { static_cast<float>(settings.DefaultColor[0] * alpha),
    static_cast<float>(settings.DefaultColor[1] * alpha),
    static_cast<float>(settings.DefaultColor[2] * alpha), static_cast<float>(alpha) };
  program->SetUniform4f("defaultColor", color);
  std::array<double, 2> largest{ { 1.0, 1.0 } };
  for (const FlowPaints::Paint& paint : scene.Paints.Paints)
  {
    const std::array<double, 2> texel{ { 1.0 / paint.Size[0], 1.0 / paint.Size[1] } };
    SetValue(program, ("paintFrame_" + paint.Name).c_str(), 1.0 - texel[0], 1.0 - texel[1],
      0.5 * texel[0], 0.5 * texel[1]);
    for (int i = 0; i < 2; ++i)
    {
      largest[i] = std::max(largest[i], static_cast<double>(paint.Size[i]));
    }
  }
  if (picture.Parts.DetailDimensions > 0)
  {
    const glm::dvec3 detail(picture.DetailSize[0], picture.DetailSize[1], picture.DetailSize[2]);
    SetValue(program, "detailScale", glm::make_vec3(settings.DetailScale));
    SetValue(program, "detailSize", detail);
    for (int i = 0; i < 2; ++i)
    {
      largest[i] = std::max(largest[i], detail[i] * std::abs(settings.DetailScale[i]));
    }
  }
  SetValue(program, "paintSize", largest[0], largest[1]);
  program->SetUniformi("largestPieces", settings.MaximumPaintSamples);
  program->SetUniformf("timePeriod", static_cast<float>(settings.TimePeriod));
  // A gate that repeats is the same for all phases that differ by whole periods.
  const bool isWhole = settings.TimeGateRepeat && picture.Parts.DetailDimensions != 3;
  const double phase = settings.TimePhase - (isWhole ? std::floor(settings.TimePhase) : 0.0);
  program->SetUniformf("timePhase", static_cast<float>(phase));
  if (settings.TimeGate)
  {
    const double* range = settings.TimeGate->GetRange();
    SetValue(program, "gateRange", range[0], std::max(range[1] - range[0], 1e-30));
  }
  SetValue(program, "transferRange", picture.TransferRange[0],
    1.0 / (picture.TransferRange[1] - picture.TransferRange[0]));
  SetValue(program, "voxels", size);
  SetValue(program, "voxelSize", 1.0 / size);
  if (picture.Parts.IsShaded)
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
