// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/FlowVolumeRenderer.h"

#include "Common/ArrayCheck.h"
#include "Draw/FlowShader.h"
#include "Draw/FlowTextures.h"
#include "Grid/SmoothVoxels.h"
#include "Loader/OpenGLFunctions.h"
#include "Loader/ScopedState.h"
#include "Paint/PaintTexels.h"

#include "vtkDataArray.h"
#include "vtkFloatTarget.h"
#include "vtkImageQuad.h"
#include "vtkOpaqueProps.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPropSelection.h"
#include "vtkRenderer.h"
#include "vtkSceneDepth.h"
#include "vtkShaderProgram.h"
#include "vtkSoftwareOpenGL.h"
#include "vtkTextureObject.h"
#include "vtkTimerLog.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <glm/gtc/type_ptr.hpp>

namespace interlume
{

struct FlowVolumeRenderer::WindowResources
{
  FlowTextures Textures;
  vtkNew<vtkTextureObject> Image;
  vtkNew<vtkTextureObject> OpaqueDepth;
  vtkNew<vtkTextureObject> NoDepth;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  vtkImageQuad RayQuad;
  vtkImageQuad ShowQuad;
  vtkPropSelection Selection;
};

struct FlowVolumeRenderer::Picture
{
  vtkRenderer* Renderer;
  vtkOpenGLRenderWindow* Window;
  vtkVolume* Volume;
  const Request& Asked;
  vtkImplicitFlowVolumeReport& Report;
  WindowResources& Resources;

  std::array<int, 2> Size{};
  FlowShader::Parts Parts{};
  vtkDataArray* OpacityValues = nullptr;
  vtkDataArray* ShadingValues = nullptr;
  std::array<int, 3> DetailSize{ { 1, 1, 1 } };
  std::array<double, 2> TransferRange{ { 0.0, 1.0 } };
  double SampleDistance = 1.0;
};

namespace
{
FlowTextures::Source MakeTable(const std::vector<float>& values, int components)
{
  FlowTextures::Source source;
  source.Size[0] = static_cast<int>(values.size()) / components;
  source.Components = components;
  source.Values = values.data();
  source.IsSmooth = components == 1;
  return source;
}

// Copies an array as floats; values that are no finite numbers become 0.
std::vector<float> MakeFloats(vtkDataArray* array)
{
  const int components = array->GetNumberOfComponents();
  std::vector<float> values(
    static_cast<std::size_t>(array->GetNumberOfTuples()) * static_cast<std::size_t>(components));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const double value =
      array->GetComponent(static_cast<vtkIdType>(i) / components, static_cast<int>(i) % components);
    values[i] = std::isfinite(value) ? static_cast<float>(value) : 0.0F;
  }
  return values;
}

vtkIdType CountNonFinite(vtkDataArray* array)
{
  vtkIdType count = 0;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    bool isFinite = true;
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      isFinite = isFinite && std::isfinite(array->GetComponent(i, c));
    }
    count += isFinite ? 0 : 1;
  }
  return count;
}

std::array<float, 3> ToFloats(const glm::dvec3& v)
{
  return { { static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z) } };
}

void Set(vtkShaderProgram* program, const char* name, const glm::dvec3& v)
{
  program->SetUniform3f(name, ToFloats(v).data());
}

void Set(vtkShaderProgram* program, const char* name, double x, double y)
{
  const float values[2] = { static_cast<float>(x), static_cast<float>(y) };
  program->SetUniform2f(name, values);
}

void Set(vtkShaderProgram* program, const char* name, const glm::dmat3& m)
{
  float values[9];
  std::copy_n(glm::value_ptr(m), 9, values);
  program->SetUniformMatrix3x3(name, values);
}
}

FlowVolumeRenderer::FlowVolumeRenderer() = default;

FlowVolumeRenderer::~FlowVolumeRenderer() = default;

std::string FlowVolumeRenderer::UpdateGrid(const Request& request)
{
  const std::pair<const void*, vtkMTimeType> stamp(request.Image, request.Image->GetMTime());
  if (this->GridStamp != stamp)
  {
    this->GridError = this->Grid.Build(request.Image);
    this->GridStamp = stamp;
    ++this->GridVersion;
  }
  return this->GridError;
}

