// SPDX-License-Identifier: BSD-3-Clause
// Tests slices of 4-simplices, and interval volumes that are written slab by slab, with extreme or
// non-finite times, degenerate 4-simplices, and empty or failing output.
#include "StabilityChecks.h"

#include "Support/Checks/ReferenceMessages.h"
#include "Support/Meshes/ReferenceVolume.h"
#include "Support/TimeVarying/ReferenceSimplexGrid.h"

#include "vtkAnalyticFieldSource.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSimplexTimeSlice.h"
#include "vtkTimeSlabWriter.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>

namespace
{

using namespace reference;
using namespace stability;
namespace files = std::filesystem;

/// Returns 4-simplices that fill [0,1]^3 x [0,3]. Times are multiplied by \a step and shifted by
/// \a offset, and coordinates are multiplied by \a size.
vtkSmartPointer<vtkUnstructuredGrid> MakeSimplices(
  double step = 1.0, double offset = 0.0, double size = 1.0)
{
  KuhnOptions options;
  options.MovedInSpace = 0.15;
  options.MovedInTime = 0.19;
  options.HasEqualTimes = true;
  auto grid = MakeKuhnGrid(options);
  auto* times = vtkDoubleArray::SafeDownCast(grid->GetPointData()->GetArray("Time"));
  std::transform(times->Begin(), times->End(), times->Begin(),
    [=](double time) { return step * time + offset; });
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    double x[3];
    grid->GetPoint(i, x);
    grid->GetPoints()->SetPoint(i, size * x[0], size * x[1], size * x[2]);
  }
  return grid;
}

double GetVolume(vtkSimplexTimeSlice* slice)
{
  const Messages messages = UpdateFilter(slice);
  return messages.Errors.empty() ? static_cast<double>(MeasureTetrahedra(slice->GetOutput()).Sum)
                                 : NaN;
}

void TestScales(StabilityCatalogue& catalogue)
{
  for (const double step : { 1e-200, 1e-9, 1.0, 1e9, 1e200 })
  {
    for (const double position : { 0.0, 1.0, 1.37, 3.0 })
    {
      vtkNew<vtkSimplexTimeSlice> slice;
      slice->SetInputData(MakeSimplices(step));
      slice->SetTime(position * step);
      catalogue.Measure("steps-" + FormatShort(step) + "-time-" + FormatShort(position),
        "steps " + FormatShort(step) + " apart, slice at step " + FormatShort(position),
        "error of the unit volume", GetVolume(slice) - 1.0, 1e-12);
    }
  }
  for (const double offset : { 0x1p40, -0x1p40 })
  {
    vtkNew<vtkSimplexTimeSlice> slice;
    slice->SetInputData(MakeSimplices(1.0, offset));
    slice->SetTime(offset + 1.375);
    catalogue.Measure("from-" + FormatShort(offset), "times starting at " + FormatShort(offset),
      "error of the unit volume", GetVolume(slice) - 1.0, 1e-12);
  }
  for (const double size : { 1e-90, 1e-9, 1e9, 1e90 })
  {
    vtkNew<vtkSimplexTimeSlice> slice;
    slice->SetInputData(MakeSimplices(1.0, 0.0, size));
    slice->SetTime(1.37);
    catalogue.Measure("size-" + FormatShort(size), "a cube of " + FormatShort(size),
      "relative error of the volume", GetVolume(slice) / size / size / size - 1.0, 1e-12);
  }
}

void TestAxes(StabilityCatalogue& catalogue)
{
  vtkNew<vtkSimplexTimeSlice> slice;
  for (const double step : { 1e-200, 1e-9, 1e9, 1e200 })
  {
    slice->SetInputData(MakeSimplices(step));
    slice->SetSliceAxis(vtkSimplexTimeSlice::Y_AXIS);
    slice->SetPosition(0.37);
    catalogue.Measure("along-y-steps-" + FormatShort(step),
      "a slice along y, steps " + FormatShort(step) + " apart", "relative error of the volume",
      GetVolume(slice) / 3.0 / step - 1.0, 1e-12);
  }
  slice->SetInputData(MakeSimplices());
  slice->SetSliceAxis(vtkSimplexTimeSlice::HYPERPLANE);
  for (const double length : { 1e-300, 1e-9, 1e9, 1e300 })
  {
    slice->SetNormal(0.0, 0.0, -length, 0.0);
    slice->SetPosition(-0.37 * length);
    catalogue.Measure("normal-" + FormatShort(length),
      "a hyperplane whose normal has the length " + FormatShort(length),
      "relative error of the volume", GetVolume(slice) / 3.0 - 1.0, 1e-12);
  }
  const auto mend = [&]()
  {
    slice->SetNormal(1.0, 1.0, 1.0, 1.0);
    slice->SetPosition(1.5);
  };
  for (const double value : { NaN, Infinity })
  {
    slice->SetPosition(value);
    ReportRejection(catalogue, slice, "position-" + FormatShort(value),
      "a slice at position " + FormatShort(value), "Position", mend);
    slice->SetNormal(0.0, value, 0.0, 0.0);
    ReportRejection(catalogue, slice, "normal-y-" + FormatShort(value),
      "a normal with a component " + FormatShort(value), "Normal", mend);
  }
  slice->SetNormal(0.0, 0.0, 0.0, 0.0);
  ReportRejection(catalogue, slice, "normal-zero", "a normal of zero length", "Normal", mend);
}

