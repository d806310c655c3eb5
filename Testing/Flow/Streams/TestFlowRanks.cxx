// SPDX-License-Identifier: BSD-3-Clause
// Implicit flow of fields that processes hold in parts, under MPI: the bytes of one process with
// all of the field, at a share of its memory; what is wrong in any process, and what keeps the
// field whole.
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
#include <vector>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace
{

using namespace reference;

/// An analytic flow on planes that come closer and closer, of any part alone.
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
  /// How many vectors the report has as fill values.
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

/// A plane and the domain's faces, and all that is kept of paths.
void SetAll(vtkImplicitFlowField* filter)
{
  AddPlane(filter, 0.31);
  filter->SetDomainFaces(true);
  filter->SetKeepSteps(true);
  filter->SetComputeArcLength(true);
  filter->SetComputeMeanVorticity(true);
  filter->SetComputeMaximumSpeed(true);
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
      filter->SetKeepSteps(true);
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
    [] { return MakeCurved(Flow::HURRICANE, CurvedGridSource::Pole, VTK_FLOAT); },
    [](vtkImplicitFlowField* filter)
    {
      AddPlane(filter, 0.31);
      filter->SetDomainFaces(true);
      filter->SetDirectionToForward();
      filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
      filter->SetSampleDimensions(10, 9, 8);
    } });
  cases.push_back({ "cells and points that are hidden in a bow",
    []
    {
      CurvedGridSource* source = MakeCurved(Flow::ABC, CurvedGridSource::Bow);
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

/// A mesh that has been made before, of which a source gives pieces.
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
    RankMeshes::Make(Kind::Mixed, { { 7, 6, 8 } }, CurvedGridSource::Bow, Flow::HURRICANE);
  cases.push_back(MakeMeshCase("hurricane in mixed cells", mixed, SetAll));
  const auto shuffled = vtkSmartPointer<vtkUnstructuredGrid>::New();
  shuffled->ShallowCopy(mixed);
  RankMeshes::Shuffle(shuffled);
  cases.push_back(MakeMeshCase("pieces that lie within each other", shuffled, SetAll));
  cases.push_back({ "blocks with vectors of their own and a flat one",
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
      Kind::Hexahedra, { { 6, 12, 7 } }, CurvedGridSource::Pole, Flow::HURRICANE, VTK_FLOAT),
    [](vtkImplicitFlowField* filter)
    {
      AddPlane(filter, 0.31);
      filter->SetDomainFaces(true);
      filter->SetDirectionToForward();
      filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
      filter->SetSampleDimensions(9, 8, 7);
    }));
  const auto hidden =
    RankMeshes::Make(Kind::Wedges, { { 6, 7, 5 } }, CurvedGridSource::Bow, Flow::ABC);
  RankMeshes::Hide(hidden);
  // Fill values in points that several processes have, of which each counts once.
  for (const vtkIdType point : { 144, 150, 151 })
  {
    hidden->GetPointData()->GetVectors()->SetTuple3(point, 1e30, 0.0, 0.0);
  }
  cases.push_back(MakeMeshCase("cells and points that are hidden among wedges", hidden,
    [](vtkImplicitFlowField* filter)
    {
      AddSphere(filter, 0.4);
      filter->SetDomainFaces(true);
    }));
  cases.back().FillValues = 3;
  cases.push_back(MakeMeshCase("tetrahedra that are refined",
    RankMeshes::Make(Kind::Tetrahedra12, { { 4, 5, 4 } }, CurvedGridSource::Bow, Flow::SOURCE_SINK),
    [](vtkImplicitFlowField* filter)
    {
      AddSphere(filter, 0.4);
      filter->SetIntegrator(vtkImplicitFlowField::ROSENBROCK);
      filter->SetDomainFaces(true);
      filter->SetRefinementLevels(1);
    }));
  cases.push_back(MakeMeshCase("pyramids, fewer samples",
    RankMeshes::Make(
      Kind::Pyramids, { { 26, 26, 25 } }, CurvedGridSource::Bow, Flow::TORNADO, VTK_FLOAT),
    [](vtkImplicitFlowField* filter)
    {
      filter->SetDomainFaces(true);
      filter->SetMaximumNumberOfSteps(1);
    }));
  cases.push_back(MakeMeshCase("five tetrahedra",
    RankMeshes::Make(Kind::Tetrahedra5, { { 1, 1, 1 } }, CurvedGridSource::Bow, Flow::UNIFORM),
    [](vtkImplicitFlowField* filter) { filter->SetDomainFaces(true); }));
}

std::vector<Case> MakeCases()
{
  using Flow = vtkAnalyticFlowSource;
  std::vector<Case> cases;
  cases.push_back(
    { "hurricane", [] { return MakeFlow(Flow::HURRICANE, VTK_FLOAT, 25, 22, 19, 2.0); }, SetAll });
  cases.push_back({ "flow past a cylinder that is hidden",
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

/// Returns the points of the whole that those of a part are, by their indices where points may have
/// the same coordinates.
std::vector<vtkIdType> FindPoints(vtkDataSet* part, vtkDataSet* whole)
{
  std::vector<vtkIdType> ids(static_cast<std::size_t>(part->GetNumberOfPoints()));
  vtkDataArray* known = part->GetPointData()->GetArray("GlobalIds");
  vtkStructuredGrid* grids[2] = { vtkStructuredGrid::SafeDownCast(part),
    vtkStructuredGrid::SafeDownCast(whole) };
  for (vtkIdType id = 0; id < part->GetNumberOfPoints(); ++id)
  {
    vtkIdType& place = ids[static_cast<std::size_t>(id)];
    if (!grids[0] || !grids[1])
    {
      place = known ? static_cast<vtkIdType>(known->GetComponent(id, 0)) : -1;
      double x[3];
      part->GetPoint(id, x);
      // Samples that refinement adds have no numbers of their own.
      if (place < 0 || !std::equal(x, x + 3, whole->GetPoint(place)))
      {
        place = whole->FindPoint(x);
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
      place += stride * (left % size + extents[0][2 * axis] - extents[1][2 * axis]);
      left /= size;
      stride *= extents[1][2 * axis + 1] - extents[1][2 * axis] + 1;
    }
  }
  return ids;
}

/// Compares the arrays of samples with those of the same places in the whole.
void Compare(Check& check, vtkDataSet* part, vtkDataSet* whole)
{
  const std::vector<vtkIdType> ids = FindPoints(part, whole);
  for (vtkIdType id = 0; id < part->GetNumberOfPoints(); ++id)
  {
    const vtkIdType place = ids[static_cast<std::size_t>(id)];
    double x[3];
    whole->GetPoint(place, x);
    check.That(std::memcmp(x, part->GetPoint(id), sizeof(x)) == 0, "a sample of the whole");
  }
  vtkPointData* found = part->GetPointData();
  // A process without blocks does not know what arrays others have.
  if (part->GetNumberOfPoints() > 0)
  {
    check.Equal(found->GetNumberOfArrays(), whole->GetPointData()->GetNumberOfArrays(), "arrays");
  }
  check.That(
    part->GetNumberOfPoints() == 0 || !found->GetVectors() == !whole->GetPointData()->GetVectors(),
    "active vectors");
  for (int i = 0; i < found->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = found->GetArray(i);
    // A cell beyond the samples of this process may be the one that a surface passes through.
    if (std::string(array->GetName()) == vtkFlowStatus::SideArray())
    {
      continue;
    }
    vtkDataArray* expected = whole->GetPointData()->GetArray(array->GetName());
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
    check.Equal(differences, 0, std::string("samples of other bytes in ") + array->GetName());
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
  vtkNew<vtkCallbackCommand> silence;
  for (auto& filter : filters)
  {
    const auto source = vtk::TakeSmartPointer(test.MakeSource());
    filter->SetInputConnection(source->GetOutputPort());
    test.Set(filter);
    if (test.FillValues > 0)
    {
      // Whoever has the whole warns of them.
      filter->AddObserver(vtkCommand::WarningEvent, silence);
    }
  }
  filters[0]->SetController(nullptr);
  filters[0]->Update();
  vtkDataSet* whole = vtkDataSet::SafeDownCast(filters[0]->GetOutputDataObject(0));
  const auto all = CopyReport(filters[0]->GetReport());

  filters[1]->UpdateInformation();
  filters[1]->UpdatePiece(rank, ranks, 0);
  vtkInterlumeReport* own = filters[1]->GetReport();
  vtkDataSet* part = vtkDataSet::SafeDownCast(filters[1]->GetOutputDataObject(0));
  Compare(check, part, whole);
  check.That(
    Sum(controller, part->GetNumberOfPoints()) >= whole->GetNumberOfPoints(), "all samples");
  const std::string reason = own->GetText("WholeFieldReason");
  check.That(reason.empty(), "in parts, not " + reason);
  for (const char* name : { "MaximumSpeed", "MaximumError", "FillValues", "ToleranceMatchedFaces",
         "LargestFaceGap", "NonconformingFaces", "FirstNonconformingCell" })
  {
    check.Near(own->GetNumber(name), all->GetNumber(name), 0.0, name);
  }
  check.Equal(own->GetSize("StepsPerProcess"), ranks > 1 ? ranks : 0, "ranks");
  check.Near(all->GetNumber("FillValues"), test.FillValues, 0.0, "fill values");
  check.That(
    ranks == 1 || own->GetNumber("StreamlineTransfers") > 0 || all->GetNumber("Steps") < 100,
    "streamlines are handed on");
  if (rank == 0)
  {
    const auto count = [](vtkInterlumeReport* report, const char* name, vtkIdType entry = 0)
    { return static_cast<vtkIdType>(report->GetNumber(name, entry)); };
    std::cout << test.Name << ": " << whole->GetNumberOfPoints() << " samples, bytes of the field "
              << count(own, "FieldBytes") << " of " << count(all, "FieldBytes") << ", handed on "
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

/// Returns a line of what Linux tells of the process, in bytes: its memory (VmRSS), or the most
/// that it has had (VmHWM). 0 elsewhere.
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

/// Has the most memory be counted from now on. Returns whether Linux has done so.
bool ResetMemory()
{
#ifdef __GLIBC__
  // What was freed counts no more.
  malloc_trim(0);
#endif
  std::ofstream("/proc/self/clear_refs") << 5 << std::flush;
  return GetMemory("VmHWM") <= 1.01 * GetMemory("VmRSS");
}

/// A larger field takes a process its share of the memory: by what the filter tells, and by what
/// the system does, which is first asked of the part and then of the whole.
void TestMemory(Check& check, vtkMultiProcessController* controller, const std::string& name,
  vtkIdType points, std::size_t size, const std::function<vtkAlgorithm*()>& makeSource)
{
  const int ranks = controller->GetNumberOfProcesses();
  double bytes[2];
  double growths[2];
  bool isCounted = true;
  for (int isWhole = 0; isWhole < 2; ++isWhole)
  {
    isCounted = ResetMemory() && isCounted;
    const double before = GetMemory("VmRSS");
    const auto source = vtk::TakeSmartPointer(makeSource());
    vtkNew<vtkImplicitFlowField> filter;
    filter->SetController(isWhole ? nullptr : controller);
    filter->SetInputConnection(source->GetOutputPort());
    filter->SetDomainFaces(true);
    filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
    filter->SetSampleDimensions(8, 8, 8);
    filter->UpdateInformation();
    filter->UpdatePiece(controller->GetLocalProcessId(), ranks, 0);
    bytes[isWhole] = filter->GetReport()->GetNumber("FieldBytes");
    growths[isWhole] = GetMemory("VmHWM") - before;
  }
  check.SetContext(name + ", " + std::to_string(ranks) + " processes");
  check.That(bytes[1] == static_cast<double>(size) * static_cast<double>(points), "bytes");
  const double most = ranks == 1 ? 1.0 : (ranks == 2 ? 0.65 : 0.4);
  check.That(
    bytes[0] / bytes[1] <= most, "share of the field: " + std::to_string(bytes[0] / bytes[1]));
  const double share = isCounted ? growths[0] / growths[1] : 0.0;
  // What the exchange itself takes, some MiB, differs between implementations of MPI.
  check.That(ranks == 1 || share <= (ranks == 2 ? 0.7 : most),
    "share of the memory: " + std::to_string(share));
  if (controller->GetLocalProcessId() == 0)
  {
    std::cout << name << ", shares of the whole field: bytes " << bytes[0] / bytes[1] << ", memory "
              << share << " of " << growths[1] / 1048576.0 << " MiB" << std::endl;
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
        MakeCurved(vtkAnalyticFlowSource::UNIFORM, CurvedGridSource::Bow, VTK_FLOAT);
      for (int i = 0; i < 6; ++i)
      {
        source->WholeExtent[i] = i % 2 ? 80 : 0;
      }
      return source;
    });
  const auto mesh = RankMeshes::Make(reference::MeshKind::Hexahedra, { { 72, 72, 72 } },
    CurvedGridSource::Bow, vtkAnalyticFlowSource::UNIFORM, VTK_FLOAT);
  TestMemory(
    check, controller, "mesh", 73 * 73 * 73, 24, [mesh] { return RankMeshes::MakeSource(mesh); });
}

/// Ends the execution of one process while it follows streamlines.
void Abort(vtkObject* caller, unsigned long, void*, void*)
{
  vtkAlgorithm* filter = vtkAlgorithm::SafeDownCast(caller);
  if (filter->GetProgress() > 0.2)
  {
    filter->SetAbortExecute(1);
  }
}

/// What is aborted in one process is in all, leaves no samples, and can be done again.
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
    "samples of an execution that was aborted");
  check.Near(filter->GetReport()->GetNumber("Executions"), 0, 0.0, "executions");
  filter->RemoveObserver(abort);
  filter->SetAbortExecute(0);
  filter->Modified();
  filter->UpdatePiece(rank, ranks, 0);
  check.That(vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfPoints() > 0,
    "samples after that");
  check.Near(filter->GetReport()->GetNumber("Executions"), 1, 0.0, "executions after that");
}

/// What keeps the field whole, and answers all the same.
void TestWholeField(Check& check, vtkMultiProcessController* controller)
{
  check.SetContext("whole field");
  const int ranks = controller->GetNumberOfProcesses();
  const std::function<void(vtkImplicitFlowField*)> obstacles[] = {
    [](vtkImplicitFlowField* filter) { filter->SetShareStreamlines(true); },
    [](vtkImplicitFlowField* filter) { filter->SetCriticalPointSpheres(true); },
    [](vtkImplicitFlowField* filter)
    {
      vtkNew<vtkTerminationInflow> inflow;
      filter->AddTerminationSurface(inflow);
    },
  };
  for (const auto& set : obstacles)
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
    check.Near(report->GetNumber("FieldBytes"), 9 * 9 * 9 * 12, 0.0, "bytes of the whole");
    check.That((ranks > 1) == !report->GetText("WholeFieldReason").empty(), "the reason is told");
    check.Equal(report->GetSize("StepsPerProcess"), 0, "no steps of processes");
  }
}

/// What is seen from the pieces of a mesh to keep the field whole, and what does not.
void TestMeshPieces(Check& check, vtkMultiProcessController* controller)
{
  using Kind = reference::MeshKind;
  const auto make = [](Kind kind)
  {
    return RankMeshes::Make(
      kind, { { 4, 3, 6 } }, CurvedGridSource::Bow, vtkAnalyticFlowSource::SHEAR);
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
    { "ghost cells that nobody asked for",
      makeSource([&](int piece, int pieces)
        { return RankMeshes::MakePiece(mesh, piece, pieces, pieces > 1 ? 1 : 0); }),
      "" },
    { "faces that do not fit",
      makeSource(
        [&](int piece, int pieces) {
          return RankMeshes::MakePiece(pieces > 1 && piece % 2 ? other : mesh, piece, pieces, 0);
        }),
      "do not fit" },
    { "all in one process",
      makeSource(
        [&](int piece, int pieces)
        {
          return piece == pieces - 1 ? RankMeshes::MakePiece(mesh, 0, 1, 0)
                                     : vtkSmartPointer<vtkUnstructuredGrid>::New();
        }),
      "to one process" },
    { "all in each process",
      makeSource([&](int, int) { return RankMeshes::MakePiece(mesh, 0, 1, 0); }),
      "to several processes" },
    { "blocks of other arrays", [&] { return RankMeshes::MakeBlockSource(mesh, 14, true); },
      "differ in arrays" },
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
      const bool isWhole = ranks > 1 && !pieces.Reason.empty();
      const std::string reason = report->GetText("WholeFieldReason");
      check.That(isWhole == !reason.empty() &&
          reason.find(isWhole ? pieces.Reason : "") != std::string::npos,
        "the reason is told: " + reason);
      check.Equal(report->GetSize("StepsPerProcess"), isWhole || ranks == 1 ? 0 : ranks,
        "steps of processes");
      check.Near(report->GetNumber("Executions"), i, 0.0, "executions");
    }
  }
}

/// What is wrong is told by every process, and none waits for ever.
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
  const std::string message = MessagesOf(filter);
  check.That(message.find("Pressure") != std::string::npos, "the array that lacks: " + message);
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
    vtk::TakeSmartPointer(MakeCurved(vtkAnalyticFlowSource::HURRICANE, CurvedGridSource::Pole)));
  TestAbort(check, controller, "mesh",
    vtk::TakeSmartPointer(RankMeshes::MakeSource(RankMeshes::Make(reference::MeshKind::Hexahedra,
      { { 14, 18, 10 } }, CurvedGridSource::Pole, vtkAnalyticFlowSource::HURRICANE))));
  const vtkIdType failures = Sum(controller, check.Result() == EXIT_SUCCESS ? 0 : 1);
  vtkMultiProcessController::SetGlobalController(nullptr);
  controller->Finalize();
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
