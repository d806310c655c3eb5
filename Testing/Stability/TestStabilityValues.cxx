// SPDX-License-Identifier: BSD-3-Clause
// Tests extreme values of the scalar and the bounds.
#include "StabilityChecks.h"

#include "Support/Intervals/ReferenceExtraction.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceGrid.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/Meshes/ReferenceVolume.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTypeInt64Array.h"
#include "vtkTypeUInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <functional>
#include <limits>
#include <random>

namespace
{

using namespace reference;

constexpr std::array<int, 3> Cells = { 4, 4, 3 };
constexpr double DomainVolume = 4 * 4 * 3;
constexpr double VolumeBound = 1e-12;

using Value = std::function<double(vtkIdType)>;

/// Returns a random even integer in [0, 2000), which never equals an odd bound.
double EvenInteger(vtkIdType point)
{
  std::mt19937 random(static_cast<unsigned int>(point) * 7919u + 1u);
  return 2.0 * (random() % 1000);
}

template <typename Array>
vtkSmartPointer<vtkUnstructuredGrid> MakeInput(
  const std::function<typename Array::ValueType(vtkIdType)>& value, MeshKind kind = MeshKind::Mixed)
{
  auto mesh = MakeMesh(kind, Cells);
  vtkNew<Array> array;
  array->SetName("f");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    array->InsertNextValue(value(i));
  }
  mesh->GetPointData()->SetScalars(array);
  return mesh;
}

double VolumeOf(vtkDataSet* mesh, const std::vector<Interval>& intervals)
{
  return static_cast<double>(MeasureTetrahedra(ExtractIntervals(mesh, intervals).Volume).Sum);
}

/// Returns the error relative to the domain's volume. If \a expected is 0, returns NaN to fail the
/// case.
double RelativeError(double found, double expected)
{
  return expected > 0 ? std::abs(found - expected) / DomainVolume : std::nan("");
}

/// Returns the number of simplices that differ between scaled and unscaled values and bounds.
template <typename Array>
double DifferentSimplices(double scale, double shift = 0)
{
  using T = typename Array::ValueType;
  auto plain = MakeInput<vtkDoubleArray>(EvenInteger);
  auto scaled =
    MakeInput<Array>([&](vtkIdType i) { return static_cast<T>(EvenInteger(i) * scale + shift); });
  const auto expected = GeometricSet(ExtractIntervals(plain, { { 501, 1203 } }).Volume);
  const auto found = GeometricSet(
    ExtractIntervals(scaled, { { 501 * scale + shift, 1203 * scale + shift } }).Volume);
  std::vector<GeometricSimplex> different;
  std::set_symmetric_difference(
    expected.begin(), expected.end(), found.begin(), found.end(), std::back_inserter(different));
  return expected.empty() ? std::nan("") : static_cast<double>(different.size());
}

void TestRanges(StabilityCatalogue& catalogue)
{
  const auto measure = [&catalogue](const char* name, const char* extreme, double different)
  {
    catalogue.Measure(
      name, extreme, "number of tetrahedra that differ from the result at scale 1", different, 0);
  };
  measure("range-1e-30", "values within 2^-100 of each other",
    DifferentSimplices<vtkDoubleArray>(std::ldexp(1, -111)));
  measure(
    "range-1e+30", "values up to 2^100", DifferentSimplices<vtkDoubleArray>(std::ldexp(1, 89)));
  measure("range-1e-30-float", "float values within 2^-100",
    DifferentSimplices<vtkFloatArray>(std::ldexp(1, -111)));
  measure("range-1e+30-float", "float values up to 2^100",
    DifferentSimplices<vtkFloatArray>(std::ldexp(1, 89)));
  measure("subnormal-float", "float values in multiples of 2^-149",
    DifferentSimplices<vtkFloatArray>(std::ldexp(1, -149)));
  measure("subnormal-double", "double values in multiples of 2^-1074",
    DifferentSimplices<vtkDoubleArray>(std::ldexp(1, -1074)));
  for (double scale : { 1e-30, 1e+30, 1e-300, 1e+300 })
  {
    auto mesh = MakeInput<vtkDoubleArray>(
      [&](vtkIdType i) { return scale * EvenInteger(i); }, MeshKind::Tetrahedra5);
    const Range range = { "f", 501 * scale, 1203 * scale };
    std::string name = "volume-at-" + std::to_string(static_cast<int>(std::log10(scale)));
    catalogue.Measure(name, "values times a power of ten", "relative error of the volume",
      RelativeError(VolumeOf(mesh, { { range.Lower, range.Upper } }),
        static_cast<double>(ClippedVolume(mesh, { range }))),
      VolumeBound);
  }
  // The difference of two values exceeds the largest double.
  constexpr double largest = std::numeric_limits<double>::max();
  auto mesh = MakeInput<vtkDoubleArray>(
    [](vtkIdType i) { return (EvenInteger(i) / 1000 - 1) * largest; }, MeshKind::Tetrahedra5);
  const Range range = { "f", -0.4 * largest, 0.7 * largest };
  catalogue.Measure("range-beyond-double", "values from -1.8e308 to 1.8e308",
    "relative error of the volume",
    RelativeError(VolumeOf(mesh, { { range.Lower, range.Upper } }),
      static_cast<double>(ClippedVolume(mesh, { range }))),
    VolumeBound);
  catalogue.Measure("offset", "values from 1e9 in steps of 1e-4",
    "number of tetrahedra that differ from the result without offset",
    DifferentSimplices<vtkDoubleArray>(std::ldexp(1, -13), std::ldexp(1, 30)), 0);
}

