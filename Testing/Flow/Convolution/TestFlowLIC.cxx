// SPDX-License-Identifier: BSD-3-Clause
// vtkFlowLIC: values compared with brute-force quadrature, contrast, coherence along streamlines,
// ends of streamlines, points outside the field and points at rest, dataset types, threads and
// errors.
#include "Support/AnalyticFlows/ReferenceNoise.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceExecution.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Checks/ReferenceProgress.h"
#include "Support/Checks/ReferenceRandom.h"
#include "Support/Flow/ReferenceFlowGrid.h"
#include "Support/Meshes/ReferenceImageSource.h"

#include "vtkFlowLIC.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPlaneSource.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkTriangle.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace
{

using namespace reference;

constexpr double Pi = 3.14159265358979324;
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/// Parameters of vtkFlowLIC.
struct Setting
{
  bool IsHann = true;
  double Length = 1.0;
  double Scale = 0.25;
  double Step = 0.01;
  int Seed = 5;
};

double GetKernel(const Setting& setting, double s)
{
  return setting.IsHann ? 0.5 * (1.0 + std::cos(Pi * s / setting.Length)) : 1.0;
}

/// Returns the kernel-weighted mean of the noise at line(s), with s from -back to front.
double GetMean(
  const Setting& setting, const std::function<Vector(double)>& line, double back, double front)
{
  constexpr int parts = 1000;
  double sum = 0.0;
  double weights = 0.0;
  for (int i = 0; i < parts; ++i)
  {
    const double s = -back + (back + front) * (i + 0.5) / parts;
    const double weight = GetKernel(setting, s);
    sum += weight * GetNoise(line(s), setting.Scale, setting.Seed);
    weights += weight;
  }
  return sum / weights;
}

/// Returns the covariance of one-dimensional noise at two positions \a distance apart, if values at
/// grid points have unit variance: the autocorrelation of the tent function.
double GetCorrelation(double distance)
{
  constexpr int parts = 200;
  double sum = 0.0;
  for (int i = 0; i < parts; ++i)
  {
    const double t = -1.0 + 2.0 * (i + 0.5) / parts;
    sum += GetTent(t) * GetTent(t + distance);
  }
  return 2.0 * sum / parts;
}

/// Returns the standard deviation of GetMean() for straight lines, from covariances of the noise
/// that are averaged over random directions.
double GetDeviation(const Setting& setting, double back, double front)
{
  std::vector<double> correlations;
  for (int i = 0; i <= 1000; ++i)
  {
    correlations.push_back(GetCorrelation(0.002 * i));
  }
  const int parts = std::max(2, static_cast<int>((back + front) / setting.Scale * 16.0));
  const double part = (back + front) / parts;
  std::vector<double> covariances(parts, 0.0);
  Random random(3);
  constexpr int directions = 3000;
  for (int direction = 0; direction < directions; ++direction)
  {
    const Vector d = random.GetDirection();
    for (int i = 0; i < parts; ++i)
    {
      double product = 1.0 / 12.0 / directions;
      for (int axis = 0; axis < 3; ++axis)
      {
        const auto position =
          static_cast<std::size_t>(std::abs(d[axis]) * i * part / setting.Scale * 500.0 + 0.5);
        product *= position < correlations.size() ? correlations[position] : 0.0;
      }
      covariances[i] += product;
    }
  }
  double sum = 0.0;
  double weights = 0.0;
  for (int i = 0; i < parts; ++i)
  {
    const double weight = GetKernel(setting, -back + part * (i + 0.5));
    weights += weight;
    for (int j = 0; j < parts; ++j)
    {
      sum += weight * GetKernel(setting, -back + part * (j + 0.5)) * covariances[std::abs(i - j)];
    }
  }
  return std::sqrt(sum) / weights;
}

vtkSmartPointer<vtkFlowLIC> MakeFilter(const Setting& setting)
{
  auto filter = vtkSmartPointer<vtkFlowLIC>::New();
  filter->SetKernel(setting.IsHann ? vtkFlowLIC::HANN : vtkFlowLIC::BOX);
  filter->SetLength(setting.Length);
  filter->SetNoiseScale(setting.Scale);
  filter->SetStepLength(setting.Step);
  filter->SetSeed(setting.Seed);
  return filter;
}

/// Returns an image with bounds [-2, 2] along each axis.
vtkSmartPointer<vtkImageData> MakeImage(int points, const VectorField& field)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(points, points, points);
  image->SetOrigin(-2.0, -2.0, -2.0);
  const double spacing = 4.0 / (points - 1);
  image->SetSpacing(spacing, spacing, spacing);
  AddVectors(image, field);
  return image;
}

