// SPDX-License-Identifier: BSD-3-Clause
// Tests implicit flow fields of all types of grids and surfaces at sizes whose squares or cubes
// overflow or underflow. The results must equal the results at size 1.
#include "StabilityChecks.h"
#include "StabilityShapes.h"

#include "Support/AnalyticFlows/ReferenceFlowMaps.h"
#include "Support/Checks/LargestError.h"
#include "Support/Meshes/ReferenceMesh.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFlowStatus.h"
#include "vtkImageData.h"
#include "vtkImplicitFlowField.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkTerminationSurface.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace
{

using namespace reference;
using namespace stability;

constexpr double Lower = -2.1;
constexpr double Width = 4.4;
constexpr int Cells = 6;
/// Powers of 2 close to 1e-160, 1e-100, 1e-12 and so on. Scaling by them changes only exponents.
/// Therefore rounding cannot put a sample on the other side of a surface.
const double Sizes[] = { std::ldexp(1.0, -532), std::ldexp(1.0, -332), std::ldexp(1.0, -40),
  std::ldexp(1.0, 40), std::ldexp(1.0, 332), std::ldexp(1.0, 532) };

double GridCoordinate(double i, int cells = Cells)
{
  return Lower + Width * i / cells;
}

vtkSmartPointer<vtkDataSet> MakeImage(double size)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(Cells + 1, Cells + 1, Cells + 1);
  image->SetOrigin(Lower * size, Lower * size, Lower * size);
  const double spacing = Width / Cells * size;
  image->SetSpacing(spacing, spacing, spacing);
  return image;
}

vtkSmartPointer<vtkDataSet> MakeRectilinear(double size)
{
  vtkNew<vtkDoubleArray> coordinates;
  for (int i = 0; i <= Cells; ++i)
  {
    coordinates->InsertNextValue((GridCoordinate(i) + (i == 2 ? 0.1 : 0.0)) * size);
  }
  auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  grid->SetDimensions(Cells + 1, Cells + 1, Cells + 1);
  grid->SetXCoordinates(coordinates);
  grid->SetYCoordinates(coordinates);
  grid->SetZCoordinates(coordinates);
  return grid;
}

vtkSmartPointer<vtkDataSet> MakeCurvilinear(double size)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int k = 0; k <= Cells; ++k)
  {
    for (int j = 0; j <= Cells; ++j)
    {
      for (int i = 0; i <= Cells; ++i)
      {
        const double x[3] = { GridCoordinate(i), GridCoordinate(j), GridCoordinate(k) };
        points->InsertNextPoint((x[0] + 0.1 * std::sin(x[1])) * size,
          (x[1] + 0.1 * std::sin(x[2])) * size, (x[2] + 0.1 * std::sin(x[0])) * size);
      }
    }
  }
  auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  grid->SetDimensions(Cells + 1, Cells + 1, Cells + 1);
  grid->SetPoints(points);
  return grid;
}

/// Returns a structured grid around the z-axis whose last angle almost coincides with the first.
vtkSmartPointer<vtkDataSet> MakeClosed(double size)
{
  constexpr int angles = 12;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int k = 0; k <= Cells; ++k)
  {
    for (int j = 0; j <= Cells; ++j)
    {
      for (int i = 0; i <= angles; ++i)
      {
        const double angle = 2.0 * vtkMath::Pi() * i / angles * (1.0 - 1e-7);
        const double radius = 0.2 + 0.35 * j;
        points->InsertNextPoint(radius * std::cos(angle) * size, radius * std::sin(angle) * size,
          GridCoordinate(k) * size);
      }
    }
  }
  auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  grid->SetDimensions(angles + 1, Cells + 1, Cells + 1);
  grid->SetPoints(points);
  return grid;
}

vtkSmartPointer<vtkDataSet> MakeUnstructured(MeshKind kind, double size, int cells = Cells)
{
  auto mesh = MakeMesh(kind, { { cells, cells, cells } });
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double x[3];
    mesh->GetPoint(i, x);
    for (double& component : x)
    {
      component = GridCoordinate(component, cells) * size;
    }
    points->InsertNextPoint(x);
  }
  mesh->SetPoints(points);
  return mesh;
}

struct Kind
{
  const char* Name;
  std::function<vtkSmartPointer<vtkDataSet>(double size)> Make;
};

std::vector<Kind> MakeKinds()
{
  std::vector<Kind> kinds = { { "image", MakeImage }, { "rectilinear", MakeRectilinear },
    { "curvilinear", MakeCurvilinear }, { "closed", MakeClosed } };
  const struct
  {
    const char* Name;
    MeshKind Kind;
  } meshes[] = { { "hexahedra", MeshKind::Hexahedra }, { "wedges", MeshKind::Wedges },
    { "pyramids", MeshKind::Pyramids }, { "tetrahedra", MeshKind::Tetrahedra6 } };
  for (const auto& mesh : meshes)
  {
    kinds.push_back(
      { mesh.Name, [kind = mesh.Kind](double size) { return MakeUnstructured(kind, size); } });
  }
  return kinds;
}

