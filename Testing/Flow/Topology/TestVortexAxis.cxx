// SPDX-License-Identifier: BSD-3-Clause
// Straight, tilted and curved axes on all kinds of grids, found exactly or with second-order
// errors. Also tests several vortices, the seed, the frame of reference, interrupted axes, fields
// without vortices, planes, threads, progress, abort and errors.
#include "Support/AnalyticFlows/ReferenceFlowMaps.h"
#include "Support/Arrays/ReferenceVector.h"
#include "Support/Checks/LargestError.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceExecution.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Checks/ReferenceProgress.h"
#include "Support/Meshes/ReferenceLattice.h"
#include "Support/Meshes/ReferenceMesh.h"

#include "vtkAnalyticFlowSource.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVortexAxis.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{

using namespace reference;

constexpr double Pi = 3.14159265358979323846;

// Function that returns the position on an axis at a given z.
using Curve = std::function<FlowVector(double)>;

// Returns a vortex with zero in-plane velocity on a curve and a swirl that decays outward.
FlowFunction MakeVortex(const Curve& curve, double swirl, double radius)
{
  return [=](const FlowVector& x)
  {
    const FlowVector axis = curve(x[2]);
    const double d[2] = { x[0] - axis[0], x[1] - axis[1] };
    const double rotation = swirl * std::exp(-(d[0] * d[0] + d[1] * d[1]) / (radius * radius));
    return FlowVector{ { -rotation * d[1] - 0.1 * d[0], rotation * d[0] - 0.1 * d[1], 0.3 } };
  };
}

vtkSmartPointer<vtkImageData> MakeCube(int cells)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(cells + 1, cells + 1, cells + 1);
  image->SetOrigin(-1.0, -1.0, -1.0);
  image->SetSpacing(2.0 / cells, 2.0 / cells, 2.0 / cells);
  return image;
}

// Returns a filter whose warnings about an empty result are ignored.
vtkSmartPointer<vtkVortexAxis> MakeFilter()
{
  auto filter = vtkSmartPointer<vtkVortexAxis>::New();
  AllowWarnings(filter);
  return filter;
}

vtkPolyData* Run(vtkVortexAxis* filter, vtkDataSet* data)
{
  filter->SetInputDataObject(data);
  filter->Update();
  return filter->GetOutput();
}

// Returns the maximum in-plane distance of the output's points from a curve.
double GetError(vtkPolyData* output, const Curve& curve)
{
  double largest = 0.0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double x[3];
    output->GetPoint(i, x);
    const FlowVector axis = curve(x[2]);
    reference::KeepLargest(largest, std::hypot(x[0] - axis[0], x[1] - axis[1]));
  }
  return largest;
}

double GetLargest(vtkPolyData* output, const char* name)
{
  double range[2] = { 0.0, HUGE_VAL };
  if (vtkDataArray* array = output->GetPointData()->GetArray(name))
  {
    array->GetRange(range);
  }
  return range[1];
}

void CheckLine(vtkPolyData* output, vtkIdType points, Check& check)
{
  check.Equal(output->GetNumberOfPoints(), points, "places");
  check.Equal(output->GetNumberOfLines(), 1, "lines");
  check.Equal(output->GetNumberOfVerts(), 0, "vertices");
  check.Near(GetLargest(output, "CrossFlowSpeed"), 0.0, 1e-13, "cross-flow speed", 1.0);
  for (vtkIdType i = 1; i < output->GetNumberOfPoints(); ++i)
  {
    double a[3];
    double b[3];
    output->GetPoint(i - 1, a);
    output->GetPoint(i, b);
    check.That(a[2] < b[2], "points are ordered by height");
  }
}

