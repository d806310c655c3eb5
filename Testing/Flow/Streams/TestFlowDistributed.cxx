// SPDX-License-Identifier: BSD-3-Clause
// Implicit flow of distributed fields under MPI: results are bit-identical to a single process,
// with a fraction of its memory. Also tests errors in any process, and conditions that require the
// full field in every process.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Checks/ReferenceReport.h"
#include "Streams/CurvedGridSource.h"
#include "Streams/RankMeshes.h"

#include "Support/Inputs/DataFiles.h"

#include "vtkAnalyticFlowSource.h"
#include "vtkFlowStatus.h"
#include "vtkImplicitFlowField.h"
#include "vtkTerminationCylinder.h"
#include "vtkTerminationInflow.h"
#include "vtkTerminationPlane.h"
#include "vtkTerminationSphere.h"

#include "vtkCallbackCommand.h"
#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMPIController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkRectilinearGridAlgorithm.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLStructuredGridReader.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace
{

using namespace reference;

/// Source of an analytic flow on a rectilinear grid with decreasing spacing, which can produce any
/// requested extent.
class GridSource : public vtkRectilinearGridAlgorithm
{
public:
  static GridSource* New();
  vtkTypeMacro(GridSource, vtkRectilinearGridAlgorithm);

  vtkNew<vtkAnalyticFlowSource> Flow;
  int WholeExtent[6] = { 3, 27, -4, 18, 0, 21 };

protected:
  GridSource() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* info = outputs->GetInformationObject(0);
    info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), this->WholeExtent, 6);
    info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
    return 1;
  }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* info = outputs->GetInformationObject(0);
    vtkRectilinearGrid* grid = vtkRectilinearGrid::GetData(info);
    int extent[6];
    info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent);
    grid->SetExtent(extent);
    vtkNew<vtkDoubleArray> coordinates[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const int first = this->WholeExtent[2 * axis];
      const int last = this->WholeExtent[2 * axis + 1];
      for (int i = extent[2 * axis]; i <= extent[2 * axis + 1]; ++i)
      {
        const double part = static_cast<double>(i - first) / (last - first);
        coordinates[axis]->InsertNextValue(-1.0 + 2.0 * part * (1.3 - 0.3 * part));
      }
    }
    grid->SetXCoordinates(coordinates[0]);
    grid->SetYCoordinates(coordinates[1]);
    grid->SetZCoordinates(coordinates[2]);
    vtkNew<vtkDoubleArray> vectors;
    vectors->SetName("Velocity");
    vectors->SetNumberOfComponents(3);
    vectors->SetNumberOfTuples(grid->GetNumberOfPoints());
    for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
    {
      double v[3];
      this->Flow->Evaluate(grid->GetPoint(id), v);
      vectors->SetTypedTuple(id, v);
    }
    grid->GetPointData()->SetVectors(vectors);
    return 1;
  }
};
vtkStandardNewMacro(GridSource);

struct Case
{
  std::string Name;
  std::function<vtkAlgorithm*()> MakeSource;
  std::function<void(vtkImplicitFlowField*)> Set;
  /// Expected number of fill values.
  vtkIdType FillValues = 0;
};

vtkAlgorithm* MakeFlow(
  int field, int type, int x, int y, int z, double size, int inside = vtkAnalyticFlowSource::HIDDEN)
{
  vtkAnalyticFlowSource* source = vtkAnalyticFlowSource::New();
  source->SetField(field);
  source->SetOutputScalarType(type);
  source->SetDimensions(x, y, z);
  source->SetBounds(-size, size, -0.9 * size, size, -0.8 * size, 0.7 * size);
  source->SetInside(inside);
  return source;
}

void AddPlane(vtkImplicitFlowField* filter, double x)
{
  vtkNew<vtkTerminationPlane> plane;
  plane->SetOrigin(x, -30.0, -30.0);
  plane->SetPoint1(x, 30.0, -30.0);
  plane->SetPoint2(x, -30.0, 30.0);
  filter->AddTerminationSurface(plane);
}

/// Adds a plane and turns on domain faces and all optional results.
void SetAll(vtkImplicitFlowField* filter)
{
  AddPlane(filter, 0.31);
  filter->SetDomainFaces(true);
  filter->SetStoreStepCounts(true);
  filter->SetComputeArcLength(true);
  filter->SetComputeMeanVorticity(true);
  filter->SetComputeMaximumSpeed(true);
  filter->SetComputeLocalAttributes(true);
}

