// SPDX-License-Identifier: BSD-3-Clause
// Texels of volume samples: values of each type and layout are reproduced within the rounding error
// of texels; non-finite voxels are masked and counted; invalid input is reported; results do not
// depend on the number of threads.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceExecution.h"

#include "vtkBitArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkShortArray.h"
#include "vtkSmartPointer.h"
#include "Volume/VolumeSamples.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

namespace
{

using namespace reference;

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
using Size = std::array<int, 3>;

double GetTexel(const interlume::VolumeSamples& samples, vtkIdType index)
{
  const unsigned char* texels = samples.Texels.data();
  if (samples.Format == interlume::VolumeSamples::UNORM8)
  {
    return texels[index] / 255.0;
  }
  if (samples.Format == interlume::VolumeSamples::UNORM16)
  {
    std::uint16_t texel = 0;
    std::memcpy(&texel, texels + 2 * index, sizeof(texel));
    return texel / 65535.0;
  }
  float texel = 0.0F;
  std::memcpy(&texel, texels + 4 * index, sizeof(texel));
  return texel;
}

/// Checks that values are reproduced within \a tolerance, and that texels are small enough to be
/// squared in single precision.
void CheckValues(
  vtkDataArray* array, const interlume::VolumeSamples& samples, double tolerance, Check& check)
{
  const int components = array->GetNumberOfComponents();
  for (vtkIdType voxel = 0; voxel < array->GetNumberOfTuples(); ++voxel)
  {
    for (int c = 0; c < components; ++c)
    {
      const double texel = GetTexel(samples, voxel * components + c);
      const double value = array->GetComponent(voxel, c);
      check.That(std::abs(samples.Offset[c] + samples.Scale[c] * texel - value) <= tolerance,
        "the value of a texel");
      check.That(std::abs(texel) <= 2.0, "a texel of at most 2");
    }
  }
}

struct Type
{
  double Lowest;
  double Highest;
  int Id;
  interlume::VolumeSamples::Formats Format;
};

const Type Types[] = { { VTK_CHAR_MIN, VTK_CHAR_MAX, VTK_CHAR, interlume::VolumeSamples::UNORM8 },
  { -128, 127, VTK_SIGNED_CHAR, interlume::VolumeSamples::UNORM8 },
  { 0, 255, VTK_UNSIGNED_CHAR, interlume::VolumeSamples::UNORM8 },
  { 0, 1, VTK_BIT, interlume::VolumeSamples::UNORM8 },
  { -32768, 32767, VTK_SHORT, interlume::VolumeSamples::UNORM16 },
  { 0, 65535, VTK_UNSIGNED_SHORT, interlume::VolumeSamples::UNORM16 },
  { -2147483648.0, 2147483647.0, VTK_INT, interlume::VolumeSamples::FLOAT32 },
  { 0, 4294967295.0, VTK_UNSIGNED_INT, interlume::VolumeSamples::FLOAT32 },
  { -1e18, 1e18, VTK_LONG, interlume::VolumeSamples::FLOAT32 },
  { 0, 1e19, VTK_UNSIGNED_LONG, interlume::VolumeSamples::FLOAT32 },
  { -1e18, 1e18, VTK_LONG_LONG, interlume::VolumeSamples::FLOAT32 },
  { 0, 1e19, VTK_UNSIGNED_LONG_LONG, interlume::VolumeSamples::FLOAT32 },
  { 1000000000.0, 1000000100.0, VTK_ID_TYPE, interlume::VolumeSamples::FLOAT32 },
  { -3.4e38, 3.4e38, VTK_FLOAT, interlume::VolumeSamples::FLOAT32 },
  { 16777215.0, 16777217.0, VTK_FLOAT, interlume::VolumeSamples::FLOAT32 },
  { 0.001, 0.7, VTK_FLOAT, interlume::VolumeSamples::FLOAT32 },
  { -3.5, -3.25, VTK_FLOAT, interlume::VolumeSamples::FLOAT32 },
  { -1.0, 1.0, VTK_DOUBLE, interlume::VolumeSamples::FLOAT32 },
  { 1e9, 1e9 + 1e-3, VTK_DOUBLE, interlume::VolumeSamples::FLOAT32 },
  { -1e9 - 1e-3, -1e9, VTK_DOUBLE, interlume::VolumeSamples::FLOAT32 },
  { 1e-300, 3e-300, VTK_DOUBLE, interlume::VolumeSamples::FLOAT32 },
  { -1e308, 1e308, VTK_DOUBLE, interlume::VolumeSamples::FLOAT32 },
  { 1.1e308, 1.7e308, VTK_DOUBLE, interlume::VolumeSamples::FLOAT32 } };

/// Fills an array with the lowest and highest values of its type, and with random values.
void Fill(vtkDataArray* array, const Type& type, vtkIdType voxels, int components)
{
  std::mt19937 random(static_cast<unsigned int>(type.Id));
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(voxels);
  for (vtkIdType i = 0; i < voxels * components; ++i)
  {
    const double fraction = i < components ? 0.0
      : i < 2 * components                 ? 1.0
                                           : random() / static_cast<double>(random.max());
    const double value = type.Lowest * (1.0 - fraction) + type.Highest * fraction;
    const bool real = type.Id == VTK_FLOAT || type.Id == VTK_DOUBLE;
    array->SetComponent(
      i / components, static_cast<int>(i % components), real ? value : std::floor(value));
  }
}

void CheckType(vtkDataArray* array, const Type& type, int components, bool widens, Check& check)
{
  check.SetContext("type " + std::to_string(array->GetDataType()) + " " + array->GetClassName() +
    " from " + std::to_string(type.Lowest) + ", components " + std::to_string(components) +
    (widens ? ", widened" : ""));
  const Size size{ { 5, 4, 3 } };
  Fill(array, type, 60, components);
  interlume::VolumeSamples samples;
  check.That(!samples.Build(array, size, widens), "no error");
  const bool wider = widens && type.Format == interlume::VolumeSamples::UNORM8;
  check.Equal(
    samples.Format, wider ? interlume::VolumeSamples::UNORM16 : type.Format, "the format");
  check.Equal(samples.Components, components, "components");
  check.That(samples.Size == size && samples.Mask.empty() && samples.NonFinite == 0, "no mask");
  check.Equal(static_cast<long long>(samples.Texels.size()),
    60 * components *
      (samples.Format == interlume::VolumeSamples::UNORM8       ? 1
          : samples.Format == interlume::VolumeSamples::UNORM16 ? 2
                                                                : 4),
    "bytes");
  for (int c = 0; c < components; ++c)
  {
    check.That(samples.Range[c][0] == array->GetComponent(0, c), "the smallest value");
    check.That(samples.Range[c][1] == array->GetComponent(1, c), "the largest value");
  }
  const double largest = std::max(std::abs(type.Lowest), std::abs(type.Highest));
  const double extent = std::min(type.Highest - type.Lowest, std::numeric_limits<double>::max());
  CheckValues(array, samples,
    type.Id == VTK_FLOAT ? 0.0
      : type.Format != interlume::VolumeSamples::FLOAT32
      ? 1e-10
      : std::ldexp(extent, -23) + 1e-15 * largest,
    check);
}

template <typename T>
void CheckStructureOfArrays(int id, Check& check)
{
  for (const Type& type : Types)
  {
    if (type.Id == id)
    {
      vtkNew<vtkSOADataArrayTemplate<T>> array;
      CheckType(array, type, 3, false, check);
    }
  }
}

void CheckTypes(Check& check)
{
  for (const Type& type : Types)
  {
    for (const int components : { 1, 2, 3, 4 })
    {
      for (const bool widens : { false, true })
      {
        const auto array =
          vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type.Id));
        CheckType(array, type, components, widens, check);
      }
    }
  }
  CheckStructureOfArrays<signed char>(VTK_SIGNED_CHAR, check);
  CheckStructureOfArrays<unsigned char>(VTK_UNSIGNED_CHAR, check);
  CheckStructureOfArrays<short>(VTK_SHORT, check);
  CheckStructureOfArrays<int>(VTK_INT, check);
  CheckStructureOfArrays<float>(VTK_FLOAT, check);
  CheckStructureOfArrays<double>(VTK_DOUBLE, check);
}