// The tilted axis of a linear vortex is found up to rounding error on any grid.
void CheckLinear(Check& check)
{
  const FlowVector direction = { { 0.2, -0.3, 1.0 } };
  const Curve line = [&](double z) {
    return FlowVector{ { 1.41 + direction[0] * z, 2.37 + direction[1] * z, z } };
  };
  const FlowFunction field = [&](const FlowVector& x)
  {
    const FlowVector axis = line(x[2]);
    const double d[2] = { x[0] - axis[0], x[1] - axis[1] };
    return FlowVector{ { 0.4 * d[0] - 3.0 * d[1], 2.0 * d[0] - 0.2 * d[1], 0.7 + x[2] } };
  };
  // Imaginary part of the eigenvalues of [[0.4, -3], [2, -0.2]].
  const double swirl = std::sqrt(6.0 - 0.09);
  for (const MeshKind kind : { MeshKind::Hexahedra, MeshKind::Voxels, MeshKind::Wedges,
         MeshKind::Pyramids, MeshKind::Tetrahedra5, MeshKind::Tetrahedra6, MeshKind::Tetrahedra12 })
  {
    auto mesh = MakeMesh(kind, { 3, 4, 2 });
    SetVelocity(mesh, field);
    for (const int planes : { 0, 1, 2, 3, 7, 20 })
    {
      check.SetContext(GetName(kind) + ", " + std::to_string(planes) + " planes");
      const auto filter = MakeFilter();
      filter->SetNumberOfPlanes(planes);
      vtkPolyData* output = Run(filter, mesh);
      if (planes == 1)
      {
        check.Equal(output->GetNumberOfPoints(), 1, "places");
        check.Equal(output->GetNumberOfVerts(), 1, "vertices");
        check.Near(output->GetPoint(0)[2], 1.0, 1e-15, "the center plane");
      }
      else
      {
        const double number = std::cbrt(static_cast<double>(mesh->GetNumberOfPoints()));
        CheckLine(output, planes == 0 ? std::lround(number) : planes, check);
      }
      check.Near(GetError(output, line), 0.0, 1e-13, "distance from the axis", 1.0);
      for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
      {
        vtkPointData* data = output->GetPointData();
        check.Near(data->GetArray("SwirlStrength")->GetTuple1(i), swirl, 1e-12, "swirl");
        check.Near(data->GetArray("AxialVelocity")->GetTuple1(i), 0.7 + output->GetPoint(i)[2],
          1e-12, "axial velocity");
      }
    }
  }
  auto image = MakeImage({ 8, 7, 6 });
  SetVelocity(image,
    [](const FlowVector& x)
    {
      const double d[2] = { x[0] + 0.93 - 0.02 * x[2], x[1] - 1.8 + 0.1 * x[2] };
      return FlowVector{ { -d[1], d[0], 1.0 } };
    });
  for (const DataSetVariant& form : FormsOf(image))
  {
    check.SetContext(form.Name);
    const auto filter = MakeFilter();
    filter->SetNumberOfPlanes(form.Data->IsA("vtkUnstructuredGrid") ? 7 : 0);
    vtkPolyData* output = Run(filter, form.Data);
    CheckLine(output, 7, check);
    const Curve axis = [](double z) {
      return FlowVector{ { -0.93 + 0.02 * z, 1.8 - 0.1 * z, z } };
    };
    check.Near(GetError(output, axis), 0.0, 1e-12, "distance from the axis", 1.0);
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      check.Near(output->GetPoint(i)[2], 2.1 + 0.7 * i, 1e-13, "one layer of points");
    }
  }
}

// Layers with nonuniform spacing, and layers whose coordinates along the axis differ by rounding
// errors.
void CheckLayers(Check& check)
{
  check.SetContext("nonuniform layers");
  vtkNew<vtkRectilinearGrid> grid;
  grid->SetDimensions(4, 4, 5);
  vtkNew<vtkDoubleArray> across;
  vtkNew<vtkDoubleArray> along;
  for (const double x : { -1.0, -0.2, 0.3, 1.0 })
  {
    across->InsertNextValue(x);
  }
  const double layers[5] = { 3.0, 2.5, 1.0, 0.9, -2.0 };
  for (const double layer : layers)
  {
    along->InsertNextValue(layer);
  }
  grid->SetXCoordinates(across);
  grid->SetYCoordinates(across);
  grid->SetZCoordinates(along);
  const Curve line = [](double) { return FlowVector{ { 0.1, 0.2, 0.0 } }; };
  SetVelocity(grid, MakeVortex(line, 1.0, 1e6));
  const auto filter = MakeFilter();
  vtkPolyData* output = Run(filter, grid);
  CheckLine(output, 5, check);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    check.Near(output->GetPoint(i)[2], layers[4 - i], 1e-15, "the layer", 1.0);
  }

  check.SetContext("rotated layers");
  auto image = MakeImage({ 9, 8, 11 });
  const double third = 1.0 / 3.0;
  image->SetDirectionMatrix(
    2 * third, -third, 2 * third, 2 * third, 2 * third, -third, -third, 2 * third, 2 * third);
  image->SetOrigin(117.3, -211.9, 301.7);
  const FlowVector axis = { { 2 * third, -third, 2 * third } };
  filter->SetAxis(axis.data());
  for (int position = 0; position < 30; ++position)
  {
    FlowVector center;
    image->GetPoint(1 + position % 7 + 10 * (1 + position / 7), center.data());
    SetVelocity(image,
      [&](const FlowVector& x)
      {
        return Multiply(CrossMatrix(axis),
          { { x[0] - center[0] - 0.001 * position, x[1] - center[1], x[2] - center[2] } });
      });
    for (const DataSetVariant& form : FormsOf(image))
    {
      filter->SetNumberOfPlanes(form.Data->IsA("vtkUnstructuredGrid") ? 12 : 0);
      output = Run(filter, form.Data);
      check.Equal(output->GetNumberOfPoints(), 12, "one point per layer of the " + form.Name);
      check.Equal(output->GetNumberOfLines(), 1, "lines");
    }
  }
}