vtkSmartPointer<vtkPolyData> MakePoints(const std::vector<Vector>& positions)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vector& position : positions)
  {
    points->InsertNextPoint(position.data());
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  return data;
}

std::vector<Vector> MakePositions(int number, double size)
{
  Random random(11);
  std::vector<Vector> positions;
  for (int i = 0; i < number; ++i)
  {
    positions.push_back(random.GetPoint(size));
  }
  return positions;
}

double GetValue(vtkAlgorithm* filter, vtkIdType id)
{
  auto* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  vtkDataArray* values = output->GetPointData()->GetArray("LIC");
  return values ? values->GetComponent(id, 0) : NaN;
}

Vector Uniform(const Vector&)
{
  return { { 0.6, -1.2, 0.8 } };
}

Vector Rotation(const Vector& x)
{
  return { { -3.0 * x[1], 3.0 * x[0], 0.0 } };
}

/// Compares values at points with quadrature along known streamlines.
void TestValues(Check& check, const std::string& name, const VectorField& field,
  const std::function<Vector(const Vector&, double)>& line)
{
  for (const bool isHann : { true, false })
  {
    for (const double scale : { 0.25, 0.1 })
    {
      Setting setting;
      setting.IsHann = isHann;
      setting.Scale = scale;
      check.SetContext(name + (isHann ? ", Hann, " : ", box, ") + std::to_string(scale) + ": ");
      const std::vector<Vector> positions = MakePositions(60, 0.7);
      const vtkSmartPointer<vtkFlowLIC> filter = MakeFilter(setting);
      filter->SetInputData(MakePoints(positions));
      filter->SetFieldData(MakeImage(9, field));
      check.That(UpdateAndGetErrors(filter).empty(), "no messages");
      const double deviation = GetDeviation(setting, setting.Length, setting.Length);
      double largest = 0.0;
      for (std::size_t i = 0; i < positions.size(); ++i)
      {
        const double mean = GetMean(
          setting, [&](double s) { return line(positions[i], s); }, setting.Length, setting.Length);
        const double expected = std::clamp(0.5 + 0.2 * (mean - 0.5) / deviation, 0.0, 1.0);
        largest =
          std::max(largest, std::abs(GetValue(filter, static_cast<vtkIdType>(i)) - expected));
      }
      check.That(largest <= 0.008, "error " + std::to_string(largest));
      check.Equal(filter->GetReport()->GetCount("PointsWithShortLines"), 0, "short streamlines");
      check.Equal(filter->GetReport()->GetCount("Steps"), 100, "steps");
    }
  }
}

/// With few samples per streamline, the end weights of the trapezoidal rule matter. The difference
/// between a value and 1/2 is proportional to the trapezoidal sum of the noise minus 1/2.
void TestWeights(Check& check)
{
  check.SetContext("weights: ");
  Setting setting;
  setting.IsHann = false;
  setting.Step = 0.5;
  const std::vector<Vector> positions = MakePositions(30, 0.7);
  const vtkSmartPointer<vtkFlowLIC> filter = MakeFilter(setting);
  filter->SetContrast(0.05);
  filter->SetInputData(MakePoints(positions));
  filter->SetFieldData(MakeImage(9, Uniform));
  filter->Update();
  double factor = 0.0;
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    double sum = 0.0;
    for (int j = -2; j <= 2; ++j)
    {
      const double s = 0.5 * j / GetNorm(Uniform(positions[i]));
      const Vector x = { { positions[i][0] + 0.6 * s, positions[i][1] - 1.2 * s,
        positions[i][2] + 0.8 * s } };
      sum += (std::abs(j) == 2 ? 0.125 : 0.25) * (GetNoise(x, setting.Scale, setting.Seed) - 0.5);
    }
    const double found = GetValue(filter, static_cast<vtkIdType>(i)) - 0.5;
    factor = i == 0 ? found / sum : factor;
    check.Near(found, factor * sum, 1e-4, "value", 1.0);
  }
}