void CheckNonFinite(Check& check)
{
  const std::vector<double> values = { 1.0, 5.0, NaN, 6.0, 2.0, Infinity, 3.0, 9.0, -Infinity, NaN,
    4.0, 8.0 };
  const std::vector<unsigned short> mask = { 65535, 0, 0, 65535, 0, 65535 };
  for (const bool single : { false, true })
  {
    check.SetContext(single ? "float with NaN" : "double with NaN");
    const auto array = vtkSmartPointer<vtkDataArray>::Take(
      vtkDataArray::CreateDataArray(single ? VTK_FLOAT : VTK_DOUBLE));
    array->SetNumberOfComponents(2);
    array->SetNumberOfTuples(6);
    for (int i = 0; i < 12; ++i)
    {
      array->SetComponent(i / 2, i % 2, values[static_cast<std::size_t>(i)]);
    }
    interlume::VolumeSamples samples;
    check.That(!samples.Build(array, { { 3, 2, 1 } }, false), "no error");
    check.Equal(samples.NonFinite, 3, "voxels are counted, not values");
    check.That(samples.Mask == mask, "the mask");
    check.That(
      samples.Range[0] == std::array<double, 2>{ { 1.0, 4.0 } }, "range of the first component");
    check.That(
      samples.Range[1] == std::array<double, 2>{ { 5.0, 9.0 } }, "range of the second component");
    for (int i = 0; i < 12; ++i)
    {
      const double texel = GetTexel(samples, i);
      const bool masked = mask[static_cast<std::size_t>(i / 2)] == 0;
      check.Near(masked ? texel : samples.Offset[i % 2] + samples.Scale[i % 2] * texel,
        masked ? 0.0 : values[static_cast<std::size_t>(i)], 1e-7, "texel", masked ? 0.0 : 1.0);
    }
  }

  check.SetContext("all values are NaN");
  vtkNew<vtkFloatArray> none;
  none->SetNumberOfTuples(8);
  none->FillValue(std::numeric_limits<float>::quiet_NaN());
  interlume::VolumeSamples samples;
  check.That(!samples.Build(none, { { 2, 2, 2 } }, false), "no error");
  check.Equal(samples.NonFinite, 8, "all voxels are counted");
  check.That(samples.Range[0] == std::array<double, 2>{ { 0.0, 0.0 } }, "the range is zero");
  check.That(samples.Scale[0] > 0.0 && samples.Offset[0] == 0.0, "the scale is positive");
}

