// SPDX-License-Identifier: BSD-3-Clause
// Domain faces of unstructured grids and of several blocks: patches between sharp edges, their ids
// and parameters, compared with known streamlines.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Flow/ReferenceFlowGrid.h"

#include "vtkFlowStatus.h"
#include "vtkImplicitFlowField.h"

#include "vtkAppendFilter.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <map>
#include <string>

namespace
{

using namespace reference;

constexpr int Cells = 4;

/// Flow out of the box along straight lines from its center.
Vector Diverge(const Vector& x)
{
  return { { x[0] - 2.0, x[1] - 2.0, x[2] - 2.0 } };
}

vtkDataSet* Follow(vtkImplicitFlowField* filter, vtkDataObject* field)
{
  filter->SetInputDataObject(field);
  filter->SetDirectionToForward();
  filter->DomainFacesOn();
  filter->SetDomainFaceId(40);
  filter->Update();
  return vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
}

double GetValue(vtkDataSet* data, const char* name, vtkIdType id, int component = 0)
{
  return data->GetPointData()->GetArray(name)->GetComponent(id, component);
}

/// Checks that the samples in a box reach the expected patch at the expected position and time.
void CheckBox(const std::string& name, vtkDataObject* field, double tolerance, Check& check)
{
  check.SetContext(name);
  vtkNew<vtkImplicitFlowField> filter;
  filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
  filter->SetSampleDimensions(9, 8, 10);
  filter->SetSampleBounds(0.3, 3.67, 0.41, 3.53, 0.27, 3.6);
  vtkDataSet* output = Follow(filter, field);
  check.Equal(output->GetFieldData()->GetArray(vtkFlowStatus::SurfacesArray())->GetNumberOfTuples(),
    6, "patches");
  std::map<int, int> sides;
  for (vtkIdType id = 0; id < output->GetNumberOfPoints(); ++id)
  {
    Vector x;
    output->GetPoint(id, x.data());
    const Vector direction = Diverge(x);
    int axis = 0;
    for (int i = 1; i < 3; ++i)
    {
      axis = std::abs(direction[i]) > std::abs(direction[axis]) ? i : axis;
    }
    const int side = 2 * axis + (direction[axis] > 0.0 ? 1 : 0);
    check.Equal(static_cast<int>(GetValue(output, "FlowStatus", id)),
      vtkFlowStatus::REACHED_SURFACE, "samples that leave the domain");
    const int patch = static_cast<int>(GetValue(output, "TerminationId", id));
    check.That(patch >= 40 && patch < 46, "ids of patches");
    check.Equal(sides.emplace(patch, side).first->second, side, "one patch for each side");
    check.Near(GetValue(output, "AdvectionTime", id), std::log(2.0 / std::abs(direction[axis])),
      1e-5 + tolerance, "time to the patch", 1.0);
    int component = 0;
    for (int i = 0; i < 3; ++i)
    {
      if (i != axis)
      {
        check.Near(GetValue(output, "TerminationUV", id, component++),
          0.5 + 0.5 * direction[i] / std::abs(direction[axis]), 1e-5 + tolerance,
          "position on the patch", 1.0);
      }
    }
  }
  check.Equal(sides.size(), 6, "number of sides that are reached");
}

void TestBoxes(Check& check)
{
  const std::array<int, 3> cells = { { Cells, Cells, Cells } };
  for (const MeshKind kind : FlowMeshKinds())
  {
    for (const double bend : { 0.0, 1e-3 })
    {
      auto grid = MakeFlowMesh(kind, cells, bend == 0.0);
      MovePoints(grid,
        [bend](const Vector& x)
        {
          return Vector{ { x[0] + bend * std::sin(5.0 * x[1]), x[1] + bend * std::sin(5.0 * x[2]),
            x[2] + bend * std::sin(5.0 * x[0]) } };
        });
      AddVectors(grid, Diverge);
      CheckBox(GetName(kind) + " displaced by " + std::to_string(bend), grid, 2.0 * bend, check);
    }
  }
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (int i = 0; i < 2; ++i)
  {
    auto block = MakeStructuredGrid({ { Cells / 2, Cells, Cells } });
    MovePoints(block, [i](const Vector& x) { return Vector{ { x[0] + 2.0 * i, x[1], x[2] } }; });
    AddVectors(block, Diverge);
    blocks->SetBlock(i, block);
  }
  CheckBox("two blocks", blocks, 0.0, check);
  check.SetContext("");
}

/// Adjacent faces at a small angle form one patch. A ring has four patches: inside, outside and
/// both ends.
void TestRing(Check& check)
{
  vtkNew<vtkAppendFilter> append;
  append->AddInputData(MakeRing({ { 3, 16, 4 } }));
  append->Update();
  vtkUnstructuredGrid* ring = append->GetOutput();
  AddVectors(ring, [](const Vector& x) { return Vector{ { x[0], x[1], 0.0 } }; });
  vtkNew<vtkImplicitFlowField> filter;
  vtkDataSet* output = Follow(filter, ring);
  check.Equal(output->GetFieldData()->GetArray(vtkFlowStatus::SurfacesArray())->GetNumberOfTuples(),
    4, "patches of a ring");
  check.Equal(filter->GetReport()->GetSize("SurfaceIds"), 1, "number of patches that are reached");
  check.Equal(filter->GetReport()->GetCount("SamplesBySurface"), ring->GetNumberOfPoints(),
    "samples that reach the outside");
}

}

int TestFlowDomainPatches(int, char*[])
{
  Check check;
  TestBoxes(check);
  TestRing(check);
  return check.Result();
}
