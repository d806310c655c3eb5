// SPDX-License-Identifier: BSD-3-Clause
// Stream tubes of potential flow around a ball of hidden points, against streamlines from many
// random places of the same field: below 2 % with as many samples as the field has points, but for
// tubes narrower than two samples where the flow grazes the ball. There the error is that of
// interpolation between samples, which falls with their distance.
#include "Support/AnalyticFlows/ReferenceFlowAnswers.h"
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
/// The distance from the axis, at the plane where streamlines end.
constexpr const char* AxisDistance = "sqrt((10*u-5-0.02)^2+(10*v-5+0.03)^2)";

/// Flow along x with speed 1 that a ball deflects.
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

vtkSmartPointer<vtkUnstructuredGrid> MakePlaces(int boxes)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vector& x : MakeRandomPlaces(boxes, 3))
  {
    points->InsertNextPoint(x.data());
  }
  auto places = vtkSmartPointer<vtkUnstructuredGrid>::New();
  places->SetPoints(points);
  return places;
}

/// The samples of a filter, with the distance from the axis as Inflow.
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

/// The share of places in a tube, as a volume.
class Places
{
public:
  Places()
  {
    vtkNew<vtkImplicitFlowField> field;
    field->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_INPUT);
    field->SetSampleData(MakePlaces(64));
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

  /// Returns the error of a tube's volume, relative to that of the places.
  double GetError(const Tube& tube, const Places& places)
  {
    this->Volume->SetInterval(0, tube[0], tube[1]);
    this->Volume->Update();
    const double exact = places.Measure(tube);
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
  const Places places;
  const Tube all{ { 0.0, 2.0 } };
  const Tube behind{ { 0.0, 0.6 } };
  // As wide as 1.6 cells of 33 samples, where the flow grazes the ball.
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
    check.Near(tubes.GetError(all, places), 0.0, one.OfAll, "all", 1.0);
    check.Near(tubes.GetError(behind, places), 0.0, one.OfBehind, "behind the ball", 1.0);
    errors.push_back(std::abs(tubes.GetError(grazing, places)));
    check.Near(errors.back(), 0.0, one.OfGrazing, "a narrow tube", 1.0);
  }
  check.SetContext("order");
  const double order = std::log2(errors[0] / errors[1]);
  std::cout << "order in the distance of samples: " << order << "\n";
  check.That(order > 1.5, "the error of a narrow tube falls with the samples' distance");
  check.That(errors[2] < 0.5 * errors[0], "and by refinement");
  return check.Result();
}
