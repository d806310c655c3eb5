// SPDX-License-Identifier: BSD-3-Clause
// Tests inflow mappings, flow volumes, bands and parameters of stream surfaces with extreme
// settings and scales, and with empty results.
#include "StabilityChecks.h"

#include "Support/AnalyticFlows/ReferenceFlowResults.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Flow/ReferenceContourSurfaces.h"
#include "Support/Flow/ReferenceFlowGrid.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFlowStatus.h"
#include "vtkFlowVolume.h"
#include "vtkFlowVolumeFromVectors.h"
#include "vtkImageData.h"
#include "vtkInflowMapping.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamSurfaceParameters.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <limits>

namespace
{

using namespace reference;
using namespace stability;

/// Returns samples in a cube with uniform flow along x. They reach the plane x = 0 at the
/// parameters (y, z) / \a size, or no surface if \a isReached is false.
vtkSmartPointer<vtkImageData> MakeSamples(
  int points, double size = 1.0, double speed = 0.5, bool isReached = true)
{
  auto image =
    MakeFlowImage({ { points, points, points } }, { { 0.0, size, 0.0, size, 0.0, size } });
  AddFlow(image,
    [=](const double* x) -> FlowResult
    {
      return { isReached ? vtkFlowStatus::REACHED_SURFACE : vtkFlowStatus::OUT_OF_TIME, 0,
        x[1] / size, x[2] / size, x[0] / size / speed };
    },
    { { { 0, 0, 0 } } });
  return image;
}

vtkDataArray* GetInflow(vtkInflowMapping* mapping)
{
  return mapping->GetOutput()->GetPointData()->GetArray("Inflow");
}

/// Returns the number of values of Inflow that are not NaN.
double CountValues(vtkInflowMapping* mapping)
{
  vtkDataArray* inflow = GetInflow(mapping);
  double number = inflow ? 0.0 : NaN;
  for (vtkIdType i = 0; inflow && i < inflow->GetNumberOfTuples(); ++i)
  {
    number += std::isnan(inflow->GetComponent(i, 0)) ? 0.0 : 1.0;
  }
  return number;
}

void TestFormulas(StabilityCatalogue& catalogue, vtkInflowMapping* mapping)
{
  for (const char* formula : { "1/(u-u)", "ln(-1-u)", "1e308*10*(1+u)", "sqrt(-1-v)" })
  {
    mapping->SetFormula(vtkInflowMapping::ALL, formula);
    const Messages messages = UpdateFilter(mapping);
    catalogue.Measure(std::string("formula-") + formula, "a formula without a finite value",
      "values other than NaN, with a warning",
      messages.Errors.empty() && messages.Warnings.find("no finite value") != std::string::npos
        ? CountValues(mapping)
        : NaN,
      0.0);
  }
  for (const double size : { 1e-300, 1e300 })
  {
    mapping->SetFormula(vtkInflowMapping::ALL, ("u*" + FormatShort(size)).c_str());
    catalogue.Measure("value-" + FormatShort(size), "values of " + FormatShort(size),
      "relative error", mapping->Evaluate(0, 0.5, 0.5) / (0.5 * size) - 1.0, 1e-15);
  }
}

void TestRings(StabilityCatalogue& catalogue, vtkInflowMapping* mapping)
{
  mapping->RemoveAllMappings();
  mapping->AddRing(vtkInflowMapping::ALL, 0.5, 0.5, 0.0, 1e-300, 3.0);
  catalogue.Measure("ring-narrow", "a ring of width 1e-300", "error at its center and outside",
    std::abs(mapping->Evaluate(0, 0.5, 0.5) - 3.0) + std::abs(mapping->Evaluate(0, 0.6, 0.5)), 0.0);
  mapping->RemoveAllMappings();
  mapping->AddRing(vtkInflowMapping::ALL, 0.5, 0.5, 0.0, 1e300, -1e300);
  catalogue.Measure("ring-wide", "a ring of width 1e300 and amplitude -1e300", "relative error",
    mapping->Evaluate(0, 0.1, 0.9) / -1e300 - 1.0, 0.0);
  mapping->RemoveAllMappings();
}

vtkSmartPointer<vtkImageData> MakeConstantImage(int x, int y, int z, double value)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(x, y, z);
  image->AllocateScalars(VTK_DOUBLE, 1);
  image->GetPointData()->GetScalars()->Fill(value);
  return image;
}

