// SPDX-License-Identifier: BSD-3-Clause
// A filter that is updated again and again, with KeepMemory, has the bytes of a fresh one in every
// state, whatever changes in between; what others hold of its outputs stays as it is; memory is
// used again, counted and freed.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceProgress.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceGrid.h"
#include "Support/Meshes/ReferenceLattice.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkIntervalVolume.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <random>

namespace
{

using namespace reference;

constexpr int Cells = 20;
constexpr int NumberOfSteps = 30;

using Grids = std::vector<vtkSmartPointer<vtkUnstructuredGrid>>;

Grids CopyOutputs(vtkIntervalVolume* filter)
{
  Grids copies;
  for (int port = 0; port < 2; ++port)
  {
    copies.push_back(vtkSmartPointer<vtkUnstructuredGrid>::New());
    copies.back()->DeepCopy(filter->GetOutputDataObject(port));
  }
  return copies;
}

/// Smooth data with some noise, as 8-bit integers: many values equal a bound that is whole.
void AddBytes(vtkDataSet* data, unsigned int seed)
{
  std::mt19937 generator(seed);
  const double phase = std::uniform_real_distribution<double>(0, 3)(generator);
  // Where they are there already, they change in their place.
  vtkSmartPointer<vtkUnsignedCharArray> bytes =
    vtkUnsignedCharArray::SafeDownCast(data->GetPointData()->GetArray("bytes"));
  if (!bytes)
  {
    bytes = vtkSmartPointer<vtkUnsignedCharArray>::New();
    bytes->SetName("bytes");
    bytes->SetNumberOfValues(data->GetNumberOfPoints());
    data->GetPointData()->AddArray(bytes);
  }
  double bounds[6];
  data->GetBounds(bounds);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double x[3];
    data->GetPoint(i, x);
    double wave = phase;
    for (int axis = 0; axis < 3; ++axis)
    {
      wave += 3.0 * (x[axis] - bounds[2 * axis]) / (bounds[2 * axis + 1] - bounds[2 * axis]);
    }
    bytes->SetValue(
      i, static_cast<unsigned char>(120 + 90 * std::sin(wave) + static_cast<int>(generator() % 7)));
  }
  bytes->Modified();
}

/// Numbers in the range of the bytes, some of them not finite.
void AddNumbers(vtkDataSet* data, unsigned int seed)
{
  vtkDoubleArray* numbers = AddRandomField(data, seed, "numbers");
  std::mt19937 generator(seed);
  for (vtkIdType i = 0; i < numbers->GetNumberOfTuples(); ++i)
  {
    const double odd = generator() % 2 == 0 ? std::numeric_limits<double>::quiet_NaN()
                                            : std::numeric_limits<double>::infinity();
    numbers->SetValue(i, generator() % 1000 == 0 ? odd : 255 * numbers->GetValue(i));
  }
}

/// The settings of a state, and the filter that goes through all states.
class Sequence
{
public:
  Sequence(vtkDataSet* data, unsigned int seed, Check& check)
    : Data(data)
    , Generator(seed)
    , Errors(check)
  {
    this->Kept->SetInputDataObject(data);
    this->Kept->KeepMemoryOn();
    this->Change(this->Kept);
  }

  void Step()
  {
    this->Take();
    this->Change(this->Kept);
    vtkSMPTools::Initialize(std::array<int, 3>{ { 1, 2, 8 } }[this->Roll(3)]);
    if (this->Roll(4) == 0)
    {
      this->Abort();
    }
    this->Kept->Update();
    this->Reused += this->Kept->GetReport()->GetNumber("ReusedBytes");
    vtkNew<vtkIntervalVolume> fresh;
    fresh->SetInputDataObject(this->Data);
    this->Change(fresh);
    fresh->Update();
    for (int port = 0; port < 2; ++port)
    {
      const std::string difference =
        FindDifference(vtkUnstructuredGrid::SafeDownCast(this->Kept->GetOutputDataObject(port)),
          vtkUnstructuredGrid::SafeDownCast(fresh->GetOutputDataObject(port)));
      this->Errors.That(difference.empty(), difference);
    }
    this->WithOutput += fresh->GetOutput()->GetNumberOfCells() > 0;
    this->Errors.Near(
      fresh->GetReport()->GetNumber("ReusedBytes"), 0, 0.0, "bytes used again by a fresh filter");
    this->Hold();
  }

  double GetReused() const { return this->Reused; }
  int GetStepsWithOutput() const { return this->WithOutput; }

private:
  int Roll(int number) { return static_cast<int>(this->Generator() % number); }

