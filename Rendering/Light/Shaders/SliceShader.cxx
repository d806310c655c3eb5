// SPDX-License-Identifier: BSD-3-Clause
#include "Shaders/SliceShader.h"

#include "ShadowMaps/SceneOccluders.h"
#include "Common/Vectors.h"
#include "Receivers/SliceScene.h"
#include "Shaders/SliceFeatures.h"
#include "Space/ShaderUniforms.h"
#include "Space/UnitVector.h"
#include "Translucent/TranslucentShadowMaps.h"

#include "vtkProjectiveLight.h"
#include "vtkSliceMedium.h"

#include <algorithm>
#include <array>

namespace interlume
{

namespace
{
// Optical depth above which a slab counts as thick. Thinner slabs show no steps.
constexpr double ThickDepth = 0.15;

// Maximum fraction of occupied samples at which software OpenGL draws empty fragments first. At
// higher fractions, this saves no time.
constexpr double MaximumOccupancyForEmptyPart = 0.5;

using Sweep = SlicePlan::Sweep;
using ShadowedLight = SlicePlan::ShadowedLight;

void AddMedium(const VolumeRenderState& frame, SliceFeatures& features)
{
  const MaterialTable& material = frame.Material;
  features.AddValue("COLUMNS", MaterialTable::Columns);
  features.AddValue("ROWS", material.Rows);
  features.AddValue("OPACITY_OF",
    material.Kind == MaterialTable::INDEPENDENT       ? "r"
      : material.Kind == MaterialTable::COLOR_OPACITY ? "g"
                                                      : "a");
  if (frame.Number > 0)
  {
    features.AddValue("VOLUME_NUMBER", frame.Number);
  }
  features.Add("CUSTOM_MEDIUM", frame.Medium != nullptr);
  features.Add("MASK", !frame.Samples.Mask.empty());
  features.Add("DIFFERENCES", frame.HasDifferences);
  features.Add("GRADIENT_OPACITY", !material.GradientOpacity.empty());
  features.Add("BENDS", !material.Bends.empty());
  if (material.HasEdges())
  {
    features.Add("EDGES");
    features.AddValue("EDGE_POSITIONS", TransferColumns::EdgePositions);
  }
  features.Add("CROPPING", frame.Region.Regions.HasGaps());
  if (!frame.Region.ClippingPlanes.empty())
  {
    features.AddValue("CLIPPING_PLANES", static_cast<int>(frame.Region.ClippingPlanes.size()));
  }
}

// Returns the source of the custom medium, or an empty string.
std::string GetMedium(const VolumeRenderState& frame)
{
  return frame.Medium ? frame.Medium->GetSource() : std::string();
}

// Returns true if any volume of the image colors the light that it transmits.
bool HasTransmission(const VolumeRenderState& frame)
{
  return frame.Image->GetLightChannels() > 1 && frame.Image->HasShadows();
}

// Returns true if extinction is integrated between two samples of a slab instead of sampled at the
// center of the slab.
bool HasSpans(const VolumeRenderState& frame, bool isThick)
{
  return !isThick && frame.Image->HasShadows() &&
    SliceShader::GetRampExtinction(frame) * frame.Image->Plan.Sweeps[0].Spacing >
    SlicePlan::DenseDepth;
}

void AddTransmission(const VolumeRenderState& frame, SliceFeatures& features)
{
  features.Add("TRANSMISSION", HasTransmission(frame));
  features.Add("GRAY", HasTransmission(frame) && frame.Material.Transmission.empty());
}

const ShadowedLight* FindShadow(const Sweep& sweep, int light)
{
  const auto found = std::find_if(sweep.Lights.begin(), sweep.Lights.end(),
    [light](const ShadowedLight& shadowed) { return shadowed.Light == light; });
  return found == sweep.Lights.end() ? nullptr : &*found;
}

void AddLight(const LightSource& light, const ShadowedLight* shadow, const std::string& suffix,
  SliceFeatures& features)
{
  features.Add("POSITIONAL" + suffix, light.IsPositional);
  features.Add("CONE" + suffix, light.ConeCosine > -1.0);
  features.Add("SCREEN" + suffix, light.Projective != nullptr);
  features.Add("IMAGE" + suffix, light.Projective && light.Projective->GetImage());
  features.Add("SHADOW" + suffix, shadow != nullptr);
  features.Add("WIDE" + suffix, shadow && shadow->IsWide);
}

// Returns true if surfaces of the scene cast shadows in the volume.
bool HasOccluders(const VolumeRenderState& frame)
{
  return frame.Image->Scene && frame.Image->HasShadows() &&
    frame.Image->Scene->Occluders->HasViews();
}

// Returns true if translucent surfaces of the scene cast shadows in the volume.
bool HasTranslucentShadows(const VolumeRenderState& frame)
{
  return frame.Image->Scene && frame.Image->HasShadows() && frame.Image->Scene->TranslucentMaps &&
    frame.Image->Scene->TranslucentMaps->GetLayers() > 0;
}

// Adds the features for scattered light.
void AddScattering(const SliceScattering& scattering, SliceFeatures& features)
{
  if (!scattering.IsOn())
  {
    return;
  }
  features.Add("SCATTER");
  features.Add("SCATTER_BRIGHTNESS", scattering.Brightness != 1.0);
  features.Add(
    "PHASE_ANISOTROPY", scattering.Kind == vtkShadowedSliceSettings::HENYEY_GREENSTEIN_PHASE);
  if (scattering.Kind == vtkShadowedSliceSettings::TABLE_PHASE)
  {
    features.Add("PHASE_TABLE");
    features.AddValue("PHASE_COLUMNS", SliceScattering::PhaseColumns);
  }
  if (scattering.HasMaps())
  {
    features.AddValue("FIELD_MAPS", scattering.GetNumberOfMaps());
  }
}

// Returns the index of a light's map of forward-scattered light, or 0. Of the samples of an area
// light, only the first has a map.
int GetForwardMap(const VolumeRenderState& frame, int light)
{
  const auto isSame = [&](const LightSource& other)
  { return other.Light == frame.Image->Lights[light].Light; };
  const auto first = std::find_if(frame.Image->Lights.begin(), frame.Image->Lights.end(), isSame);
  return std::distance(frame.Image->Lights.begin(), first) == light
    ? frame.Scattering.GetForwardMap(frame.Image->Lights[light].Light)
    : 0;
}

// Adds the macros of a light. \a light is its index in the image, \a number its index in the
// shader. Returns a GLSL call that evaluates the shadows of translucent surfaces, or an empty
// string.
std::string AddLightOfImage(const VolumeRenderState& frame, std::size_t sweep, int light,
  std::size_t number, SliceFeatures& features)
{
  const ImageState& image = *frame.Image;
  const LightSource& source = image.Lights[light];
  const std::string suffix = "_" + std::to_string(number);
  AddLight(source, FindShadow(image.Plan.Sweeps[sweep], light), suffix, features);
  const std::string fraction = HasOccluders(frame)
    ? image.Scene->Occluders->GetLightFraction(source.Light, "sampleAt", "vec4(0.0)")
    : std::string();
  if (!fraction.empty())
  {
    features.Add("OCCLUDERS" + suffix);
    features.AddValue("OCCLUDER_FRACTION" + suffix, fraction);
  }
  const int map = GetForwardMap(frame, light);
  if (map > 0)
  {
    features.AddValue("FORWARD_MAP" + suffix, map);
  }
  return HasTranslucentShadows(frame)
    ? image.Scene->TranslucentMaps->GetLightFraction(source.Light, "sampleAt", "vec4(0.0)")
    : std::string();
}

// For each row of the transfer function table, maps a texel to a column: (texel - Origin) * Scale.
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

Columns GetColorColumns(const VolumeRenderState& frame)
{
  const VolumeSamples& samples = frame.Samples;
  Columns columns;
  if (frame.Material.Kind == MaterialTable::RGB_OPACITY)
  {
    // Byte texels are already normalized colors. Other texels are mapped to their values.
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

void SetMediumUniforms(
  vtkShaderProgram* program, const VolumeRenderState& frame, const Sweep& sweep)
{
  const ShaderUniforms uniforms(program);
  const UnitSpace& space = frame.Space;
  const std::array<std::array<double, 2>, 3>& box = frame.Region.Box;
  uniforms.Set("textureFromUnit", space.TextureFromUnit);
  uniforms.Set("worldLength", space.Radius);
  uniforms.Set("boxLower", glm::dvec3(box[0][0], box[1][0], box[2][0]));
  uniforms.Set("boxUpper", glm::dvec3(box[0][1], box[1][1], box[2][1]));
  uniforms.Set("sliceNormal", sweep.Normal);
  uniforms.Set("sliceSpacing", sweep.Spacing);
  uniforms.Set("voxel", 1.0 / glm::dvec3(space.Size[0], space.Size[1], space.Size[2]));

  const MaterialTable& material = frame.Material;
  Columns columns;
  std::array<double, 4> gradientScale{};
  std::array<double, 4> distances{ { 1.0, 1.0, 1.0, 1.0 } };
  for (int row = 0; row < material.Rows; ++row)
  {
    const int component = material.GetOpacityComponent(row);
    columns.Set(frame.Samples, component, material.OpacityRange[row]);
    gradientScale[row] =
      frame.Samples.Scale[component] * (MaterialTable::Columns - 1) / material.GradientRange[row];
    distances[row] = frame.UnitDistances[row] / space.Radius;
  }
  uniforms.Set("columnScale", columns.Scale);
  uniforms.Set("columnOrigin", columns.Origin);
  const Columns colors = GetColorColumns(frame);
  uniforms.Set("colorColumnScale", colors.Scale);
  uniforms.Set("colorColumnOrigin", colors.Origin);
  uniforms.Set("gradientSteps", 0.5 * frame.GradientSteps);
  uniforms.Set("gradientColumnScale", gradientScale);
  uniforms.Set("unitDistances", distances);
  std::vector<glm::vec4> planes;
  for (const std::array<double, 4>& plane : frame.Region.ClippingPlanes)
  {
    planes.emplace_back(glm::make_vec4(plane.data()));
  }
  uniforms.Set("clippingPlanes", planes);
  if (frame.Region.Regions.HasGaps())
  {
    frame.Region.Regions.SetUniforms(program);
  }
}

void SetScattering(vtkShaderProgram* program, const SliceScattering& scattering)
{
  const ShaderUniforms uniforms(program);
  const double g = scattering.Anisotropy;
  uniforms.Set("brightness", scattering.Brightness);
  uniforms.Set("phase", glm::dvec3(1.0 - g * g, (1.0 - g) * (1.0 - g), g));
  uniforms.Set("nodeFromUnit", scattering.NodeFromUnit);
  uniforms.Set("fieldNodes", glm::dvec3(scattering.Nodes));
  uniforms.Set("meanCosine", scattering.MeanCosine);
}

void SetLight(vtkShaderProgram* program, const LightSource& light, const ShadowedLight* shadow,
  const std::string& number)
{
  const ShaderUniforms uniforms(program, number);
  uniforms.Set("diffuse", light.Diffuse);
  uniforms.Set("specular", light.Specular);
  uniforms.Set("position", light.Position);
  uniforms.Set("attenuation", light.Attenuation);
  uniforms.Set("direction", light.Direction);
  uniforms.Set("cone", glm::dvec2(light.ConeCosine, light.Exponent));
  if (light.Projective)
  {
    uniforms.Set("screenFromUnit", light.ScreenFromUnit);
    uniforms.Set("edgeWidth", light.Projective->GetEdgeWidth());
    uniforms.Set("screenOpacity", light.Projective->GetScreenOpacity());
  }
  if (shadow)
  {
    uniforms.Set("strength", light.ShadowStrength);
    uniforms.Set("frame", shadow->Frame);
    uniforms.Set("bufferFromUnit", shadow->BufferFromUnit);
    uniforms.Set("voxelLength", shadow->VoxelLength);
  }
}
}

std::vector<int> SliceShader::GetSweepLights(const VolumeRenderState& frame, std::size_t sweep)
{
  std::vector<int> lights;
  if (!frame.IsLit())
  {
    return lights;
  }
  for (const ShadowedLight& light : frame.Image->Plan.Sweeps[sweep].Lights)
  {
    lights.push_back(light.Light);
  }
  for (std::size_t i = 0; frame.Image->Plan.IsInFirstImage(sweep) && i < frame.Image->Lights.size();
       ++i)
  {
    if (!(frame.Image->Lights[i].ShadowStrength > 0.0))
    {
      lights.push_back(static_cast<int>(i));
    }
  }
  return lights;
}

double SliceShader::GetLargestExtinction(const VolumeRenderState& frame)
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

double SliceShader::GetRampExtinction(const VolumeRenderState& frame)
{
  const bool isRamp = !frame.Medium && frame.Material.GradientOpacity.empty();
  return isRamp ? GetLargestExtinction(frame) : 0.0;
}

bool SliceShader::HasThickPart(const VolumeRenderState& frame, std::size_t sweep)
{
  const SlicePlan::Sweep& planned = frame.Image->Plan.Sweeps[sweep];
  // Opacity functions with ramps are excluded: a steep ramp acts as a jump in only some slabs,
  // which causes stripes.
  return frame.Material.HasSharpOpacity() &&
    GetLargestExtinction(frame) * planned.Spacing > ThickDepth &&
    std::any_of(planned.Lights.begin(), planned.Lights.end(),
      [](const ShadowedLight& light) { return !light.IsWide; });
}

bool SliceShader::HasEmptyPart(const VolumeRenderState& frame, std::size_t sweep)
{
  return frame.IsSoftware && frame.IsLit() && !frame.Medium &&
    frame.OccupiedFraction < MaximumOccupancyForEmptyPart && !HasThickPart(frame, sweep);
}

bool SliceShader::HasThinPart(const VolumeRenderState& frame, std::size_t sweep)
{
  return !HasThickPart(frame, sweep) ||
    frame.Material.GetSmallestExtinction() * frame.Image->Plan.Sweeps[sweep].Spacing *
      frame.Space.Radius <=
    ThickDepth;
}

std::string SliceShader::GetImageShaderSource(
  const VolumeRenderState& frame, std::size_t sweep, bool isOccluded, Parts part)
{
  const ImageState& image = *frame.Image;
  SliceFeatures features(SliceFeatures::IMAGE);
  SliceFeatures::Sources sources;
  sources.Medium = GetMedium(frame);
  AddMedium(frame, features);
  features.Add("THIN", part == THIN);
  features.Add("EMPTY", part == EMPTY);
  features.Add("THICK", part == THICK);
  if (part != ALL)
  {
    features.AddValue("MINIMUM_DEPTH", std::to_string(ThickDepth));
  }
  const bool hasSpans = part != THICK && HasSpans(frame, HasThickPart(frame, sweep));
  features.Add("SUMS", part == THICK || hasSpans);
  features.Add("SPANS", hasSpans);
  features.Add("NEAREST_LOOKUP", !image.IsSmoothLookup);
  features.Add("PERSPECTIVE", !image.Camera.IsParallel);
  features.Add("NEAR_PLANE", image.NearPlane.IsCutting);
  features.Add("FAR_PLANE", image.FarPlane.IsCutting);
  features.Add("OPAQUE", isOccluded);
  features.Add("FRONT", image.Scene && image.Scene->FrontDepth);
  features.Add("RGB", frame.Material.Kind == MaterialTable::RGB_OPACITY);
  if (part == EMPTY)
  {
    return features.MakeSource(sources);
  }
  features.Add("LIT", frame.IsLit());
  features.Add("BACK_TO_FRONT", !image.Plan.Sweeps[sweep].IsFrontToBack);
  features.Add("SHADE", frame.IsShaded);
  features.Add("TWO_SIDED", frame.IsShaded && frame.TwoSidedLighting);
  AddScattering(frame.Scattering, features);
  AddTransmission(frame, features);
  if (HasOccluders(frame))
  {
    features.Add("OCCLUDER_GATHER");
    features.AddOther(image.Scene->Occluders->GetFeatures());
    sources.Surfaces = image.Scene->Occluders->GetSource();
  }
  sources.Surfaces +=
    HasTranslucentShadows(frame) ? image.Scene->TranslucentMaps->GetSource(false) : std::string();
  for (int light : GetSweepLights(frame, sweep))
  {
    sources.Lights.push_back(AddLightOfImage(frame, sweep, light, sources.Lights.size(), features));
  }
  sources.HasFluence = frame.Scattering.HasFluence && image.Plan.IsInFirstImage(sweep);
  return features.MakeSource(sources);
}

std::string SliceShader::GetLightBufferShaderSource(
  const VolumeRenderState& frame, const SlicePlan::ShadowedLight& light, bool isThick)
{
  SliceFeatures features(SliceFeatures::LIGHT);
  SliceFeatures::Sources sources;
  sources.Medium = GetMedium(frame);
  sources.HasBatches = light.SoftMethod == SlicePlan::LAYERS;
  AddMedium(frame, features);
  AddTransmission(frame, features);
  const bool hasSpans = !light.IsWide && HasSpans(frame, isThick);
  features.Add("WIDE", light.IsWide);
  features.Add("SUMS", hasSpans);
  features.Add("SPANS", hasSpans);
  features.Add("POSITIONAL", frame.Image->Lights[light.Light].IsPositional);
  features.AddValue("LIGHT_NUMBER", light.Light);
  return features.MakeSource(sources);
}

std::string SliceShader::GetReceiverShaderSource(
  const VolumeRenderState& frame, const SlicePlan::ShadowedLight& light)
{
  SliceFeatures features(SliceFeatures::RECEIVER);
  SliceFeatures::Sources sources;
  sources.Medium = GetMedium(frame);
  sources.Lights.resize(1);
  AddMedium(frame, features);
  AddTransmission(frame, features);
  features.Add("NEAREST_LOOKUP", !frame.Image->IsSmoothLookup);
  AddLight(frame.Image->Lights[light.Light], &light, "_0", features);
  features.AddValue("LIGHT_NUMBER", light.Light);
  // All volumes share the light buffer, so only the first volume's program multiplies by it.
  features.Add("WITHIN", frame.Number > 0);
  return features.MakeSource(sources);
}

std::string SliceShader::GetNames(const VolumeRenderState& frame, bool isOccluded)
{
  const MaterialTable& material = frame.Material;
  std::string names = material.Kind == MaterialTable::RGB_OPACITY ? "rgb-opacity"
    : material.Kind == MaterialTable::COLOR_OPACITY               ? "color-opacity"
                                                                  : "scalar";
  names += material.Rows > 1 ? "-" + std::to_string(material.Rows) : std::string();
  const auto add = [&names](bool has, const char* name)
  { names += has ? std::string(" ") + name : std::string(); };
  add(frame.Image->Camera.IsParallel, "parallel");
  add(!frame.Image->Camera.IsParallel, "perspective");
  add(frame.Medium != nullptr, "matter");
  add(!frame.Samples.Mask.empty(), "mask");
  add(!material.GradientOpacity.empty(), "gradient-opacity");
  add(frame.Region.Regions.HasGaps(), "cropping");
  add(!frame.Region.ClippingPlanes.empty(), "clipping-planes");
  add(frame.Image->NearPlane.IsCutting, "near-plane");
  add(frame.Image->FarPlane.IsCutting, "far-plane");
  add(isOccluded, "opaque");
  add(frame.IsShaded, "shade");
  add(frame.IsShaded && frame.TwoSidedLighting, "two-sided");
  add(frame.Image->HasShadows(), "shadow");
  add(HasEmptyPart(frame, 0), "empty-first");
  const SliceScattering& scattering = frame.Scattering;
  add(scattering.IsOn(), "scattering");
  add(scattering.IsOn() && scattering.Kind == vtkShadowedSliceSettings::HENYEY_GREENSTEIN_PHASE,
    "anisotropy");
  add(scattering.IsOn() && scattering.Kind == vtkShadowedSliceSettings::TABLE_PHASE, "phase-table");
  add(scattering.HasMaps(), "scattering-field");
  add(HasTransmission(frame), "transmission");
  add(HasOccluders(frame), "casters");
  add(HasTranslucentShadows(frame), "panes");
  const auto hasShadow = [&frame](auto&& test)
  {
    return std::any_of(frame.Image->Plan.Sweeps.begin(), frame.Image->Plan.Sweeps.end(),
      [&test](const Sweep& sweep)
      { return std::any_of(sweep.Lights.begin(), sweep.Lights.end(), test); });
  };
  add(hasShadow([](const ShadowedLight& light) { return light.IsWide; }), "shadow-wide");
  add(hasShadow([](const ShadowedLight& light) { return light.SoftMethod != SlicePlan::HARD; }),
    "shadow-soft");
  const auto has = [&frame](auto&& test)
  {
    return frame.IsLit() &&
      std::any_of(frame.Image->Lights.begin(), frame.Image->Lights.end(), test);
  };
  add(has([](const LightSource& light) { return light.IsPositional; }), "positional");
  add(has([](const LightSource& light) { return light.ConeCosine > -1.0; }), "cone");
  add(has([](const LightSource& light) { return light.Projective != nullptr; }), "screen");
  return names;
}

void SliceShader::SetImageUniforms(
  vtkShaderProgram* program, const VolumeRenderState& frame, std::size_t sweep)
{
  const ImageState& image = *frame.Image;
  SetMediumUniforms(program, frame, image.Plan.Sweeps[sweep]);
  const ShaderUniforms uniforms(program);
  uniforms.Set("clipFromUnit", image.Camera.ClipFromUnit);
  uniforms.Set("eyeDirection", image.Camera.Direction);
  uniforms.Set("eyePosition", image.Camera.Position);
  uniforms.Set("nearPlane", image.NearPlane.Plane);
  uniforms.Set("farPlane", image.FarPlane.Plane);
  uniforms.Set("imageSize", glm::dvec2(image.Size[0], image.Size[1]));
  uniforms.Set("unitFromClip", glm::inverse(image.Camera.ClipFromUnit));
  if (!frame.IsLit())
  {
    return;
  }
  if (HasOccluders(frame))
  {
    image.Scene->Occluders->SetUniforms(program, frame.Space.GetWorldFromUnit());
  }
  if (HasTranslucentShadows(frame))
  {
    image.Scene->TranslucentMaps->SetUniforms(program, frame.Space.GetWorldFromUnit());
  }
  int number = 0;
  for (int light : GetSweepLights(frame, sweep))
  {
    SetLight(program, image.Lights[light], FindShadow(image.Plan.Sweeps[sweep], light),
      "_" + std::to_string(number++));
  }
  if (frame.Scattering.IsOn())
  {
    SetScattering(program, frame.Scattering);
  }
  const MaterialTable& material = frame.Material;
  std::vector<glm::vec4> materials;
  std::array<double, 4> surfaceColumns{};
  for (int row = 0; row < material.Rows; ++row)
  {
    materials.push_back(glm::make_vec4(frame.Materials[row].data()));
    const std::array<double, 2>& scalars = material.ScalarRange[row];
    const std::array<double, 2>& range = material.OpacityRange[row];
    // Changes below a millionth of the range are rounding errors.
    surfaceColumns[row] = (MaterialTable::Columns - 1) *
      std::max(frame.SurfaceGradient * ((scalars[1] - scalars[0]) / (range[1] - range[0])), 1e-6);
  }
  uniforms.Set("materials", materials);
  uniforms.Set("surfaceColumns", surfaceColumns);
  uniforms.Set("ambient", image.Plan.IsInFirstImage(sweep) ? image.Ambient : glm::dvec3(0.0));
}

glm::dmat4 SliceShader::GetBufferMatrix(const SlicePlan::ShadowedLight& light)
{
  const double rows[16] = { 2.0, 0.0, 0.0, -1.0, 0.0, 2.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 1.0 };
  return light.IsWide ? UnitVector::FromRows(rows) : light.BufferFromUnit;
}

void SliceShader::SetLightUniforms(vtkShaderProgram* program, const VolumeRenderState& frame,
  const SlicePlan::Sweep& sweep, const SlicePlan::ShadowedLight& light)
{
  SetMediumUniforms(program, frame, sweep);
  const ShaderUniforms uniforms(program);
  uniforms.Set("clipFromUnit", GetBufferMatrix(light));
  uniforms.Set("frame", light.Frame);
  const LightSource& source = frame.Image->Lights[light.Light];
  uniforms.Set("position", source.Position);
  uniforms.Set("direction", source.Direction);
}

void SliceShader::SetReceiverUniforms(vtkShaderProgram* program, const VolumeRenderState& frame,
  const SlicePlan::Sweep& sweep, const SlicePlan::ShadowedLight& light)
{
  SetMediumUniforms(program, frame, sweep);
  ShaderUniforms(program).Set("clipFromUnit", frame.Image->Camera.ClipFromUnit);
  SetLight(program, frame.Image->Lights[light.Light], &light, "_0");
}

void SliceShader::SetLayerPointUniforms(
  vtkShaderProgram* program, const VolumeRenderState& frame, const SlicePlan::ShadowedLight& light)
{
  const ShaderUniforms uniforms(program);
  uniforms.Set("clipFromUnit", frame.Image->Camera.ClipFromUnit);
  std::vector<glm::mat4> layers;
  std::vector<float> weights;
  for (const SlicePlan::SampleView& sample : light.Samples)
  {
    layers.emplace_back(sample.LayerFromUnit);
    weights.push_back(static_cast<float>(sample.Weight));
  }
  uniforms.Set("layerFromUnit", layers);
  uniforms.Set("layerWeights", weights);
}

}