void AddSphere(vtkImplicitFlowField* filter, double radius)
{
  vtkNew<vtkTerminationSphere> sphere;
  sphere->SetRadius(radius);
  filter->AddTerminationSurface(sphere);
}

CurvedGridSource* MakeCurved(int field, CurvedGridSource::Shape shape, int type = VTK_DOUBLE)
{
  CurvedGridSource* source = CurvedGridSource::New();
  source->Flow->SetField(field);
  source->GetPosition = shape;
  source->PointType = type;
  return source;
}

void AddCurvedCases(std::vector<Case>& cases)
{
  using Flow = vtkAnalyticFlowSource;
  cases.push_back({ "hurricane on a ring",
    [] { return MakeCurved(Flow::HURRICANE, CurvedGridSource::Ring, VTK_FLOAT); },
    [](vtkImplicitFlowField* filter)
    {
      AddPlane(filter, -1.3);
      filter->SetDomainFaces(true);
      filter->SetStoreStepCounts(true);
      filter->SetComputeArcLength(true);
      filter->SetComputeMeanVorticity(true);
    } });
  cases.push_back(
    { "closed orbits on a ring", [] { return MakeCurved(Flow::ROTATION, CurvedGridSource::Ring); },
      [](vtkImplicitFlowField* filter)
      {
        AddSphere(filter, 0.45);
        filter->SetDomainFaces(true);
        filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
        filter->SetSampleDimensions(8, 7, 4);
        filter->SetMaximumNumberOfSteps(4000);
      } });
  cases.push_back({ "hurricane around a pole",
    [] { return MakeCurved(Flow::HURRICANE, CurvedGridSource::PolarGrid, VTK_FLOAT); },
    [](vtkImplicitFlowField* filter)
    {
      AddPlane(filter, 0.31);
      filter->SetDomainFaces(true);
      filter->SetDirectionToForward();
      filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
      filter->SetSampleDimensions(10, 9, 8);
    } });
  cases.push_back({ "hidden cells and points in a bent box",
    []
    {
      CurvedGridSource* source = MakeCurved(Flow::ABC, CurvedGridSource::BentBox);
      source->IsBlanked = true;
      return source;
    },
    [](vtkImplicitFlowField* filter)
    {
      AddSphere(filter, 0.4);
      filter->SetDomainFaces(true);
      filter->SetRefinementLevels(1);
    } });
  const auto makeFin = []
  {
    vtkXMLStructuredGridReader* reader = vtkXMLStructuredGridReader::New();
    reader->SetFileName(interlume::DataFile("bluntfin.vts").c_str());
    return reader;
  };
  cases.push_back({ "blunt fin", makeFin,
    [](vtkImplicitFlowField* filter)
    {
      filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Velocity");
      filter->SetDomainFaces(true);
      filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
      filter->SetSampleDimensions(14, 10, 12);
    } });
  cases.push_back({ "blunt fin, fewer samples", makeFin,
    [](vtkImplicitFlowField* filter)
    {
      filter->SetDomainFaces(true);
      filter->SetMaximumNumberOfSteps(1);
    } });
  cases.push_back({ "rectilinear grid, fewer samples",
    []
    {
      GridSource* source = GridSource::New();
      source->WholeExtent[1] += 20;
      return source;
    },
    [](vtkImplicitFlowField* filter)
    {
      filter->SetDomainFaces(true);
      filter->SetMaximumNumberOfSteps(1);
    } });
}

/// Returns a case with a mesh that the source divides into pieces.
Case MakeMeshCase(const std::string& name, const vtkSmartPointer<vtkUnstructuredGrid>& mesh,
  const std::function<void(vtkImplicitFlowField*)>& set)
{
  return { name, [mesh] { return RankMeshes::MakeSource(mesh); }, set, 0 };
}

