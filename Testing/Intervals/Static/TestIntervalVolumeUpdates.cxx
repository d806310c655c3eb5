// SPDX-License-Identifier: BSD-3-Clause
// A filter with ReuseMemory that is updated many times produces the same output as a fresh filter
// with the same settings and data. Outputs that other objects hold remain unchanged, and memory is
// reused, counted and freed.
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

/// Adds smooth 8-bit data with noise. Many values equal an integer bound of the interval.
void AddBytes(vtkDataSet* data, unsigned int seed)
{
  std::mt19937 generator(seed);
  const double phase = std::uniform_real_distribution<double>(0, 3)(generator);
  // An existing array is modified in place.
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

/// Adds floating-point values from 0 to 255. A few are not finite.
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

/// A random sequence of settings and the filter under test.
class Sequence
{
public:
  Sequence(vtkDataSet* data, unsigned int seed, Check& check)
    : Data(data)
    , Generator(seed)
    , Errors(check)
  {
    this->Reusing->SetInputDataObject(data);
    this->Reusing->ReuseMemoryOn();
    this->Change(this->Reusing);
  }

  void Step()
  {
    this->ChangeSetting();
    this->Change(this->Reusing);
    vtkSMPTools::Initialize(std::array<int, 3>{ { 1, 2, 8 } }[this->Roll(3)]);
    if (this->Roll(4) == 0)
    {
      this->Abort();
    }
    this->Reusing->Update();
    this->Reused += this->Reusing->GetReport()->GetNumber("ReusedBytes");
    vtkNew<vtkIntervalVolume> fresh;
    fresh->SetInputDataObject(this->Data);
    this->Change(fresh);
    fresh->Update();
    for (int port = 0; port < 2; ++port)
    {
      const std::string difference =
        FindDifference(vtkUnstructuredGrid::SafeDownCast(this->Reusing->GetOutputDataObject(port)),
          vtkUnstructuredGrid::SafeDownCast(fresh->GetOutputDataObject(port)));
      this->Errors.That(difference.empty(), difference);
    }
    this->WithOutput += fresh->GetOutput()->GetNumberOfCells() > 0;
    this->Errors.Equal(
      fresh->GetReport()->GetCount("ReusedBytes"), 0, "bytes reused by a fresh filter");
    this->Hold();
  }

  double GetReused() const { return this->Reused; }
  int GetStepsWithOutput() const { return this->WithOutput; }

private:
  int Roll(int number) { return static_cast<int>(this->Generator() % number); }

  /// Changes one random setting.
  void ChangeSetting()
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
        this->HasInterior = !this->HasInterior;
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
    filter->SetKeepInteriorCells(this->HasInterior);
    filter->SetGenerateOriginArrays(this->HasOrigins);
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

  /// Aborts an execution at a random progress value.
  void Abort()
  {
    ProgressWatch watch;
    watch.AbortAt = 0.1 * this->Roll(9);
    const unsigned long tag = ObserveProgress(this->Reusing, watch);
    this->Reusing->Modified();
    this->Reusing->Update();
    this->Reusing->RemoveObserver(tag);
    this->Reusing->SetAbortExecute(0);
    this->Reusing->Modified();
  }

  /// Holds the outputs for several steps, as a downstream filter may, and checks that they remain
  /// unchanged.
  void Hold()
  {
    if (!this->Held.empty() && this->Roll(3) == 0)
    {
      for (int port = 0; port < 2; ++port)
      {
        this->Errors.That(FindDifference(this->Held[port], this->HeldCopies[port]).empty(),
          "an output held by others is unchanged");
      }
      this->Held.clear();
      this->HeldCopies.clear();
    }
    if (this->Held.empty() && this->Roll(2) == 0)
    {
      this->HeldCopies = CopyOutputs(this->Reusing);
      for (int port = 0; port < 2; ++port)
      {
        this->Held.push_back(vtkSmartPointer<vtkUnstructuredGrid>::New());
        this->Held.back()->ShallowCopy(this->Reusing->GetOutputDataObject(port));
      }
    }
  }

  vtkDataSet* Data;
  std::mt19937 Generator;
  Check& Errors;
  vtkNew<vtkIntervalVolume> Reusing;
  Grids Held;
  Grids HeldCopies;
  double Reused = 0.0;
  int WithOutput = 0;
  bool AreBytes = true;
  bool HasBoundaries = false;
  bool HasInterior = false;
  bool HasOrigins = false;
  bool IsDouble = false;
  bool HasCriterion = false;
  bool HasIndex = true;
  int Number = 1;
  double Lower = 100;
  double Upper = 180;
};

void CheckSequence(const DataSetVariant& form, unsigned int seed, Check& check)
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
  check.That(sequence.GetReused() > 0, "memory is reused");
}

