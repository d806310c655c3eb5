// SPDX-License-Identifier: BSD-3-Clause
// Stream tubes of potential flow around a sphere of hidden points, compared with streamlines from
// many random positions. Errors are below 2 % if the number of samples equals the number of points.
// Tubes narrower than two samples that graze the sphere have larger errors, which are caused by
// interpolation between samples and decrease with their spacing.
#include "Support/AnalyticFlows/ReferenceFlowResults.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Flow/ReferenceFlowGrid.h"
#include "Support/Flow/ReferenceFlowVolume.h"

#include "vtkFlowVolume.h"
#include "vtkImplicitFlowField.h"
#include "vtkInflowMapping.h"
#include "vtkTerminationPlane.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

namespace
{

using namespace reference;

constexpr double Radius = 0.43;
constexpr Vector Center{ { -0.31, 0.02, -0.03 } };
constexpr int FieldPoints = 33;
/// Formula of the distance from the axis where a streamline reaches the termination plane.
constexpr const char* AxisDistance = "sqrt((10*u-5-0.02)^2+(10*v-5+0.03)^2)";

/// Flow along x with speed 1, deflected by a sphere.
Vector GetPotentialFlow(const Vector& x)
{
  const Vector way = x - Center;
  const double distance = std::max(GetNorm(way), 0.5 * Radius);
  const double strength = 0.5 * std::pow(Radius / distance, 3);
  const double radial = 3.0 * strength * way[0] / (distance * distance);
  return { { 1.0 + strength - radial * way[0], -radial * way[1], -radial * way[2] } };
}

vtkSmartPointer<vtkImageData> MakeField()
{
  auto image =
    MakeFlowImage({ { FieldPoints, FieldPoints, FieldPoints } }, { { -1, 1, -1, 1, -1, 1 } });
  AddVectors(image, GetPotentialFlow);
  vtkUnsignedCharArray* ghosts = image->AllocatePointGhostArray();
  for (vtkIdType p = 0; p < image->GetNumberOfPoints(); ++p)
  {
    Vector x;
    image->GetPoint(p, x.data());
    if (GetNorm(x - Center) < Radius)
    {
      ghosts->SetValue(p, vtkDataSetAttributes::HIDDENPOINT);
    }
  }
  return image;
}

vtkSmartPointer<vtkUnstructuredGrid> MakeSampleBoxes(int boxes)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vector& x : MakeRandomPositions(boxes, 3))
  {
    points->InsertNextPoint(x.data());
  }
  auto positions = vtkSmartPointer<vtkUnstructuredGrid>::New();
  positions->SetPoints(points);
  return positions;
}

/// Returns the output samples of \a field, with the distance from the axis as Inflow.
vtkSmartPointer<vtkDataSet> MapSamples(vtkImplicitFlowField* field)
{
  field->SetInputData(MakeField());
  field->SetSamplingChecks(0);
  field->AddTerminationSurface(MakeWidePlane(-0.97));
  vtkNew<vtkInflowMapping> mapping;
  mapping->SetInputConnection(field->GetOutputPort());
  mapping->SetFormula(vtkInflowMapping::ALL, AxisDistance);
  mapping->Update();
  return vtkDataSet::SafeDownCast(mapping->GetOutputDataObject(0));
}

using Tube = std::array<double, 2>;

/// Measures the volume of a tube by the fraction of random positions that are inside it.
class SampleBoxes
{
public:
  SampleBoxes()
  {
    vtkNew<vtkImplicitFlowField> field;
    field->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_INPUT);
    field->SetSampleData(MakeSampleBoxes(64));
    this->Samples = MapSamples(field);
  }

  double Measure(const Tube& tube) const
  {
    vtkDataArray* inflow = this->Samples->GetPointData()->GetArray("Inflow");
    const vtkIdType number = inflow->GetNumberOfTuples();
    vtkIdType inside = 0;
    for (vtkIdType p = 0; p < number; ++p)
    {
      const double value = inflow->GetComponent(p, 0);
      inside += value >= tube[0] && value < tube[1] ? 1 : 0;
    }
    return 8.0 * static_cast<double>(inside) / static_cast<double>(number);
  }

private:
  vtkSmartPointer<vtkDataSet> Samples;
};

/// Extracts tubes from samples.
class Tubes
{
public:
  Tubes(int samples, int levels)
  {
    vtkNew<vtkImplicitFlowField> field;
    field->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
    field->SetSampleDimensions(samples, samples, samples);
    field->SetRefinementLevels(levels);
    this->Volume->SetInputData(MapSamples(field));
    this->Volume->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  }

  /// Returns the relative error of a tube's volume.
  double GetError(const Tube& tube, const SampleBoxes& positions)
  {
    this->Volume->SetInterval(0, tube[0], tube[1]);
    this->Volume->Update();
    const double exact = positions.Measure(tube);
    const double error = MeasureVolume(this->Volume->GetOutput()) / exact - 1.0;
    std::cout << "  [" << tube[0] << ", " << tube[1] << "] of " << exact << ": " << 100.0 * error
              << " %\n";
    return error;
  }

private:
  vtkNew<vtkFlowVolume> Volume;
};

}

int TestFlowVolumeTubes(int, char*[])
{
  Check check;
  const SampleBoxes positions;
  const Tube all{ { 0.0, 2.0 } };
  const Tube behind{ { 0.0, 0.6 } };
  // A tube that grazes the sphere. It is 1.6 cells wide with 33 samples per axis.
  const Tube grazing{ { 0.25, 0.35 } };
  const struct
  {
    std::string Name;
    int Samples;
    int Levels;
    double OfAll;
    double OfBehind;
    double OfGrazing;
  } cases[] = {
    { "33 samples", 33, 0, 0.002, 0.01, 0.07 },
    { "65 samples", 65, 0, 0.002, 0.005, 0.02 },
    { "33 samples, refined once", 33, 1, 0.002, 0.01, 0.02 },
  };
  std::vector<double> errors;
  for (const auto& one : cases)
  {
    std::cout << one.Name << "\n";
    check.SetContext(one.Name);
    Tubes tubes(one.Samples, one.Levels);
    check.Near(tubes.GetError(all, positions), 0.0, one.OfAll, "all", 1.0);
    check.Near(tubes.GetError(behind, positions), 0.0, one.OfBehind, "behind the sphere", 1.0);
    errors.push_back(std::abs(tubes.GetError(grazing, positions)));
    check.Near(errors.back(), 0.0, one.OfGrazing, "a narrow tube", 1.0);
  }
  check.SetContext("order");
  const double order = std::log2(errors[0] / errors[1]);
  std::cout << "order of convergence with the sample spacing: " << order << "\n";
  check.That(order > 1.5, "the error of a narrow tube decreases with the sample spacing");
  check.That(errors[2] < 0.5 * errors[0], "the error decreases with refinement");
  return check.Result();
}