void TestImages(StabilityCatalogue& catalogue, vtkInflowMapping* mapping)
{
  for (const double value : { 1e-300, 1e300 })
  {
    mapping->SetImage(vtkInflowMapping::ALL, MakeConstantImage(1, 1, 1, value));
    catalogue.Measure("image-1x1-" + FormatShort(value),
      "an image of one point of " + FormatShort(value), "relative error",
      mapping->Evaluate(0, 0.3, 0.9) / value - 1.0, 0.0);
    mapping->SetImage(vtkInflowMapping::ALL, MakeConstantImage(3, 4, 1, value));
    catalogue.Measure("image-beyond-" + FormatShort(value), "parameters of 1e300 outside an image",
      "relative error of the value at the image's edge",
      mapping->Evaluate(0, 1e300, -1e300) / value - 1.0, 1e-15);
  }
  mapping->SetImage(vtkInflowMapping::ALL, MakeConstantImage(3, 4, 1, NaN));
  const Messages messages = UpdateFilter(mapping);
  catalogue.Measure("image-nan", "an image of NaN", "values other than NaN, with a warning",
    messages.Warnings.find("no finite value") != std::string::npos ? CountValues(mapping) : NaN,
    0.0);
  mapping->SetImage(vtkInflowMapping::ALL, nullptr);
  mapping->SetFormula(vtkInflowMapping::ALL, "u");
}

void TestMapping(StabilityCatalogue& catalogue)
{
  catalogue.SetClass("vtkInflowMapping");
  vtkNew<vtkInflowMapping> mapping;
  mapping->SetInputData(MakeSamples(5));
  TestFormulas(catalogue, mapping);
  TestRings(catalogue, mapping);
  TestImages(catalogue, mapping);
  mapping->SetInputData(MakeSamples(5, 1.0, 0.5, false));
  const Messages messages = UpdateFilter(mapping);
  catalogue.Measure("none-reached", "no sample reaches a surface",
    "values other than NaN, with a warning",
    messages.Warnings.find("0 of them reached") != std::string::npos ? CountValues(mapping) : NaN,
    0.0);
}

/// Generates the flow volume of an inflow region, by default a cylinder above a disk.
struct Pipeline
{
  vtkNew<vtkInflowMapping> Mapping;
  vtkNew<vtkFlowVolume> Volume;

  explicit Pipeline(vtkDataSet* data, const char* formula = "(u-0.5)^2+(v-0.5)^2")
  {
    AllowWarnings(this->Mapping);
    this->Mapping->SetInputData(data);
    this->Mapping->SetFormula(vtkInflowMapping::ALL, formula);
    this->Volume->SetInputConnection(this->Mapping->GetOutputPort());
    this->Volume->SetInterval(0, -1.0, 0.09);
    this->Volume->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  }
};

void TestVolumeScales(StabilityCatalogue& catalogue)
{
  catalogue.SetClass("vtkFlowVolume");
  Pipeline plain(MakeSamples(13));
  plain.Volume->SetTimeRange(0.4, 1.5);
  const bool isPlain = UpdateFilter(plain.Volume).Errors.empty();
  const double expected = isPlain ? MeasureVolume(plain.Volume->GetOutput()) : NaN;
  catalogue.Measure("cylinder", "size 1, for comparison",
    "relative error of the volume of a cylinder", expected / (0.55 * 0.09 * vtkMath::Pi()) - 1.0,
    0.03);
  for (const double size : { 1e-90, 1e-6, 1e6, 1e90 })
  {
    for (const double speed : { 1e-200, 1e-6, 1e6, 1e200 })
    {
      Pipeline scaled(MakeSamples(13, size, 0.5 * speed));
      scaled.Volume->SetTimeRange(0.4 / speed, 1.5 / speed);
      const Messages messages = UpdateFilter(scaled.Volume);
      catalogue.Measure("size-" + FormatShort(size) + "-speed-" + FormatShort(speed),
        "a cube of " + FormatShort(size) + ", crossed in " + FormatShort(1.0 / speed),
        "relative difference from the volume at size 1",
        messages.Errors.empty() && messages.Warnings.empty()
          ? MeasureVolume(scaled.Volume->GetOutput()) / size / size / size / expected - 1.0
          : NaN,
        1e-12);
    }
  }
}