/// If a streamline leaves the field, its mean is normalized with the standard deviation for the
/// truncated kernel.
void TestEnds(Check& check)
{
  Setting setting;
  const auto along = [](const Vector&) { return Vector{ { 2.0, 0.0, 0.0 } }; };
  const std::vector<Vector> positions = { { { 1.605, 0.3, 0.1 } }, { { -1.905, 0.2, -0.7 } },
    { { 1.805, -0.3, 0.6 } }, { { 0.005, 1.1, 0.9 } } };
  for (const bool isHann : { true, false })
  {
    setting.IsHann = isHann;
    check.SetContext(isHann ? "ends, Hann: " : "ends, box: ");
    const vtkSmartPointer<vtkFlowLIC> filter = MakeFilter(setting);
    filter->SetInputData(MakePoints(positions));
    filter->SetFieldData(MakeImage(9, along));
    filter->Update();
    check.Equal(filter->GetReport()->GetCount("PointsWithShortLines"), 3, "short streamlines");
    for (std::size_t i = 0; i < positions.size(); ++i)
    {
      // A streamline that leaves the field ends after the last full step inside it. Its last
      // sample represents another half step.
      const auto reach = [&](double space)
      { return std::min(setting.Length, std::floor(space / setting.Step) * setting.Step); };
      const auto part = [&](double r) { return r + (r < setting.Length ? setting.Step / 2 : 0.0); };
      const double back = part(reach(positions[i][0] + 2.0));
      const double front = part(reach(2.0 - positions[i][0]));
      const double mean = GetMean(
        setting,
        [&](double s) {
          return Vector{ { positions[i][0] + s, positions[i][1], positions[i][2] } };
        },
        back, front);
      const double expected =
        std::clamp(0.5 + 0.2 * (mean - 0.5) / GetDeviation(setting, back, front), 0.0, 1.0);
      check.Near(GetValue(filter, static_cast<vtkIdType>(i)), expected, 0.008,
        "point " + std::to_string(i), 1.0);
    }
  }
}

/// The mean and standard deviation over a volume do not depend on the kernel and its length.
void TestContrast(Check& check)
{
  for (const double length : { 0.05, 0.5, 1.5 })
  {
    for (const bool isHann : { true, false })
    {
      Setting setting;
      setting.IsHann = isHann;
      setting.Length = length;
      setting.Scale = 0.1;
      setting.Step = 0.025;
      check.SetContext("contrast, length " + std::to_string(length) + ": ");
      const vtkSmartPointer<vtkFlowLIC> filter = MakeFilter(setting);
      filter->SetContrast(0.1);
      filter->SetInputData(MakePoints(MakePositions(4000, 2.0)));
      filter->SetFieldData(MakeImage(9, Uniform));
      filter->Update();
      double sum = 0.0;
      double squares = 0.0;
      const vtkIdType number = filter->GetReport()->GetNumber("Points");
      for (vtkIdType id = 0; id < number; ++id)
      {
        sum += GetValue(filter, id);
        squares += std::pow(GetValue(filter, id), 2);
      }
      const double mean = sum / static_cast<double>(number);
      check.Near(mean, 0.5, 0.02, "mean", 1.0);
      check.Near(
        std::sqrt(squares / static_cast<double>(number) - mean * mean), 0.1, 0.06, "deviation");
    }
  }
}