void CheckExtremes(Check& check)
{
  vtkNew<vtkDoubleArray> array;
  interlume::VolumeSamples samples;
  for (const double value :
    { 0.0, 0.1, -7.0, 1e9 + 0.3, 1e-300, 5e-324, -1.7e308, 1.7e308, 12345678901.0 })
  {
    for (const Size& size : { Size{ { 1, 1, 1 } }, Size{ { 1, 1, 7 } }, Size{ { 3, 1, 2 } } })
    {
      check.SetContext("equal values " + std::to_string(value));
      array->SetNumberOfTuples(size[0] * size[1] * size[2]);
      array->FillValue(value);
      check.That(!samples.Build(array, size, false), "no error");
      check.That(samples.Range[0] == std::array<double, 2>{ { value, value } }, "the range");
      check.That(samples.Scale[0] > 0.0 && std::isfinite(1.0 / samples.Scale[0]), "a finite scale");
      CheckValues(array, samples, 0.0, check);
    }
  }
  check.SetContext("the smallest numbers");
  array->SetNumberOfTuples(2);
  array->SetValue(0, -5e-324);
  array->SetValue(1, 1e-323);
  check.That(!samples.Build(array, { { 2, 1, 1 } }, false), "no error");
  CheckValues(array, samples, 0.0, check);
}