// Directions other than the default, and axes along edges and faces of cells.
void CheckDirections(Check& check)
{
  const std::vector<FlowVector> axes = { { { 0.0, 0.0, 1.0 } }, { { 3.0, 0.0, 0.0 } },
    { { 0.0, -1e-200, 0.0 } }, { { 1.0, 2.0, -2.0 } }, { { 0.1, 1e5, 0.3 } } };
  for (const FlowVector& axis : axes)
  {
    for (const FlowVector& center :
      { FlowVector{ { 0.0, 0.0, 0.0 } }, { { 0.1, 0.03, -0.07 } }, { { 0.0, 0.04, 0.1 } } })
    {
      check.SetContext("axis " + std::to_string(axis[0]) + " " + std::to_string(axis[1]) + " " +
        std::to_string(axis[2]));
      vtkNew<vtkAnalyticFlowSource> source;
      source->SetField(vtkAnalyticFlowSource::ROTATION);
      source->SetDimensions(21, 21, 21);
      source->SetAxis(axis[0], axis[1], axis[2]);
      source->SetAngularVelocity(-1.5);
      source->SetCenter(center[0], center[1], center[2]);
      source->Update();
      const auto filter = MakeFilter();
      filter->SetAxis(axis.data());
      vtkPolyData* output = Run(filter, source->GetOutput());
      const double largest = std::max({ std::abs(axis[0]), std::abs(axis[1]), std::abs(axis[2]) });
      const FlowVector scaled = (1.0 / largest) * axis;
      const double length = GetNorm(scaled);
      const FlowVector unit = (1.0 / length) * scaled;
      check.That(output->GetNumberOfPoints() >= 12 && output->GetNumberOfPoints() <= 21,
        "points: " + std::to_string(output->GetNumberOfPoints()));
      check.Equal(output->GetNumberOfLines(), 1, "lines");
      if (length == 1.0)
      {
        check.Equal(output->GetNumberOfPoints(), 21, "one point per layer");
      }
      for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
      {
        FlowVector d;
        output->GetPoint(i, d.data());
        d = d - center;
        check.Near(GetNorm(d - Dot(unit, d) * unit), 0.0, 1e-12, "place", 1.0);
        check.Near(
          output->GetPointData()->GetArray("SwirlStrength")->GetTuple1(i), 1.5, 1e-10, "swirl");
      }
    }
  }
}

