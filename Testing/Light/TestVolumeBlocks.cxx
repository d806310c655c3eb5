// SPDX-License-Identifier: BSD-3-Clause
// Visible blocks: blocks with some opacity and their neighbors are visible. Blocks in which all
// sampled and interpolated values are transparent are invisible. Block borders are at the samples.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceExecution.h"

#include "vtkDataArray.h"
#include "Volume/MaterialTable.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkSmartPointer.h"
#include "Volume/VolumeBlocks.h"
#include "vtkVolumeProperty.h"
#include "Volume/VolumeSamples.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <vector>

namespace
{

using namespace reference;

using Size = std::array<int, 3>;
using Index = std::array<int, 3>;

/// Type, size and values of a test volume.
struct Case
{
  std::string Name;
  int Type = VTK_FLOAT;
  Size Samples{};
  int Components = 1;
  bool Independent = true;
  /// Value of a component at a sample index.
  std::function<double(const Index&, int)> Value;
};

/// Range of values with nonzero opacity, both ends excluded, as fractions of the type's range.
const std::array<double, 2> Band = { { 0.25, 0.75 } };

double FullOf(int type)
{
  return type == VTK_UNSIGNED_CHAR ? 255.0 : type == VTK_SHORT ? 32767.0 : 1.0;
}

vtkSmartPointer<vtkDataArray> MakeArray(const Case& volume)
{
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(volume.Type));
  const Size& size = volume.Samples;
  array->SetNumberOfComponents(volume.Components);
  array->SetNumberOfTuples(size[0] * size[1] * size[2]);
  for (int v = 0; v < array->GetNumberOfTuples(); ++v)
  {
    const Index index{ { v % size[0], v / size[0] % size[1], v / size[0] / size[1] } };
    for (int c = 0; c < volume.Components; ++c)
    {
      array->SetComponent(v, c, volume.Value(index, c));
    }
  }
  return array;
}

/// Returns true if the band overlaps the range of a component's values in a block and the samples
/// next to it. The band is widened by two columns of the material table if \a isWidened.
bool IntersectsBand(vtkDataArray* array, const Case& volume, const Index& block, int edge,
  int component, bool isWidened)
{
  const Size& size = volume.Samples;
  double lower = std::numeric_limits<double>::infinity();
  double upper = -lower;
  const auto first = [&](int axis) { return std::max(edge * block[axis] - 1, 0); };
  const auto last = [&](int axis)
  { return std::min(edge * (block[axis] + 1) + 1, size[axis] - 1); };
  for (int k = first(2); k <= last(2); ++k)
  {
    for (int j = first(1); j <= last(1); ++j)
    {
      for (int i = first(0); i <= last(0); ++i)
      {
        const vtkIdType voxel = (static_cast<vtkIdType>(k) * size[1] + j) * size[0] + i;
        bool finite = true;
        for (int c = 0; c < volume.Components; ++c)
        {
          finite = finite && std::isfinite(array->GetComponent(voxel, c));
        }
        if (finite)
        {
          lower = std::min(lower, array->GetComponent(voxel, component));
          upper = std::max(upper, array->GetComponent(voxel, component));
        }
      }
    }
  }
  const double full = FullOf(volume.Type);
  const double margin = isWidened ? 2.0 * full / interlume::MaterialTable::Columns : 0.0;
  return lower <= upper && upper > Band[0] * full - margin && lower < Band[1] * full + margin;
}

/// Returns a property with nonzero opacity in the band only.
vtkNew<vtkVolumeProperty> MakeProperty(const Case& volume)
{
  vtkNew<vtkVolumeProperty> property;
  property->SetIndependentComponents(volume.Independent ? 1 : 0);
  const double full = FullOf(volume.Type);
  for (int c = 0; c < volume.Components; ++c)
  {
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(Band[0] * full, 0.0);
    opacity->AddPoint(0.5 * full, 0.5);
    opacity->AddPoint(Band[1] * full, 0.0);
    property->SetScalarOpacity(c, opacity);
  }
  return property;
}

