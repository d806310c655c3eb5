// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/SliceShader.h"

#include "Casters/SceneCasters.h"
#include "Common/Vectors.h"
#include "Receivers/SliceScene.h"
#include "Space/MatrixUniform.h"
#include "Space/UnitVector.h"
#include "Translucent/PaneMaps.h"

#include "InterlumeLightScreen.h"
#include "InterlumeSliceFS.h"
#include "InterlumeSliceLight.h"
#include "InterlumeSliceLightFS.h"
#include "InterlumeSliceMedium.h"
#include "InterlumeSliceReceiverFS.h"
#include "InterlumeSliceScatter.h"
#include "vtkProjectiveLight.h"
#include "vtkShaderFeatures.h"
#include "vtkShaderProgram.h"
#include "vtkSliceMatter.h"

#include <algorithm>
#include <array>

namespace interlume
{

namespace
{
// The optical depth of a slab from which on it counts as thick: thinner ones show no steps.
constexpr double LeastDepth = 0.15;

// The share of samples with matter up to which software OpenGL draws what is empty first. A sphere
// that fills two thirds of its blocks takes as long either way.
constexpr double MostForEmptyPart = 0.5;

using Sweep = SlicePlan::Sweep;
using ShadowedLight = SlicePlan::ShadowedLight;

std::string Replace(std::string text, const std::string& mark, const std::string& by)
{
  for (std::size_t place = text.find(mark); place != std::string::npos;
       place = text.find(mark, place + by.size()))
  {
    text.replace(place, mark.size(), by);
  }
  return text;
}

std::string GetMediumFeatures(const SliceFrame& frame)
{
  const MaterialTable& material = frame.Material;
  std::string features =
    "COLUMNS=" + std::to_string(MaterialTable::Columns) + " ROWS=" + std::to_string(material.Rows);
  // Equal sources of two volumes would share one program, and its uniforms.
  features += frame.Number > 0 ? " VOLUME_NUMBER=" + std::to_string(frame.Number) : std::string();
  features += material.Kind == MaterialTable::INDEPENDENT ? " OPACITY_OF=r"
    : material.Kind == MaterialTable::COLOR_OPACITY       ? " OPACITY_OF=g"
                                                          : " OPACITY_OF=a";
  if (frame.Matter)
  {
    features += " MATTER";
  }
  features += frame.Samples.Mask.empty() ? "" : " MASK";
  features += material.GradientOpacity.empty() ? "" : " GRADIENT_OPACITY";
  features += material.Bends.empty() ? "" : " BENDS";
  features +=
    material.HasEdges() ? " EDGES EDGE_PLACES=" + std::to_string(TransferColumns::EdgePlaces) : "";
  features += frame.Region.Regions.HasGaps() ? " CROPPING" : "";
  if (!frame.Region.ClippingPlanes.empty())
  {
    features += " CLIPPING_PLANES=" + std::to_string(frame.Region.ClippingPlanes.size());
  }
  return features;
}

// Returns the functions that the matter of a volume is looked up by.
std::string GetMedium(const SliceFrame& frame)
{
  return Replace(InterlumeSliceMedium, "//INTERLUME::MATTER",
    frame.Matter ? frame.Matter->GetSource() : std::string());
}

// Returns whether light has colours of its own inside the matter, or another volume's.
bool HasTransmission(const SliceFrame& frame)
{
  return frame.GetLightChannels() > 1 && frame.HasShadows();
}

// Returns whether extinctions are integrated over a ray's way through a slab, between two samples,
// instead of taken from its middle.
bool HasSpans(const SliceFrame& frame, bool isThick)
{
  return !isThick && frame.HasShadows() &&
    SliceShader::GetRampExtinction(frame) * frame.Plan.Sweeps[0].Spacing > SlicePlan::DenseDepth;
}

std::string GetTransmissionFeatures(const SliceFrame& frame)
{
  if (!HasTransmission(frame))
  {
    return {};
  }
  return frame.Material.Transmission.empty() ? " TRANSMISSION GREY" : " TRANSMISSION";
}

const ShadowedLight* FindShadow(const Sweep& sweep, int light)
{
  const auto found = std::find_if(sweep.Lights.begin(), sweep.Lights.end(),
    [light](const ShadowedLight& shadowed) { return shadowed.Light == light; });
  return found == sweep.Lights.end() ? nullptr : &*found;
}

std::string GetLightFeatures(const LightSource& light, const ShadowedLight* shadow, int number)
{
  std::string features;
  const auto add = [&](bool has, const char* name)
  { features += has ? std::string(" ") + name + "_" + std::to_string(number) : std::string(); };
  add(light.IsPositional, "POSITIONAL");
  add(light.ConeCosine > -1.0, "CONE");
  add(light.Projective != nullptr, "SCREEN");
  add(light.Projective && light.Projective->GetImage(), "IMAGE");
  add(shadow != nullptr, "SHADOW");
  add(shadow && shadow->IsWide, "WIDE");
  return features;
}

// Returns whether surfaces of the scene cast shadows in the volume.
bool HasCasters(const SliceFrame& frame)
{
  return frame.Scene && frame.HasShadows() && frame.Scene->Casters->HasViews();
}

// Returns whether translucent surfaces of the scene do.
bool HasPanes(const SliceFrame& frame)
{
  return frame.Scene && frame.HasShadows() && frame.Scene->Panes &&
    frame.Scene->Panes->GetLayers() > 0;
}

// Returns how a light asks what surfaces leave of it.
std::string GetCasterFeatures(const SliceFrame& frame, int light, int number)
{
  const std::string share = HasCasters(frame)
    ? frame.Scene->Casters->GetShare(frame.Lights[light].Light, "sampleAt", "vec4(0.0)")
    : std::string();
  const std::string suffix = "_" + std::to_string(number);
  return share.empty() ? share : " CASTERS" + suffix + " CASTER_SHARE" + suffix + "=" + share;
}

// Returns how light is scattered towards the eye.
std::string GetScatteringFeatures(const SliceScattering& scattering)
{
  if (!scattering.IsOn())
  {
    return {};
  }
  std::string features = " SCATTER";
  features += scattering.Brightness != 1.0 ? " SCATTER_BRIGHTNESS" : "";
  features +=
    scattering.Kind == vtkShadowedSliceSettings::HENYEY_GREENSTEIN_PHASE ? " PHASE_ANISOTROPY" : "";
  features += scattering.Kind == vtkShadowedSliceSettings::TABLE_PHASE
    ? " PHASE_TABLE PHASE_COLUMNS=" + std::to_string(SliceScattering::PhaseColumns)
    : std::string();
  features +=
    scattering.HasField() ? " FIELD_MAPS=" + std::to_string(scattering.GetMaps()) : std::string();
  return features;
}

// Returns the number of the map of what is scattered on with a light of the list, for the first of
// those that stand for it, or 0.
int GetForwardMap(const SliceFrame& frame, int light)
{
  const auto isSame = [&](const LightSource& other)
  { return other.Light == frame.Lights[light].Light; };
  const auto first = std::find_if(frame.Lights.begin(), frame.Lights.end(), isSame);
  return std::distance(frame.Lights.begin(), first) == light
    ? frame.Scattering.GetForwardMap(frame.Lights[light].Light)
    : 0;
}

// Returns the eye's program with these features, the sources of its lights, and the calls of them.
std::string MakeEyeSource(const SliceFrame& frame, const std::string& features,
  const std::string& lights, const std::string& calls)
{
  std::string source = Replace(InterlumeSliceFS, "//INTERLUME::MEDIUM", GetMedium(frame));
  source = Replace(source, "//INTERLUME::LIGHTS", lights);
  source = Replace(source, "//INTERLUME::SHINE", calls);
  return vtkShaderFeatures::Insert(source, features);
}

void SetVector(vtkShaderProgram* program, const std::string& name, const glm::dvec3& v)
{
  program->SetUniform3f(name.c_str(), glm::value_ptr(v));
}

void SetVector(vtkShaderProgram* program, const std::string& name, const std::array<double, 4>& v)
{
  const float values[4] = { static_cast<float>(v[0]), static_cast<float>(v[1]),
    static_cast<float>(v[2]), static_cast<float>(v[3]) };
  program->SetUniform4f(name.c_str(), values);
}

void SetFrame(vtkShaderProgram* program, const std::string& name, const std::array<double, 9>& axes)
{
  float columns[9];
  std::transform(axes.begin(), axes.end(), std::begin(columns),
    [](double value) { return static_cast<float>(value); });
  program->SetUniformMatrix3x3(name.c_str(), columns);
}

// The map from a texel to the column of its value in a row of the range: less the origin, times the
// scale.
struct Columns
{
  std::array<double, 4> Scale{ { 0.0, 0.0, 0.0, 0.0 } };
  std::array<double, 4> Origin{ { 0.0, 0.0, 0.0, 0.0 } };