void TestEqualBounds(StabilityCatalogue& catalogue)
{
  auto random = MakeInput<vtkDoubleArray>(EvenInteger);
  const Extraction empty = ExtractIntervals(random, { { 501, 501 } });
  catalogue.Measure("equal-bounds", "lower = upper, equal to no value", "number of tetrahedra",
    static_cast<double>(empty.Volume->GetNumberOfCells()), 0);

  auto mesh = MakeMesh(MeshKind::Tetrahedra5, Cells);
  AddIntegerField(mesh, 2, 3);
  const Range flat = { "f", 1, 1 };
  const double expected = static_cast<double>(ClippedVolume(mesh, { flat }));
  catalogue.Measure("equal-bounds-flat", "lower = upper = all values of some cells",
    "relative error of the volume of those cells",
    RelativeError(VolumeOf(mesh, { { 1, 1 } }), expected), VolumeBound);
}

void TestConstant(StabilityCatalogue& catalogue)
{
  auto mesh = MakeInput<vtkDoubleArray>([](vtkIdType) { return 3.0; });
  struct
  {
    const char* Name;
    std::vector<Interval> Intervals;
    int Holder; ///< index of the interval that contains the domain
  } const cases[] = { { "all-equal-lower", { { 3, 4 } }, 0 },
    { "all-equal-upper", { { 2, 3 } }, 0 }, { "all-equal-both", { { 3, 3 } }, 0 },
    { "all-equal-shared", { { 2, 3 }, { 3, 4 } }, 1 }, { "all-inside", { { 2, 4 } }, 0 } };
  for (const auto& one : cases)
  {
    const Extraction extraction = ExtractIntervals(mesh, one.Intervals);
    const double volume = static_cast<double>(MeasureInterval(extraction.Volume, one.Holder).Sum);
    catalogue.Measure(one.Name, "every value is 3", "relative error of the volume of the domain",
      RelativeError(volume, DomainVolume), VolumeBound);
    const TetrahedraVolume all = MeasureTetrahedra(extraction.Volume);
    catalogue.Measure(std::string(one.Name) + "-once", "every value is 3",
      "relative error of the volume in all intervals",
      RelativeError(static_cast<double>(all.SumOfAbsolute), DomainVolume), VolumeBound);
  }
  catalogue.Measure("all-outside", "every value is 3, interval [4, 5]", "number of tetrahedra",
    static_cast<double>(ExtractIntervals(mesh, { { 4, 5 } }).Volume->GetNumberOfCells()), 0);
  for (double value : { 2.0, 3.0, 4.0 })
  {
    catalogue.Measure("contour-constant-" + std::to_string(static_cast<int>(value)),
      "every value is 3", "number of triangles",
      static_cast<double>(ExtractContours(mesh, { value }).Surface->GetNumberOfCells()), 0);
  }
}

void TestUnsignedChar(StabilityCatalogue& catalogue)
{
  auto value = [](vtkIdType i)
  { return static_cast<unsigned char>(static_cast<int>(EvenInteger(i)) % 3 * 127 + i % 2); };
  auto mesh = MakeInput<vtkUnsignedCharArray>(value, MeshKind::Tetrahedra6);
  for (const Interval& interval :
    { Interval{ 0, 255 }, { -10, 300 }, { 0.5, 254.5 }, { 127, 128 }, { 127.5, 255 } })
  {
    const Range range = { "f", interval[0], interval[1] };
    catalogue.Measure(
      "unsigned-char-" + std::to_string(interval[0]) + "-" + std::to_string(interval[1]),
      "unsigned char values up to 255", "relative error of the volume",
      RelativeError(
        VolumeOf(mesh, { interval }), static_cast<double>(ClippedVolume(mesh, { range }))),
      VolumeBound);
  }
}

