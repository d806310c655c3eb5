// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVortexAxis.h"

#include "Common/AbortCheck.h"
#include "Common/CellArrayConversion.h"
#include "Common/Error.h"
#include "Common/NamedValue.h"
#include "Common/ReportValue.h"
#include "Fields/FieldVectors.h"
#include "Termination/CrossFlow.h"

#include "vtkCellArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkVortexAxis);

namespace
{
using Vortex = interlume::CrossFlow::Vortex;

// Connects vortices from plane to plane.
class Tracker
{
public:
  Tracker(const interlume::CrossFlow& flow, const std::vector<interlume::ZeroSearch::Zero>& zeros,
    double minimumSwirlStrength, double radius)
    : Flow(flow)
    , Radius(radius)
    , Planes(flow.GetNumberOfPlanes())
  {
    for (const interlume::ZeroSearch::Zero& zero : zeros)
    {
      const Vortex vortex = flow.MakeVortex(zero);
      if (vortex.SwirlStrength > 0.0 && vortex.SwirlStrength >= minimumSwirlStrength)
      {
        this->Planes[vortex.Plane].push_back(vortex);
      }
    }
  }

  // Returns the strongest vortex, or null if there are none.
  const Vortex* FindStrongest() const
  {
    const Vortex* strongest = nullptr;
    for (const auto& plane : this->Planes)
    {
      for (const Vortex& vortex : plane)
      {
        strongest =
          !strongest || vortex.SwirlStrength > strongest->SwirlStrength ? &vortex : strongest;
      }
    }
    return strongest;
  }

  const Vortex* FindNearest(const double seed[3]) const
  {
    const double height = this->Flow.GetHeight(seed);
    const Vortex* nearest = nullptr;
    std::pair<double, double> smallest;
    for (const auto& plane : this->Planes)
    {
      for (const Vortex& vortex : plane)
      {
        const std::pair<double, double> distances = { std::abs(
                                                        this->Flow.GetPlane(vortex.Plane) - height),
          this->Flow.GetDistance(vortex.Position, seed) };
        if (!nearest || distances < smallest)
        {
          nearest = &vortex;
          smallest = distances;
        }
      }
    }
    return nearest;
  }

  // Returns the vortices connected to \a start, at most one per plane, in ascending order of
  // planes.
  std::vector<const Vortex*> Follow(const Vortex* start) const
  {
    std::vector<const Vortex*> axis = { start };
    for (const int direction : { -1, 1 })
    {
      const Vortex* last = start;
      for (int plane = start->Plane + direction;
           plane >= 0 && plane < static_cast<int>(this->Planes.size()); plane += direction)
      {
        if (const Vortex* next = this->FindNext(*last, plane))
        {
          axis.push_back(next);
          last = next;
        }
      }
    }
    std::sort(axis.begin(), axis.end(),
      [](const Vortex* a, const Vortex* b) { return a->Plane < b->Plane; });
    return axis;
  }

private:
  const Vortex* FindNext(const Vortex& last, int plane) const
  {
    const Vortex* next = nullptr;
    double smallest = this->Radius > 0.0 ? this->Radius * std::abs(plane - last.Plane)
                                         : 2.0 *
        (std::abs(this->Flow.GetPlane(plane) - this->Flow.GetPlane(last.Plane)) + last.CellLength);
    for (const Vortex& vortex : this->Planes[plane])
    {
      const double distance = this->Flow.GetDistance(vortex.Position, last.Position);
      if (vortex.IsCounterclockwise == last.IsCounterclockwise &&
        (next ? distance < smallest : distance <= smallest))
      {
        next = &vortex;
        smallest = distance;
      }
    }
    return next;
  }