void CheckOrder(Check& check)
{
  const std::pair<const char*, Curve> curves[] = {
    { "straight",
      [](double) {
        return FlowVector{ { 0.123, -0.077, 0.0 } };
      } },
    { "tilted",
      [](double z) {
        return FlowVector{ { 0.123 + 0.3 * z, -0.077 - 0.2 * z, 0.0 } };
      } },
    { "curved",
      [](double z) {
        return FlowVector{ { 0.05 + 0.3 * std::sin(2.0 * z), 0.2 * std::cos(1.5 * z) - 0.1, 0.0 } };
      } },
  };
  for (const auto& curve : curves)
  {
    check.SetContext(curve.first);
    std::vector<double> errors;
    for (const int cells : { 16, 32, 64 })
    {
      auto image = MakeCube(cells);
      // The swirl is not symmetric around the axis, because symmetric errors would cancel.
      const FlowFunction vortex = MakeVortex(curve.second, 2.0, 0.6);
      SetVelocity(image,
        [&](const FlowVector& x)
        {
          const FlowVector axis = curve.second(x[2]);
          const FlowVector v = vortex(x);
          const double factor = 1.0 + 0.5 * std::sin(3.0 * (x[0] - axis[0]) + (x[1] - axis[1]));
          return FlowVector{ { factor * v[0], factor * v[1], v[2] } };
        });
      const auto filter = MakeFilter();
      vtkPolyData* output = Run(filter, image);
      CheckLine(output, cells + 1, check);
      errors.push_back(GetError(output, curve.second));
      check.Near(errors.back(), 0.0, 2.0 / cells / cells, "distance from the axis", 1.0);
      check.Near(GetLargest(output, "SwirlStrength"), 2.0, 8.0 / cells, "swirl");
      check.Near(GetLargest(output, "AxialVelocity"), 0.3, 1e-13, "axial velocity");
    }
    check.That(errors[2] < errors[0] / 8.0,
      "second order: " + std::to_string(errors[0]) + " " + std::to_string(errors[1]) + " " +
        std::to_string(errors[2]));
  }

  check.SetContext("hurricane");
  vtkNew<vtkAnalyticFlowSource> source;
  source->SetUpdraft(0.0);
  source->SetDimensions(61, 61, 31);
  source->Update();
  const auto filter = MakeFilter();
  vtkPolyData* output = Run(filter, source->GetOutput());
  CheckLine(output, 31, check);
  const Curve eye = [](double z)
  {
    const double bend = std::sin(Pi * 0.5 * (z + 1.0));
    return FlowVector{ { 0.1 * z + 0.1 * bend, 0.05 * z - 0.05 * bend, 0.0 } };
  };
  check.Near(GetError(output, eye), 0.0, 0.003, "distance from the eye", 1.0);
  // The sinking air in the eye flows along the tilted axis, so that the in-plane velocity is 0
  // slightly off the axis.
  source->SetUpdraft(0.3);
  source->Update();
  output = Run(filter, source->GetOutput());
  CheckLine(output, 31, check);
  check.Near(GetError(output, eye), 0.0, 0.008, "distance from the eye", 1.0);
}

void CheckChoice(Check& check)
{
  const Curve strong = [](double z) { return FlowVector{ { -0.5 + 0.1 * z, 0.0, 0.0 } }; };
  const Curve weak = [](double z) { return FlowVector{ { 0.5, 0.1 * z, 0.0 } }; };
  auto image = MakeCube(32);
  SetVelocity(image,
    [&](const FlowVector& x)
    { return MakeVortex(x[0] < 0.0 ? strong : weak, x[0] < 0.0 ? 3.0 : -1.0, 0.15)(x); });
  const auto filter = MakeFilter();
  check.SetContext("the strongest vortex");
  vtkPolyData* output = Run(filter, image);
  CheckLine(output, 33, check);
  check.Near(GetError(output, strong), 0.0, 0.01, "distance", 1.0);
  check.SetContext("the vortex closest to the seed");
  filter->UseSeedOn();
  filter->SetSeed(0.3, 0.2, 7.0);
  output = Run(filter, image);
  CheckLine(output, 33, check);
  check.Near(GetError(output, weak), 0.0, 0.01, "distance", 1.0);
  filter->SetSeed(-0.1, 0.0, -0.5);
  output = Run(filter, image);
  check.Near(GetError(output, strong), 0.0, 0.01, "distance", 1.0);
  check.SetContext("no vortex is strong enough");
  filter->SetMinimumSwirlStrength(10.0);
  output = Run(filter, image);
  check.Equal(output->GetNumberOfPoints(), 0, "places");

  check.SetContext("two vortices with the same rotation");
  const Curve other = [](double z) { return FlowVector{ { 0.1, 0.1 * z, 0.0 } }; };
  SetVelocity(image,
    [&](const FlowVector& x) { return MakeVortex(x[0] < -0.2 ? strong : other, 1.0, 0.15)(x); });
  const auto wide = MakeFilter();
  wide->SetSearchRadius(2.0);
  wide->UseSeedOn();
  for (const double seed : { -0.5, 0.1 })
  {
    wide->SetSeed(seed, 0.0, 0.0);
    output = Run(wide, image);
    CheckLine(output, 33, check);
    check.Near(GetError(output, seed < 0.0 ? strong : other), 0.0, 0.01, "distance", 1.0);
  }

  check.SetContext("a frame of reference");
  const Curve still = [](double z) { return FlowVector{ { 0.2, 0.1 * z, 0.0 } }; };
  SetVelocity(image,
    [&](const FlowVector& x)
    {
      const FlowVector v = MakeVortex(still, 1.0, 5.0)(x);
      return FlowVector{ { v[0] + 4.0, v[1] - 3.0, v[2] + 2.0 } };
    });
  const auto traveling = MakeFilter();
  output = Run(traveling, image);
  check.Equal(output->GetNumberOfPoints(), 0, "points without a frame velocity");
  traveling->SetFrameVelocity(4.0, -3.0, 2.0);
  output = Run(traveling, image);
  CheckLine(output, 33, check);
  check.Near(GetError(output, still), 0.0, 0.001, "distance", 1.0);
  check.Near(GetLargest(output, "AxialVelocity"), 0.3, 1e-12, "axial velocity");
}