void TestSimplices(StabilityCatalogue& catalogue)
{
  vtkNew<vtkSimplexTimeSlice> slice;
  slice->SetInputData(MakeSimplices());
  const auto mend = [&]() { slice->SetTime(1.37); };
  for (const double t : { NaN, Infinity, -Infinity })
  {
    slice->SetTime(t);
    ReportRejection(catalogue, slice, "time-" + FormatShort(t), "a slice at time " + FormatShort(t),
      "finite", mend);
  }
  for (const double t : { -1e-9, 3.0 + 1e-9, 1e300 })
  {
    slice->SetTime(t);
    ReportEmpty(
      catalogue, slice, "outside-" + FormatShort(t), "a slice outside the time range", "time");
  }
  // 4-simplices with a time that is not finite are skipped, so an interior point with such a time
  // causes a hole.
  auto broken = MakeSimplices();
  auto* times = broken->GetPointData()->GetArray("Time");
  for (vtkIdType i = 0; i < times->GetNumberOfTuples(); i += 40)
  {
    times->SetComponent(i, 0, i % 80 == 0 ? NaN : Infinity);
  }
  slice->SetInputData(broken);
  mend();
  const double volume = GetVolume(slice);
  catalogue.Check("times-not-finite", "every fortieth time NaN or infinite",
    "a finite part of the volume", FormatShort(volume), volume > 0.3 && volume < 1.0);
  times->Fill(NaN);
  times->Modified();
  broken->Modified();
  ReportEmpty(catalogue, slice, "times-nan", "only NaN times", "");
  // All 4-simplices have the same time and lie in the slice.
  auto flat = MakeSimplices(0.0, 1.37);
  slice->SetInputData(flat);
  ReportEmpty(catalogue, slice, "times-equal", "4-simplices whose only time is the slice's", "");
  // Two of the five points coincide.
  auto point = MakeSimplexGrid({ { { 0, 0, 0, 0 } }, { { 1, 0, 0, 1 } }, { { 0, 1, 0, 2 } },
                                 { { 0, 0, 1, 3 } }, { { 0, 0, 0, 0 } } },
    { { { 0, 1, 2, 3, 4 } } });
  slice->SetInputData(point);
  catalogue.Measure(
    "two-points-one", "a 4-simplex with two coincident points", "volume", GetVolume(slice), 1e-15);
}

void SetInput(vtkTimeSlabWriter* writer, double first, double last, int steps)
{
  vtkNew<vtkAnalyticFieldSource> source;
  source->SetFieldToLinear();
  source->SetRate(0.0);
  source->SetDimensions(5, 5, 5);
  source->SetTimeRange(first, last);
  source->SetNumberOfTimeSteps(steps);
  writer->SetInputConnection(source->GetOutputPort());
  writer->SetInterval(0, -0.5, 0.25);
}

/// Returns the sum of the volumes of the tetrahedra of all slabs, each multiplied by its mean
/// DeltaT, or NaN if a file is missing.
double MeasureSlabs(const files::path& folder, int slabs)
{
  double sum = 0.0;
  for (int i = 0; i < slabs; ++i)
  {
    const files::path name = folder / "slabs" / ("slabs_" + std::to_string(i) + ".vtu");
    if (!files::exists(name))
    {
      return NaN;
    }
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    reader->SetFileName(name.string().c_str());
    reader->Update();
    vtkUnstructuredGrid* grid = reader->GetOutput();
    vtkDataArray* extents = grid->GetPointData()->GetArray("DeltaT");
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; extents && cell < grid->GetNumberOfCells(); ++cell)
    {
      grid->GetCellPoints(cell, ids);
      std::array<std::array<long double, 3>, 4> corners;
      double extent = 0.0;
      for (int c = 0; c < 4; ++c)
      {
        double x[3];
        grid->GetPoint(ids->GetId(c), x);
        std::copy_n(x, 3, corners[c].begin());
        extent += 0.25 * extents->GetComponent(ids->GetId(c), 0);
      }
      sum += extent *
        static_cast<double>(std::abs(Determinant(corners[0], corners[1], corners[2], corners[3]))) /
        6.0;
    }
  }
  return sum;
}

void TestWriter(StabilityCatalogue& catalogue)
{
  catalogue.SetClass("vtkTimeSlabWriter");
  const files::path folder = files::current_path() / "StabilitySlabs";
  for (const double step : { 1e-200, 1e-9, 1e9, 1e200 })
  {
    files::remove_all(folder);
    files::create_directories(folder);
    vtkNew<vtkTimeSlabWriter> writer;
    SetInput(writer, 0.0, 3.0 * step, 4);
    writer->SetFileName((folder / "slabs.vtm").string().c_str());
    bool isWritten = false;
    const std::string errors = CaptureErrors(writer, [&]() { isWritten = writer->Write(); });
    catalogue.Measure("steps-" + FormatShort(step),
      "four time steps, " + FormatShort(step) + " apart",
      "relative error of the hypervolume of all slabs" + errors,
      isWritten ? MeasureSlabs(folder, 3) / (0.75 * 4.0 * 3.0 * step) - 1.0 : NaN, 1e-6);
  }
  files::remove_all(folder);
  vtkNew<vtkTimeSlabWriter> writer;
  SetInput(writer, 0.0, 1.0, 3);
  writer->SetFileName("/dev/null/slabs.vtm");
  bool isWritten = true;
  const std::string errors = CaptureErrors(writer, [&]() { isWritten = writer->Write(); });
  catalogue.Check("no-folder", "a directory that cannot exist",
    "Write returns false, and the error names the directory", errors,
    !isWritten && errors.find("/dev/null") != std::string::npos);
}

}

int TestStabilitySlices(int argc, char* argv[])
{
  return RunCases(__func__, "vtkSimplexTimeSlice", argc, argv,
    { TestScales, TestAxes, TestSimplices, TestWriter });
}