/// Checks the memory statistics in the report.
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
    update(0.21, 0.5)->GetNumber("ReusedBytes"), 0, 0.0, "bytes reused without ReuseMemory");
  check.Equal(filter->GetReport()->GetCount("IdleBytes"), 0, "idle bytes without ReuseMemory");

  filter->ReuseMemoryOn();
  check.Near(
    update(0.2, 0.5)->GetNumber("ReusedBytes"), 0, 0.0, "bytes reused by the first execution");
  check.That(filter->GetReport()->GetNumber("IdleBytes") > 0, "working memory is retained");
  const vtkIdType points = filter->GetOutput()->GetNumberOfPoints();
  const vtkIdType cells = filter->GetOutput()->GetNumberOfCells();
  // The output stores four point ids, an offset and an interval id per cell, and coordinates and a
  // scalar per point.
  const vtkIdType bytes = cells * (16 + 4 + 4) + points * (12 + 8);
  const double reused = update(0.201, 0.5)->GetNumber("ReusedBytes");
  std::cout << static_cast<vtkIdType>(reused) << " of at least " << bytes << " bytes reused, "
            << filter->GetReport()->GetCount("IdleBytes") << " idle\n";
  check.That(reused > 0.98 * static_cast<double>(bytes), "almost all memory is reused");
  check.That(update(0.202, 0.5)->GetNumber("IdleBytes") < bytes / 2,
    "idle memory is smaller than the output");

  // The memory of an output that another object holds is reused only after the object releases it.
  vtkNew<vtkUnstructuredGrid> held;
  held->ShallowCopy(filter->GetOutput());
  check.That(update(0.203, 0.5)->GetNumber("ReusedBytes") < reused / 2,
    "memory held by others is not reused");
  held->Initialize();
  check.That(
    update(0.204, 0.5)->GetNumber("ReusedBytes") > 0.95 * reused, "released memory is reused");
  filter->WarnOnEmptyOutputOff();
  check.That(
    update(2, 3)->GetNumber("IdleBytes") > bytes / 2, "blocks are retained for one more execution");
  check.Equal(
    update(2, 4)->GetCount("IdleBytes"), 0, "idle bytes after two executions without output");
  update(0.2, 0.5);
  filter->ReuseMemoryOff();
  check.Near(update(0.21, 0.5)->GetNumber("IdleBytes"), 0, 0.0,
    "idle bytes after ReuseMemory is turned off");

  // An output array outlives the filter and can be resized.
  vtkNew<vtkUnstructuredGrid> last;
  {
    vtkNew<vtkIntervalVolume> gone;
    gone->SetInputDataObject(image);
    gone->SetInterval(0, 0.2, 0.5);
    gone->ReuseMemoryOn();
    gone->Update();
    last->ShallowCopy(gone->GetOutput());
  }
  check.Equal(last->GetNumberOfCells(), cells, "cells of the output of a deleted filter");
  vtkDataArray* field = last->GetPointData()->GetScalars();
  const double value = field->GetComponent(points - 1, 0);
  field->Resize(2 * points);
  check.That(
    field->GetComponent(points - 1, 0) == value, "an array that grows preserves its values");
  field->Initialize();
  field->SetNumberOfTuples(points);
  field->Fill(1.0);
  check.That(field->GetComponent(points - 1, 0) == 1.0, "a reinitialized array has its new values");
}

}

int TestIntervalVolumeUpdates(int, char*[])
{
  Check check;
  unsigned int seed = 1;
  auto image = MakeImage({ Cells, Cells, Cells });
  for (const DataSetVariant& form : FormsOf(image))
  {
    CheckSequence(form, seed++, check);
  }
  CheckCounts(check);
  return check.Result();
}