std::string FlowVolumeRenderer::FindArrays(Picture& picture)
{
  const vtkImplicitFlowVolumeSettings& settings = picture.Asked.Settings;
  const auto find = [&](const std::string& name, vtkDataArray*& array) -> std::string
  {
    std::string fault = ArrayCheck::FindPointFault(picture.Asked.Image, "input", name, 0);
    array = fault.empty() ? picture.Asked.Image->GetPointData()->GetArray(name.c_str()) : nullptr;
    return fault;
  };
  std::string fault;
  FlowShader::Parts& parts = picture.Parts;
  if (!settings.OpacityArray.empty())
  {
    fault = find(settings.OpacityArray, picture.OpacityValues);
    if (fault.empty() && picture.OpacityValues->GetNumberOfComponents() != 1)
    {
      fault = ArrayCheck::FindPointFault(picture.Asked.Image, picture.OpacityValues, 1);
    }
    parts.HasTransfer = true;
  }
  const bool isShaded = picture.Volume->GetProperty()->GetShade() != 0;
  if (fault.empty() && isShaded && !settings.ShadingArray.empty())
  {
    fault = find(settings.ShadingArray, picture.ShadingValues);
    const int components =
      picture.ShadingValues ? picture.ShadingValues->GetNumberOfComponents() : 1;
    parts.IsShaded = true;
    parts.IsShadedByVectors = components == 3;
    if (components != 1 && components != 3)
    {
      fault = ArrayCheck::Describe(picture.ShadingValues) + " has " +
        ArrayCheck::Count(components, "component") + "; 1 or 3 are needed to shade by";
    }
  }
  if (fault.empty() && settings.DetailTexture)
  {
    int size[3];
    settings.DetailTexture->GetDimensions(size);
    parts.DetailDimensions = size[0] > 1 && size[1] > 1 && size[2] > 1 ? 3 : 2;
  }
  return fault;
}

std::string FlowVolumeRenderer::Update(Picture& picture)
{
  std::string error = this->UpdateGrid(picture.Asked);
  if (error.empty())
  {
    error = this->FindArrays(picture);
  }
  if (error.empty())
  {
    error = this->View.Set(
      picture.Renderer, picture.Asked.Image, picture.Volume->GetMatrix(), picture.Asked.Cuts);
  }
  if (!error.empty())
  {
    return error;
  }
  const vtkImplicitFlowVolumeSettings& settings = picture.Asked.Settings;
  vtkImplicitFlowVolumeReport& report = picture.Report;
  this->Paints.Assign(settings.InflowTextures, this->Grid);
  // llvmpipe ends a shader's loops after 65,535 rounds of all of them.
  const double mostSamples = 60000.0 / (settings.MaximumPaintSamples + 4);
  picture.SampleDistance =
    std::max(settings.SampleDistance > 0.0 ? settings.SampleDistance : 0.5 * this->View.Spacing,
      this->View.Diagonal / mostSamples);
  report.SampleDistance = picture.SampleDistance;
  report.ImageSampleDistance = settings.ImageSampleDistance;
  report.Surfaces = static_cast<int>(this->Grid.Ids.size());
  report.SurfacesWithoutTexture = this->Paints.WithoutTexture;
  report.UniformCells = this->Grid.UniformCells;
  report.SplitCells = this->Grid.SplitCells;
  report.EmptyCells = this->Grid.EmptyCells;
  report.NonFiniteSamples = this->Grid.NonFinite;
  picture.Parts.IsSoftware = vtkSoftwareOpenGL::IsUsed(picture.Window);
  picture.Parts.HasSplitCells = this->Grid.SplitCells > 0;
  if (picture.Parts.IsShaded)
  {
    const glm::dvec3 middle =
      0.5 * glm::dvec3(this->Grid.Size[0] - 1, this->Grid.Size[1] - 1, this->Grid.Size[2] - 1);
    this->Lights.Gather(
      picture.Renderer, glm::dvec3(this->View.WorldFromVoxels * glm::dvec4(middle, 1.0)));
    picture.Parts.Lights = this->Lights.GetNumber();
  }
  return {};
}

