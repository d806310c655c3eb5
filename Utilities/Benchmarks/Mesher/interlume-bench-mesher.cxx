// SPDX-License-Identifier: BSD-3-Clause
// Measures vtkTetrahedralMesher for the suite filter-errors of interlume-bench, which starts this
// program, since the mesher is not part of its package: prints rows as JSON.
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

/// Triangles of nearly the same size on a ball of radius 1, with the field's values in their
/// points.
vtkSmartPointer<vtkPolyData> MakeBall(int subdivisions)
{
  vtkNew<vtkPlatonicSolidSource> solid;
  solid->SetSolidTypeToIcosahedron();
  vtkNew<vtkLinearSubdivisionFilter> finer;
  finer->SetInputConnection(solid->GetOutputPort());
  finer->SetNumberOfSubdivisions(subdivisions);
  finer->Update();
  auto ball = vtkSmartPointer<vtkPolyData>::New();
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
  ball->SetPoints(points);
  ball->SetPolys(finer->GetOutput()->GetPolys());
  ball->GetPointData()->SetScalars(values);
  return ball;
}

/// The root mean square over all tetrahedra of what is interpolated less the field, by four points
/// in each.
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
      double place[3] = { 0.0, 0.0, 0.0 };
      double value = 0.0;
      for (int corner = 0; corner < 4; ++corner)
      {
        const double weight = corner == point ? near : far;
        value += weight * f[corner];
        for (int axis = 0; axis < 3; ++axis)
        {
          place[axis] += weight * x[corner][axis];
        }
      }
      const double off = value - Evaluate(place);
      sum += 0.25 * size * off * off;
    }
    volume += size;
  }
  return std::sqrt(sum / volume) / Range;
}

void AddMesher(vtkPolyData* ball, const std::string& method, double quality, double share,
  const std::string& setting, Maker maker, Trials& trials)
{
  auto mesher = vtkSmartPointer<vtkTetrahedralMesher>::New();
  // TetGen 1.6 does not reach every quality bound; the row shows the error in any case.
  vtkNew<vtkCallbackCommand> ignore;
  mesher->AddObserver(vtkCommand::WarningEvent, ignore);
  mesher->SetInputData(ball);
  mesher->SetQualityBound(quality);
  mesher->SetMaximumVolume(share * 4.0 / 3.0 * vtkMath::Pi());
  trials.Add(method, setting, maker, WithThreads(1, Again(mesher)),
    [mesher]() { return MeasureInterpolation(mesher->GetOutput()); });
}

void AddPeer(vtkPolyData* ball, Trials& trials)
{
  auto peer = vtkSmartPointer<vtkDelaunay3D>::New();
  peer->SetInputData(ball);
  trials.Add("vtkDelaunay3D", "", Maker::Peer, WithThreads(1, Again(peer)),
    [peer]() { return MeasureInterpolation(peer->GetOutput()); });
}

BenchRows Measure(const BenchOptions& options)
{
  const vtkSmartPointer<vtkPolyData> ball = MakeBall(options.Pick(4, 3, 1));
  Trials trials;
  trials.SetSize("triangles", static_cast<double>(ball->GetNumberOfPolys()));
  AddMesher(ball, "bounds", 0.0, 0.0, "none", Maker::Default, trials);
  const auto shares = options.Pick<std::vector<double>>(
    { 1e-2, 1e-3, 1e-4, 1e-5, 1e-6 }, { 1e-2, 1e-3, 1e-4 }, { 1e-2 });
  for (const double share : shares)
  {
    AddMesher(ball, "largest volume", 0.0, share, NumberText(share), Maker::Own, trials);
    AddMesher(
      ball, "largest volume, quality 1.2", 1.2, share, NumberText(share), Maker::Own, trials);
  }
  for (const double quality :
    options.Pick<std::vector<double>>({ 2.0, 1.6, 1.4, 1.2 }, { 2.0, 1.4 }, { 2.0 }))
  {
    AddMesher(ball, "quality", quality, 0.0, NumberText(quality), Maker::Own, trials);
  }
  AddPeer(ball, trials);
  BenchRows rows("filter-errors");
  trials.Run(MakeMesherFamily().Asked, options, rows);
  return rows;
}
}

int main(int argc, char* argv[])
{
  BenchOptions options;
  bool quick = false;
  bool tiny = false;
  CLI::App app("Measures the mesher of tetrahedra for interlume-bench", "interlume-bench-mesher");
  app.add_flag("--quick", quick, "Smaller cases");
  app.add_flag("--tiny", tiny)->group("");
  app.add_option("--threads", options.Threads)->group("");
  app.add_option("--seed", options.Seed)->group("");
  CLI11_PARSE(app, argc, argv);
  options.Size = tiny ? BenchOptions::TINY : quick ? BenchOptions::QUICK : BenchOptions::FULL;
  try
  {
    // Rows are printed as they come; what is read is the JSON alone.
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