/// Neighboring points on one streamline have similar values. Neighboring points on different
/// streamlines do not.
void TestCoherence(Check& check)
{
  check.SetContext("coherence: ");
  Setting setting;
  setting.Scale = 0.05;
  setting.Step = 0.0125;
  double along = 0.0;
  double across = 0.0;
  std::vector<Vector> positions;
  Random random(4);
  constexpr double distance = 0.1;
  for (int i = 0; i < 1000; ++i)
  {
    const double radius = random.Get(0.6, 1.6);
    const double angle = random.Get(0.0, 2.0 * Pi);
    const double z = random.Get(-1.5, 1.5);
    const auto add = [&](double r, double a) {
      positions.push_back({ { r * std::cos(a), r * std::sin(a), z } });
    };
    add(radius, angle);
    add(radius, angle + distance / radius);
    add(radius + distance, angle);
  }
  const vtkSmartPointer<vtkFlowLIC> filter = MakeFilter(setting);
  filter->SetInputData(MakePoints(positions));
  filter->SetFieldData(MakeImage(9, Rotation));
  filter->Update();
  for (vtkIdType i = 0; i < 3000; i += 3)
  {
    along += std::pow(GetValue(filter, i + 1) - GetValue(filter, i), 2);
    across += std::pow(GetValue(filter, i + 2) - GetValue(filter, i), 2);
  }
  check.That(
    across >= 8.0 * along, "across " + std::to_string(across) + ", along " + std::to_string(along));
  check.Near(std::sqrt(across / 2000.0), 0.2, 0.1, "deviation across streamlines");
}

/// The value is 0 at points outside the field, and these points are counted. Points at rest have
/// the value of the noise.
void TestOutside(Check& check)
{
  check.SetContext("outside: ");
  Setting setting;
  const std::vector<Vector> positions = { { { 0.1, 0.2, 0.3 } }, { { 2.1, 0.0, 0.0 } },
    { { 0.0, -9.0, 0.0 } }, { { 0.0, 0.0, NaN } } };
  vtkSmartPointer<vtkFlowLIC> filter = MakeFilter(setting);
  filter->SetInputData(MakePoints(positions));
  filter->SetFieldData(MakeImage(5, Uniform));
  check.That(UpdateAndGetErrors(filter).empty(), "no messages");
  check.Equal(filter->GetReport()->GetCount("Points"), 4, "points");
  check.Equal(filter->GetReport()->GetCount("PointsOutside"), 3, "points outside");
  check.That(GetValue(filter, 0) > 0.0, "inside");
  for (vtkIdType id = 1; id < 4; ++id)
  {
    check.That(GetValue(filter, id) == 0.0, "the value is 0 outside");
  }
  check.SetContext("at rest: ");
  const double deviation = GetDeviation(setting, 0.0, 1e-9);
  const VectorField fields[2] = { [](const Vector&) {
                                   return Vector{ { 0.0, 0.0, 0.0 } };
                                 },
    [](const Vector&) {
      return Vector{ { NaN, 0.0, 0.0 } };
    } };
  for (const VectorField& field : fields)
  {
    filter = MakeFilter(setting);
    const std::vector<Vector> inside = MakePositions(40, 1.9);
    filter->SetInputData(MakePoints(inside));
    filter->SetFieldData(MakeImage(5, field));
    const bool isFinite = std::isfinite(field({ { 0.0, 0.0, 0.0 } })[0]);
    const std::string warning = WarningsOf(filter);
    check.That(isFinite ? warning.empty() : warning.find("NaN or infinite") != std::string::npos,
      "a warning for NaN only");
    check.Equal(filter->GetReport()->GetCount("PointsAtRest"), 40, "points at rest");
    check.Equal(filter->GetReport()->GetCount("PointsWithShortLines"), 0,
      "points at rest are not counted as short streamlines");
    for (std::size_t i = 0; i < inside.size(); ++i)
    {
      const double noise = GetNoise(inside[i], setting.Scale, setting.Seed);
      check.Near(GetValue(filter, static_cast<vtkIdType>(i)),
        std::clamp(0.5 + 0.2 * (noise - 0.5) / deviation, 0.0, 1.0), 0.01, "noise", 1.0);
    }
  }
}