  /// Changes one thing.
  void Take()
  {
    switch (this->Roll(12))
    {
      case 0:
        this->AreBytes = !this->AreBytes;
        break;
      case 1:
        AddBytes(this->Data, static_cast<unsigned int>(this->Generator()));
        AddNumbers(this->Data, static_cast<unsigned int>(this->Generator()));
        break;
      case 2:
        this->HasBoundaries = !this->HasBoundaries;
        break;
      case 3:
        this->HasWhole = !this->HasWhole;
        break;
      case 4:
        this->HasOrigins = !this->HasOrigins;
        this->IsDouble = !this->IsDouble;
        break;
      case 5:
        this->SetGhosts();
        break;
      case 6:
        this->HasCriterion = !this->HasCriterion;
        break;
      case 7:
        this->Number = 3 - this->Number;
        break;
      case 8:
        this->HasIndex = !this->HasIndex;
        break;
      default:
        this->Lower = std::min(this->Lower + this->Roll(5) - 2, 200.0);
        this->Upper = std::max(this->Lower, this->Upper + 0.5 * (this->Roll(5) - 2));
    }
  }

  void SetGhosts()
  {
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    ghosts->SetNumberOfValues(this->Data->GetNumberOfCells());
    for (vtkIdType cell = 0; cell < ghosts->GetNumberOfValues(); ++cell)
    {
      const int roll = this->Roll(50);
      ghosts->SetValue(cell,
        roll == 0     ? vtkDataSetAttributes::DUPLICATECELL
          : roll == 1 ? vtkDataSetAttributes::HIDDENCELL
                      : 0);
    }
    if (this->Roll(2) == 0)
    {
      this->Data->GetCellData()->RemoveArray(ghosts->GetName());
    }
    else
    {
      this->Data->GetCellData()->AddArray(ghosts);
    }
    this->Data->Modified();
  }

  void Change(vtkIntervalVolume* filter)
  {
    filter->SetInputArrayToProcess(
      0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, this->AreBytes ? "bytes" : "numbers");
    filter->SetNumberOfIntervals(this->Number);
    filter->SetInterval(0, this->Lower, this->Upper);
    if (this->Number == 2)
    {
      filter->SetInterval(1, this->Upper, this->Upper + 10);
    }
    filter->SetGenerateBoundaries(this->HasBoundaries);
    filter->SetKeepWholeCells(this->HasWhole);
    filter->SetKeepOrigins(this->HasOrigins);
    filter->SetOutputPointsPrecision(
      this->IsDouble ? vtkAlgorithm::DOUBLE_PRECISION : vtkAlgorithm::DEFAULT_PRECISION);
    filter->SetUseValueIndex(this->HasIndex);
    filter->RemoveAllCriteria();
    if (this->HasCriterion)
    {
      filter->AddCriterion("side", 0.25, 0.75);
    }
    filter->WarnOnEmptyOutputOff();
  }

  /// Aborts an execution somewhere.
  void Abort()
  {
    ProgressWatch watch;
    watch.AbortAt = 0.1 * this->Roll(9);
    const unsigned long tag = Observe(this->Kept, watch);
    this->Kept->Modified();
    this->Kept->Update();
    this->Kept->RemoveObserver(tag);
    this->Kept->SetAbortExecute(0);
    this->Kept->Modified();
  }

  /// Holds the outputs for a few states, as filters downstream do, and compares them then.
  void Hold()
  {
    if (!this->Held.empty() && this->Roll(3) == 0)
    {
      for (int port = 0; port < 2; ++port)
      {
        this->Errors.That(FindDifference(this->Held[port], this->HeldCopies[port]).empty(),
          "an output that is held stays");
      }
      this->Held.clear();
      this->HeldCopies.clear();
    }
    if (this->Held.empty() && this->Roll(2) == 0)
    {
      this->HeldCopies = CopyOutputs(this->Kept);
      for (int port = 0; port < 2; ++port)
      {
        this->Held.push_back(vtkSmartPointer<vtkUnstructuredGrid>::New());
        this->Held.back()->ShallowCopy(this->Kept->GetOutputDataObject(port));
      }
    }
  }

  vtkDataSet* Data;
  std::mt19937 Generator;
  Check& Errors;
  vtkNew<vtkIntervalVolume> Kept;
  Grids Held;
  Grids HeldCopies;
  double Reused = 0.0;
  int WithOutput = 0;
  bool AreBytes = true;
  bool HasBoundaries = false;
  bool HasWhole = false;
  bool HasOrigins = false;
  bool IsDouble = false;
  bool HasCriterion = false;
  bool HasIndex = true;
  int Number = 1;
  double Lower = 100;
  double Upper = 180;
};