  void Set(const VolumeSamples& samples, int component, const std::array<double, 2>& range)
  {
    const double columns = (MaterialTable::Columns - 1) / (range[1] - range[0]);
    this->Scale[component] = samples.Scale[component] * columns;
    this->Origin[component] = (range[0] - samples.Offset[component]) / samples.Scale[component];
  }
};

int GetOpacityComponent(const MaterialTable& material, int row)
{
  switch (material.Kind)
  {
    case MaterialTable::COLOR_OPACITY:
      return 1;
    case MaterialTable::RGB_OPACITY:
      return 3;
    default:
      return row;
  }
}

Columns GetColorColumns(const SliceFrame& frame)
{
  const VolumeSamples& samples = frame.Samples;
  Columns columns;
  if (frame.Material.Kind == MaterialTable::RGB_OPACITY)
  {
    // Texels of bytes are colours as texels; all others are colours as they are.
    const bool isByte = samples.Scale[0] == 255.0 && samples.Offset[0] == 0.0;
    for (int c = 0; c < 3; ++c)
    {
      columns.Scale[c] = isByte ? 1.0 : samples.Scale[c];
      columns.Origin[c] = isByte ? 0.0 : -samples.Offset[c] / samples.Scale[c];
    }
    return columns;
  }
  for (int row = 0; row < frame.Material.Rows; ++row)
  {
    columns.Set(samples, row, frame.Material.ColorRange[row]);
  }
  return columns;
}

void SetMediumUniforms(vtkShaderProgram* program, const SliceFrame& frame, const Sweep& sweep)
{
  const UnitSpace& space = frame.Space;
  MatrixUniform::Set(program, "textureFromUnit", space.TextureFromUnit);
  program->SetUniformf("worldLength", static_cast<float>(space.Radius));
  SetVector(program, "boxLower",
    glm::dvec3(frame.Region.Box[0][0], frame.Region.Box[1][0], frame.Region.Box[2][0]));
  SetVector(program, "boxUpper",
    glm::dvec3(frame.Region.Box[0][1], frame.Region.Box[1][1], frame.Region.Box[2][1]));
  SetVector(program, "sliceNormal", sweep.Normal);
  program->SetUniformf("sliceSpacing", static_cast<float>(sweep.Spacing));

  Columns columns;
  for (int row = 0; row < frame.Material.Rows; ++row)
  {
    columns.Set(
      frame.Samples, GetOpacityComponent(frame.Material, row), frame.Material.OpacityRange[row]);
  }
  SetVector(program, "columnScale", columns.Scale);
  SetVector(program, "columnOrigin", columns.Origin);
  if (program->IsUniformUsed("colorColumnScale"))
  {
    const Columns colors = GetColorColumns(frame);
    SetVector(program, "colorColumnScale", colors.Scale);
    SetVector(program, "colorColumnOrigin", colors.Origin);
  }
  if (program->IsUniformUsed("voxel"))
  {
    SetVector(
      program, "voxel", glm::dvec3(1.0 / space.Size[0], 1.0 / space.Size[1], 1.0 / space.Size[2]));
  }
  if (!frame.Material.GradientOpacity.empty())
  {
    std::array<double, 4> scale{};
    std::array<double, 4> distances{ { 1.0, 1.0, 1.0, 1.0 } };
    for (int row = 0; row < frame.Material.Rows; ++row)
    {
      const int component = GetOpacityComponent(frame.Material, row);
      scale[row] = frame.Samples.Scale[component] * (MaterialTable::Columns - 1) /
        frame.Material.GradientRange[row];
      distances[row] = frame.UnitDistances[row] / space.Radius;
    }
    SetVector(program, "gradientSteps", 0.5 * frame.GradientSteps);
    SetVector(program, "gradientColumnScale", scale);
    SetVector(program, "unitDistances", distances);
  }
  if (!frame.Region.ClippingPlanes.empty())
  {
    std::vector<float> planes;
    for (const auto& plane : frame.Region.ClippingPlanes)
    {
      planes.insert(planes.end(), plane.begin(), plane.end());
    }
    program->SetUniform4fv(
      "clippingPlanes", static_cast<int>(frame.Region.ClippingPlanes.size()), planes.data());
  }
  if (frame.Region.Regions.HasGaps())
  {
    frame.Region.Regions.SetUniforms(program);
  }
}

void SetScattering(vtkShaderProgram* program, const SliceScattering& scattering)
{
  if (program->IsUniformUsed("brightness"))
  {
    program->SetUniformf("brightness", static_cast<float>(scattering.Brightness));
  }
  if (program->IsUniformUsed("phase"))
  {
    const double g = scattering.Anisotropy;
    SetVector(program, "phase", glm::dvec3(1.0 - g * g, (1.0 - g) * (1.0 - g), g));
  }
  if (program->IsUniformUsed("scattered"))
  {
    MatrixUniform::Set(program, "nodeFromUnit", scattering.NodeFromUnit);
    SetVector(program, "fieldNodes", glm::dvec3(scattering.Nodes));
    program->SetUniformf("meanCosine", static_cast<float>(scattering.MeanCosine));
  }
}

void SetLight(vtkShaderProgram* program, const LightSource& light, const ShadowedLight* shadow,
  const std::string& number)
{
  SetVector(program, "diffuse" + number, light.Diffuse);
  const auto isUsed = [&](const std::string& name)
  { return program->IsUniformUsed((name + number).c_str()); };
  if (isUsed("specular"))
  {
    SetVector(program, "specular" + number, light.Specular);
  }
  if (isUsed("position"))
  {
    SetVector(program, "position" + number, light.Position);
  }
  if (isUsed("attenuation"))
  {
    SetVector(program, "attenuation" + number, light.Attenuation);
  }
  if (isUsed("direction"))
  {
    SetVector(program, "direction" + number, light.Direction);
  }
  if (isUsed("cone"))
  {
    const float cone[2] = { static_cast<float>(light.ConeCosine),
      static_cast<float>(light.Exponent) };
    program->SetUniform2f(("cone" + number).c_str(), cone);
  }
  if (light.Projective)
  {
    MatrixUniform::Set(program, "screenFromUnit" + number, light.ScreenFromUnit);
    program->SetUniformf(
      ("edgeWidth" + number).c_str(), static_cast<float>(light.Projective->GetEdgeWidth()));
    program->SetUniformf(
      ("screenOpacity" + number).c_str(), static_cast<float>(light.Projective->GetScreenOpacity()));
  }
  if (shadow)
  {
    program->SetUniformf(("strength" + number).c_str(), static_cast<float>(light.ShadowStrength));
    if (shadow->IsWide)
    {
      SetFrame(program, "frame" + number, shadow->Frame);
    }
    else
    {
      MatrixUniform::Set(program, "bufferFromUnit" + number, shadow->BufferFromUnit);
      if (isUsed("voxelLength"))
      {
        program->SetUniformf(
          ("voxelLength" + number).c_str(), static_cast<float>(shadow->VoxelLength));
      }
    }
  }
}
}

std::vector<int> SliceShader::GetLightsOf(const SliceFrame& frame, std::size_t sweep)
{
  std::vector<int> lights;
  if (!frame.IsLit())
  {
    return lights;
  }
  for (const ShadowedLight& light : frame.Plan.Sweeps[sweep].Lights)
  {
    lights.push_back(light.Light);
  }
  for (std::size_t i = 0; frame.Plan.IsOfFirstPicture(sweep) && i < frame.Lights.size(); ++i)
  {
    if (!(frame.Lights[i].ShadowStrength > 0.0))
    {
      lights.push_back(static_cast<int>(i));
    }
  }
  return lights;
}

double SliceShader::GetLargestExtinction(const SliceFrame& frame)
{
  const MaterialTable& material = frame.Material;
  double extinction = 0.0;
  for (int row = 0; row < material.Rows; ++row)
  {
    const std::array<double, 2>& range = material.OpacityRange[row];
    extinction += material.GetLargestExtinction(row, range[0], range[1]);
  }
  return extinction * frame.Space.Radius;
}

double SliceShader::GetRampExtinction(const SliceFrame& frame)
{
  const bool isRamp = !frame.Matter && frame.Material.GradientOpacity.empty();
  return isRamp ? GetLargestExtinction(frame) : 0.0;
}

bool SliceShader::HasThickPart(const SliceFrame& frame, std::size_t sweep)
{
  const SlicePlan::Sweep& planned = frame.Plan.Sweeps[sweep];
  // On a ramp that is steep some slabs would see a jump and others none, which shows as stripes.
  return frame.Material.HasSharpOpacity() &&
    GetLargestExtinction(frame) * planned.Spacing > LeastDepth &&
    std::any_of(planned.Lights.begin(), planned.Lights.end(),
      [](const ShadowedLight& light) { return !light.IsWide; });
}

bool SliceShader::HasEmptyPart(const SliceFrame& frame, std::size_t sweep)
{
  return frame.IsSoftware && frame.IsLit() && !frame.Matter &&
    frame.ShareOfMatter < MostForEmptyPart && !HasThickPart(frame, sweep);
}

bool SliceShader::HasThinPart(const SliceFrame& frame, std::size_t sweep)
{
  return !HasThickPart(frame, sweep) ||
    frame.Material.GetSmallestExtinction() * frame.Plan.Sweeps[sweep].Spacing *
      frame.Space.Radius <=
    LeastDepth;
}

std::string SliceShader::GetEyeSource(
  const SliceFrame& frame, std::size_t sweep, bool isOccluded, Parts part)
{
  std::string features = GetMediumFeatures(frame);
  const std::array<const char*, 4> names{ { "", " THIN", " EMPTY", " THICK" } };
  features += names[part];
  const bool isThick = HasThickPart(frame, sweep);
  features += part == THICK ? " SUMS" : HasSpans(frame, isThick) ? " SUMS SPANS" : "";
  features += part == ALL ? "" : " LEAST_DEPTH=" + std::to_string(LeastDepth);
  features += frame.IsSmoothLookup ? "" : " NEAREST_LIGHT";
  features += frame.Eye.IsParallel ? "" : " PERSPECTIVE";
  features += frame.NearPlane.IsCutting ? " NEAR_PLANE" : "";
  features += frame.FarPlane.IsCutting ? " FAR_PLANE" : "";
  features += isOccluded ? " OPAQUE" : "";
  features += frame.Scene && frame.Scene->FrontDepth ? " FRONT" : "";
  features += frame.Material.Kind == MaterialTable::RGB_OPACITY ? " RGB" : "";
  if (part == EMPTY)
  {
    return MakeEyeSource(frame, features, "", "");
  }
  features += frame.IsLit() ? " LIT" : "";
  features += frame.Plan.Sweeps[sweep].IsFrontToBack ? "" : " BACK_TO_FRONT";
  features += frame.IsShaded ? " SHADE" : "";
  features += frame.IsShaded && frame.TwoSidedLighting ? " TWO_SIDED" : "";
  features += GetScatteringFeatures(frame.Scattering);
  features += GetTransmissionFeatures(frame);
  std::string lights;
  std::string calls;
  if (HasCasters(frame))
  {
    features += " CASTER_GATHER " + frame.Scene->Casters->GetFeatures();
    lights = frame.Scene->Casters->GetSource();
  }
  lights += HasPanes(frame) ? frame.Scene->Panes->GetSource(false) : std::string();
  const std::vector<int> seen = GetLightsOf(frame, sweep);
  const bool hasScreens = std::any_of(seen.begin(), seen.end(),
    [&frame](int light) { return frame.Lights[light].Projective != nullptr; });
  lights += hasScreens ? InterlumeLightScreen : "";
  int number = 0;
  for (int light : seen)
  {
    features +=
      GetLightFeatures(frame.Lights[light], FindShadow(frame.Plan.Sweeps[sweep], light), number);
    features += GetCasterFeatures(frame, light, number);
    const int map = GetForwardMap(frame, light);
    features += map > 0 ? " FORWARD_MAP_" + std::to_string(number) + "=" + std::to_string(map)
                        : std::string();
    const std::string panes = HasPanes(frame)
      ? frame.Scene->Panes->GetShare(frame.Lights[light].Light, "sampleAt", "vec4(0.0)")
      : std::string();
    lights += Replace(
      Replace(InterlumeSliceLight, "OF_PANES_INDEX ", panes.empty() ? panes : panes + " * "),
      "INDEX", std::to_string(number));
    calls += "shine_" + std::to_string(number) + "(color);\n";
    ++number;
  }
  calls += frame.Scattering.HasFluence && frame.Plan.IsOfFirstPicture(sweep)
    ? "addScattered(color);\n"
    : "";
  return Replace(MakeEyeSource(frame, features, lights, calls), "//INTERLUME::SCATTER",
    frame.Scattering.IsOn() ? InterlumeSliceScatter : "");
}

std::string SliceShader::GetLightSource(
  const SliceFrame& frame, const SlicePlan::ShadowedLight& light, bool isThick)
{
  std::string features = GetMediumFeatures(frame);
  features += GetTransmissionFeatures(frame);
  features += light.IsWide ? " WIDE" : HasSpans(frame, isThick) ? " SUMS SPANS" : "";
  features += frame.Lights[light.Light].IsPositional ? " POSITIONAL" : "";
  // Equal sources would share one program, and its uniforms.
  features += " LIGHT_NUMBER=" + std::to_string(light.Light);
  std::string source = Replace(InterlumeSliceLightFS, "//INTERLUME::MEDIUM", GetMedium(frame));
  // VTK declares every output that is named, whatever the features are.
  source = Replace(source, "//INTERLUME::BATCH",
    light.SoftMethod == SlicePlan::LAYERS ? "gl_FragData[1] = gl_FragData[0];" : "");
  return vtkShaderFeatures::Insert(source, features);
}

std::string SliceShader::GetReceiverSource(
  const SliceFrame& frame, const SlicePlan::ShadowedLight& light)
{
  std::string features = GetMediumFeatures(frame);
  features += GetTransmissionFeatures(frame);
  features += frame.IsSmoothLookup ? "" : " NEAREST_LIGHT";
  features += GetLightFeatures(frame.Lights[light.Light], &light, 0);
  features += " LIGHT_NUMBER=" + std::to_string(light.Light);
  // The first volume has the light's buffer, which is the same for all of them.
  features += frame.Number > 0 ? " WITHIN" : "";
  std::string source = Replace(InterlumeSliceReceiverFS, "//INTERLUME::MEDIUM", GetMedium(frame));
  const std::string screen = frame.Lights[light.Light].Projective ? InterlumeLightScreen : "";
  source = Replace(source, "//INTERLUME::LIGHTS",
    screen + Replace(Replace(InterlumeSliceLight, "OF_PANES_INDEX ", ""), "INDEX", "0"));
  return vtkShaderFeatures::Insert(source, features);
}

std::string SliceShader::GetNames(const SliceFrame& frame, bool isOccluded)
{
  const MaterialTable& material = frame.Material;
  std::string names = material.Kind == MaterialTable::RGB_OPACITY ? "rgb-opacity"
    : material.Kind == MaterialTable::COLOR_OPACITY               ? "color-opacity"
                                                                  : "scalar";
  names += material.Rows > 1 ? "-" + std::to_string(material.Rows) : std::string();
  const auto add = [&names](bool has, const char* name)
  { names += has ? std::string(" ") + name : std::string(); };
  add(frame.Eye.IsParallel, "parallel");
  add(!frame.Eye.IsParallel, "perspective");
  add(frame.Matter != nullptr, "matter");
  add(!frame.Samples.Mask.empty(), "mask");
  add(!material.GradientOpacity.empty(), "gradient-opacity");
  add(frame.Region.Regions.HasGaps(), "cropping");
  add(!frame.Region.ClippingPlanes.empty(), "clipping-planes");
  add(frame.NearPlane.IsCutting, "near-plane");
  add(frame.FarPlane.IsCutting, "far-plane");
  add(isOccluded, "opaque");
  add(frame.IsShaded, "shade");
  add(frame.IsShaded && frame.TwoSidedLighting, "two-sided");
  add(frame.HasShadows(), "shadow");
  add(HasEmptyPart(frame, 0), "empty-first");
  const SliceScattering& scattering = frame.Scattering;
  add(scattering.IsOn(), "scattering");
  add(scattering.IsOn() && scattering.Kind == vtkShadowedSliceSettings::HENYEY_GREENSTEIN_PHASE,
    "anisotropy");
  add(scattering.IsOn() && scattering.Kind == vtkShadowedSliceSettings::TABLE_PHASE, "phase-table");
  add(scattering.HasField(), "scattering-field");
  add(HasTransmission(frame), "transmission");
  add(HasCasters(frame), "casters");
  add(HasPanes(frame), "panes");
  const auto hasShadow = [&frame](auto&& test)
  {
    return std::any_of(frame.Plan.Sweeps.begin(), frame.Plan.Sweeps.end(),
      [&test](const Sweep& sweep)
      { return std::any_of(sweep.Lights.begin(), sweep.Lights.end(), test); });
  };
  add(hasShadow([](const ShadowedLight& light) { return light.IsWide; }), "shadow-wide");
  add(hasShadow([](const ShadowedLight& light) { return light.SoftMethod != SlicePlan::HARD; }),
    "shadow-soft");
  const auto has = [&frame](auto&& test)
  { return frame.IsLit() && std::any_of(frame.Lights.begin(), frame.Lights.end(), test); };
  add(has([](const LightSource& light) { return light.IsPositional; }), "positional");
  add(has([](const LightSource& light) { return light.ConeCosine > -1.0; }), "cone");
  add(has([](const LightSource& light) { return light.Projective != nullptr; }), "screen");
  return names;
}

void SliceShader::SetEyeUniforms(
  vtkShaderProgram* program, const SliceFrame& frame, std::size_t sweep, bool isOccluded)
{
  SetMediumUniforms(program, frame, frame.Plan.Sweeps[sweep]);
  MatrixUniform::Set(program, "clipFromUnit", frame.Eye.ClipFromUnit);
  if (frame.Eye.IsParallel)
  {
    SetVector(program, "eyeDirection", frame.Eye.Direction);
  }
  else
  {
    SetVector(program, "eyePosition", frame.Eye.Position);
  }
  if (frame.NearPlane.IsCutting)
  {
    SetVector(program, "nearPlane", frame.NearPlane.Plane);
  }
  if (frame.FarPlane.IsCutting)
  {
    SetVector(program, "farPlane", frame.FarPlane.Plane);
  }
  if (isOccluded)
  {
    const float size[2] = { static_cast<float>(frame.Size[0]), static_cast<float>(frame.Size[1]) };
    program->SetUniform2f("imageSize", size);
    MatrixUniform::Set(program, "unitFromClip", glm::inverse(frame.Eye.ClipFromUnit));
  }
  if (!frame.IsLit())
  {
    return;
  }
  if (HasCasters(frame))
  {
    frame.Scene->Casters->SetUniforms(program, frame.Space.GetWorldFromUnit());
  }
  if (HasPanes(frame))
  {
    frame.Scene->Panes->SetUniforms(program, frame.Space.GetWorldFromUnit());
  }
  int number = 0;
  for (int light : GetLightsOf(frame, sweep))
  {
    SetLight(program, frame.Lights[light], FindShadow(frame.Plan.Sweeps[sweep], light),
      "_" + std::to_string(number++));
  }
  if (frame.Scattering.IsOn())
  {
    SetScattering(program, frame.Scattering);
    return;
  }
  std::vector<float> materials;
  for (int row = 0; row < frame.Material.Rows; ++row)
  {
    materials.insert(materials.end(), frame.Materials[row].begin(), frame.Materials[row].end());
  }
  if (frame.IsShaded)
  {
    std::array<double, 4> columns{};
    for (int row = 0; row < frame.Material.Rows; ++row)
    {
      const std::array<double, 2>& scalars = frame.Material.ScalarRange[row];
      const std::array<double, 2>& range = frame.Material.OpacityRange[row];
      // A change by a millionth of the range is rounding.
      columns[row] = (MaterialTable::Columns - 1) *
        std::max(frame.SurfaceGradient * ((scalars[1] - scalars[0]) / (range[1] - range[0])), 1e-6);
    }
    SetVector(program, "surfaceColumns", columns);
  }
  program->SetUniform4fv("materials", frame.Material.Rows, materials.data());
  const glm::dvec3 none{ 0.0, 0.0, 0.0 };
  SetVector(program, "ambient", frame.Plan.IsOfFirstPicture(sweep) ? frame.Ambient : none);
}

void SliceShader::SetLightUniforms(vtkShaderProgram* program, const SliceFrame& frame,
  const SlicePlan::Sweep& sweep, const SlicePlan::ShadowedLight& light)
{
  SetMediumUniforms(program, frame, sweep);
  const LightSource& source = frame.Lights[light.Light];
  if (light.IsWide)
  {
    SetFrame(program, "frame", light.Frame);
    // From a place in the buffer.
    const double rows[16] = { 2.0, 0.0, 0.0, -1.0, 0.0, 2.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0,
      0.0, 0.0, 1.0 };
    MatrixUniform::Set(program, "clipFromUnit", UnitVector::FromRows(rows));
  }
  else
  {
    MatrixUniform::Set(program, "clipFromUnit", light.BufferFromUnit);
  }
  if (source.IsPositional)
  {
    SetVector(program, "position", source.Position);
  }
  else
  {
    SetVector(program, "direction", source.Direction);
  }
}

void SliceShader::SetReceiverUniforms(vtkShaderProgram* program, const SliceFrame& frame,
  const SlicePlan::Sweep& sweep, const SlicePlan::ShadowedLight& light)
{
  SetMediumUniforms(program, frame, sweep);
  MatrixUniform::Set(program, "clipFromUnit", frame.Eye.ClipFromUnit);
  SetLight(program, frame.Lights[light.Light], &light, "_0");
}

void SliceShader::SetLayerPointUniforms(
  vtkShaderProgram* program, const SliceFrame& frame, const SlicePlan::ShadowedLight& light)
{
  MatrixUniform::Set(program, "clipFromUnit", frame.Eye.ClipFromUnit);
  std::vector<float> layers;
  std::vector<float> weights;
  for (const SlicePlan::SampleView& sample : light.Samples)
  {
    const glm::mat4 layer(sample.LayerFromUnit);
    layers.insert(layers.end(), glm::value_ptr(layer), glm::value_ptr(layer) + 16);
    weights.push_back(static_cast<float>(sample.Weight));
  }
  const auto count = static_cast<int>(weights.size());
  program->SetUniformMatrix4x4v("layerFromUnit", count, layers.data());
  program->SetUniform1fv("layerWeights", count, weights.data());
}

}