/// A streamline does not jump back and forth across a sink.
void TestSink(Check& check)
{
  check.SetContext("sink: ");
  Setting setting;
  setting.Step = 0.04;
  const auto sink = [](const Vector& x) { return Vector{ { -x[0], -x[1], -x[2] } }; };
  const vtkSmartPointer<vtkFlowLIC> filter = MakeFilter(setting);
  filter->SetInputData(MakePoints({ { { 0.5, 0.1, 0.1 } }, { { 1.3, 0.0, 0.0 } } }));
  filter->SetFieldData(MakeImage(10, sink));
  filter->Update();
  // One streamline ends at the sink, the other at the boundary of the box.
  check.Equal(filter->GetReport()->GetCount("PointsWithShortLines"), 2, "short streamlines");
  const double size = std::sqrt(0.27);
  const double mean = GetMean(
    setting,
    [&](double s) {
      return Vector{ { 0.5 * (1 - s / size), 0.1 * (1 - s / size), 0.1 * (1 - s / size) } };
    },
    1.0, 0.5);
  const double expected = 0.5 + 0.2 * (mean - 0.5) / GetDeviation(setting, 1.0, 0.5);
  check.Near(GetValue(filter, 0), expected, 0.03, "value", 1.0);
}

/// Values do not depend on the type of the dataset that provides the field or the points.
void TestDatasets(Check& check)
{
  Setting setting;
  setting.Length = 0.5;
  setting.Step = 0.05;
  const auto shear = [](const Vector& x) { return Vector{ { 1.0, 0.25 * x[2], 0.0 } }; };
  const auto grids = MakeFlowGrids();
  std::vector<Vector> positions;
  for (const Vector& position : MakePositions(50, 1.3))
  {
    positions.push_back({ { position[0] + 2.0, position[1] + 2.0, position[2] + 2.0 } });
  }
  std::vector<double> values;
  for (const auto& grid : grids)
  {
    check.SetContext(grid.first + ": ");
    AddVectors(grid.second, shear);
    const vtkSmartPointer<vtkFlowLIC> filter = MakeFilter(setting);
    filter->SetInputData(MakePoints(positions));
    filter->SetFieldData(grid.second);
    check.That(UpdateAndGetErrors(filter).empty(), "no messages");
    for (vtkIdType id = 0; id < 50; ++id)
    {
      if (values.size() < 50)
      {
        values.push_back(GetValue(filter, id));
      }
      check.Near(GetValue(filter, id), values[id], 1e-6, "value", 1.0);
    }
    // If there is no separate field, the input is the field, and values are computed at its points.
    const vtkSmartPointer<vtkFlowLIC> own = MakeFilter(setting);
    own->SetInputData(grid.second);
    check.That(UpdateAndGetErrors(own).empty(), "no messages without points input");
    auto* output = vtkDataSet::SafeDownCast(own->GetOutputDataObject(0));
    check.That(output->IsA(grid.second->GetClassName()), "type");
    check.Equal(output->GetNumberOfCells(), grid.second->GetNumberOfCells(), "cells");
    check.Equal(own->GetReport()->GetCount("PointsOutside"), 0, "points outside");
    check.That(output->GetPointData()->GetScalars() == output->GetPointData()->GetArray("LIC"),
      "active scalars");
    check.That(grid.second->GetPointData()->GetArray("LIC") == nullptr, "the input is unchanged");
  }
}