void AddMeshCases(std::vector<Case>& cases)
{
  using Flow = vtkAnalyticFlowSource;
  using Kind = reference::MeshKind;
  const auto mixed =
    RankMeshes::Make(Kind::Mixed, { { 7, 6, 8 } }, CurvedGridSource::BentBox, Flow::HURRICANE);
  cases.push_back(MakeMeshCase("hurricane in mixed cells", mixed, SetAll));
  const auto shuffled = vtkSmartPointer<vtkUnstructuredGrid>::New();
  shuffled->ShallowCopy(mixed);
  RankMeshes::Shuffle(shuffled);
  cases.push_back(MakeMeshCase("interleaved pieces", shuffled, SetAll));
  cases.push_back({ "blocks with separate vectors and an empty block",
    [mixed] { return RankMeshes::MakeBlockSource(mixed, 6); }, SetAll, 0 });
  const auto setOrbits = [](vtkImplicitFlowField* filter)
  {
    AddSphere(filter, 0.45);
    filter->SetDomainFaces(true);
    filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
    filter->SetSampleDimensions(8, 7, 4);
    filter->SetMaximumNumberOfSteps(4000);
  };
  cases.push_back(MakeMeshCase("closed orbits in a ring of tetrahedra",
    RankMeshes::Make(
      Kind::Tetrahedra6, { { 4, 9, 3 } }, CurvedGridSource::Ring, Flow::ROTATION, VTK_FLOAT),
    setOrbits));
  cases.push_back(MakeMeshCase("closed orbits in a ring of hexahedra",
    RankMeshes::Make(Kind::Hexahedra, { { 6, 14, 5 } }, CurvedGridSource::Ring, Flow::ROTATION),
    setOrbits));
  cases.push_back(MakeMeshCase("hexahedra around a pole",
    RankMeshes::Make(
      Kind::Hexahedra, { { 6, 12, 7 } }, CurvedGridSource::PolarGrid, Flow::HURRICANE, VTK_FLOAT),
    [](vtkImplicitFlowField* filter)
    {
      AddPlane(filter, 0.31);
      filter->SetDomainFaces(true);
      filter->SetDirectionToForward();
      filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
      filter->SetSampleDimensions(9, 8, 7);
    }));
  const auto hidden =
    RankMeshes::Make(Kind::Wedges, { { 6, 7, 5 } }, CurvedGridSource::BentBox, Flow::ABC);
  RankMeshes::Hide(hidden);
  // Fill values at points that several processes share. Each is counted once.
  for (const vtkIdType point : { 144, 150, 151 })
  {
    hidden->GetPointData()->GetVectors()->SetTuple3(point, 1e30, 0.0, 0.0);
  }
  cases.push_back(MakeMeshCase("hidden cells and points in wedges", hidden,
    [](vtkImplicitFlowField* filter)
    {
      AddSphere(filter, 0.4);
      filter->SetDomainFaces(true);
    }));
  cases.back().FillValues = 3;
  cases.push_back(MakeMeshCase("refined tetrahedra",
    RankMeshes::Make(
      Kind::Tetrahedra12, { { 4, 5, 4 } }, CurvedGridSource::BentBox, Flow::SOURCE_SINK),
    [](vtkImplicitFlowField* filter)
    {
      AddSphere(filter, 0.4);
      filter->SetIntegrator(vtkImplicitFlowField::ROSENBROCK);
      filter->SetDomainFaces(true);
      filter->SetRefinementLevels(1);
    }));
  cases.push_back(MakeMeshCase("pyramids, fewer samples",
    RankMeshes::Make(
      Kind::Pyramids, { { 26, 26, 25 } }, CurvedGridSource::BentBox, Flow::TORNADO, VTK_FLOAT),
    [](vtkImplicitFlowField* filter)
    {
      filter->SetDomainFaces(true);
      filter->SetMaximumNumberOfSteps(1);
    }));
  cases.push_back(MakeMeshCase("five tetrahedra",
    RankMeshes::Make(Kind::Tetrahedra5, { { 1, 1, 1 } }, CurvedGridSource::BentBox, Flow::UNIFORM),
    [](vtkImplicitFlowField* filter) { filter->SetDomainFaces(true); }));
}