void TestSixtyFourBits(StabilityCatalogue& catalogue)
{
  // A double has 53 significant bits: at 2^62, it distinguishes multiples of 1024.
  const double shift = std::ldexp(1, 62);
  catalogue.Measure("int64-exact", "int64 values 2^62 + multiples of 1024",
    "number of tetrahedra that differ from the result without 2^62",
    DifferentSimplices<vtkTypeInt64Array>(1024, shift), 0);

  auto fine = MakeInput<vtkTypeInt64Array>([](vtkIdType i)
    { return (vtkTypeInt64(1) << 62) + static_cast<vtkTypeInt64>(EvenInteger(i)) / 8; });
  catalogue.Measure("int64-beyond-double",
    "int64 values 2^62 + 0 to 249, which a double cannot distinguish",
    "relative error of the domain's volume in two adjacent intervals",
    RelativeError(VolumeOf(fine, { { 0, shift }, { shift, 2 * shift } }), DomainVolume),
    VolumeBound);

  // Above 2^53, the next double after an integer is not the next integer.
  const auto base = vtkTypeInt64(1) << 60;
  auto few = MakeInput<vtkTypeInt64Array>([base](vtkIdType i)
    { return base + 1024 * (static_cast<vtkTypeInt64>(EvenInteger(i)) / 2 % 3); });
  const double lowest = std::ldexp(1, 60);
  catalogue.Measure("int64-tied",
    "int64 values 2^60 + 0, 1024, 2048, with bounds equal to the extremes",
    "relative error of the domain's volume in one interval",
    RelativeError(VolumeOf(few, { { lowest, lowest + 2048 } }), DomainVolume), VolumeBound);

  auto ends = [](vtkIdType i) { return static_cast<int>(EvenInteger(i)) % 4 == 0; };
  auto extreme = MakeInput<vtkTypeInt64Array>(
    [&](vtkIdType i)
    {
      return ends(i) ? std::numeric_limits<vtkTypeInt64>::min()
                     : std::numeric_limits<vtkTypeInt64>::max();
    },
    MeshKind::Tetrahedra5);
  const Range range = { "f", -shift, shift / 2 };
  catalogue.Measure("int64-ends", "the smallest and the largest int64 in one cell",
    "relative error of the volume",
    RelativeError(VolumeOf(extreme, { { range.Lower, range.Upper } }),
      static_cast<double>(ClippedVolume(extreme, { range }))),
    VolumeBound);

  auto largest = MakeInput<vtkTypeUInt64Array>([&](vtkIdType i)
    { return ends(i) ? 0 : std::numeric_limits<vtkTypeUInt64>::max(); },
    MeshKind::Tetrahedra5);
  const Range unsignedRange = { "f", shift, 3 * shift };
  catalogue.Measure("uint64-ends", "0 and the largest uint64 in one cell",
    "relative error of the volume",
    RelativeError(VolumeOf(largest, { { unsignedRange.Lower, unsignedRange.Upper } }),
      static_cast<double>(ClippedVolume(largest, { unsignedRange }))),
    VolumeBound);
}

void TestNotFinite(StabilityCatalogue& catalogue)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const double values[] = { nan, infinity, -infinity };
  auto mesh = MakeInput<vtkDoubleArray>(
    [&](vtkIdType i) { return i % 23 == 0 ? values[i % 3] : EvenInteger(i); }, MeshKind::Hexahedra);
  long long expected = 0;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    vtkIdType count;
    const vtkIdType* ids;
    mesh->GetCellPoints(cell, count, ids);
    expected += std::any_of(ids, ids + count, [](vtkIdType id) { return id % 23 == 0; }) ? 1 : 0;
  }
  const Extraction extraction = ExtractIntervals(mesh, { { -1, 3000 } });
  catalogue.Measure("not-finite-cells", "every 23rd value is NaN or infinite",
    "difference from the number of cells with such values",
    extraction.Report->GetNumber("NonFiniteCells") - static_cast<double>(expected), 0);
  catalogue.Measure("not-finite-volume", "every 23rd value is NaN or infinite",
    "relative error of the volume of the other cells",
    RelativeError(static_cast<double>(MeasureTetrahedra(extraction.Volume).Sum),
      static_cast<double>(mesh->GetNumberOfCells() - expected)),
    VolumeBound);

  auto all = MakeInput<vtkDoubleArray>([&](vtkIdType) { return nan; }, MeshKind::Hexahedra);
  const Extraction empty = ExtractIntervals(all, { { 0, 1 } });
  catalogue.Check("all-nan", "every value is NaN", "an empty output, every cell reported",
    std::to_string(empty.Volume->GetNumberOfCells()) + " tetrahedra, " +
      stability::FormatShort(empty.Report->GetNumber("NonFiniteCells")) + " cells reported",
    empty.Volume->GetNumberOfCells() == 0 &&
      empty.Report->GetNumber("NonFiniteCells") == all->GetNumberOfCells());

  auto other = MakeInput<vtkDoubleArray>(EvenInteger);
  const auto before = GeometricSet(ExtractIntervals(other, { { 501, 1203 } }).Volume);
  vtkNew<vtkDoubleArray> bad;
  bad->SetName("bad");
  bad->SetNumberOfTuples(other->GetNumberOfPoints());
  bad->FillValue(nan);
  other->GetPointData()->AddArray(bad);
  const bool same = GeometricSet(ExtractIntervals(other, { { 501, 1203 } }).Volume) == before;
  catalogue.Check("nan-elsewhere", "NaN in an array that is only interpolated",
    "the same tetrahedra", same ? "the same tetrahedra" : "other tetrahedra",
    same && !before.empty());
}

}

int TestStabilityValues(int argc, char* argv[])
{
  return stability::RunCases(__func__, "vtkIntervalVolume", argc, argv,
    { TestRanges, TestEqualBounds, TestConstant, TestUnsignedChar, TestSixtyFourBits,
      TestNotFinite });
}