void CheckErrors(Check& check)
{
  check.SetContext("errors");
  interlume::VolumeSamples samples;
  const auto fails = [&](vtkDataArray* array, const Size& size, const std::string& word)
  {
    vtkNew<vtkShortArray> before;
    before->InsertNextValue(3);
    check.That(!samples.Build(before, { { 1, 1, 1 } }, false), "no error before");
    const std::string message = samples.Build(array, size, false).GetMessage();
    check.That(message.find(word) != std::string::npos, "'" + word + "' in: " + message);
    check.That(samples.Texels.empty() && samples.Components == 0, "no data are left");
  };
  vtkNew<vtkFloatArray> array;
  array->SetName("density");
  fails(nullptr, { { 1, 1, 1 } }, "no scalar values");
  fails(array, { { 0, 4, 4 } }, "no scalar values");
  fails(array, { { 1, 1, 1 } }, "density");
  array->SetNumberOfTuples(7);
  fails(array, { { 2, 2, 2 } }, "7 values for 8");
  vtkNew<vtkFloatArray> wide;
  wide->SetName("stress");
  wide->SetNumberOfComponents(5);
  wide->SetNumberOfTuples(8);
  fails(wide, { { 2, 2, 2 } }, "stress' has 5");
}

/// Compares the differences between neighbors with the values of an irregular function.
void CheckDifferences(Check& check)
{
  const Size size{ { 5, 1, 4 } };
  for (const int type : { VTK_UNSIGNED_CHAR, VTK_UNSIGNED_SHORT, VTK_FLOAT })
  {
    const auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
    array->SetNumberOfTuples(20);
    for (int i = 0; i < 20; ++i)
    {
      array->SetComponent(i, 0, (i * i * 7) % 251);
    }
    interlume::VolumeSamples samples;
    check.That(!samples.Build(array, size, true), "no error");
    const std::vector<float> differences = samples.FindDifferences();
    check.Equal(static_cast<long long>(differences.size()), 60, "three differences for each voxel");
    for (int i = 0; i < 20; ++i)
    {
      const int x = i % 5;
      const int z = i / 5;
      const auto at = [&](int column, int layer)
      { return array->GetComponent(std::clamp(column, 0, 4) + 5 * std::clamp(layer, 0, 3), 0); };
      const double expected[3] = { at(x + 1, z) - at(x - 1, z), 0.0, at(x, z + 1) - at(x, z - 1) };
      for (int axis = 0; axis < 3; ++axis)
      {
        check.Near(samples.Scale[0] * differences[static_cast<std::size_t>(3 * i + axis)],
          expected[axis], 1e-4, "difference", 1.0);
      }
    }
  }
}

void CheckThreads(Check& check)
{
  // Zeros of both signs and masked voxels, in a volume large enough for several threads.
  vtkNew<vtkDoubleArray> array;
  array->SetNumberOfComponents(2);
  array->SetNumberOfTuples(60 * 60 * 50);
  for (vtkIdType voxel = 0; voxel < array->GetNumberOfTuples(); ++voxel)
  {
    const double value = voxel % 3 == 0 ? voxel : voxel % 3 == 1 ? -0.0 : 0.0;
    array->SetComponent(voxel, 0, value);
    array->SetComponent(voxel, 1, voxel % 1001 == 0 ? NaN : voxel % 3 == 0 ? -value : value);
  }
  const Size size{ { 60, 60, 50 } };
  interlume::VolumeSamples expected;
  vtkSMPTools::SetBackend("Sequential");
  SetThreads(1);
  check.That(!expected.Build(array, size, false), "no error");
  check.That(!std::signbit(expected.Range[0][0]) && !std::signbit(expected.Range[1][1]),
    "the zero of a range is positive");
  const auto compare = [&]()
  {
    interlume::VolumeSamples samples;
    check.That(!samples.Build(array, size, false), "no error");
    check.That(samples.Texels == expected.Texels && samples.Mask == expected.Mask &&
        samples.NonFinite == expected.NonFinite,
      "the same texels");
    check.That(samples.Range == expected.Range && samples.Offset == expected.Offset &&
        samples.Scale == expected.Scale,
      "the same range");
  };
  ForEachThreadCount("samples", compare, check);
}

}

int TestVolumeSamples(int, char*[])
{
  Check check;
  CheckTypes(check);
  CheckNonFinite(check);
  CheckExtremes(check);
  CheckErrors(check);
  CheckDifferences(check);
  CheckThreads(check);
  return check.Result();
}