void TestVolumeSettings(StabilityCatalogue& catalogue)
{
  const double tiny = std::numeric_limits<double>::denorm_min();
  Pipeline pipeline(MakeSamples(9));
  const auto mend = [&]()
  {
    pipeline.Volume->SetNumberOfIntervals(1);
    pipeline.Volume->SetInterval(0, -1.0, 0.09);
    pipeline.Volume->SetTimeRange(0.0, 1.0);
  };
  pipeline.Volume->SetInterval(0, 0.05, 0.05);
  const Messages thin = UpdateFilter(pipeline.Volume);
  catalogue.Measure("interval-flat", "an interval from 0.05 to 0.05", "volume",
    thin.Errors.empty() ? MeasureVolume(pipeline.Volume->GetOutput()) : NaN, 1e-15);
  mend();
  pipeline.Volume->SetTimeRange(0.7, 0.7 + 1e-15);
  const Messages moment = UpdateFilter(pipeline.Volume);
  catalogue.Measure("times-flat", "times 1e-15 long", "volume",
    moment.Errors.empty() ? MeasureVolume(pipeline.Volume->GetOutput()) : NaN, 1e-14);
  mend();
  pipeline.Volume->SetInterval(0, 5.0, 6.0);
  ReportEmpty(catalogue, pipeline.Volume, "interval-outside",
    "an interval above all values of Inflow", "outside of the range of Inflow");
  mend();
  pipeline.Volume->SetTimeRange(1e300, 2e300);
  ReportEmpty(catalogue, pipeline.Volume, "times-late", "times from 1e300", "time range");
  mend();
  pipeline.Volume->SetTimeRange(-tiny, 1e308);
  pipeline.Volume->SetInterval(0, -1e308, 1e308);
  const Messages all = UpdateFilter(pipeline.Volume);
  catalogue.Measure("bounds-1e308", "interval and times up to 1e308",
    "relative error of the volume of the domain",
    all.Errors.empty() ? MeasureVolume(pipeline.Volume->GetOutput()) - 1.0 : NaN, 1e-13);
  // Adjacent intervals together fill the whole domain, but each interval adds rounding errors.
  for (int i = 0; i < 1000; ++i)
  {
    pipeline.Volume->SetInterval(i, -0.1 + 0.0007 * i, -0.1 + 0.0007 * (i + 1));
  }
  const Messages many = UpdateFilter(pipeline.Volume);
  catalogue.Measure("intervals-1000", "1,000 adjacent intervals",
    "relative error of the volume of the domain",
    many.Errors.empty() ? MeasureVolume(pipeline.Volume->GetOutput()) - 1.0 : NaN, 1e-11);

  Pipeline unreached(MakeSamples(5, 1.0, 0.5, false));
  ReportEmpty(
    catalogue, unreached.Volume, "none-reached", "no sample reaches a surface", "None of");
  Pipeline invalid(MakeSamples(5), "ln(-1-u)");
  ReportEmpty(catalogue, invalid.Volume, "inflow-nan", "Inflow that is NaN", "None of");
}

/// Returns the volume of the bands of a uniform flow along x through a cube, relative to half of
/// the cube, or NaN if there are messages.
double MeasureBands(double size, const Vector& velocity, int bands)
{
  const auto image = MakeFlowImage({ { 9, 9, 9 } }, { { 0.0, size, 0.0, size, 0.0, size } });
  AddVectors(image, [&velocity](const Vector&) { return velocity; });
  vtkNew<vtkFlowVolumeFromVectors> filter;
  filter->SetInputData(image);
  filter->SetNumberOfBands(bands);
  const Messages messages = UpdateFilter(filter);
  return messages.Errors.empty() && messages.Warnings.empty()
    ? MeasureVolume(filter->GetOutput()) / (0.5 * size) / size / size
    : NaN;
}

void TestBands(StabilityCatalogue& catalogue)
{
  catalogue.SetClass("vtkFlowVolumeFromVectors");
  // Cuts where the flow ends are located to an eighth of a cell.
  constexpr double accuracy = 0.03;
  for (const double size : { 1e-30, 1e-6, 1.0, 1e6, 1e30 })
  {
    for (const double speed : { 1e-200, 1.0, 1e200 })
    {
      catalogue.Measure("size-" + FormatShort(size) + "-speed-" + FormatShort(speed),
        "a cube of " + FormatShort(size) + " and speed " + FormatShort(speed),
        "relative error of the volume of five bands",
        MeasureBands(size, { { speed, 0.0, 0.0 } }, 5) - 1.0, accuracy);
    }
  }
  catalogue.Measure("bands-1000", "1,000 bands, narrower than a cell",
    "relative error of their volume", MeasureBands(1.0, { { 1.0, 0.0, 0.0 } }, 1000) - 1.0,
    accuracy);
  const auto image = MakeFlowImage({ { 5, 5, 5 } }, { { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 } });
  vtkNew<vtkFlowVolumeFromVectors> filter;
  filter->SetInputData(image);
  const auto set = [&image](double speed) {
    AddVectors(image, [speed](const Vector&) { return Vector{ { speed, 0.0, 0.0 } }; });
  };
  for (const double value : { 0.0, NaN, Infinity })
  {
    set(value);
    ReportRejection(catalogue, filter, "vectors-" + FormatShort(value),
      "vectors of " + FormatShort(value), "the field has no flow", [&set] { set(1.0); });
  }
}