/// Settings that are 0, the default, are replaced with values derived from the bounds.
void TestDefaults(Check& check)
{
  check.SetContext("defaults: ");
  vtkNew<vtkFlowLIC> filter;
  filter->SetFieldData(MakeImage(5, Uniform));
  filter->SetInputData(MakePoints(MakePositions(125, 2.0)));
  filter->Update();
  vtkInterlumeReport* report = filter->GetReport();
  double box[6];
  filter->GetOutput()->GetBounds(box);
  const double scale =
    GetNorm(std::array<double, 3>{ { box[1] - box[0], box[3] - box[2], box[5] - box[4] } }) / 128.0;
  check.Near(report->GetNumber("NoiseScale"), scale, 1e-12, "scale");
  check.Near(report->GetNumber("Length"), 10.0 * scale, 1e-12, "length");
  check.Equal(report->GetCount("Steps"), 40, "steps");
  check.Near(report->GetNumber("StepLength"), 0.25 * scale, 1e-12, "step");
  filter->SetStepLength(0.3 * scale);
  filter->Update();
  check.Equal(filter->GetReport()->GetCount("Steps"), 34, "steps over the full length");
  check.Near(filter->GetReport()->GetNumber("StepLength"), scale / 3.4, 1e-12, "a shorter step");
  filter->SetSeed(-1);
  std::vector<double> before;
  for (vtkIdType id = 0; id < 125; ++id)
  {
    before.push_back(GetValue(filter, id));
  }
  filter->Update();
  int changed = 0;
  for (vtkIdType id = 0; id < 125; ++id)
  {
    changed += std::abs(before[id] - GetValue(filter, id)) > 1e-3 ? 1 : 0;
  }
  check.That(changed > 110, "another seed changes the values");
  check.SetContext("cells larger than the noise: ");
  vtkNew<vtkFlowLIC> coarse;
  coarse->SetInputData(MakeImage(5, Uniform));
  coarse->Update();
  check.Near(coarse->GetReport()->GetNumber("NoiseScale"), 2.0, 1e-12, "scale");
}

vtkPolyData* GetSurface(vtkFlowLIC* filter)
{
  return vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
}

/// Tests the lengths of edges, the area, and that each inner edge belongs to two triangles.
void CheckTriangles(vtkPolyData* surface, double length, double expectedArea, Check& check)
{
  double area = 0.0;
  double longest = 0.0;
  std::map<std::pair<vtkIdType, vtkIdType>, int> edges;
  for (vtkIdType id = 0; id < surface->GetNumberOfCells(); ++id)
  {
    vtkCell* triangle = surface->GetCell(id);
    area += vtkTriangle::SafeDownCast(triangle)->ComputeArea();
    for (int edge = 0; edge < 3; ++edge)
    {
      longest = std::max(longest, std::sqrt(triangle->GetEdge(edge)->GetLength2()));
      const vtkIdType a = triangle->GetPointId(edge);
      const vtkIdType b = triangle->GetPointId((edge + 1) % 3);
      ++edges[{ std::min(a, b), std::max(a, b) }];
    }
  }
  check.Near(area, expectedArea, 1e-4, "area");
  check.That(longest <= length * (1.0 + 1e-6), "edges");
  const auto isInside = [surface](vtkIdType id)
  {
    double x[3];
    surface->GetPoint(id, x);
    return std::abs(x[0]) < 1.999 && std::abs(x[1]) < 1.499;
  };
  const auto open = std::count_if(edges.begin(), edges.end(),
    [&](const auto& edge)
    { return edge.second != 2 && isInside(edge.first.first) && isInside(edge.first.second); });
  check.Equal(static_cast<long long>(open), 0, "inner edges without two triangles");
}

/// Returns a rectangle around the z-axis, in the plane z = 0.5.
vtkSmartPointer<vtkPlaneSource> MakePlane(double halfX, double halfY, int columns, int rows)
{
  auto plane = vtkSmartPointer<vtkPlaneSource>::New();
  plane->SetOrigin(-halfX, -halfY, 0.5);
  plane->SetPoint1(halfX, -halfY, 0.5);
  plane->SetPoint2(-halfX, halfY, 0.5);
  plane->SetResolution(columns, rows);
  return plane;
}