std::string FlowVolumeRenderer::KeepGrid(Picture& picture)
{
  vtkImplicitFlowVolumeReport& report = picture.Report;
  const FlowTextures::Stamp stamp(this, this->GridVersion);
  // Software interpolates floats as such; graphics cards round the weights to eight bits.
  const bool isSoftware = picture.Parts.IsSoftware;
  std::vector<float> smooth;
  const auto keep = [&](const char* name, int components, int type,
                      const std::function<const void*()>& getValues, bool isOfCells)
  {
    const std::string wrong = picture.Resources.Textures.Keep(
      picture.Window, name, true, stamp,
      [&]
      {
        FlowTextures::Source source;
        source.Size = this->Grid.Size;
        for (int& length : source.Size)
        {
          length -= isOfCells ? 1 : 0;
        }
        source.Components = components;
        source.Type = type;
        source.Values = getValues();
        source.IsSmooth = isSoftware && type == VTK_FLOAT;
        return source;
      },
      report.GridUploads, report.UploadedBytes);
    return wrong.empty() ? wrong : "the texture of voxels `" + std::string(name) + "` " + wrong;
  };
  const FlowGrid& grid = this->Grid;
  std::string error = keep(
    "cells", 2, VTK_UNSIGNED_SHORT, [&] { return grid.Cells.data(); }, true);
  if (error.empty())
  {
    error = keep(
      "places", isSoftware ? 4 : 2, VTK_FLOAT,
      [&]
      {
        smooth = isSoftware ? SmoothVoxels::Make(grid) : std::vector<float>();
        return isSoftware ? smooth.data() : grid.Places.data();
      },
      false);
  }
  if (error.empty() && picture.Parts.HasSplitCells)
  {
    error = keep(
      "groups", 1, VTK_UNSIGNED_SHORT, [&] { return grid.Groups.data(); }, false);
  }
  const bool needsTimes =
    picture.Asked.Settings.TimeGate != nullptr || picture.Parts.DetailDimensions == 3;
  if (error.empty() && needsTimes)
  {
    error = keep(
      "times", 1, VTK_FLOAT, [&] { return grid.Times.data(); }, false);
  }
  return error;
}

std::string FlowVolumeRenderer::KeepPaints(Picture& picture)
{
  const vtkImplicitFlowVolumeSettings& settings = picture.Asked.Settings;
  vtkImplicitFlowVolumeReport& report = picture.Report;
  FlowTextures& textures = picture.Resources.Textures;
  PaintTexels texels;
  const auto makeImage = [&](bool isRepeated)
  {
    FlowTextures::Source source;
    source.Size = texels.Size;
    source.Components = 4;
    source.Type = VTK_UNSIGNED_SHORT;
    source.Values = texels.Texels.data();
    source.IsSmooth = true;
    source.IsRepeated = isRepeated;
    source.HasLevels = settings.PaintFilter;
    return source;
  };
  std::string error;
  const auto keep =
    [&](const std::string& name, vtkImageData* image, int dimensions, bool isRepeated, int& count)
  {
    // The levels of detail are a part of the texture: with and without are two states of it.
    const FlowTextures::Stamp stamp(image, 2 * image->GetMTime() + (settings.PaintFilter ? 1 : 0));
    return textures.Keep(
      picture.Window, name, dimensions == 3, stamp,
      [&]
      {
        const std::string fault = texels.Build(image, dimensions);
        FlowTextures::Source source = makeImage(isRepeated);
        source.Fault = fault;
        return source;
      },
      count, report.UploadedBytes);
  };
  for (FlowPaints::Paint& paint : this->Paints.Paints)
  {
    int size[3];
    paint.Image->GetDimensions(size);
    error = keep("paint_" + paint.Name, paint.Image, 2, false, report.InflowUploads);
    if (!error.empty())
    {
      return "the inflow texture of id " + paint.Name + " " + error;
    }
    int axis = 0;
    paint.Size = { { 1, 1 } };
    for (const int length : size)
    {
      if (length > 1)
      {
        paint.Size[axis++] = length;
      }
    }
  }
  if (picture.Parts.DetailDimensions > 0)
  {
    settings.DetailTexture->GetDimensions(picture.DetailSize.data());
    error = keep(
      "detail", settings.DetailTexture, picture.Parts.DetailDimensions, true, report.DetailUploads);
    if (!error.empty())
    {
      return "the detail texture " + error;
    }
  }
  if (!this->Paints.IsOne)
  {
    error = textures.Keep(
      picture.Window, "surfaces", false, { &this->Paints, this->Paints.Version },
      [&] { return MakeTable(this->Paints.Surfaces, 4); }, report.InflowUploads,
      report.UploadedBytes);
  }
  return error;
}