std::vector<Case> MakeCases()
{
  using Flow = vtkAnalyticFlowSource;
  std::vector<Case> cases;
  cases.push_back(
    { "hurricane", [] { return MakeFlow(Flow::HURRICANE, VTK_FLOAT, 25, 22, 19, 2.0); }, SetAll });
  cases.push_back({ "flow past a hidden cylinder",
    [] { return MakeFlow(Flow::CYLINDER, VTK_DOUBLE, 31, 27, 14, 3.0); },
    [](vtkImplicitFlowField* filter)
    {
      AddPlane(filter, -2.7);
      AddPlane(filter, 1.9);
      filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
      filter->SetSampleDimensions(26, 24, 17);
    } });
  cases.push_back(
    { "tornado, fewer samples", [] { return MakeFlow(Flow::TORNADO, VTK_FLOAT, 45, 41, 33, 1.5); },
      [](vtkImplicitFlowField* filter)
      {
        AddSphere(filter, 0.7);
        filter->SetDirectionToForward();
      } });
  cases.push_back({ "closed orbits on a rectilinear grid",
    []
    {
      GridSource* source = GridSource::New();
      source->Flow->SetField(Flow::ABC);
      return source;
    },
    [](vtkImplicitFlowField* filter)
    {
      AddSphere(filter, 0.25);
      filter->SetMaximumNumberOfSteps(4000);
    } });
  cases.push_back(
    { "stiff node", [] { return MakeFlow(Flow::SOURCE_SINK, VTK_DOUBLE, 24, 20, 21, 2.0); },
      [](vtkImplicitFlowField* filter)
      {
        AddSphere(filter, 0.4);
        filter->SetIntegrator(vtkImplicitFlowField::ROSENBROCK);
        filter->SetDomainFaces(true);
        filter->SetDirectionToForward();
        filter->SetRefinementLevels(1);
      } });
  cases.push_back({ "four cells", [] { return MakeFlow(Flow::UNIFORM, VTK_FLOAT, 2, 2, 5, 1.0); },
    [](vtkImplicitFlowField* filter) { filter->SetDomainFaces(true); } });
  AddCurvedCases(cases);
  AddMeshCases(cases);
  return cases;
}

/// Returns the ids of a part's points in the full output. Uses structured indices for structured
/// grids, whose points may coincide.
std::vector<vtkIdType> FindPoints(vtkDataSet* part, vtkDataSet* full)
{
  std::vector<vtkIdType> ids(static_cast<std::size_t>(part->GetNumberOfPoints()));
  vtkDataArray* globalIds = part->GetPointData()->GetArray("GlobalIds");
  vtkStructuredGrid* grids[2] = { vtkStructuredGrid::SafeDownCast(part),
    vtkStructuredGrid::SafeDownCast(full) };
  for (vtkIdType id = 0; id < part->GetNumberOfPoints(); ++id)
  {
    vtkIdType& index = ids[static_cast<std::size_t>(id)];
    if (!grids[0] || !grids[1])
    {
      index = globalIds ? static_cast<vtkIdType>(globalIds->GetComponent(id, 0)) : -1;
      double x[3];
      part->GetPoint(id, x);
      // Samples added by refinement have no id.
      if (index < 0 || !std::equal(x, x + 3, full->GetPoint(index)))
      {
        index = full->FindPoint(x);
      }
      continue;
    }
    int extents[2][6];
    grids[0]->GetExtent(extents[0]);
    grids[1]->GetExtent(extents[1]);
    vtkIdType left = id;
    vtkIdType stride = 1;
    for (int axis = 0; axis < 3; ++axis)
    {
      const int size = extents[0][2 * axis + 1] - extents[0][2 * axis] + 1;
      index += stride * (left % size + extents[0][2 * axis] - extents[1][2 * axis]);
      left /= size;
      stride *= extents[1][2 * axis + 1] - extents[1][2 * axis] + 1;
    }
  }
  return ids;
}

