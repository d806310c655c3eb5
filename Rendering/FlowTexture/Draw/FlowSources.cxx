// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/FlowSources.h"

#include "Draw/FlowPicture.h"
#include "Draw/FlowTextures.h"
#include "Grid/SmoothVoxels.h"
#include "Loader/OpenGLFunctions.h"
#include "Paint/PaintTexels.h"

#include "vtkDataArray.h"
#include "vtkImplicitFlowVolumeMapper.h"
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

void KeepGrid(FlowPicture& picture, const FlowScene& scene, FlowTextures& textures)
{
  const FlowGrid& grid = scene.Grid;
  // Software interpolates floats as such; graphics cards round the weights to eight bits.
  const bool isSoftware = picture.Parts.IsSoftware;
  std::vector<float> smooth;
  const auto keep = [&](const std::string& name, const std::array<int, 3>& size, int components,
                      int type, const std::function<const void*()>& getValues)
  {
    textures.Keep(
      name, "the texture of voxels `" + name + "`", true, { &scene, scene.GridVersion, {} },
      [&]
      {
        FlowTextures::Source source;
        source.Size = size;
        source.Components = components;
        source.Type = type;
        source.Values = getValues();
        source.IsSmooth = isSoftware && type == VTK_FLOAT;
        return source;
      },
      picture.Report.GridUploads);
  };
  keep("cells", { { grid.Size[0] - 1, grid.Size[1] - 1, grid.Size[2] - 1 } }, 2, VTK_UNSIGNED_SHORT,
    [&] { return grid.Cells.data(); });
  keep("places", grid.Size, isSoftware ? 4 : 2, VTK_FLOAT,
    [&]
    {
      smooth = isSoftware ? SmoothVoxels::Make(grid) : std::vector<float>();
      return isSoftware ? smooth.data() : grid.Places.data();
    });
  if (picture.Parts.HasSplitCells)
  {
    keep("groups", grid.Size, 1, VTK_UNSIGNED_SHORT, [&] { return grid.Groups.data(); });
  }
  if (picture.Mapper.GetTimeGate() || picture.Parts.DetailDimensions == 3)
  {
    keep("times", grid.Size, 1, VTK_FLOAT, [&] { return grid.Times.data(); });
  }
}

void KeepPaints(FlowPicture& picture, FlowScene& scene, FlowTextures& textures)
{
  vtkImplicitFlowVolumeMapper& mapper = picture.Mapper;
  FlowVolumeRenderReport& report = picture.Report;
  PaintTexels texels;
  const auto keep = [&](const std::string& name, const std::string& title, vtkImageData* image,
                      int dimensions, bool isRepeated, int& count)
  {
    // The levels of detail are a part of the texture: with and without are two states of it.
    textures.Keep(
      name, title, dimensions == 3,
      { image, 2 * image->GetMTime() + (mapper.GetPaintFilter() ? 1 : 0), {} },
      [&]
      {
        FlowTextures::Source source;
        source.Error = texels.Build(image, dimensions);
        source.Size = texels.Size;
        source.Components = 4;
        source.Type = VTK_UNSIGNED_SHORT;
        source.Values = texels.Texels.data();
        source.IsSmooth = true;
        source.IsRepeated = isRepeated;
        source.HasLevels = mapper.GetPaintFilter();
        return source;
      },
      count);
  };
  for (FlowPaints::Paint& paint : scene.Paints.Paints)
  {
    keep("paint_" + paint.Name, "the inflow texture of id " + paint.Name, paint.Image, 2, false,
      report.InflowUploads);
    int size[3];
    paint.Image->GetDimensions(size);
    std::size_t axis = 0;
    paint.Size = { { 1, 1 } };
    for (const int length : size)
    {
      if (length > 1 && axis < paint.Size.size())
      {
        paint.Size[axis++] = length;
      }
    }
  }
  if (picture.Parts.DetailDimensions > 0)
  {
    mapper.GetDetailTexture()->GetDimensions(picture.DetailSize.data());
    keep("detail", "the detail texture", mapper.GetDetailTexture(), picture.Parts.DetailDimensions,
      true, report.DetailUploads);
  }
  if (!scene.Paints.IsOne)
  {
    textures.Keep(
      "surfaces", "the texture of surfaces", false, { &scene.Paints, scene.Paints.Version, {} },
      [&] { return MakeTable(scene.Paints.Surfaces, 4); }, report.InflowUploads);
  }
}

void KeepArrays(FlowPicture& picture, const FlowScene& scene, FlowTextures& textures)
{
  FlowVolumeRenderReport& report = picture.Report;
  std::vector<float> values;
  const auto keepArray = [&](const char* name, vtkDataArray* array)
  {
    report.NonFiniteSamples += CountNonFinite(array);
    const std::array<int, 3>& size = scene.Grid.Size;
    textures.Keep(
      name, "a texture of values", true,
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
      report.ArrayUploads);
  };
  const auto keepFunction = [&](const char* name, vtkPiecewiseFunction* function,
                              const std::array<double, 2>& range, int& count)
  {
    textures.Keep(
      name, "a texture of a function", false,
      { function, function->GetMTime(), { { range[0], range[1], 0.0 } } },
      [&]
      {
        values.resize(FlowShader::Columns);
        function->GetTable(range[0], range[1], FlowShader::Columns, values.data());
        return MakeTable(values, 1);
      },
      count);
  };
  if (picture.OpacityValues)
  {
    keepArray("opacityValues", picture.OpacityValues);
    double range[2];
    picture.OpacityValues->GetFiniteRange(range, 0);
    picture.TransferRange = { { range[0], range[1] > range[0] ? range[1] : range[0] + 1.0 } };
    keepFunction("transfer", picture.Volume->GetProperty()->GetScalarOpacity(0),
      picture.TransferRange, report.TransferUploads);
  }
  if (picture.ShadingValues)
  {
    keepArray("shadingValues", picture.ShadingValues);
  }
  if (vtkPiecewiseFunction* gate = picture.Mapper.GetTimeGate())
  {
    const double* range = gate->GetRange();
    const bool isRepeated = picture.Mapper.GetTimeGateRepeat();
    keepFunction("gate", gate, { { isRepeated ? 0.0 : range[0], isRepeated ? 1.0 : range[1] } },
      report.GateUploads);
  }
}
}

Error FlowSources::Keep(FlowPicture& picture, FlowScene& scene, FlowTextures& textures)
{
  textures.Begin(picture.Window);
  KeepGrid(picture, scene, textures);
  KeepPaints(picture, scene, textures);
  KeepArrays(picture, scene, textures);
  Error error = textures.Finish();
  picture.Report.UploadedBytes = textures.GetSentBytes();
  picture.Report.Textures = textures.GetNumber();
  picture.Report.TextureBytes = textures.GetBytes();
  if (error)
  {
    return error;
  }
  GLint units = 0;
  glGetIntegerv(GL_MAX_TEXTURE_IMAGE_UNITS, &units);
  if (textures.GetNumber() + 1 > units)
  {
    return { "the picture needs " + std::to_string(textures.GetNumber() + 1) +
        " textures, and a shader here has at most " + std::to_string(units),
      ErrorCode::OpenGL };
  }
  const vtkIdType most = picture.Mapper.GetMaximumTextureMemory();
  if (most > 0 && textures.GetBytes() > most)
  {
    return { "textures of the picture take " + std::to_string(textures.GetBytes()) +
        " bytes, and MaximumTextureMemory is " + std::to_string(most),
      ErrorCode::OutOfMemory };
  }
  return {};
}

}