/// Sets upward flow that rotates about the z-axis.
void SetFlow(vtkDataSet* field, double size, double speed)
{
  SetVelocity(field,
    [=](const FlowVector& x)
    {
      return FlowVector{ { speed * (0.3 - 0.2 * (x[1] / size)), speed * (0.2 + 0.2 * (x[0] / size)),
        speed * (1.0 + 0.1 * (x[2] / size)) } };
    });
}

/// Divides the values of \a data by \a scale and returns the largest difference from \a expected,
/// or NaN if array sizes differ or a value is not finite. Periodic values are compared modulo 1.
double Compare(vtkFieldData* data, vtkFieldData* expected, const std::string& name, double scale,
  bool isPeriodic = false)
{
  vtkDataArray* array = data->GetArray(name.c_str());
  vtkDataArray* other = expected->GetArray(name.c_str());
  if (!array || !other || array->GetNumberOfValues() != other->GetNumberOfValues())
  {
    return array || other ? NaN : 0.0;
  }
  double largest = 0.0;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      double error = array->GetComponent(i, c) / scale - other->GetComponent(i, c);
      error = isPeriodic ? error - std::round(error) : error;
      // KeepLargest() stores NaN, which fails the comparison.
      reference::KeepLargest(largest, std::abs(error));
    }
  }
  return largest;
}

/// Returns the sum of each result array's largest difference from the results at size 1.
double CompareResults(vtkDataSet* output, vtkDataSet* expected, double size, double time)
{
  const auto compare = [&](const std::string& name, double scale, bool isPeriodic = false)
  {
    const std::string farSide = vtkFlowStatus::FarSidePrefix() + name;
    return Compare(output->GetPointData(), expected->GetPointData(), name, scale, isPeriodic) +
      Compare(output->GetFieldData(), expected->GetFieldData(), farSide, scale, isPeriodic);
  };
  return compare(vtkFlowStatus::StatusArray(), 1.0) + compare(vtkFlowStatus::IdArray(), 1.0) +
    compare(vtkFlowStatus::SideArray(), 1.0) +
    compare(vtkFlowStatus::ParametersArray(), 1.0, true) +
    compare(vtkFlowStatus::TimeArray(), time) + compare("ArcLength", size) +
    compare("MaximumSpeed", size / time) + compare("MeanVorticity", 1.0 / time) +
    compare("SampleDistance", size) + compare("SamplePosition", size);
}

int CountReached(vtkDataSet* output)
{
  vtkDataArray* status = output->GetPointData()->GetArray(vtkFlowStatus::StatusArray());
  int number = 0;
  for (vtkIdType i = 0; status && i < status->GetNumberOfTuples(); ++i)
  {
    number += status->GetTuple1(i) == vtkFlowStatus::REACHED_SURFACE ? 1 : 0;
  }
  return number;
}

using Setting = std::function<void(vtkImplicitFlowField*, double size, double speed)>;

/// Reports the difference from the results at size 1, where more than 10 samples must have reached
/// a surface.
void ReportSizes(StabilityCatalogue& catalogue, const std::string& name, const Kind& kind,
  const std::string& condition, double speed, const Setting& set)
{
  const auto execute = [&](vtkImplicitFlowField* filter, double size, double scaled)
  {
    auto field = kind.Make(size);
    SetFlow(field, size, scaled);
    filter->SetInputData(field);
    set(filter, size, scaled);
    return UpdateFilter(filter).Errors;
  };
  vtkNew<vtkImplicitFlowField> expected;
  execute(expected, 1.0, 1.0);
  const int reached = CountReached(expected->GetOutput());
  for (const double size : Sizes)
  {
    vtkNew<vtkImplicitFlowField> filter;
    const std::string errors = execute(filter, size, speed);
    catalogue.Measure(name + "-" + FormatShort(size),
      std::string(kind.Name) + " of size " + FormatShort(size) + ", " + condition,
      "largest difference from the results at size 1, of which " + std::to_string(reached) +
        " are on surfaces" + errors,
      reached > 10 ? CompareResults(filter->GetOutput(), expected->GetOutput(), size, size / speed)
                   : NaN,
      1e-12);
  }
}

