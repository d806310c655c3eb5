// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Approximations/FilterFamilies.h"
#include "Support/AnalyticFlows/ReferenceFlowMaps.h"
#include "Support/AnalyticFlows/ReferenceNoise.h"

#include "vtkFlowLIC.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <array>
#include <cmath>
#include <memory>
#include <vector>

namespace approximations
{
namespace
{
using Vector = std::array<double, 3>;

constexpr double Scale = 0.02;
constexpr int Seed = 7;
constexpr double Length = 10.0 * Scale;
/// Step length in units of the noise scale.
constexpr double DefaultStep = 0.25;

/// Returns a rotational flow about the z-axis, which trilinear interpolation reproduces exactly.
vtkSmartPointer<vtkImageData> MakeRotation()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(41, 41, 3);
  image->SetSpacing(0.05, 0.05, 0.05);
  image->SetOrigin(-1.0, -1.0, -0.05);
  reference::SetVelocity(image, [](const Vector& x) { return Vector{ { -x[1], x[0], 0.0 } }; });
  return image;
}

/// Returns the point at an arc length along the circle through \a x.
Vector Along(const Vector& x, double arc)
{
  const double angle = arc / std::hypot(x[0], x[1]);
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return { { c * x[0] - s * x[1], s * x[0] + c * x[1], x[2] } };
}

/// Returns points that are distributed over an annulus by the golden angle. Streamlines stay in the
/// annulus.
std::vector<Vector> MakePoints(int number)
{
  std::vector<Vector> points;
  for (int i = 0; i < number; ++i)
  {
    const double radius = std::sqrt(0.09 + 0.72 * (i + 0.5) / number);
    points.push_back(
      { { radius * std::cos(2.399963 * i), radius * std::sin(2.399963 * i), 0.013 } });
  }
  return points;
}

/// Returns a filter that computes LIC only at the given positions.
vtkSmartPointer<vtkFlowLIC> NewFilter(
  vtkImageData* field, const std::vector<Vector>& positions, int kernel, double step)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vector& x : positions)
  {
    points->InsertNextPoint(x.data());
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  auto filter = vtkSmartPointer<vtkFlowLIC>::New();
  filter->SetInputData(data);
  filter->SetFieldData(field);
  filter->SetKernel(kernel);
  filter->SetNoiseScale(Scale);
  filter->SetLength(Length);
  filter->SetStepLength(step * Scale);
  filter->SetSeed(Seed);
  return filter;
}

/// Returns the mean of the noise, weighted by the kernel, along an exact arc of the circle through
/// \a x.
double IntegrateNoise(const Vector& x, int kernel)
{
  constexpr int parts = 800;
  double sum = 0.0;
  double weights = 0.0;
  for (int i = 0; i < parts; ++i)
  {
    const double arc = Length * (2.0 * (i + 0.5) / parts - 1.0);
    const double weight =
      kernel == vtkFlowLIC::HANN ? 0.5 * (1.0 + std::cos(vtkMath::Pi() * arc / Length)) : 1.0;
    sum += weight * reference::GetNoise(Along(x, arc), Scale, Seed);
    weights += weight;
  }
  return sum / weights;
}

/// Returns the root mean square difference between the LIC values and \a means, relative to
/// Contrast, the standard deviation of the values. The means are scaled by a least-squares fit.
/// Values clamped to 0 or 1 are excluded.
double MeasureMeans(vtkFlowLIC* filter, const std::vector<double>& means)
{
  vtkDataArray* values =
    vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetPointData()->GetArray("LIC");
  double products = 0.0;
  double squares = 0.0;
  std::vector<std::array<double, 2>> pairs;
  for (vtkIdType id = 0; id < values->GetNumberOfTuples(); ++id)
  {
    const double value = values->GetTuple1(id);
    if (value > 0.0 && value < 1.0)
    {
      pairs.push_back({ { value - 0.5, means[id] - 0.5 } });
      products += pairs.back()[0] * pairs.back()[1];
      squares += pairs.back()[1] * pairs.back()[1];
    }
  }
  double sum = 0.0;
  for (const auto& pair : pairs)
  {
    sum += std::pow(pair[0] - products / squares * pair[1], 2);
  }
  return std::sqrt(sum / static_cast<double>(pairs.size())) / filter->GetContrast();
}

void AddStepRows(const Question& question, const BenchOptions& options, BenchRows& rows)
{
  const std::vector<Vector> positions = MakePoints(options.Pick(20000, 4000, 200));
  auto field = MakeRotation();
  Trials trials;
  trials.SetSize("points", static_cast<double>(positions.size()));
  for (const int kernel : { vtkFlowLIC::HANN, vtkFlowLIC::BOX })
  {
    const auto means = std::make_shared<std::vector<double>>();
    for (const Vector& x : positions)
    {
      means->push_back(IntegrateNoise(x, kernel));
    }
    for (const double step : options.Pick<std::vector<double>>(
           { 2.0, 1.0, 0.5, 0.25, 0.125, 0.0625 }, { 2.0, 1.0, 0.5, 0.25, 0.125 }, { 0.5, 0.25 }))
    {
      auto filter = NewFilter(field, positions, kernel, step);
      trials.Add(kernel == vtkFlowLIC::HANN ? "Hann" : "box", NumberText(step),
        kernel == vtkFlowLIC::HANN && step == DefaultStep ? Maker::Default : Maker::Own,
        WithThreads(1, MakeRerunWork(filter)),
        [filter, means]() { return MeasureMeans(filter, *means); });
    }
  }
  trials.Run(question, options, rows);
}
}

Family MakeLicStepFamily()
{
  return { { "lic-step", "Steps of line integral convolution: error against run time, 1 thread",
             "Which step length is sufficient for line integral convolution?",
             "A rotation, both kernels; labels are steps in units of the noise scale. The "
             "reference is the "
             "integral along circles in double precision.",
             "run time (s)", "difference, rms, in standard deviations" },
    AddStepRows };
}
}