void CheckBreaks(Check& check)
{
  // No vortex in the layers -0.3 < z < 0.2, and the opposite rotation above 0.7.
  const Curve axis = [](double z) { return FlowVector{ { 0.03, 0.1 * z, 0.0 } }; };
  auto image = MakeCube(20);
  SetVelocity(image,
    [&](const FlowVector& x)
    {
      const bool isGap = x[2] > -0.35 && x[2] < 0.25;
      return isGap ? FlowVector{ { 1.0, 0.0, 0.0 } }
                   : MakeVortex(axis, x[2] > 0.75 ? -1.0 : 1.0, 5.0)(x);
    });
  check.SetContext("breaks");
  const auto filter = MakeFilter();
  vtkPolyData* output = Run(filter, image);
  check.Equal(output->GetNumberOfLines(), 2, "lines");
  check.Equal(output->GetNumberOfPoints(), 7 + 5, "places");
  check.Near(GetError(output, axis), 0.0, 1e-3, "distance", 1.0);
  vtkNew<vtkIdList> ids;
  output->GetLines()->GetCellAtId(0, ids);
  check.Equal(ids->GetNumberOfIds(), 7, "points of the lower line");

  // The swirl determines the sense of rotation, even if the divergence is larger.
  check.SetContext("senses");
  SetVelocity(image,
    [&](const FlowVector& x)
    {
      const double rotation = x[2] > 0.25 ? -1.0 : 1.1;
      return FlowVector{ { 5.0 * x[0] - rotation * x[1], rotation * x[0] + 5.0 * x[1], 1.0 } };
    });
  output = Run(filter, image);
  check.Equal(output->GetNumberOfPoints(), 13, "points below the change of rotation");

  // An axis with a lateral jump, with search radii below and above the size of the jump.
  check.SetContext("a jump");
  const Curve jump = [](double z) { return FlowVector{ { z < 0.05 ? -0.4 : 0.5, 0.01, 0.0 } }; };
  SetVelocity(
    image, [&](const FlowVector& x) { return MakeVortex(jump, x[2] < 0.05 ? 2.0 : 1.0, 5.0)(x); });
  const auto near = MakeFilter();
  near->SetSearchRadius(0.05);
  output = Run(near, image);
  CheckLine(output, 11, check);
  near->SetSearchRadius(0.95);
  output = Run(near, image);
  CheckLine(output, 21, check);
  near->SetSearchRadius(0.16);
  output = Run(near, image);
  check.Equal(output->GetNumberOfLines(), 2, "found again after six planes");
  check.Equal(output->GetNumberOfPoints(), 11 + 5, "places");
}