/// Compares the samples of a part with the samples at the same positions in the full output.
void Compare(Check& check, vtkDataSet* part, vtkDataSet* full)
{
  const std::vector<vtkIdType> ids = FindPoints(part, full);
  for (vtkIdType id = 0; id < part->GetNumberOfPoints(); ++id)
  {
    const vtkIdType index = ids[static_cast<std::size_t>(id)];
    double x[3];
    full->GetPoint(index, x);
    check.That(std::memcmp(x, part->GetPoint(id), sizeof(x)) == 0, "a sample of the full output");
  }
  vtkPointData* found = part->GetPointData();
  // A process without blocks does not know the arrays.
  if (part->GetNumberOfPoints() > 0)
  {
    check.Equal(found->GetNumberOfArrays(), full->GetPointData()->GetNumberOfArrays(), "arrays");
  }
  check.That(
    part->GetNumberOfPoints() == 0 || !found->GetVectors() == !full->GetPointData()->GetVectors(),
    "active vectors");
  for (int i = 0; i < found->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = found->GetArray(i);
    // TerminationSide depends on cells at surfaces, which may belong to another process.
    if (std::string(array->GetName()) == vtkFlowStatus::SideArray())
    {
      continue;
    }
    vtkDataArray* expected = full->GetPointData()->GetArray(array->GetName());
    const auto size =
      static_cast<std::size_t>(array->GetNumberOfComponents() * array->GetDataTypeSize());
    vtkIdType differences = 0;
    for (vtkIdType id = 0; id < array->GetNumberOfTuples(); ++id)
    {
      const vtkIdType other = ids[static_cast<std::size_t>(id)] * array->GetNumberOfComponents();
      differences += std::memcmp(array->GetVoidPointer(id * array->GetNumberOfComponents()),
                       expected->GetVoidPointer(other), size) == 0
        ? 0
        : 1;
    }
    check.Equal(differences, 0, std::string("samples with other values in ") + array->GetName());
  }
}

vtkIdType Sum(vtkMultiProcessController* controller, vtkIdType own)
{
  vtkIdType sum = own;
  controller->AllReduce(&own, &sum, 1, vtkCommunicator::SUM_OP);
  return sum;
}

void TestCase(Check& check, vtkMultiProcessController* controller, const Case& test)
{
  const int ranks = controller->GetNumberOfProcesses();
  const int rank = controller->GetLocalProcessId();
  check.SetContext(
    test.Name + ", process " + std::to_string(rank) + " of " + std::to_string(ranks));
  vtkNew<vtkImplicitFlowField> filters[2];
  vtkNew<vtkCallbackCommand> ignore;
  for (auto& filter : filters)
  {
    const auto source = vtk::TakeSmartPointer(test.MakeSource());
    filter->SetInputConnection(source->GetOutputPort());
    test.Set(filter);
    if (test.FillValues > 0)
    {
      // A process that stores the full field warns of fill values.
      filter->AddObserver(vtkCommand::WarningEvent, ignore);
    }
  }
  filters[0]->SetController(nullptr);
  filters[0]->Update();
  vtkDataSet* full = vtkDataSet::SafeDownCast(filters[0]->GetOutputDataObject(0));
  const auto all = CopyReport(filters[0]->GetReport());

  filters[1]->UpdateInformation();
  filters[1]->UpdatePiece(rank, ranks, 0);
  vtkInterlumeReport* own = filters[1]->GetReport();
  vtkDataSet* part = vtkDataSet::SafeDownCast(filters[1]->GetOutputDataObject(0));
  Compare(check, part, full);
  check.That(
    Sum(controller, part->GetNumberOfPoints()) >= full->GetNumberOfPoints(), "all samples");
  const std::string reason = own->GetText("WholeFieldReason");
  check.That(reason.empty(), "distributed field, not " + reason);
  for (const char* name : { "MaximumSpeed", "MaximumError", "FillValues", "ToleranceMatchedFaces",
         "LargestFaceGap", "NonconformingFaces", "FirstNonconformingCell" })
  {
    check.Near(own->GetNumber(name), all->GetNumber(name), 0.0, name);
  }
  check.Equal(own->GetSize("StepsPerProcess"), ranks > 1 ? ranks : 0, "ranks");
  check.Equal(all->GetCount("FillValues"), test.FillValues, "fill values");
  check.That(
    ranks == 1 || own->GetNumber("StreamlineTransfers") > 0 || all->GetNumber("Steps") < 100,
    "streamlines are transferred");
  if (rank == 0)
  {
    const auto count = [](vtkInterlumeReport* report, const char* name, vtkIdType entry = 0)
    { return report->GetCount(name, entry); };
    std::cout << test.Name << ": " << full->GetNumberOfPoints() << " samples, bytes of the field "
              << count(own, "FieldBytes") << " of " << count(all, "FieldBytes") << ", transferred "
              << count(own, "StreamlineTransfers") << ", steps";
    for (vtkIdType process = 0; process < own->GetSize("StepsPerProcess"); ++process)
    {
      std::cout << " " << count(own, "StepsPerProcess", process);
    }
    std::cout << " of "
              << count(all, "Steps") + count(all, "RejectedSteps") + count(all, "StiffSteps") +
        count(all, "RejectedStiffSteps")
              << std::endl;
  }
}