/// Returns the length of the contour of a value, or NaN if there is not exactly one contour.
double MeasureContour(double size, double value, int resolution, const char* formula,
  std::string& words, double* largestS = nullptr, double scale = 1.0)
{
  vtkNew<Plane> plane;
  plane->SetId(0);
  plane->SetSize(size, size);
  Pipeline pipeline(MakeSamples(25, size), formula);
  pipeline.Volume->SetNumberOfIntervals(0);
  pipeline.Volume->SetStreamSurface(0, value);
  pipeline.Volume->GenerateStreamSurfacesOn();
  vtkNew<vtkStreamSurfaceParameters> parameters;
  parameters->SetInputConnection(pipeline.Volume->GetOutputPort(1));
  parameters->SetMapping(pipeline.Mapping);
  parameters->AddTerminationSurface(plane);
  parameters->SetResolution(resolution);
  parameters->SetLengthScale(scale);
  const Messages messages = UpdateFilter(parameters);
  words = messages.Errors + messages.Warnings;
  vtkDataArray* lengths = parameters->GetOutput()->GetFieldData()->GetArray("ContourLength");
  if (vtkDataArray* texture = parameters->GetOutput()->GetPointData()->GetTCoords())
  {
    double range[2];
    texture->GetRange(range, 0);
    if (largestS)
    {
      *largestS = range[1];
    }
  }
  return words.empty() && lengths && lengths->GetNumberOfTuples() == 1 ? lengths->GetComponent(0, 0)
                                                                       : NaN;
}

void TestParameters(StabilityCatalogue& catalogue)
{
  catalogue.SetClass("vtkStreamSurfaceParameters");
  const char* const circle = "(u-0.5)^2+(v-0.5)^2";
  std::string words;
  for (const double size : { 1e-100, 1e-6, 1.0, 1e6, 1e100 })
  {
    const double length = MeasureContour(size, 0.09, 256, circle, words);
    catalogue.Measure("circle-" + FormatShort(size),
      "a circle on a plane of size " + FormatShort(size), "relative error of its length" + words,
      length / (0.6 * vtkMath::Pi() * size) - 1.0, 2e-5);
  }
  for (const int resolution : { -1, 4, 16, 64, 1024 })
  {
    const double squares = std::max(4, resolution);
    const double length = MeasureContour(1.0, 0.09, resolution, circle, words);
    catalogue.Measure("resolution-" + std::to_string(resolution),
      "contours on a grid of " + FormatShort(squares) + " squares per axis",
      "relative error of a circle's length" + words, length / (0.6 * vtkMath::Pi()) - 1.0,
      4.0 / squares / squares);
  }
  // The contour lies inside a square and encloses none of the square's corners, so it is not found.
  double along = NaN;
  MeasureContour(1.0, 0.0036, 4, "(u-0.62)^2+(v-0.62)^2", words, &along);
  catalogue.Measure("contour-small", "a contour smaller than a square", "largest s", along, 0.0);
  for (const double scale : { 0.0, 1e-300, 1e300 })
  {
    const double length = MeasureContour(1.0, 0.09, 64, circle, words, &along, scale);
    catalogue.Measure("scale-" + FormatShort(scale), "LengthScale " + FormatShort(scale),
      "largest s, relative to length and scale, minus 1.2",
      scale == 0.0 ? along : std::max(0.0, along / length / scale - 1.2), 0.0);
  }
  // A thousand contours in one update.
  Pipeline pipeline(MakeSamples(9), "u");
  vtkNew<Plane> plane;
  plane->SetId(0);
  pipeline.Volume->SetNumberOfIntervals(0);
  pipeline.Volume->GenerateStreamSurfacesOn();
  for (int i = 0; i < 1000; ++i)
  {
    pipeline.Volume->SetStreamSurface(i, (i + 0.5) / 1000.0);
  }
  vtkNew<vtkStreamSurfaceParameters> parameters;
  parameters->SetInputConnection(pipeline.Volume->GetOutputPort(1));
  parameters->SetMapping(pipeline.Mapping);
  parameters->AddTerminationSurface(plane);
  parameters->Update();
  vtkDataArray* lengths = parameters->GetOutput()->GetFieldData()->GetArray("ContourLength");
  catalogue.Measure("contours-1000", "1,000 straight contours of length 1",
    "lengths not within 1e-12 of 1, and missing contours",
    CountOutside(lengths, 1.0 - 1e-12, 1.0 + 1e-12) + 1000.0 -
      static_cast<double>(lengths->GetNumberOfTuples()),
    0.0);
  vtkNew<vtkPolyData> nothing;
  parameters->SetInputData(nothing);
  ReportEmpty(catalogue, parameters, "empty", "an input without cells", "no triangles");
}

}

int TestStabilityInflow(int argc, char* argv[])
{
  return RunCases(__func__, "", argc, argv,
    { TestMapping, TestVolumeScales, TestVolumeSettings, TestBands, TestParameters });
}
