// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/FlowSources.h"

#include "Draw/FlowPicture.h"
#include "Draw/FlowTextures.h"
#include "Grid/SmoothVoxels.h"
#include "Loader/OpenGLFunctions.h"
#include "Paint/PaintTexels.h"

#include "vtkDataArray.h"
#include "vtkImplicitFlowVolumeReport.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace interlume
{

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
}

FlowSources::FlowSources(FlowScene& scene, FlowTextures& textures)
  : Scene(scene)
  , Textures(textures)
{
}

std::string FlowSources::KeepGrid(FlowPicture& picture)
{
  vtkImplicitFlowVolumeReport& report = picture.Report;
  const FlowTextures::Stamp stamp{ &this->Scene, this->Scene.GridVersion, {} };
  // Software interpolates floats as such; graphics cards round the weights to eight bits.
  const bool isSoftware = picture.Parts.IsSoftware;
  std::vector<float> smooth;
  const auto keep = [&](const char* name, int components, int type,
                      const std::function<const void*()>& getValues, bool isOfCells)
  {
    const std::string wrong = this->Textures.Keep(
      picture.Window, name, true, stamp,
      [&]
      {
        FlowTextures::Source source;
        source.Size = this->Scene.Grid.Size;
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
  const FlowGrid& grid = this->Scene.Grid;
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

std::string FlowSources::KeepPaints(FlowPicture& picture)
{
  const vtkImplicitFlowVolumeSettings& settings = picture.Asked.Settings;
  vtkImplicitFlowVolumeReport& report = picture.Report;
  FlowTextures& textures = this->Textures;
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
    const FlowTextures::Stamp stamp{ image, 2 * image->GetMTime() + (settings.PaintFilter ? 1 : 0),
      {} };
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
  for (FlowPaints::Paint& paint : this->Scene.Paints.Paints)
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
  if (!this->Scene.Paints.IsOne)
  {
    error = textures.Keep(
      picture.Window, "surfaces", false, { &this->Scene.Paints, this->Scene.Paints.Version, {} },
      [&] { return MakeTable(this->Scene.Paints.Surfaces, 4); }, report.InflowUploads,
      report.UploadedBytes);
  }
  return error;
}

std::string FlowSources::KeepArrays(FlowPicture& picture)
{
  const vtkImplicitFlowVolumeSettings& settings = picture.Asked.Settings;
  vtkImplicitFlowVolumeReport& report = picture.Report;
  FlowTextures& textures = this->Textures;
  std::vector<float> values;
  const auto keepArray = [&](const char* name, vtkDataArray* array)
  {
    report.NonFiniteSamples += CountNonFinite(array);
    const std::array<int, 3>& size = this->Scene.Grid.Size;
    return textures.Keep(
      picture.Window, name, true,
      { array, array->GetMTime(), { { double(size[0]), double(size[1]), double(size[2]) } } },
      [&]
      {
        values = MakeFloats(array);
        FlowTextures::Source source;
        source.Size = size;
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
        { function, function->GetMTime(),
          { { picture.TransferRange[0], picture.TransferRange[1], 0.0 } } },
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
      { gate, 2 * gate->GetMTime() + (settings.TimeGateRepeat ? 1 : 0), {} },
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

std::string FlowSources::Keep(FlowPicture& picture)
{
  FlowTextures& textures = this->Textures;
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

}