/// Returns the current (VmRSS) or peak (VmHWM) resident memory of the process in bytes on Linux.
/// Returns 0 on other systems.
double GetMemory(const std::string& name)
{
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
  {
    if (line.rfind(name + ":", 0) == 0)
    {
      return 1024.0 * std::stod(line.substr(name.size() + 1));
    }
  }
  return 0.0;
}

/// Resets the peak memory to the current memory. Returns false if the system does not support it.
bool ResetMemory()
{
#ifdef __GLIBC__
  // Returns freed memory to the system first.
  malloc_trim(0);
#endif
  std::ofstream("/proc/self/clear_refs") << 5 << std::flush;
  return GetMemory("VmHWM") <= 1.01 * GetMemory("VmRSS");
}

/// Each process stores a fraction of a large field. Compares the reported size of the field and the
/// memory of the process with those for the full field.
void TestMemory(Check& check, vtkMultiProcessController* controller, const std::string& name,
  vtkIdType points, std::size_t size, const std::function<vtkAlgorithm*()>& makeSource)
{
  const int ranks = controller->GetNumberOfProcesses();
  double bytes[2];
  double growths[2];
  bool isCounted = true;
  for (int isFull = 0; isFull < 2; ++isFull)
  {
    isCounted = ResetMemory() && isCounted;
    const double before = GetMemory("VmRSS");
    const auto source = vtk::TakeSmartPointer(makeSource());
    vtkNew<vtkImplicitFlowField> filter;
    filter->SetController(isFull ? nullptr : controller);
    filter->SetInputConnection(source->GetOutputPort());
    filter->SetDomainFaces(true);
    filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
    filter->SetSampleDimensions(8, 8, 8);
    filter->UpdateInformation();
    filter->UpdatePiece(controller->GetLocalProcessId(), ranks, 0);
    bytes[isFull] = filter->GetReport()->GetNumber("FieldBytes");
    growths[isFull] = GetMemory("VmHWM") - before;
  }
  check.SetContext(name + ", " + std::to_string(ranks) + " processes");
  check.That(bytes[1] == static_cast<double>(size) * static_cast<double>(points), "bytes");
  const double maximum = ranks == 1 ? 1.0 : (ranks == 2 ? 0.65 : 0.4);
  check.That(bytes[0] / bytes[1] <= maximum,
    "fraction of the field: " + std::to_string(bytes[0] / bytes[1]));
  const double fraction = isCounted ? growths[0] / growths[1] : 0.0;
  // The limits allow for several MiB of MPI buffers, whose size depends on the implementation.
  check.That(ranks == 1 || fraction <= (ranks == 2 ? 0.7 : maximum),
    "fraction of the memory: " + std::to_string(fraction));
  if (controller->GetLocalProcessId() == 0)
  {
    std::cout << name << ", fractions of the full field: bytes " << bytes[0] / bytes[1]
              << ", memory " << fraction << " of " << growths[1] / 1048576.0 << " MiB" << std::endl;
  }
}

void TestMemories(Check& check, vtkMultiProcessController* controller)
{
  TestMemory(check, controller, "image", 201 * 201 * 201, 12,
    [] { return MakeFlow(vtkAnalyticFlowSource::UNIFORM, VTK_FLOAT, 201, 201, 201, 1.0); });
  TestMemory(check, controller, "bow", 81 * 81 * 81, 24,
    []
    {
      CurvedGridSource* source =
        MakeCurved(vtkAnalyticFlowSource::UNIFORM, CurvedGridSource::BentBox, VTK_FLOAT);
      for (int i = 0; i < 6; ++i)
      {
        source->WholeExtent[i] = i % 2 ? 80 : 0;
      }
      return source;
    });
  const auto mesh = RankMeshes::Make(reference::MeshKind::Hexahedra, { { 72, 72, 72 } },
    CurvedGridSource::BentBox, vtkAnalyticFlowSource::UNIFORM, VTK_FLOAT);
  TestMemory(
    check, controller, "mesh", 73 * 73 * 73, 24, [mesh] { return RankMeshes::MakeSource(mesh); });
}

/// Observer that aborts the filter while it advects streamlines.
void Abort(vtkObject* caller, unsigned long, void*, void*)
{
  vtkAlgorithm* filter = vtkAlgorithm::SafeDownCast(caller);
  if (filter->GetProgress() > 0.2)
  {
    filter->SetAbortExecute(1);
  }
}