std::string FlowVolumeRenderer::KeepArrays(Picture& picture)
{
  const vtkImplicitFlowVolumeSettings& settings = picture.Asked.Settings;
  vtkImplicitFlowVolumeReport& report = picture.Report;
  FlowTextures& textures = picture.Resources.Textures;
  std::vector<float> values;
  const auto keepArray = [&](const char* name, vtkDataArray* array)
  {
    report.NonFiniteSamples += CountNonFinite(array);
    return textures.Keep(
      picture.Window, name, true, { array, array->GetMTime() },
      [&]
      {
        values = MakeFloats(array);
        FlowTextures::Source source;
        source.Size = this->Grid.Size;
        source.Components = array->GetNumberOfComponents();
        source.Values = values.data();
        source.IsSmooth = true;
        return source;
      },
      report.ArrayUploads, report.UploadedBytes);
  };
  std::string error;
  if (picture.OpacityValues)
  {
    error = keepArray("opacityValues", picture.OpacityValues);
    double range[2];
    picture.OpacityValues->GetFiniteRange(range, 0);
    picture.TransferRange = { { range[0], range[1] > range[0] ? range[1] : range[0] + 1.0 } };
    vtkPiecewiseFunction* function = picture.Volume->GetProperty()->GetScalarOpacity(0);
    if (error.empty())
    {
      error = textures.Keep(
        picture.Window, "transfer", false,
        { function, std::max(function->GetMTime(), picture.OpacityValues->GetMTime()) },
        [&]
        {
          values.resize(FlowShader::Columns);
          function->GetTable(
            picture.TransferRange[0], picture.TransferRange[1], FlowShader::Columns, values.data());
          return MakeTable(values, 1);
        },
        report.TransferUploads, report.UploadedBytes);
    }
  }
  if (error.empty() && picture.ShadingValues)
  {
    error = keepArray("shadingValues", picture.ShadingValues);
  }
  if (error.empty() && settings.TimeGate)
  {
    vtkPiecewiseFunction* gate = settings.TimeGate;
    error = textures.Keep(
      picture.Window, "gate", false,
      { gate, 2 * gate->GetMTime() + (settings.TimeGateRepeat ? 1 : 0) },
      [&]
      {
        values.resize(FlowShader::Columns);
        const bool isWhole = settings.TimeGateRepeat;
        const double* range = gate->GetRange();
        gate->GetTable(
          isWhole ? 0.0 : range[0], isWhole ? 1.0 : range[1], FlowShader::Columns, values.data());
        return MakeTable(values, 1);
      },
      report.GateUploads, report.UploadedBytes);
  }
  return error.empty() ? error : "a texture of values or of a function " + error;
}

std::string FlowVolumeRenderer::KeepTextures(Picture& picture)
{
  FlowTextures& textures = picture.Resources.Textures;
  textures.Begin();
  std::string error = this->KeepGrid(picture);
  if (error.empty())
  {
    error = this->KeepPaints(picture);
  }
  if (error.empty())
  {
    error = this->KeepArrays(picture);
  }
  textures.Finish(picture.Window);
  picture.Report.Textures = textures.GetNumber();
  picture.Report.TextureBytes = textures.GetBytes();
  if (!error.empty())
  {
    return error;
  }
  GLint units = 0;
  glGetIntegerv(GL_MAX_TEXTURE_IMAGE_UNITS, &units);
  if (textures.GetNumber() + 1 > units)
  {
    return "the picture needs " + std::to_string(textures.GetNumber() + 1) +
      " textures, and a shader here has at most " + std::to_string(units);
  }
  const vtkIdType most = picture.Asked.Settings.MaximumTextureMemory;
  if (most > 0 && textures.GetBytes() > most)
  {
    return "textures of the picture take " + std::to_string(textures.GetBytes()) +
      " bytes, and MaximumTextureMemory is " + std::to_string(most);
  }
  return {};
}

void FlowVolumeRenderer::SetViewUniforms(const Picture& picture, vtkShaderProgram* program) const
{
  const FlowView& view = this->View;
  Set(program, "rayOrigin", view.Origin);
  Set(program, "rayOriginX", view.OriginX);
  Set(program, "rayOriginY", view.OriginY);
  Set(program, "rayDirection", view.Direction);
  Set(program, "rayDirectionX", view.DirectionX);
  Set(program, "rayDirectionY", view.DirectionY);
  Set(program, "worldFromVoxels", glm::dmat3(view.WorldFromVoxels));
  Set(program, "nearFar", view.NearFar[0], view.NearFar[1]);
  program->SetUniformf("middle", static_cast<float>(view.Middle));
  Set(program, "boxLower", view.BoxLower);
  Set(program, "boxUpper", view.BoxUpper);
  Set(program, "pixelSize", 2.0 / picture.Size[0], 2.0 / picture.Size[1]);
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
  if (view.HasRegions)
  {
    Set(program, "croppingLower", view.CroppingLower);
    Set(program, "croppingUpper", view.CroppingUpper);
    program->SetUniformi("croppingFlags", view.CroppingFlags);
    float values[16];
    std::copy_n(glm::value_ptr(view.VolumeFromVoxels), 16, values);
    program->SetUniformMatrix4x4("volumeFromVoxels", values);
  }
}