/// Checks blocks with \a edge cells along each edge.
void CheckBlocks(const Case& volume, int edge, Check& check)
{
  check.SetContext(volume.Name + ", blocks of " + std::to_string(edge));
  const auto array = MakeArray(volume);
  const auto property = MakeProperty(volume);
  interlume::VolumeSamples samples;
  check.That(!samples.Build(array, volume.Samples, false), "samples");
  interlume::MaterialTable material;
  check.That(!material.Build(property, samples, nullptr), "materials");
  interlume::VolumeBlocks blocks;
  blocks.Build(samples, edge);
  check.Equal(blocks.GetNumberOfVisibleBlocks(), 0, "no block is visible before classification");
  blocks.Classify(material);

  int count = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int cells = std::max(volume.Samples[axis] - 1, 1);
    const int expected = (cells + edge - 1) / edge;
    check.Equal(blocks.GetSize()[axis], expected, "blocks");
    count *= expected;
  }
  check.Equal(blocks.GetNumberOfBlocks(), count, "all blocks");

  std::vector<int> opacityComponents;
  if (volume.Independent)
  {
    for (int c = 0; c < volume.Components; ++c)
    {
      opacityComponents.push_back(c);
    }
  }
  else
  {
    opacityComponents.push_back(volume.Components - 1);
  }
  const Size size = blocks.GetSize();
  int visible = 0;
  for (int b = 0; b < count; ++b)
  {
    const Index block{ { b % size[0], b / size[0] % size[1], b / size[0] / size[1] } };
    bool isRequired = false;
    bool isAllowed = false;
    for (const int c : opacityComponents)
    {
      isRequired = isRequired || IntersectsBand(array, volume, block, edge, c, false);
      isAllowed = isAllowed || IntersectsBand(array, volume, block, edge, c, true);
    }
    const bool found = blocks.IsVisible(block[0], block[1], block[2]);
    const std::string name =
      std::to_string(block[0]) + " " + std::to_string(block[1]) + " " + std::to_string(block[2]);
    check.That(found || !isRequired, "visible: block " + name);
    check.That(!found || isAllowed, "not visible: block " + name);
    visible += found ? 1 : 0;
  }
  check.Equal(blocks.GetNumberOfVisibleBlocks(), visible, "visible blocks");
}

/// Blocks that are joined from small blocks equal blocks that are computed from the samples.
void CheckJoined(const Case& volume, Check& check)
{
  check.SetContext(volume.Name + ", joined blocks");
  interlume::VolumeSamples samples;
  check.That(!samples.Build(MakeArray(volume), volume.Samples, false), "samples");
  interlume::MaterialTable material;
  check.That(!material.Build(MakeProperty(volume), samples, nullptr), "materials");
  interlume::VolumeBlocks small;
  small.Build(samples, interlume::VolumeBlocks::SmallSize);
  interlume::VolumeBlocks joined;
  joined.Join(small);
  joined.Classify(material);
  interlume::VolumeBlocks built;
  built.Build(samples);
  built.Classify(material);
  check.That(joined.GetSize() == built.GetSize(), "blocks");
  check.That(
    joined.GetBlockGrid().GetVisible() == built.GetBlockGrid().GetVisible(), "visible blocks");
  for (int axis = 0; axis < 3; ++axis)
  {
    check.That(joined.GetBorders(axis) == built.GetBorders(axis), "borders");
  }
}

void CheckCase(const Case& volume, Check& check)
{
  CheckJoined(volume, check);
  CheckBlocks(volume, interlume::VolumeBlocks::BlockSize, check);
  CheckBlocks(volume, interlume::VolumeBlocks::SmallSize, check);
}

/// Returns values that are 0 except for a few samples in the band.
std::function<double(const Index&, int)> MakeSparse(const Size& size, int type, int points)
{
  std::mt19937 random(static_cast<unsigned int>(size[0] + 100 * size[1] + points));
  std::vector<Index> indices;
  for (int i = 0; i < points; ++i)
  {
    Index index{};
    for (int axis = 0; axis < 3; ++axis)
    {
      index[axis] = static_cast<int>(random() % static_cast<unsigned int>(size[axis]));
    }
    indices.push_back(index);
  }
  return [indices, type](const Index& index, int)
  {
    return std::find(indices.begin(), indices.end(), index) != indices.end()
      ? std::floor(0.5 * FullOf(type)) + (FullOf(type) == 1.0 ? 0.5 : 0.0)
      : 0.0;
  };
}

void CheckSizes(Check& check)
{
  for (const Size& size :
    { Size{ { 1, 1, 1 } }, Size{ { 1, 1, 40 } }, Size{ { 40, 1, 1 } }, Size{ { 2, 2, 2 } },
      Size{ { 16, 17, 18 } }, Size{ { 33, 34, 15 } }, Size{ { 50, 35, 65 } } })
  {
    for (const int type : { VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_FLOAT, VTK_DOUBLE })
    {
      for (const int points : { 0, 1, 3 })
      {
        Case volume;
        volume.Name = std::to_string(size[0]) + " " + std::to_string(size[1]) + " " +
          std::to_string(size[2]) + ", type " + std::to_string(type) + ", points " +
          std::to_string(points);
        volume.Type = type;
        volume.Samples = size;
        volume.Value = MakeSparse(size, type, points);
        CheckCase(volume, check);
      }
    }
  }
}

