// SPDX-License-Identifier: BSD-3-Clause
// A source that writes every step into the same array yields the same output as a source with one
// array per step, whether the source marks the array as modified or not.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Meshes/ReferenceGrid.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/TimeVarying/ReferenceTimeVarying.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"
#include "vtkUnstructuredGridAlgorithm.h"

#include <algorithm>

namespace
{

using namespace reference;

/// Returns the same grid for every step and copies the scalars and points of the requested step
/// into it.
class InPlaceSource : public vtkUnstructuredGridAlgorithm
{
public:
  static InPlaceSource* New();
  vtkTypeMacro(InPlaceSource, vtkUnstructuredGridAlgorithm);

  TimeSteps Steps;
  bool MarksModified = true;
  int Requests = 0;

protected:
  InPlaceSource() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    std::vector<double> times;
    for (const TimeStep& step : this->Steps)
    {
      times.push_back(step.Time);
    }
    vtkInformation* info = outputs->GetInformationObject(0);
    const double range[2] = { times.front(), times.back() };
    info->Set(
      vtkStreamingDemandDrivenPipeline::TIME_STEPS(), times.data(), static_cast<int>(times.size()));
    info->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
    return 1;
  }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    ++this->Requests;
    vtkInformation* info = outputs->GetInformationObject(0);
    const double time = info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP());
    const auto step = std::find_if(this->Steps.begin(), this->Steps.end(),
      [time](const TimeStep& one) { return one.Time == time; });
    auto* from = vtkUnstructuredGrid::SafeDownCast(GetDataSet(*step));
    if (this->Grid->GetNumberOfPoints() == 0)
    {
      this->Grid->DeepCopy(from);
    }
    Overwrite(from->GetPoints()->GetData(), this->Grid->GetPoints()->GetData());
    Overwrite(from->GetPointData()->GetScalars(), this->Grid->GetPointData()->GetScalars());
    if (this->MarksModified)
    {
      this->Grid->GetPoints()->GetData()->Modified();
      this->Grid->GetPointData()->GetScalars()->Modified();
    }
    vtkUnstructuredGrid::GetData(outputs)->ShallowCopy(this->Grid);
    return 1;
  }

private:
  static void Overwrite(vtkDataArray* from, vtkDataArray* to)
  {
    for (vtkIdType tuple = 0; tuple < from->GetNumberOfTuples(); ++tuple)
    {
      for (int c = 0; c < from->GetNumberOfComponents(); ++c)
      {
        const double value = from->GetComponent(tuple, c);
        auto* values = static_cast<double*>(to->GetVoidPointer(0));
        values[tuple * from->GetNumberOfComponents() + c] = value;
      }
    }
  }

  vtkNew<vtkUnstructuredGrid> Grid;
};

vtkStandardNewMacro(InPlaceSource);

void CheckSource(const TimeSteps& steps, bool reportsError, Check& check)
{
  const TimeVaryingSettings settings = { { { 0.2, 0.7 } } };
  const TimeVaryingExtraction expected = ExtractTimeVarying(steps, settings);
  vtkNew<InPlaceSource> source;
  source->Steps = steps;
  source->MarksModified = reportsError;
  vtkNew<vtkTimeVaryingIntervalVolume> filter;
  filter->SetInputConnection(source->GetOutputPort());
  Apply(settings, filter);
  filter->Update();
  vtkUnstructuredGrid* const known[3] = { expected.Tetrahedra, expected.Boundaries,
    expected.Simplices };
  check.That(known[0]->GetNumberOfCells() > 0, "there are tetrahedra");
  for (int port = 0; port < 3; ++port)
  {
    check.That(FindDifference(
                 vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(port)), known[port])
                 .empty(),
      "port " + std::to_string(port) + " equals the output for one array per step");
  }
  check.Equal(source->Requests, static_cast<long long>(steps.size()) + 2,
    "requested steps, two of them repeatedly");
}

}

int TestTimeVaryingOverwritten(int, char*[])
{
  Check check;
  for (MeshKind kind : { MeshKind::Hexahedra, MeshKind::Honeycomb })
  {
    TimeSteps steps = RepeatGrid(MakeMesh(kind, { 3, 3, 2 }), { 0, 1, 1.5 });
    AddRandomTimeField(steps, 4);
    for (bool reportsError : { true, false })
    {
      check.SetContext(GetName(kind) + (reportsError ? ", modified" : ", not modified"));
      CheckSource(steps, reportsError, check);
    }
    MovePoints(steps, Stretch);
    check.SetContext(GetName(kind) + ", moving");
    CheckSource(steps, true, check);
  }
  return check.Result();
}