void FlowVolumeRenderer::SetUniforms(const Picture& picture, vtkShaderProgram* program) const
{
  const vtkImplicitFlowVolumeSettings& settings = picture.Asked.Settings;
  vtkVolumeProperty* property = picture.Volume->GetProperty();
  this->SetViewUniforms(picture, program);
  const glm::dvec3 size(this->Grid.Size[0], this->Grid.Size[1], this->Grid.Size[2]);
  Set(program, "lastCell", size - 2.0);
  program->SetUniformf("sampleDistance", static_cast<float>(picture.SampleDistance));
  program->SetUniformf(
    "unitDistance", static_cast<float>(property->GetScalarOpacityUnitDistance(0)));
  const double alpha = settings.DefaultColor[3];
  const float color[4] = { static_cast<float>(settings.DefaultColor[0] * alpha),
    static_cast<float>(settings.DefaultColor[1] * alpha),
    static_cast<float>(settings.DefaultColor[2] * alpha), static_cast<float>(alpha) };
  program->SetUniform4f("defaultColor", color);
  std::array<double, 2> largest{ { 1.0, 1.0 } };
  for (const FlowPaints::Paint& paint : this->Paints.Paints)
  {
    Set(program, ("paintSize_" + paint.Name).c_str(), paint.Size[0], paint.Size[1]);
    for (int i = 0; i < 2; ++i)
    {
      largest[i] = std::max(largest[i], static_cast<double>(paint.Size[i]));
    }
  }
  if (picture.Parts.DetailDimensions > 0)
  {
    const glm::dvec3 detail(picture.DetailSize[0], picture.DetailSize[1], picture.DetailSize[2]);
    Set(program, "detailScale", glm::make_vec3(settings.DetailScale));
    Set(program, "detailSize", detail);
    for (int i = 0; i < 2; ++i)
    {
      largest[i] = std::max(largest[i], detail[i] * std::abs(settings.DetailScale[i]));
    }
  }
  Set(program, "paintSize", largest[0], largest[1]);
  program->SetUniformi("largestPieces", settings.MaximumPaintSamples);
  program->SetUniformf("timePeriod", static_cast<float>(settings.TimePeriod));
  // A gate that repeats is the same for all phases that differ by whole periods.
  const bool isWhole = settings.TimeGateRepeat && picture.Parts.DetailDimensions != 3;
  const double phase = settings.TimePhase - (isWhole ? std::floor(settings.TimePhase) : 0.0);
  program->SetUniformf("timePhase", static_cast<float>(phase));
  if (settings.TimeGate)
  {
    const double* range = settings.TimeGate->GetRange();
    Set(program, "gateRange", range[0], std::max(range[1] - range[0], 1e-30));
  }
  Set(program, "transferRange", picture.TransferRange[0],
    1.0 / (picture.TransferRange[1] - picture.TransferRange[0]));
  Set(program, "voxels", size);
  if (picture.Parts.IsShaded)
  {
    Set(program, "shadingVoxels", size);
    Set(program, "material",
      { property->GetAmbient(), property->GetDiffuse(), property->GetSpecular() });
    program->SetUniformf("power", static_cast<float>(property->GetSpecularPower()));
    const glm::dmat3 axes(this->View.WorldFromVoxels);
    Set(program, "worldOrigin", -(axes * (0.5 * (size - 1.0))));
    const glm::dmat3 fromVolume = axes * glm::inverse(glm::dmat3(this->View.VolumeFromVoxels));
    Set(program, "worldFromVolume", fromVolume);
    this->Lights.SetUniforms(program);
  }
}