void CheckSequence(const LatticeForm& form, unsigned int seed, Check& check)
{
  AddBytes(form.Data, seed);
  AddNumbers(form.Data, seed);
  AddRandomField(form.Data, seed, "side");
  vtkNew<vtkDoubleArray> ofCells;
  ofCells->SetName("cells");
  ofCells->SetNumberOfValues(form.Data->GetNumberOfCells());
  for (vtkIdType cell = 0; cell < form.Data->GetNumberOfCells(); ++cell)
  {
    ofCells->SetValue(cell, 0.25 * static_cast<double>(cell));
  }
  form.Data->GetCellData()->AddArray(ofCells);
  Sequence sequence(form.Data, seed, check);
  for (int step = 0; step < NumberOfSteps; ++step)
  {
    check.SetContext(form.Name + ", step " + std::to_string(step));
    sequence.Step();
  }
  check.That(sequence.GetStepsWithOutput() > NumberOfSteps / 2, "most states have output");
  check.That(sequence.GetReused() > 0, "memory is used again");
}

/// What the report tells of memory.
void CheckCounts(Check& check)
{
  check.SetContext("counts");
  vtkSMPTools::Initialize(2);
  auto image = MakeImage({ 40, 40, 40 });
  AddRandomField(image, 3);
  vtkNew<vtkIntervalVolume> filter;
  filter->SetInputDataObject(image);
  const auto update = [&](double lower, double upper) -> vtkInterlumeReport*
  {
    filter->SetInterval(0, lower, upper);
    filter->Update();
    return filter->GetReport();
  };
  update(0.2, 0.5);
  check.Near(
    update(0.21, 0.5)->GetNumber("ReusedBytes"), 0, 0.0, "bytes used again without KeepMemory");
  check.Near(filter->GetReport()->GetNumber("IdleBytes"), 0, 0.0, "bytes held without KeepMemory");

  filter->KeepMemoryOn();
  check.Near(update(0.2, 0.5)->GetNumber("ReusedBytes"), 0, 0.0, "bytes used again at first");
  check.That(filter->GetReport()->GetNumber("IdleBytes") > 0, "working memory is held");
  const vtkIdType points = filter->GetOutput()->GetNumberOfPoints();
  const vtkIdType cells = filter->GetOutput()->GetNumberOfCells();
  // Connectivity, offsets, interval ids; coordinates and the scalar. There is no list of points.
  const vtkIdType bytes = cells * (16 + 4 + 4) + points * (12 + 8);
  const double reused = update(0.201, 0.5)->GetNumber("ReusedBytes");
  std::cout << static_cast<vtkIdType>(reused) << " of at least " << bytes << " bytes used again, "
            << static_cast<vtkIdType>(filter->GetReport()->GetNumber("IdleBytes")) << " idle\n";
  check.That(reused > 0.98 * static_cast<double>(bytes), "nearly all is used again");
  check.That(
    update(0.202, 0.5)->GetNumber("IdleBytes") < bytes / 2, "what is idle is less than the output");

  // An output that is held is not used again, and comes back later.
  vtkNew<vtkUnstructuredGrid> held;
  held->ShallowCopy(filter->GetOutput());
  check.That(
    update(0.203, 0.5)->GetNumber("ReusedBytes") < reused / 2, "what is held is not used again");
  held->Initialize();
  check.That(
    update(0.204, 0.5)->GetNumber("ReusedBytes") > 0.95 * reused, "what was held is used again");
  filter->WarnOnEmptyOutputOff();
  check.That(
    update(2, 3)->GetNumber("IdleBytes") > bytes / 2, "blocks are kept for one execution more");
  check.Near(
    update(2, 4)->GetNumber("IdleBytes"), 0, 0.0, "bytes held after two executions that use none");
  update(0.2, 0.5);
  filter->KeepMemoryOff();
  check.Near(
    update(0.21, 0.5)->GetNumber("IdleBytes"), 0, 0.0, "bytes held once KeepMemory is off");

  // An array outlives the filter, and may be given other memory.
  vtkNew<vtkUnstructuredGrid> last;
  {
    vtkNew<vtkIntervalVolume> gone;
    gone->SetInputDataObject(image);
    gone->SetInterval(0, 0.2, 0.5);
    gone->KeepMemoryOn();
    gone->Update();
    last->ShallowCopy(gone->GetOutput());
  }
  check.Equal(last->GetNumberOfCells(), cells, "cells of the output of a filter that is gone");
  vtkDataArray* field = last->GetPointData()->GetScalars();
  const double value = field->GetComponent(points - 1, 0);
  field->Resize(2 * points);
  check.That(field->GetComponent(points - 1, 0) == value, "an array that grows keeps its values");
  field->Initialize();
  field->SetNumberOfTuples(points);
  field->Fill(1.0);
  check.That(field->GetComponent(points - 1, 0) == 1.0, "an array that starts anew has its values");
}

}

int TestIntervalVolumeUpdates(int, char*[])
{
  Check check;
  unsigned int seed = 1;
  auto image = MakeImage({ Cells, Cells, Cells });
  for (const LatticeForm& form : FormsOf(image))
  {
    CheckSequence(form, seed++, check);
  }
  CheckCounts(check);
  return check.Result();
}