/// An abort in one process aborts all processes and leaves no samples. Afterward, the filter can
/// execute again.
void TestAbort(Check& check, vtkMultiProcessController* controller, const std::string& name,
  const vtkSmartPointer<vtkAlgorithm>& source)
{
  check.SetContext("abort, " + name);
  const int ranks = controller->GetNumberOfProcesses();
  const int rank = controller->GetLocalProcessId();
  vtkNew<vtkImplicitFlowField> filter;
  filter->SetInputConnection(source->GetOutputPort());
  filter->SetDomainFaces(true);
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback(Abort);
  if (rank == ranks - 1)
  {
    filter->AddObserver(vtkCommand::ProgressEvent, abort);
  }
  filter->UpdateInformation();
  filter->UpdatePiece(rank, ranks, 0);
  check.Equal(vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfPoints(), 0,
    "samples after an abort");
  check.Equal(filter->GetReport()->GetCount("Executions"), 0, "executions");
  filter->RemoveObserver(abort);
  filter->SetAbortExecute(0);
  filter->Modified();
  filter->UpdatePiece(rank, ranks, 0);
  check.That(vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfPoints() > 0,
    "samples of the next execution");
  check.Equal(
    filter->GetReport()->GetCount("Executions"), 1, "executions after the next execution");
}

/// Some settings require the full field in every process. The report states the reason.
void TestWholeField(Check& check, vtkMultiProcessController* controller)
{
  check.SetContext("full field");
  const int ranks = controller->GetNumberOfProcesses();
  const std::pair<const char*, std::function<void(vtkImplicitFlowField*)>> settings[] = {
    { "InterpolateStreamlines is on",
      [](vtkImplicitFlowField* filter) { filter->SetInterpolateStreamlines(true); } },
    { "CriticalPointSpheres is on",
      [](vtkImplicitFlowField* filter) { filter->SetCriticalPointSpheres(true); } },
    { "a termination surface is placed by the vectors",
      [](vtkImplicitFlowField* filter)
      {
        vtkNew<vtkTerminationInflow> inflow;
        filter->AddTerminationSurface(inflow);
      } },
  };
  for (const auto& [reason, set] : settings)
  {
    const auto source =
      vtk::TakeSmartPointer(MakeFlow(vtkAnalyticFlowSource::SHEAR, VTK_FLOAT, 9, 9, 9, 1.0));
    vtkNew<vtkImplicitFlowField> filter;
    filter->SetInputConnection(source->GetOutputPort());
    filter->SetDomainFaces(true);
    set(filter);
    filter->UpdateInformation();
    filter->UpdatePiece(controller->GetLocalProcessId(), ranks, 0);
    vtkInterlumeReport* report = filter->GetReport();
    check.Equal(report->GetCount("FieldBytes"), 9 * 9 * 9 * 12, "bytes of the full field");
    check.That(report->GetText("WholeFieldReason") == (ranks > 1 ? reason : ""),
      "reported reason: " + report->GetText("WholeFieldReason"));
    check.Equal(report->GetSize("StepsPerProcess"), 0, "no steps per process");
  }
}