/// Tests refined surfaces and their attributes, the limit of triangles, and that without surfaces
/// nothing is refined.
void TestRefinement(Check& check)
{
  check.SetContext("refined surface: ");
  const auto plane = MakePlane(2.0, 1.5, 7, 2);
  plane->Update();
  vtkNew<vtkPolyData> input;
  input->ShallowCopy(plane->GetOutput());
  vtkNew<vtkDoubleArray> rows;
  rows->SetName("cell");
  for (vtkIdType id = 0; id < input->GetNumberOfCells(); ++id)
  {
    rows->InsertNextValue(static_cast<double>(id));
  }
  input->GetCellData()->AddArray(rows);
  vtkNew<vtkFlowLIC> filter;
  filter->SetInputData(input);
  filter->SetFieldData(MakeImage(5, Uniform));
  filter->RefineSurfaceOn();
  filter->SetNoiseScale(0.2);
  check.That(UpdateAndGetErrors(filter).empty(), "no messages");
  check.Near(filter->GetReport()->GetNumber("NoiseScale"), 0.2, 1e-12, "scale");
  vtkPolyData* surface = GetSurface(filter);
  CheckTriangles(surface, 0.1, 12.0, check);
  for (vtkIdType id = 0; id < surface->GetNumberOfCells(); id += 10)
  {
    double box[6];
    surface->GetCellBounds(id, box);
    const double column = std::floor((0.5 * (box[0] + box[1]) + 2.0) / (4.0 / 7.0));
    check.Near(surface->GetCellData()->GetArray("cell")->GetComponent(id, 0),
      column + (box[2] + box[3] > 0.0 ? 7.0 : 0.0), 0.0, "copied cell array");
  }
  for (vtkIdType id = 0; id < surface->GetNumberOfPoints(); id += 100)
  {
    double x[3];
    surface->GetPoint(id, x);
    const double u = surface->GetPointData()->GetTCoords()->GetComponent(id, 0);
    check.Near(u, 0.25 * (x[0] + 2.0), 1e-5, "interpolated texture coordinate", 1.0);
  }
  check.SetContext("limit of triangles: ");
  for (const double scale : { 0.0, 1e-9, 1e-300 })
  {
    filter->SetNoiseScale(scale);
    filter->SetLength(scale);
    check.That(UpdateAndGetErrors(filter).empty(), "no messages");
    const double used = filter->GetReport()->GetNumber("NoiseScale");
    check.That(scale > 0.0 ? used == scale : used > 5.0 / 128.0, "scale");
    const vtkIdType triangles = GetSurface(filter)->GetNumberOfCells();
    check.That(triangles > 10000 && triangles < 60000, std::to_string(triangles));
    CheckTriangles(GetSurface(filter), scale > 0.0 ? 1.0 : 0.5 * used, 12.0, check);
  }
  filter->SetInputData(MakePoints(MakePositions(20, 2.0)));
  check.That(UpdateAndGetErrors(filter).empty(), "no messages without polygons");
  check.Equal(filter->GetOutput()->GetNumberOfPoints(), 20, "points");
}

/// The same streaks appear with and without a component of the flow across the surface, if it is
/// projected.
void TestProjection(Check& check)
{
  check.SetContext("projection: ");
  const auto plane = MakePlane(1.0, 1.0, 9, 9);
  const Setting setting;
  const vtkSmartPointer<vtkFlowLIC> along = MakeFilter(setting);
  along->SetInputConnection(plane->GetOutputPort());
  along->SetFieldData(MakeImage(5, [](const Vector&) { return Vector{ { 0.6, -1.2, 0.0 } }; }));
  along->Update();
  const vtkSmartPointer<vtkFlowLIC> across = MakeFilter(setting);
  across->SetInputConnection(plane->GetOutputPort());
  across->SetFieldData(MakeImage(5, [](const Vector&) { return Vector{ { 0.6, -1.2, 5.0 } }; }));
  for (const bool isProjected : { false, true })
  {
    across->SetProjectVectors(isProjected);
    across->Update();
    double largest = 0.0;
    for (vtkIdType id = 0; id < 100; ++id)
    {
      largest = std::max(largest, std::abs(GetValue(across, id) - GetValue(along, id)));
    }
    check.That(
      isProjected ? largest < 1e-5 : largest > 0.2, "difference " + std::to_string(largest));
  }
}

