// SPDX-License-Identifier: BSD-3-Clause
// Flow volumes behind obstacles, given as hidden points, hidden cells or NaN vectors: the volume of
// a uniform flow past an obstacle compared with lines through hidden cells, on images and other
// grids, with one obstacle, two obstacles, and an obstacle at the end of the field.
#include "Support/AnalyticFlows/ReferenceFlowResults.h"
#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Checks/ReferenceThreads.h"
#include "Support/Flow/ReferenceFlowGrid.h"
#include "Support/Flow/ReferenceFlowVolume.h"
#include "Support/Meshes/ReferenceLattice.h"
#include "Support/Meshes/ReferenceMeshing.h"

#include "vtkFlowVolume.h"
#include "vtkImplicitFlowField.h"
#include "vtkInflowMapping.h"
#include "vtkTerminationPlane.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iostream>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace
{

using namespace reference;

constexpr double SurfaceX = -0.97;

enum Paths
{
  HiddenPoints,
  HiddenCells,
  NotFinite
};

struct Case
{
  const char* Name;
  Vector Direction;
  /// Number of points of the field along each axis.
  int Points;
  std::vector<std::pair<Vector, double>> Balls;
  Paths Path = HiddenPoints;
  /// Name of the grid in FormsOf().
  std::string Form = "image";
  /// Number of refinement levels.
  int Levels = 0;
  int Samples = 17;
};

bool IsInSphere(const Case& one, const Vector& x)
{
  return std::any_of(one.Balls.begin(), one.Balls.end(),
    [&x](const auto& ball) { return GetNorm(x - ball.first) < ball.second; });
}

/// The cells of the field that use a point of the obstacle.
class Obstacle
{
public:
  explicit Obstacle(const Case& one)
    : Cells(one.Points - 1)
    , IsHidden(static_cast<std::size_t>(this->Cells * this->Cells * this->Cells))
  {
    for (const auto& [i, j, k] : AllIndices(one.Points, one.Points, one.Points))
    {
      const Vector x{ { -1.0 + 2.0 * i / this->Cells, -1.0 + 2.0 * j / this->Cells,
        -1.0 + 2.0 * k / this->Cells } };
      for (int corner = 0; IsInSphere(one, x) && corner < 8; ++corner)
      {
        this->Hide(i - (corner & 1), j - (corner >> 1 & 1), k - (corner >> 2 & 1));
      }
    }
  }

  bool Get(int i, int j, int k) const
  {
    return this->IsHidden[static_cast<std::size_t>((i * this->Cells + j) * this->Cells + k)];
  }

  /// Returns whether the line from \a x against \a direction reaches the plane within the field
  /// without crossing a hidden cell.
  bool Reaches(const Vector& x, const Vector& direction) const
  {
    const double time = (x[0] - SurfaceX) / direction[0];
    const auto steps = static_cast<int>(std::ceil(5.0 * this->Cells * time));
    for (int step = 0; step <= steps; ++step)
    {
      int index[3];
      for (int axis = 0; axis < 3; ++axis)
      {
        const double y = x[axis] - time * step / std::max(steps, 1) * direction[axis];
        index[axis] = static_cast<int>(std::floor(0.5 * (y + 1.0) * this->Cells));
        if (index[axis] < 0 || index[axis] >= this->Cells)
        {
          return false;
        }
      }
      if (this->Get(index[0], index[1], index[2]))
      {
        return false;
      }
    }
    return time >= 0.0;
  }

private:
  void Hide(int i, int j, int k)
  {
    if (std::min({ i, j, k }) >= 0 && std::max({ i, j, k }) < this->Cells)
    {
      this->IsHidden[static_cast<std::size_t>((i * this->Cells + j) * this->Cells + k)] = true;
    }
  }

  int Cells;
  std::vector<bool> IsHidden;
};

/// Returns the volume of all positions with x from \a low to \a high from which lines reach the
/// plane. Uses one random position in each of many boxes.
double MeasureLines(const Case& one, double low = -1.0, double high = 1.0)
{
  const Obstacle obstacle(one);
  const std::vector<Vector> positions = MakeRandomPositions(40, 5);
  int reached = 0;
  for (Vector x : positions)
  {
    x[0] = low + 0.5 * (x[0] + 1.0) * (high - low);
    reached += obstacle.Reaches(x, one.Direction) ? 1 : 0;
  }
  return 4.0 * (high - low) * reached / static_cast<double>(positions.size());
}

/// Returns the field with its obstacle.
vtkSmartPointer<vtkDataSet> MakeField(const Case& one)
{
  auto image =
    MakeFlowImage({ { one.Points, one.Points, one.Points } }, { { -1, 1, -1, 1, -1, 1 } });
  vtkDataArray* vectors = AddVectors(image, [&one](const Vector&) { return one.Direction; });
  vtkUnsignedCharArray* ghosts =
    one.Path == HiddenPoints ? image->AllocatePointGhostArray() : nullptr;
  for (vtkIdType p = 0; p < image->GetNumberOfPoints(); ++p)
  {
    Vector x;
    image->GetPoint(p, x.data());
    if (!IsInSphere(one, x))
    {
      continue;
    }
    if (one.Path == HiddenPoints)
    {
      ghosts->SetValue(p, vtkDataSetAttributes::HIDDENPOINT);
    }
    else if (one.Path == NotFinite)
    {
      vectors->SetTuple3(p, std::numeric_limits<double>::quiet_NaN(), 1.0, 1.0);
    }
  }
  if (one.Path == HiddenCells)
  {
    ghosts = image->AllocateCellGhostArray();
    const Obstacle obstacle(one);
    const int cells = one.Points - 1;
    for (vtkIdType cell = 0; cell < image->GetNumberOfCells(); ++cell)
    {
      if (obstacle.Get(static_cast<int>(cell % cells), static_cast<int>(cell / cells % cells),
            static_cast<int>(cell / cells / cells)))
      {
        ghosts->SetValue(cell, vtkDataSetAttributes::HIDDENCELL);
      }
    }
  }
  const std::vector<DataSetVariant> forms = FormsOf(image);
  return std::find_if(forms.begin(), forms.end(),
    [&one](const DataSetVariant& form) { return form.Name == one.Form; })
    ->Data;
}

/// Returns the implicit flow field at the samples of a case.
vtkSmartPointer<vtkDataSet> MakeSamples(const Case& one)
{
  vtkNew<vtkImplicitFlowField> field;
  if (one.Path == NotFinite)
  {
    AllowWarnings(field);
  }
  field->SetInputData(MakeField(one));
  const bool isImage = one.Points != one.Samples;
  field->SetSampleMode(
    isImage ? vtkImplicitFlowField::SAMPLES_OF_IMAGE : vtkImplicitFlowField::SAMPLES_OF_FIELD);
  field->SetSampleDimensions(one.Samples, one.Samples, one.Samples);
  field->SetSamplingChecks(0);
  field->SetRefinementLevels(one.Levels);
  field->AddTerminationSurface(MakeWidePlane(SurfaceX));
  field->Update();
  return vtkDataSet::SafeDownCast(field->GetOutputDataObject(0));
}

vtkSmartPointer<vtkUnstructuredGrid> ExtractTubes(vtkDataSet* samples)
{
  vtkNew<vtkInflowMapping> mapping;
  mapping->SetInputData(samples);
  mapping->SetFormula(vtkInflowMapping::ALL, "10*u-5");
  vtkNew<vtkFlowVolume> volume;
  volume->SetInputConnection(mapping->GetOutputPort());
  volume->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  volume->SetInterval(0, -2.0, 0.1);
  volume->SetInterval(1, 0.1, 2.0);
  volume->Update();
  return volume->GetOutput();
}

/// Returns the volume of a mesh. Checks that each face belongs to at most two tetrahedra, on
/// opposite sides.
double Measure(vtkUnstructuredGrid* mesh, Check& check)
{
  const TetrahedraReport report = Inspect(mesh);
  check.Equal(report.FacesTooOften, 0, "faces with more than two tetrahedra");
  check.Equal(report.FacesTurned, 0, "pairs of tetrahedra on the same side of a face");
  return MeasureVolume(mesh);
}

void TestVolumes(Check& check)
{
  const Vector along{ { 1.0, 0.0, 0.0 } };
  const Vector oblique{ { 1.0, 0.3, 0.2 } };
  const std::pair<Vector, double> ball{ { { -0.31, 0.02, -0.03 } }, 0.43 };
  const std::pair<Vector, double> small{ { { 0.2, 0.35, 0.3 } }, 0.31 };
  const std::pair<Vector, double> atEnd{ { { -1.0, 0.2, -0.9 } }, 0.43 };
  const Case cases[] = {
    { "along x, samples of the field", along, 33, { ball }, HiddenPoints, "image", 0, 33 },
    { "oblique, a finer field", oblique, 65, { ball }, HiddenPoints, "image", 0, 33 },
    { "oblique, samples of the field", oblique, 17, { ball } },
    { "oblique, a field whose points differ from the samples", oblique, 26, { ball } },
    { "two obstacles", oblique, 33, { ball, small } },
    { "an obstacle at the end of the field", oblique, 33, { atEnd } },
    { "hidden cells", oblique, 33, { ball }, HiddenCells },
    { "NaN vectors", oblique, 33, { ball }, NotFinite },
    { "structured grid", oblique, 17, { ball }, HiddenPoints, "structured" },
    { "structured grid with hidden cells", oblique, 17, { ball }, HiddenCells, "structured" },
    { "unstructured grid", oblique, 17, { ball }, HiddenPoints, GetName(MeshKind::Hexahedra) },
    { "refined", oblique, 33, { ball }, HiddenPoints, "image", 1 },
  };
  for (const Case& one : cases)
  {
    check.SetContext(one.Name);
    const auto samples = MakeSamples(one);
    const double exact = MeasureLines(one);
    const double found = Measure(ExtractFlow(samples), check);
    const double before = Measure(ExtractUncutFlow(samples), check);
    std::cout << one.Name << ": " << exact << ", " << 100.0 * (before / exact - 1.0)
              << " % before, " << 100.0 * (found / exact - 1.0) << " %\n";
    check.Near(found, exact, one.Samples == 33 ? 0.005 : 0.03, "volume");
    check.That(before < 0.97 * exact, "cells that would be omitted");
  }
}

/// The front of the obstacle is in the layer of cells next to the layer that contains the plane.
void TestAtPlane(Check& check)
{
  check.SetContext("an obstacle at the plane");
  const Case one{ "", { { 1.0, 0.3, 0.2 } }, 31, { { { { -0.5, 0.1, 0.05 } }, 0.4 } }, HiddenPoints,
    "image", 0, 33 };
  const double low = -1.0 + 1.0 / 16.0;
  const double high = low + 1.0 / 16.0;
  const auto mesh = ExtractFlow(MakeSamples(one));
  Measure(mesh, check);
  const double found =
    MeasureVolumeIn(mesh, [&](const double* x) { return x[0] > low && x[0] < high; });
  const double exact = MeasureLines(one, low, high);
  std::cout << "volume at the plane: " << exact << ", " << 100.0 * (found / exact - 1.0) << " %\n";
  check.Near(found, exact, 0.02, "volume");
}

/// In uniform flow, values in cut cells are exact, except close to the boundary of the region that
/// reaches the plane. There, the error in time is up to a 64th of a cell, the final width of the
/// bisection. The error in Inflow is up to a tenth of a cell.
void TestValues(Check& check)
{
  check.SetContext("values");
  const Case one{ "values", { { 1.0, 0.3, 0.2 } }, 31, { { { { -0.31, 0.02, -0.03 } }, 0.43 } } };
  const auto samples = MakeSamples(one);
  const auto mesh = ExtractTubes(samples);
  check.That(mesh->GetNumberOfCells() > 1000, "tetrahedra");
  Measure(mesh, check);
  vtkPointData* data = mesh->GetPointData();
  constexpr double cell = 2.0 / 16;
  double largest[2] = { 0.0, 0.0 };
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    const double* x = mesh->GetPoint(p);
    const double time = x[0] - SurfaceX;
    const double inflow = x[1] - one.Direction[1] * time;
    largest[0] =
      std::max(largest[0], std::abs(data->GetArray("AdvectionTime")->GetComponent(p, 0) - time));
    // On the plane, values may come from samples upstream, whose streamlines leave the field.
    if (time > 0.0)
    {
      largest[1] =
        std::max(largest[1], std::abs(data->GetArray("Inflow")->GetComponent(p, 0) - inflow));
    }
  }
  check.Near(largest[0], 0.0, cell / 64, "time", 1.0);
  check.Near(largest[1], 0.0, 0.1 * cell, "inflow", 1.0);
}

/// Without an obstacle, no boundary of the reached region is located.
void TestWithout(Check& check)
{
  check.SetContext("without an obstacle");
  const auto samples = MakeSamples({ "", { { 1.0, 0.3, 0.2 } }, 31, {} });
  double range[2];
  samples->GetFieldData()->GetArray("BeyondSampleSurface")->GetRange(range);
  check.That(range[0] >= -1, "no samples next to a boundary");
}

void TestThreads(Check& check)
{
  check.SetContext("threads");
  CheckThreads(
    "obstacle",
    []()
    {
      auto copy = vtkSmartPointer<vtkUnstructuredGrid>::New();
      copy->ShallowCopy(ExtractTubes(MakeSamples({ "", { { 1.0, 0.3, 0.2 } }, 15,
        { { { { -0.31, 0.02, -0.03 } }, 0.43 } }, HiddenPoints, "image", 0, 12 })));
      return std::vector<vtkSmartPointer<vtkUnstructuredGrid>>{ copy };
    },
    check);
}

}

int TestFlowVolumeObstacles(int, char*[])
{
  return RunChecks({ TestVolumes, TestAtPlane, TestValues, TestWithout, TestThreads });
}
