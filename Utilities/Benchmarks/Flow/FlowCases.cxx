// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Flow/FlowCases.h"

#include "Benchmarks/Data/BenchData.h"
#include "Benchmarks/Data/CellSplits.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <random>
#include <utility>

namespace flow
{
namespace
{
/// Displaces the points of \a grid, whose cells have the size \a width, and samples the field.
void MoveAndSample(vtkUnstructuredGrid* grid, const vtkAnalyticFlowSource* source, double width)
{
  constexpr double pi = 3.14159265358979323846;
  vtkPoints* points = grid->GetPoints();
  vtkNew<vtkPoints> moved;
  moved->SetDataTypeToDouble();
  moved->SetNumberOfPoints(points->GetNumberOfPoints());
  vtkNew<vtkDoubleArray> velocity;
  velocity->SetName("Velocity");
  velocity->SetNumberOfComponents(3);
  velocity->SetNumberOfTuples(points->GetNumberOfPoints());
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double x[3];
    points->GetPoint(i, x);
    const double shift = 0.1 * width * std::sin(3.0 * pi * x[0]) * std::sin(2.0 * pi * x[1]) *
      std::sin(4.0 * pi * x[2]);
    const double position[3] = { x[0] + shift, x[1] - shift, x[2] + shift };
    double v[3];
    source->Evaluate(position, v);
    moved->SetPoint(i, position);
    velocity->SetTuple(i, v);
  }
  grid->SetPoints(moved);
  grid->GetPointData()->Initialize();
  grid->GetPointData()->SetVectors(velocity);
}

vtkSmartPointer<vtkImageData> MakeImage(int points)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(points, points, points);
  const double spacing = 2.0 / (points - 1);
  image->SetSpacing(spacing, spacing, spacing);
  image->SetOrigin(-1.0, -1.0, -1.0);
  vtkNew<vtkDoubleArray> zeros;
  zeros->SetNumberOfValues(image->GetNumberOfPoints());
  zeros->FillValue(0.0);
  image->GetPointData()->SetScalars(zeros);
  return image;
}
}

vtkSmartPointer<vtkAnalyticFlowSource> MakeBeltrami(int points)
{
  auto source = vtkSmartPointer<vtkAnalyticFlowSource>::New();
  source->SetField(vtkAnalyticFlowSource::ABC);
  source->SetDimensions(points, points, points);
  return source;
}

vtkSmartPointer<vtkPolyData> MakeSeeds(int number, double half, unsigned int seed)
{
  std::mt19937 generator(seed);
  const auto next = [&]() { return half * (generator() * 0x1p-31 - 1.0); };
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(number);
  for (vtkIdType i = 0; i < number; ++i)
  {
    const double x = next();
    const double y = next();
    points->SetPoint(i, x, y, next());
  }
  auto seeds = vtkSmartPointer<vtkPolyData>::New();
  seeds->SetPoints(points);
  return seeds;
}

std::vector<Case> MakeSpeedCases(const BenchOptions& options)
{
  const int small = options.Pick(64, 64, 12);
  const int large = options.Pick(128, 96, 16);
  const int cells = options.Pick(64, 40, 12);
  const auto seeds = MakeSeeds(options.Pick(2048, 300, 40), 0.9, options.Seed);
  const double face = 0.97;
  const std::array<double, 6> box = { { -face, face, -face, face, -face, face } };

  std::vector<Case> cases;
  for (const int points : { small, large })
  {
    const auto source = MakeBeltrami(points);
    source->Update();
    cases.push_back({ "image-" + std::to_string(points), source->GetOutput(), seeds, box, true });
  }
  const auto source = MakeBeltrami(2);
  const auto image = MakeImage(cells);
  const auto hexahedra = ToHexahedra(image);
  MoveAndSample(hexahedra, source, 2.0 / (cells - 1));
  cases.push_back({ "hexahedra-" + std::to_string(cells), hexahedra, seeds, box });
  const auto tetrahedra = SplitIntoTetrahedra(image, 5);
  MoveAndSample(tetrahedra, source, 2.0 / (cells - 1));
  cases.push_back({ "tetrahedra-" + std::to_string(cells), tetrahedra, seeds, box });
  return cases;
}
}
