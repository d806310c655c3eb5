// SPDX-License-Identifier: BSD-3-Clause
// Measures vtkTetrahedralMesher for the suite filter-errors of interlume-bench. The package of
// interlume-bench does not contain the mesher, so interlume-bench starts this program, which prints
// rows as JSON.
#include "Benchmarks/Approximations/FilterFamilies.h"

#include "vtkTetrahedralMesher.h"

#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkDelaunay3D.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkLinearSubdivisionFilter.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPlatonicSolidSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTetra.h"
#include "vtkUnstructuredGrid.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <exception>
#include <iostream>
#include <vector>

namespace
{
using namespace approximations;

double Evaluate(const double x[3])
{
  return x[0] * x[0] - x[1] * x[1];
}
constexpr double Range = 2.0;

/// Returns a unit sphere of nearly equal triangles, with the values of Evaluate() at its points.
vtkSmartPointer<vtkPolyData> MakeSphere(int subdivisions)
{
  vtkNew<vtkPlatonicSolidSource> solid;
  solid->SetSolidTypeToIcosahedron();
  vtkNew<vtkLinearSubdivisionFilter> finer;
  finer->SetInputConnection(solid->GetOutputPort());
  finer->SetNumberOfSubdivisions(subdivisions);
  finer->Update();
  auto sphere = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> values;
  values->SetName("f");
  for (vtkIdType i = 0; i < finer->GetOutput()->GetNumberOfPoints(); ++i)
  {
    double x[3];
    finer->GetOutput()->GetPoint(i, x);
    vtkMath::Normalize(x);
    points->InsertNextPoint(x);
    values->InsertNextValue(Evaluate(x));
  }
  sphere->SetPoints(points);
  sphere->SetPolys(finer->GetOutput()->GetPolys());
  sphere->GetPointData()->SetScalars(values);
  return sphere;
}

/// Returns the root mean square difference between the interpolated values and Evaluate(), divided
/// by Range. Integrates over all tetrahedra with a four-point rule.
double MeasureInterpolation(vtkUnstructuredGrid* mesh)
{
  constexpr double near = 0.58541019662496852;
  constexpr double far = 0.13819660112501053;
  vtkDataArray* values = mesh->GetPointData()->GetArray("f");
  vtkNew<vtkIdList> ids;
  double sum = 0.0;
  double volume = 0.0;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, ids);
    double x[4][3];
    double f[4];
    for (int corner = 0; corner < 4; ++corner)
    {
      mesh->GetPoint(ids->GetId(corner), x[corner]);
      f[corner] = values->GetComponent(ids->GetId(corner), 0);
    }
    const double size = std::abs(vtkTetra::ComputeVolume(x[0], x[1], x[2], x[3]));
    for (int point = 0; point < 4; ++point)
    {
      double position[3] = { 0.0, 0.0, 0.0 };
      double value = 0.0;
      for (int corner = 0; corner < 4; ++corner)
      {
        const double weight = corner == point ? near : far;
        value += weight * f[corner];
        for (int axis = 0; axis < 3; ++axis)
        {
          position[axis] += weight * x[corner][axis];
        }
      }
      const double difference = value - Evaluate(position);
      sum += 0.25 * size * difference * difference;
    }
    volume += size;
  }
  return std::sqrt(sum / volume) / Range;
}

void AddMesher(vtkPolyData* sphere, const std::string& method, double quality, double fraction,
  const std::string& setting, Maker maker, Trials& trials)
{
  auto mesher = vtkSmartPointer<vtkTetrahedralMesher>::New();
  // TetGen 1.6 cannot satisfy every quality bound. Ignore warnings about this, since the row
  // contains the resulting error.
  vtkNew<vtkCallbackCommand> ignore;
  mesher->AddObserver(vtkCommand::WarningEvent, ignore);
  mesher->SetInputData(sphere);
  mesher->SetQualityBound(quality);
  mesher->SetMaximumVolume(fraction * 4.0 / 3.0 * vtkMath::Pi());
  trials.Add(method, setting, maker, WithThreads(1, MakeRerunWork(mesher)),
    [mesher]() { return MeasureInterpolation(mesher->GetOutput()); });
}

void AddBaseline(vtkPolyData* sphere, Trials& trials)
{
  auto baseline = vtkSmartPointer<vtkDelaunay3D>::New();
  baseline->SetInputData(sphere);
  trials.Add("vtkDelaunay3D", "", Maker::Baseline, WithThreads(1, MakeRerunWork(baseline)),
    [baseline]() { return MeasureInterpolation(baseline->GetOutput()); });
}

BenchRows Measure(const BenchOptions& options)
{
  const vtkSmartPointer<vtkPolyData> sphere = MakeSphere(options.Pick(4, 3, 1));
  Trials trials;
  trials.SetSize("triangles", static_cast<double>(sphere->GetNumberOfPolys()));
  AddMesher(sphere, "bounds", 0.0, 0.0, "none", Maker::Default, trials);
  const auto fractions = options.Pick<std::vector<double>>(
    { 1e-2, 1e-3, 1e-4, 1e-5, 1e-6 }, { 1e-2, 1e-3, 1e-4 }, { 1e-2 });
  for (const double fraction : fractions)
  {
    AddMesher(sphere, "largest volume", 0.0, fraction, NumberText(fraction), Maker::Own, trials);
    AddMesher(sphere, "largest volume, quality 1.2", 1.2, fraction, NumberText(fraction),
      Maker::Own, trials);
  }
  for (const double quality :
    options.Pick<std::vector<double>>({ 2.0, 1.6, 1.4, 1.2 }, { 2.0, 1.4 }, { 2.0 }))
  {
    AddMesher(sphere, "quality", quality, 0.0, NumberText(quality), Maker::Own, trials);
  }
  AddBaseline(sphere, trials);
  BenchRows rows("filter-errors");
  trials.Run(MakeMesherFamily().Query, options, rows);
  return rows;
}
}

int main(int argc, char* argv[])
{
  BenchOptions options;
  bool quick = false;
  bool tiny = false;
  CLI::App app("Measures vtkTetrahedralMesher for interlume-bench", "interlume-bench-mesher");
  app.add_flag("--quick", quick, "Smaller cases");
  app.add_flag("--tiny", tiny)->group("");
  app.add_option("--threads", options.Threads)->group("");
  app.add_option("--seed", options.Seed)->group("");
  CLI11_PARSE(app, argc, argv);
  options.Size = tiny ? BenchOptions::TINY : quick ? BenchOptions::QUICK : BenchOptions::FULL;
  try
  {
    // Redirect the rows that are printed while measuring, since standard output must contain only
    // the JSON.
    std::streambuf* output = std::cout.rdbuf(std::cerr.rdbuf());
    auto json = nlohmann::ordered_json::array();
    const BenchRows rows = Measure(options);
    for (const BenchRow& row : rows.Get())
    {
      json.push_back(row.ToJson());
    }
    std::cout.rdbuf(output);
    std::cout << json << std::endl;
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << "interlume-bench-mesher: " << error.what() << std::endl;
    return 1;
  }
}