/// Tests rows of samples in which only the sample at one index is visible.
void CheckNeighbors(Check& check)
{
  for (int index = 0; index < 50; ++index)
  {
    Case volume;
    volume.Name = "sample " + std::to_string(index) + " of a row";
    volume.Samples = { { 50, 1, 1 } };
    volume.Value = [index](const Index& p, int) { return p[0] == index ? 0.5 : 0.0; };
    CheckCase(volume, check);
  }
}

void CheckBetween(Check& check)
{
  Case volume;
  volume.Name = "0 beside 1";
  volume.Samples = { { 60, 20, 20 } };
  volume.Value = [](const Index& p, int) { return p[0] < 25 ? 0.0 : 1.0; };
  CheckCase(volume, check);
}

void CheckComponents(Check& check)
{
  Case volume;
  volume.Samples = { { 70, 20, 20 } };
  volume.Value = [](const Index& p, int c) { return p[0] == 8 + 16 * c ? 0.5 : 0.0; };
  for (const int components : { 2, 3, 4 })
  {
    volume.Components = components;
    volume.Independent = true;
    volume.Name = std::to_string(components) + " independent components";
    CheckCase(volume, check);
    if (components != 3)
    {
      volume.Independent = false;
      volume.Name = std::to_string(components) + " dependent components";
      CheckCase(volume, check);
    }
  }
}

void CheckNonFinite(Check& check)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Case volume;
  volume.Samples = { { 70, 18, 18 } };
  volume.Name = "some blocks have no finite value";
  volume.Value = [nan](const Index& p, int) {
    return p[0] < 40 ? nan : p[0] == 60 ? 0.5 : p[0] == 44 ? nan : 0.0;
  };
  CheckCase(volume, check);
  volume.Name = "1 beside NaN";
  volume.Value = [nan](const Index& p, int) { return p[0] % 2 == 0 ? nan : 1.0; };
  CheckCase(volume, check);
  volume.Name = "NaN in another component";
  volume.Components = 2;
  volume.Value = [nan](const Index& p, int c) { return c == 0 && p[0] < 40 ? nan : 0.5; };
  CheckCase(volume, check);
  volume.Name = "no finite value";
  volume.Value = [nan](const Index&, int) { return nan; };
  CheckCase(volume, check);
}

void CheckBorders(Check& check)
{
  check.SetContext("borders");
  const auto bordersOf = [&check](const Size& size, int axis)
  {
    Case volume;
    volume.Samples = size;
    volume.Value = [](const Index&, int) { return 0.0; };
    interlume::VolumeSamples samples;
    check.That(!samples.Build(MakeArray(volume), size, false), "samples");
    interlume::VolumeBlocks blocks;
    blocks.Build(samples);
    return blocks.GetBorders(axis);
  };
  const Size size{ { 40, 17, 1 } };
  check.That(
    bordersOf(size, 0) == std::vector<double>{ 0.5 / 40.0, 16.5 / 40.0, 32.5 / 40.0, 39.5 / 40.0 },
    "borders from the first sample to the last");
  check.That(bordersOf(size, 1) == std::vector<double>{ 0.5 / 17.0, 16.5 / 17.0 }, "one block");
  check.That(bordersOf(size, 2) == std::vector<double>{ 0.0, 1.0 }, "one sample");
  check.That(
    bordersOf({ { 18, 1, 1 } }, 0) == std::vector<double>{ 0.5 / 18.0, 16.5 / 18.0, 17.5 / 18.0 },
    "a block of one cell");
}

void CheckThreads(Check& check)
{
  Case volume;
  volume.Name = "threads";
  volume.Samples = { { 90, 70, 50 } };
  volume.Value = MakeSparse(volume.Samples, VTK_FLOAT, 6);
  const auto property = MakeProperty(volume);
  const auto array = MakeArray(volume);
  const auto classify = [&]()
  {
    interlume::VolumeSamples samples;
    check.That(!samples.Build(array, volume.Samples, false), "samples");
    interlume::MaterialTable material;
    check.That(!material.Build(property, samples, nullptr), "materials");
    interlume::VolumeBlocks blocks;
    blocks.Build(samples);
    blocks.Classify(material);
    std::vector<bool> result;
    result.reserve(static_cast<std::size_t>(blocks.GetNumberOfBlocks()));
    for (int b = 0; b < blocks.GetNumberOfBlocks(); ++b)
    {
      result.push_back(
        blocks.IsVisible(b % blocks.GetSize()[0], b / blocks.GetSize()[0] % blocks.GetSize()[1],
          b / blocks.GetSize()[0] / blocks.GetSize()[1]));
    }
    return result;
  };
  CheckSame(volume.Name, classify, check);
  CheckCase(volume, check);
}
}

int TestVolumeBlocks(int, char*[])
{
  Check check;
  CheckSizes(check);
  CheckNeighbors(check);
  CheckBetween(check);
  CheckComponents(check);
  CheckNonFinite(check);
  CheckBorders(check);
  CheckThreads(check);
  return check.Result();
}