/// Some ways to divide a mesh into pieces require the full field in every process, others do not.
void TestMeshPieces(Check& check, vtkMultiProcessController* controller)
{
  using Kind = reference::MeshKind;
  const auto make = [](Kind kind)
  {
    return RankMeshes::Make(
      kind, { { 4, 3, 6 } }, CurvedGridSource::BentBox, vtkAnalyticFlowSource::SHEAR);
  };
  const auto mesh = make(Kind::Hexahedra);
  const auto other = make(Kind::Tetrahedra6);
  const int ranks = controller->GetNumberOfProcesses();
  const int rank = controller->GetLocalProcessId();
  struct Pieces
  {
    std::string Name;
    std::function<vtkAlgorithm*()> MakeSource;
    std::string Reason;
  };
  const auto makeSource = [](const RankMeshes::GetPiece& get)
  { return [get] { return RankMeshes::MakeSource(get); }; };
  const Pieces all[] = {
    { "ghost cells without a request",
      makeSource([&](int piece, int pieces)
        { return RankMeshes::MakePiece(mesh, piece, pieces, pieces > 1 ? 1 : 0); }),
      "" },
    { "faces that do not match",
      makeSource(
        [&](int piece, int pieces) {
          return RankMeshes::MakePiece(pieces > 1 && piece % 2 ? other : mesh, piece, pieces, 0);
        }),
      "do not match" },
    { "all cells in one process",
      makeSource(
        [&](int piece, int pieces)
        {
          return piece == pieces - 1 ? RankMeshes::MakePiece(mesh, 0, 1, 0)
                                     : vtkSmartPointer<vtkUnstructuredGrid>::New();
        }),
      "to one process" },
    { "all cells in each process",
      makeSource([&](int, int) { return RankMeshes::MakePiece(mesh, 0, 1, 0); }),
      "to several processes" },
    { "blocks with different arrays", [&] { return RankMeshes::MakeBlockSource(mesh, 14, true); },
      "have different arrays" },
  };
  for (const Pieces& pieces : all)
  {
    check.SetContext("pieces, " + pieces.Name);
    vtkNew<vtkImplicitFlowField> filters[2];
    for (auto& filter : filters)
    {
      const auto source = vtk::TakeSmartPointer(pieces.MakeSource());
      filter->SetInputConnection(source->GetOutputPort());
      filter->SetDomainFaces(true);
      filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
      filter->SetSampleDimensions(7, 8, 9);
    }
    filters[0]->SetController(nullptr);
    filters[0]->Update();
    for (int i = 1; i <= 2; ++i)
    {
      filters[1]->Modified();
      filters[1]->UpdateInformation();
      filters[1]->UpdatePiece(rank, ranks, 0);
      Compare(check, vtkDataSet::SafeDownCast(filters[1]->GetOutputDataObject(0)),
        vtkDataSet::SafeDownCast(filters[0]->GetOutputDataObject(0)));
      vtkInterlumeReport* report = filters[1]->GetReport();
      const bool isFull = ranks > 1 && !pieces.Reason.empty();
      const std::string reason = report->GetText("WholeFieldReason");
      check.That(
        isFull == !reason.empty() && reason.find(isFull ? pieces.Reason : "") != std::string::npos,
        "the reason is reported: " + reason);
      check.Equal(
        report->GetSize("StepsPerProcess"), isFull || ranks == 1 ? 0 : ranks, "steps per process");
      check.Equal(report->GetCount("Executions"), i, "executions");
    }
  }
}

/// An error is reported by every process, and no process waits forever for another.
void TestErrors(Check& check, vtkMultiProcessController* controller)
{
  check.SetContext("errors");
  const auto source =
    vtk::TakeSmartPointer(MakeFlow(vtkAnalyticFlowSource::SHEAR, VTK_FLOAT, 9, 9, 9, 1.0));
  vtkNew<vtkImplicitFlowField> filter;
  filter->SetInputConnection(source->GetOutputPort());
  filter->SetDomainFaces(true);
  filter->UpdateInformation();
  filter->AddMeanArray("Pressure");
  vtkInformation* info = filter->GetOutputInformation(0);
  info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(),
    controller->GetNumberOfProcesses());
  info->Set(
    vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), controller->GetLocalProcessId());
  const std::string message = UpdateAndGetErrors(filter);
  check.That(
    message.find("Pressure") != std::string::npos, "the error names the missing array: " + message);
}

}

int main(int argc, char* argv[])
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  vtkMultiProcessController::SetGlobalController(controller);
  Check check;
  TestMemories(check, controller);
  for (const Case& test : MakeCases())
  {
    TestCase(check, controller, test);
  }
  TestWholeField(check, controller);
  TestMeshPieces(check, controller);
  TestErrors(check, controller);
  TestAbort(check, controller, "structured grid",
    vtk::TakeSmartPointer(
      MakeCurved(vtkAnalyticFlowSource::HURRICANE, CurvedGridSource::PolarGrid)));
  TestAbort(check, controller, "mesh",
    vtk::TakeSmartPointer(RankMeshes::MakeSource(RankMeshes::Make(reference::MeshKind::Hexahedra,
      { { 14, 18, 10 } }, CurvedGridSource::PolarGrid, vtkAnalyticFlowSource::HURRICANE))));
  const vtkIdType failures = Sum(controller, check.Result() == EXIT_SUCCESS ? 0 : 1);
  vtkMultiProcessController::SetGlobalController(nullptr);
  controller->Finalize();
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