void TestSurfaces(StabilityCatalogue& catalogue)
{
  for (const Kind& kind : MakeKinds())
  {
    for (const Shape& shape : MakeShapes())
    {
      const std::string surface =
        std::string(shape.Make(1.0, 0.0)->GetClassName()).substr(sizeof("vtkTermination") - 1);
      ReportSizes(catalogue, std::string(kind.Name) + "-" + surface, kind,
        "with a vtkTermination" + surface, 1.0,
        [&](vtkImplicitFlowField* filter, double size, double)
        { filter->AddTerminationSurface(shape.Make(1.7 * size, 0.013 * size)); });
    }
  }
}

void TestSettings(StabilityCatalogue& catalogue)
{
  const std::vector<Shape> shapes = MakeShapes();
  const auto addSurfaces = [&shapes](vtkImplicitFlowField* filter, double size, double)
  {
    for (const Shape& shape : shapes)
    {
      filter->AddTerminationSurface(shape.Make(0.5 * size, 0.013 * size));
    }
  };
  for (const Kind& kind : MakeKinds())
  {
    const std::string name = kind.Name;
    for (const double speed : { std::ldexp(1.0, -400), std::ldexp(1.0, 400) })
    {
      ReportSizes(catalogue, name + "-speed-" + FormatShort(speed), kind,
        "six surfaces, speeds of " + FormatShort(speed), speed, addSurfaces);
    }
    ReportSizes(catalogue, name + "-faces", kind, "domain faces, with lengths and vorticities", 1.0,
      [](vtkImplicitFlowField* filter, double, double)
      {
        filter->DomainFacesOn();
        filter->ComputeArcLengthOn();
        filter->ComputeMaximumSpeedOn();
        filter->ComputeMeanVorticityOn();
      });
    ReportSizes(catalogue, name + "-faces-alone", kind, "domain faces", 1.0,
      [](vtkImplicitFlowField* filter, double, double) { filter->DomainFacesOn(); });
    ReportSizes(catalogue, name + "-refined", kind, "six surfaces, refined cells", 1.0,
      [&](vtkImplicitFlowField* filter, double size, double)
      {
        addSurfaces(filter, size, 1.0);
        filter->SetRefinementLevels(1);
      });
    for (const int integrator :
      { vtkImplicitFlowField::DORMAND_PRINCE, vtkImplicitFlowField::ROSENBROCK })
    {
      ReportSizes(catalogue, name + "-method-" + std::to_string(integrator), kind,
        "six surfaces, method " + std::to_string(integrator), 1.0,
        [&](vtkImplicitFlowField* filter, double size, double)
        {
          addSurfaces(filter, size, 1.0);
          filter->SetIntegrator(integrator);
        });
    }
    // With the larger error bound, most samples are interpolated. With the smaller bound, none are.
    for (const double error : { 1e-6, 1e-8 })
    {
      ReportSizes(catalogue, name + "-shared-" + FormatShort(error), kind,
        "image samples that may interpolate streamlines, with errors up to " + FormatShort(error),
        1.0,
        [&](vtkImplicitFlowField* filter, double size, double speed)
        {
          filter->AddTerminationSurface(shapes[0].Make(size, 0.013 * size));
          filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
          filter->SetSampleDimensions(17, 17, 17);
          // All samples are above the plane, so that whole groups of neighboring samples reach it.
          filter->SetSampleBounds(
            0.6 * size, 1.2 * size, 0.6 * size, 1.2 * size, 0.2 * size, 0.8 * size);
          filter->SetMaximumError(error * speed);
          filter->InterpolateStreamlinesOn();
        });
    }
  }
}

/// Checks that the number of samples of an unstructured grid with more than 32768 points does not
/// depend on the grid's size.
void TestVoxels(StabilityCatalogue& catalogue)
{
  const auto count = [](double size)
  {
    auto field = MakeUnstructured(MeshKind::Hexahedra, size, 32);
    SetFlow(field, size, 1.0);
    vtkNew<vtkImplicitFlowField> filter;
    filter->SetInputData(field);
    filter->DomainFacesOn();
    filter->SetMaximumNumberOfSteps(1);
    filter->SetSamplingChecks(0);
    const std::string errors = UpdateFilter(filter).Errors;
    return errors.empty() ? static_cast<double>(filter->GetOutput()->GetNumberOfPoints()) : NaN;
  };
  const double expected = count(1.0);
  for (const double size : Sizes)
  {
    catalogue.Measure("voxels-" + FormatShort(size),
      "33³ points of hexahedra of size " + FormatShort(size),
      "difference from the " + FormatShort(expected) + " samples at size 1", count(size) - expected,
      0.0);
  }
}

}

int TestStabilityFlowSizes(int argc, char* argv[])
{
  return RunCases(
    __func__, "vtkImplicitFlowField", argc, argv, { TestSurfaces, TestSettings, TestVoxels });
}