void TestThreads(Check& check)
{
  check.SetContext("threads: ");
  std::vector<float> values;
  for (const int threads : { 1, 2, 7 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads },
      [&]
      {
        vtkNew<vtkFlowLIC> filter;
        filter->SetInputData(MakeImage(21, Rotation));
        filter->Update();
        std::vector<float> found;
        for (vtkIdType id = 0; id < filter->GetReport()->GetNumber("Points"); ++id)
        {
          found.push_back(static_cast<float>(GetValue(filter, id)));
        }
        check.Equal(static_cast<long long>(found.size()), 9261, "points");
        check.Equal(filter->GetReport()->GetCount("PointsAtRest"), 21, "points on the axis");
        check.That(values.empty() || values == found, "values");
        values = found;
      });
  }
}

void TestErrors(Check& check)
{
  check.SetContext("errors: ");
  vtkNew<vtkFlowLIC> filter;
  filter->SetInputData(MakePoints(MakePositions(3, 1.0)));
  CheckError(filter, "no active vectors", check);
  const vtkSmartPointer<vtkImageData> image = MakeImage(3, Uniform);
  filter->SetFieldData(image);
  check.That(UpdateAndGetErrors(filter).empty(), "a field");
  filter->SetInputArrayToProcess(0, 1, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "wind");
  CheckError(filter, "\"wind\"", check);
  vtkNew<vtkDoubleArray> wind;
  wind->SetName("wind");
  wind->SetNumberOfComponents(2);
  wind->SetNumberOfTuples(27);
  wind->Fill(1.0);
  image->GetPointData()->AddArray(wind);
  CheckError(filter, "has 2 components", check);
  vtkNew<vtkFlowLIC> surface;
  auto points = MakePoints(MakePositions(3, 1.0));
  AddVectors(points, Uniform);
  surface->SetInputData(points);
  CheckError(surface, "vtkPolyData", check);
  vtkNew<vtkFlowLIC> flat;
  vtkNew<vtkImageData> plane;
  plane->SetDimensions(4, 4, 1);
  AddVectors(plane, Uniform);
  flat->SetInputData(plane);
  CheckError(flat, "three-dimensional", check);
  vtkNew<vtkFlowLIC> slow;
  slow->SetInputData(MakeImage(3, Uniform));
  slow->SetStepLength(1e-9);
  CheckError(slow, "1,000,000 steps", check);
  vtkNew<vtkFlowLIC> empty;
  vtkNew<vtkImageData> nothing;
  empty->SetInputData(nothing);
  check.That(UpdateAndGetErrors(empty).empty(), "an empty input");
}

void TestProgress(Check& check)
{
  check.SetContext("progress: ");
  vtkNew<vtkFlowLIC> filter;
  filter->SetInputData(MakeImage(9, Rotation));
  const auto update = [&filter]()
  {
    filter->Update();
    return GetBytes(vtkImageData::SafeDownCast(filter->GetOutputDataObject(0)));
  };
  CheckAborts(filter, 5, { 0.4 }, update, check);
  CheckPrinted(Print(filter), { "Kernel: Hann", "NoiseScale: 0", "Contrast: 0.2" }, check);
}

}

int TestFlowLIC(int, char*[])
{
  Check check;
  TestValues(check, "uniform", Uniform,
    [](const Vector& x, double s)
    {
      const double size = GetNorm(Uniform(x));
      return Vector{ { x[0] + s * 0.6 / size, x[1] - s * 1.2 / size, x[2] + s * 0.8 / size } };
    });
  TestValues(check, "rotation", Rotation,
    [](const Vector& x, double s)
    {
      const double radius = std::hypot(x[0], x[1]);
      const double angle = std::atan2(x[1], x[0]) + s / radius;
      return Vector{ { radius * std::cos(angle), radius * std::sin(angle), x[2] } };
    });
  TestWeights(check);
  TestEnds(check);
  TestContrast(check);
  TestCoherence(check);
  TestOutside(check);
  TestSink(check);
  TestDatasets(check);
  TestDefaults(check);
  TestRefinement(check);
  TestProjection(check);
  TestThreads(check);
  TestErrors(check);
  TestProgress(check);
  return check.Result();
}