std::string FlowVolumeRenderer::Draw(Picture& picture)
{
  WindowResources& resources = picture.Resources;
  vtkOpenGLRenderWindow* window = picture.Window;
  vtkTextureObject* depth = resources.OpaqueDepth;
  if (vtkOpaqueProps::MayOcclude(picture.Renderer, picture.Volume))
  {
    depth->SetContext(window);
    picture.Parts.HasOpaqueDepth = vtkSceneDepth::CopyTo(picture.Renderer, depth);
  }
  else
  {
    depth->ReleaseGraphicsResources(window);
  }
  const FlowShader shader(picture.Asked.Settings, picture.Parts, this->Paints, this->View);
  picture.Report.Features = shader.GetNames();
  picture.Report.ImageBufferBytes =
    vtkFloatTarget::Allocate(window, resources.Image, picture.Size[0], picture.Size[1], 4, true);
  if (picture.Report.ImageBufferBytes == 0)
  {
    return "the graphics card has no memory for a picture of floats";
  }
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  {
    const ScopedState scoped(state);
    state->vtkglDisable(GL_CULL_FACE);
    state->vtkglDisable(GL_SCISSOR_TEST);
    resources.Framebuffer->SetContext(window);
    resources.Framebuffer->Bind();
    resources.Framebuffer->AddColorAttachment(0, resources.Image);
    resources.Framebuffer->ActivateDrawBuffer(0);
    state->vtkglViewport(0, 0, picture.Size[0], picture.Size[1]);
    state->vtkglClearColor(0.0F, 0.0F, 0.0F, 0.0F);
    state->vtkglClear(GL_COLOR_BUFFER_BIT);
    vtkTextureObject* bound = depth;
    if (!picture.Parts.HasOpaqueDepth)
    {
      // The quad binds a texture; this one is not in the shader.
      vtkFloatTarget::Allocate(window, resources.NoDepth, 1, 1, 1, false);
      bound = resources.NoDepth;
    }
    resources.RayQuad.DrawWith(window, bound, shader.GetSource(),
      [&](vtkShaderProgram* program)
      {
        resources.Textures.Activate(program);
        this->SetUniforms(picture, program);
      });
    resources.Textures.Deactivate();
  }
  state->PopFramebufferBindings();
  picture.Report.Passes = 1;
  if (picture.Renderer->GetSelector())
  {
    resources.Selection.Show(picture.Renderer->GetSelector(), window, resources.Image);
  }
  else
  {
    resources.ShowQuad.Draw(window, resources.Image);
  }
  return {};
}

std::string FlowVolumeRenderer::Render(vtkRenderer* renderer, vtkVolume* volume,
  const Request& request, vtkImplicitFlowVolumeReport& report)
{
  const double start = vtkTimerLog::GetUniversalTime();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window)
  {
    return "the render window is not an OpenGL one";
  }
  window->MakeCurrent();
  if (!HasOpenGL32())
  {
    return "OpenGL is older than 3.2";
  }
  std::unique_ptr<WindowResources>& resources = this->Windows[window];
  if (!resources)
  {
    resources = std::make_unique<WindowResources>();
  }
  Picture picture{ renderer, window, volume, request, report, *resources };
  int size[2];
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  for (int i = 0; i < 2; ++i)
  {
    picture.Size[i] =
      std::max(static_cast<int>(std::lround(size[i] / request.Settings.ImageSampleDistance)), 1);
  }
  std::string error = this->Update(picture);
  if (error.empty())
  {
    error = this->KeepTextures(picture);
  }
  if (error.empty() && !this->Grid.Ids.empty())
  {
    error = this->Draw(picture);
  }
  report.Seconds = vtkTimerLog::GetUniversalTime() - start;
  return error;
}

void FlowVolumeRenderer::ReleaseGraphicsResources(vtkWindow* window)
{
  for (auto& [owner, resources] : this->Windows)
  {
    if (!window || owner == window)
    {
      resources->Textures.ReleaseGraphicsResources(owner);
      for (vtkTextureObject* texture :
        { resources->Image.Get(), resources->OpaqueDepth.Get(), resources->NoDepth.Get() })
      {
        texture->ReleaseGraphicsResources(owner);
      }
      resources->Framebuffer->ReleaseGraphicsResources(owner);
      resources->RayQuad.ReleaseGraphicsResources(owner);
      resources->ShowQuad.ReleaseGraphicsResources(owner);
      resources->Selection.ReleaseGraphicsResources(owner);
    }
  }
  if (window)
  {
    this->Windows.erase(window);
  }
  else
  {
    this->Windows.clear();
  }
}

}
