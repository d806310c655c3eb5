// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Approximations/FilterFamilies.h"

#include "vtkConstructiveVolume.h"
#include "vtkSpatialPrimitive.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace approximations
{
namespace
{
constexpr double Radius = 0.713;
/// Along an edge of the default's image.
constexpr int UsualPoints = 64;

/// The length of a column, between two heights, that is within the ball.
double GetColumn(double x, double y, double low, double high)
{
  const double half = std::sqrt(std::max(0.0, Radius * Radius - x * x - y * y));
  return std::max(0.0, std::min(high, half) - std::max(low, -half));
}

/// The share of a cube around a place that is within the ball, by columns.
double GetShare(const double x[3], double edge)
{
  constexpr int columns = 24;
  const double half = 0.5 * edge;
  const double distance = std::hypot(x[0], x[1], x[2]);
  if (std::abs(distance - Radius) > std::sqrt(3.0) * half)
  {
    return distance < Radius ? 1.0 : 0.0;
  }
  double sum = 0.0;
  for (int j = 0; j < columns; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      sum += GetColumn(x[0] - half + edge * (i + 0.5) / columns,
        x[1] - half + edge * (j + 0.5) / columns, x[2] - half, x[2] + half);
    }
  }
  return sum / (edge * columns * columns);
}

/// What voxels have too much and too little of the ball, over its volume.
double MeasureShares(vtkImageData* image)
{
  vtkDataArray* values = image->GetPointData()->GetScalars();
  const double edge = image->GetSpacing()[0];
  double off = 0.0;
  double ball = 0.0;
  for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
  {
    double x[3];
    image->GetPoint(id, x);
    const double share = GetShare(x, edge);
    off += std::abs(values->GetTuple1(id) - share);
    ball += share;
  }
  return off / ball;
}

/// The trilinear interpolation of an image of the cube from -1 to 1 at a place, written down for
/// itself.
double Interpolate(vtkDataArray* values, int points, const double x[3])
{
  int first[3];
  double share[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double place = 0.5 * (x[axis] + 1.0) * (points - 1);
    first[axis] = std::min(static_cast<int>(place), points - 2);
    share[axis] = place - first[axis];
  }
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    double weight = 1.0;
    vtkIdType id = 0;
    for (int axis = 2; axis >= 0; --axis)
    {
      const int up = corner >> axis & 1;
      weight *= up ? share[axis] : 1.0 - share[axis];
      id = id * points + first[axis] + up;
    }
    sum += weight * values->GetTuple1(id);
  }
  return sum;
}

/// The integral of |interpolated density - ball|, by midpoints, over the ball's volume.
double MeasureEdge(vtkImageData* image, int places)
{
  const int points = image->GetDimensions()[0];
  vtkDataArray* values = image->GetPointData()->GetScalars();
  double off = 0.0;
  double ball = 0.0;
  for (int i = 0; i < places * places * places; ++i)
  {
    const int index[3] = { i % places, i / places % places, i / places / places };
    double x[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      x[axis] = 2.0 * (index[axis] + 0.5) / places - 1.0;
    }
    const double inside = std::hypot(x[0], x[1], x[2]) <= Radius ? 1.0 : 0.0;
    off += std::abs(Interpolate(values, points, x) - inside);
    ball += inside;
  }
  return off / ball;
}

/// A ball on so many points along an edge, each the mean of so many samples along its cell's edge.
vtkSmartPointer<vtkConstructiveVolume> NewBall(int points, int subsamples)
{
  vtkNew<vtkSpatialPrimitive> ball;
  ball->SetShapeToSphere();
  ball->SetRadius(Radius);
  auto source = vtkSmartPointer<vtkConstructiveVolume>::New();
  source->SetRoot(ball);
  source->SetDimensions(points, points, points);
  source->SetNumberOfSubsamples(subsamples);
  return source;
}

void AddSourceSampleRows(const Question& question, const BenchOptions& options, BenchRows& rows)
{
  const int points = options.Pick(UsualPoints, 32, 8);
  Trials trials;
  trials.SetSize("points along an edge", points);
  for (const int subsamples :
    options.Pick<std::vector<int>>({ 1, 2, 3, 4, 6, 8 }, { 1, 2, 4, 8 }, { 1, 2 }))
  {
    auto source = NewBall(points, subsamples);
    trials.Add("vtkConstructiveVolume", NumberText(subsamples),
      subsamples == 1 ? Maker::Default : Maker::Own, WithThreads(1, Again(source)),
      [source]() { return MeasureShares(source->GetOutput()); });
  }
  trials.Run(question, options, rows);
}

void AddSourceVoxelRows(const Question& question, const BenchOptions& options, BenchRows& rows)
{
  const int places = options.Pick(320, 120, 40);
  Trials trials;
  for (const int subsamples : { 1, 4 })
  {
    for (const int points :
      options.Pick<std::vector<int>>({ 16, 32, 64, 128 }, { 16, 32, 64 }, { 8, 64 }))
    {
      auto source = NewBall(points, subsamples);
      trials.Add(subsamples == 1 ? "one sample a voxel" : "4^3 samples a voxel", NumberText(points),
        subsamples == 1 && points == UsualPoints ? Maker::Default : Maker::Own,
        WithThreads(1, Again(source)),
        [source, places]() { return MeasureEdge(source->GetOutput(), places); });
    }
  }
  trials.Run(question, options, rows);
}
}

Family MakeSourceSampleFamily()
{
  return { { "source-samples", "Samples of a constructive volume: error against run time, 1 thread",
             "How many samples in a voxel for a smooth edge of a solid?",
             "A ball by vtkConstructiveVolume, NumberOfSubsamples at each point; each voxel's "
             "density against the share of its cell that is within the ball.",
             "run time (s)", "misplaced density, share of the ball's volume" },
    AddSourceSampleRows };
}

Family MakeSourceVoxelFamily()
{
  return { { "source-voxels", "Voxels of a constructive volume: error against run time, 1 thread",
             "How many voxels for the place of a solid's edge?",
             "A ball by vtkConstructiveVolume, points along an edge of the image at each point; "
             "the interpolated density against the ball itself.",
             "run time (s)", "integral of the difference, share of the ball's volume" },
    AddSourceVoxelRows };
}
}