  const interlume::CrossFlow& Flow;
  double Radius;
  std::vector<std::vector<Vortex>> Planes;
};

void Write(const std::vector<const Vortex*>& axis, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkDoubleArray> speeds;
  speeds->SetName("CrossFlowSpeed");
  vtkNew<vtkDoubleArray> swirls;
  swirls->SetName("SwirlStrength");
  vtkNew<vtkDoubleArray> velocities;
  velocities->SetName("AxialVelocity");
  std::vector<vtkIdType> ids;
  for (std::size_t i = 0; i < axis.size(); ++i)
  {
    const Vortex& vortex = *axis[i];
    ids.push_back(points->InsertNextPoint(vortex.Position));
    speeds->InsertNextValue(vortex.CrossFlowSpeed);
    swirls->InsertNextValue(vortex.SwirlStrength);
    velocities->InsertNextValue(vortex.AxialVelocity);
    if (i + 1 == axis.size() || axis[i + 1]->Plane != vortex.Plane + 1)
    {
      (ids.size() > 1 ? lines : vertices)
        ->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
      ids.clear();
    }
  }
  output->SetPoints(points);
  output->SetLines(lines);
  output->SetVerts(vertices);
  output->GetPointData()->AddArray(speeds);
  output->GetPointData()->SetScalars(swirls);
  output->GetPointData()->AddArray(velocities);
}

interlume::Error CheckVector(const char* name, const double v[3], bool isDirection)
{
  const bool isFinite = std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
  const bool isZero = v[0] == 0.0 && v[1] == 0.0 && v[2] == 0.0;
  std::ostringstream what;
  if (!isFinite || (isDirection && isZero))
  {
    what << name << " " << v[0] << " " << v[1] << " " << v[2]
         << (isFinite ? " has length 0; set a direction." : " is not finite.");
  }
  return what.str();
}

void SetAxisReport(vtkInterlumeReport* report, int planes = 0, vtkIdType zeros = 0,
  vtkIdType pointsOnAxis = 0, const interlume::ZeroSearch::Counts& counts = {},
  const std::vector<std::string>& converted = {})
{
  interlume::ReportValue::Set(report,
    { { "Planes", planes }, { "CrossFlowZeros", zeros }, { "PointsOnAxis", pointsOnAxis },
      { "NonFiniteCells", counts.NonFiniteCells }, { "FillValueCells", counts.FillValueCells },
      { "ConvertedCellArrays", converted } });
}
}

vtkVortexAxis::vtkVortexAxis()
{
  SetAxisReport(this->Report);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::VECTORS);
}

vtkVortexAxis::~vtkVortexAxis() = default;

int vtkVortexAxis::FillInputPortInformation(int, vtkInformation* info)
{
  interlume::FieldVectors::FillPortInformation(info);
  return 1;
}

int vtkVortexAxis::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  interlume::CellArrayConversion::RequestGhostCells(this, inputs, outputs);
  return 1;
}

int vtkVortexAxis::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  SetAxisReport(this->Report);
  interlume::CellArrayConversion conversion(this, 3);
  const auto selection = interlume::FieldVectors::Select(this, conversion, inputs, outputs);
  vtkDataSet* input = selection.Data;
  if (!input)
  {
    return 1;
  }
  for (const interlume::Error& error :
    { CheckVector("Axis", this->Axis, true), CheckVector("Seed", this->Seed, false),
      CheckVector("FrameVelocity", this->FrameVelocity, false) })
  {
    if (error)
    {
      vtkErrorMacro(<< error);
      return 1;
    }
  }
  this->SetProgressText("Searching planes for the vortex");
  interlume::CrossFlow flow(this->Axis, this->FrameVelocity);
  flow.PlacePlanes(input, this->NumberOfPlanes);
  interlume::ZeroSearch search;
  if (!search.Execute(this, input, vtkDataArray::SafeDownCast(selection.Array), flow))
  {
    return interlume::AbortCheck::Leave(outputs);
  }
  const Tracker tracker(flow, search.GetZeros(), this->MinimumSwirlStrength, this->SearchRadius);
  if (const Vortex* start =
        this->UseSeed ? tracker.FindNearest(this->Seed) : tracker.FindStrongest())
  {
    Write(tracker.Follow(start), output);
  }
  else
  {
    vtkWarningMacro("No plane perpendicular to Axis ("
      << this->Axis[0] << ", " << this->Axis[1] << ", " << this->Axis[2]
      << ") has a vortex: the in-plane velocity is 0 at " << search.GetZeros().size()
      << " points in the " << flow.GetNumberOfPlanes()
      << " planes, but the flow rotates around none of these points"
      << (this->MinimumSwirlStrength > 0.0 ? " as strongly as MinimumSwirlStrength requires."
                                           : "."));
  }
  SetAxisReport(this->Report, flow.GetNumberOfPlanes(),
    static_cast<vtkIdType>(search.GetZeros().size()), output->GetNumberOfPoints(),
    search.GetCounts(), conversion.GetNames());
  this->UpdateProgress(1.0);
  return 1;
}

void vtkVortexAxis::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  interlume::NamedValue::Print(os, indent,
    { { "Axis", this->Axis }, { "NumberOfPlanes", this->NumberOfPlanes },
      { "UseSeed", this->UseSeed ? "On" : "Off" }, { "Seed", this->Seed },
      { "FrameVelocity", this->FrameVelocity }, { "SearchRadius", this->SearchRadius },
      { "MinimumSwirlStrength", this->MinimumSwirlStrength } });
  os << indent << "Report:\n";
  this->Report->PrintSelf(os, indent.GetNextIndent());
}
