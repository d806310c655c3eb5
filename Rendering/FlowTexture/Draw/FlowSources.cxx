// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/FlowSources.h"

#include "Draw/FlowRenderFrame.h"
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

// Returns the values of an array as floats. Non-finite values become 0.
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

// Returns the number of samples with a non-finite coordinate, time or value in \a arrays.
std::size_t CountNonFinite(const FlowGrid& grid, const std::array<vtkDataArray*, 2>& arrays)
{
  std::vector<vtkIdType> samples = grid.NonFinite;
  for (vtkDataArray* array : arrays)
  {
    const int components = array ? array->GetNumberOfComponents() : 0;
    for (vtkIdType i = 0; array && i < array->GetNumberOfTuples() * components; ++i)
    {
      if (!std::isfinite(array->GetComponent(i / components, static_cast<int>(i % components))))
      {
        samples.push_back(i / components);
      }
    }
  }
  std::sort(samples.begin(), samples.end());
  samples.erase(std::unique(samples.begin(), samples.end()), samples.end());
  return samples.size();
}

void UpdateGrid(FlowRenderFrame& pass, const FlowRenderState& scene, FlowTextures& textures)
{
  const FlowGrid& grid = scene.Grid;
  // Software OpenGL interpolates in full precision. GPUs round interpolation weights to 8 bits.
  const bool isSoftware = pass.Parts.IsSoftware;
  std::vector<float> smooth;
  const auto update = [&](const std::string& name, const std::array<int, 3>& size, int components,
                        int type, const std::function<const void*()>& getValues)
  {
    textures.Update(
      name, "The texture of voxels `" + name + "`", true, { &scene, scene.GridVersion, {} },
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
      pass.Report.GridUploads);
  };
  update("cells", { { grid.Size[0] - 1, grid.Size[1] - 1, grid.Size[2] - 1 } }, 2,
    VTK_UNSIGNED_SHORT, [&] { return grid.Cells.data(); });
  update("places", grid.Size, isSoftware ? 4 : 2, VTK_FLOAT,
    [&]
    {
      smooth = isSoftware ? SmoothVoxels::Make(grid) : std::vector<float>();
      return isSoftware ? smooth.data() : grid.Parameters.data();
    });
  if (pass.Parts.HasSplitCells)
  {
    update("groups", grid.Size, 1, VTK_UNSIGNED_SHORT, [&] { return grid.Groups.data(); });
  }
  if (pass.Mapper.GetTimeGate() || pass.Parts.DetailDimensions == 3)
  {
    update("times", grid.Size, 1, VTK_FLOAT, [&] { return grid.Times.data(); });
  }
}

void UpdatePaints(FlowRenderFrame& pass, FlowRenderState& scene, FlowTextures& textures)
{
  vtkImplicitFlowVolumeMapper& mapper = pass.Mapper;
  FlowVolumeRenderReport& report = pass.Report;
  PaintTexels texels;
  const auto update = [&](const std::string& name, const std::string& title, vtkImageData* image,
                        int dimensions, bool isRepeated, int& count)
  {
    // Include TextureFilter in the stamp, because it determines whether the texture has mipmaps.
    textures.Update(
      name, title, dimensions == 3,
      { image, 2 * image->GetMTime() + (mapper.GetTextureFilter() ? 1 : 0), {} },
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
        source.HasLevels = mapper.GetTextureFilter();
        return source;
      },
      count);
  };
  for (SurfacePaintTextures::Paint& paint : scene.Paints.Paints)
  {
    update("paint_" + paint.Name, "The inflow texture of id " + paint.Name, paint.Image, 2, false,
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
  if (pass.Parts.DetailDimensions > 0)
  {
    mapper.GetDetailTexture()->GetDimensions(pass.DetailSize.data());
    update("detail", "The detail texture", mapper.GetDetailTexture(), pass.Parts.DetailDimensions,
      true, report.DetailUploads);
  }
  if (!scene.Paints.IsUniform)
  {
    textures.Update(
      "surfaces", "The texture of surfaces", false, { &scene.Paints, scene.Paints.Version, {} },
      [&] { return MakeTable(scene.Paints.Surfaces, 4); }, report.InflowUploads);
  }
}

void UpdateArrays(FlowRenderFrame& pass, const FlowRenderState& scene, FlowTextures& textures)
{
  FlowVolumeRenderReport& report = pass.Report;
  report.NonFiniteSamples = static_cast<vtkIdType>(
    CountNonFinite(scene.Grid, { { pass.OpacityValues, pass.ShadingValues } }));
  std::vector<float> values;
  const auto updateArray = [&](const char* name, vtkDataArray* array)
  {
    const std::array<int, 3>& size = scene.Grid.Size;
    textures.Update(
      name, std::string("The texture of array values `") + name + "`", true,
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
  const auto updateFunction = [&](const char* name, vtkPiecewiseFunction* function,
                                const std::array<double, 2>& range, int& count)
  {
    textures.Update(
      name, std::string("The texture of the function `") + name + "`", false,
      { function, function->GetMTime(), { { range[0], range[1], 0.0 } } },
      [&]
      {
        values.resize(FlowShader::Columns);
        function->GetTable(range[0], range[1], FlowShader::Columns, values.data());
        return MakeTable(values, 1);
      },
      count);
  };
  if (pass.OpacityValues)
  {
    updateArray("opacityValues", pass.OpacityValues);
    double range[2];
    pass.OpacityValues->GetFiniteRange(range, 0);
    pass.TransferRange = { { range[0], range[1] > range[0] ? range[1] : range[0] + 1.0 } };
    updateFunction("transfer", pass.Volume->GetProperty()->GetScalarOpacity(0), pass.TransferRange,
      report.TransferUploads);
  }
  if (pass.ShadingValues)
  {
    updateArray("shadingValues", pass.ShadingValues);
  }
  if (vtkPiecewiseFunction* gate = pass.Mapper.GetTimeGate())
  {
    const double* range = gate->GetRange();
    const bool isRepeated = pass.Mapper.GetTimeGateRepeat();
    updateFunction("gate", gate, { { isRepeated ? 0.0 : range[0], isRepeated ? 1.0 : range[1] } },
      report.GateUploads);
  }
}
}

Error FlowSources::Update(FlowRenderFrame& pass, FlowRenderState& scene, FlowTextures& textures)
{
  textures.Begin(pass.Window);
  UpdateGrid(pass, scene, textures);
  UpdatePaints(pass, scene, textures);
  UpdateArrays(pass, scene, textures);
  Error error = textures.Finish();
  pass.Report.UploadedBytes = textures.GetUploadedBytes();
  pass.Report.Textures = textures.GetNumber();
  pass.Report.TextureBytes = textures.GetBytes();
  if (error)
  {
    return error;
  }
  GLint units = 0;
  glGetIntegerv(GL_MAX_TEXTURE_IMAGE_UNITS, &units);
  if (textures.GetNumber() + 1 > units)
  {
    return { "The image requires " + std::to_string(textures.GetNumber() + 1) +
        " texture units, but the GPU has " + std::to_string(units) + ". Use fewer inflow textures.",
      ErrorCode::OpenGL };
  }
  const vtkIdType maximum = pass.Mapper.GetMaximumTextureMemory();
  if (maximum > 0 && textures.GetBytes() > maximum)
  {
    return { "The textures of the image require " + std::to_string(textures.GetBytes()) +
        " bytes, but MaximumTextureMemory is " + std::to_string(maximum) +
        ". Increase it or use smaller images.",
      ErrorCode::OutOfMemory };
  }
  return {};
}

}