void CheckNone(Check& check)
{
  vtkNew<vtkAnalyticFlowSource> source;
  source->SetDimensions(24, 24, 24);
  for (const int field : { vtkAnalyticFlowSource::UNIFORM, vtkAnalyticFlowSource::SADDLE,
         vtkAnalyticFlowSource::NODE, vtkAnalyticFlowSource::COUPLED_CHARGE,
         vtkAnalyticFlowSource::SHEAR, vtkAnalyticFlowSource::SPHERE })
  {
    check.SetContext(std::string("no vortex: ") + vtkAnalyticFlowSource::GetFieldName(field));
    source->SetField(field);
    for (const FlowVector& axis : { FlowVector{ { 0.0, 0.0, 1.0 } }, { { 1.0, 0.0, 0.0 } } })
    {
      source->SetNodeRates(1.0, 1.1, 1.2);
      source->Update();
      const auto filter = MakeFilter();
      filter->SetAxis(axis.data());
      filter->SetInputData(source->GetOutput());
      check.That(UpdateAndGetErrors(filter).empty(), "no error");
      check.Equal(filter->GetOutput()->GetNumberOfPoints(), 0, "places");
      check.Equal(filter->GetOutput()->GetNumberOfCells(), 0, "cells");
    }
  }
  check.SetContext("no vortex along an oblique axis");
  source->SetField(vtkAnalyticFlowSource::UNIFORM);
  source->SetVelocity(0.3, -0.7, 0.9);
  source->Update();
  const auto filter = MakeFilter();
  filter->SetAxis(0.3, -0.7, 0.9);
  SetVelocity(source->GetOutput(),
    [](const FlowVector& x)
    {
      const double speed = 1.0 + 0.3 * std::sin(7.0 * x[0] + 5.0 * x[1] - 3.0 * x[2]);
      return FlowVector{ { 0.3 * speed, -0.7 * speed, 0.9 * speed } };
    });
  check.Equal(Run(filter, source->GetOutput())->GetNumberOfPoints(), 0, "places");
}

void CheckExecution(Check& check)
{
  check.SetContext("execution");
  vtkNew<vtkAnalyticFlowSource> source;
  source->SetDimensions(30, 31, 32);
  source->Update();
  const auto filter = MakeFilter();
  const auto update = [&]() { return GetBytes(Run(filter, source->GetOutput())); };
  const auto find = [&]()
  {
    filter->Modified();
    const std::string bytes = update();
    check.That(!bytes.empty(), "an axis is found");
    return bytes;
  };
  CheckSame("execution", find, check);
  CheckAborts(filter, 5, { 0.0, 0.5 }, update, check);
}

void CheckErrors(Check& check)
{
  check.SetContext("errors");
  auto image = MakeCube(4);
  const auto filter = MakeFilter();
  filter->SetInputData(image);
  CheckError(filter, "The field has no active vectors", check);
  SetVelocity(image, MakeVortex([](double) { return FlowVector{}; }, 1.0, 5.0));
  filter->SetAxis(0.0, 0.0, 0.0);
  CheckError(filter, "Axis 0 0 0 has length 0", check);
  filter->SetAxis(0.0, std::nan(""), 1.0);
  CheckError(filter, "Axis 0 nan 1 is not finite", check);
  filter->SetAxis(0.0, 0.0, 2.0);
  filter->SetSeed(0.0, 0.0, HUGE_VAL);
  CheckError(filter, "Seed 0 0 inf is not finite", check);
  filter->SetSeed(0.0, 0.0, 0.0);
  filter->SetFrameVelocity(0.0, std::nan(""), 0.0);
  CheckError(filter, "FrameVelocity 0 nan 0 is not finite", check);
  filter->SetFrameVelocity(0.0, 0.0, 0.0);
  check.That(UpdateAndGetErrors(filter).empty(), "no error");
  check.Equal(filter->GetOutput()->GetNumberOfPoints(), 5, "places");
  auto flat = MakeImage({ 2, 2, 0 });
  SetVelocity(flat, MakeVortex([](double) { return FlowVector{}; }, 1.0, 5.0));
  filter->SetInputData(flat);
  CheckError(
    filter, "The field has no three-dimensional cells. Flow in a plane needs two layers", check);
  vtkNew<vtkUnstructuredGrid> empty;
  filter->SetInputData(empty);
  check.That(UpdateAndGetErrors(filter).empty(), "an empty grid is not an error");
  filter->SetNumberOfPlanes(-1);
  filter->SetSearchRadius(-1.0);
  filter->SetMinimumSwirlStrength(-1.0);
  CheckPrinted(Print(filter),
    { "Axis: 0 0 2", "NumberOfPlanes: 0", "UseSeed: Off", "Seed: 0 0 0", "FrameVelocity: 0 0 0",
      "SearchRadius: 0", "MinimumSwirlStrength: 0" },
    check);
}

}

int TestVortexAxis(int, char*[])
{
  return RunChecks({ CheckLinear, CheckLayers, CheckDirections, CheckOrder, CheckChoice,
    CheckBreaks, CheckNone, CheckExecution, CheckErrors });
}
