// SPDX-License-Identifier: BSD-3-Clause
#include "TimeVarying/ProjectedTetrahedra.h"

#include "Common/ParallelFor.h"
#include "TimeVarying/TimeVaryingReport.h"
#include "Arrays/ExtractionArrays.h"
#include "TimeVarying/OutputCellArrays.h"

#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cstring>

namespace interlume
{

namespace
{
constexpr int NumberOfPoints = SimplexProjection::NumberOfPoints;
// Number of simplices projected at a time. Their data should fit in the L1 cache.
constexpr int BatchSize = 64;

constexpr unsigned char ClassNames[SimplexSigns::NumberOfClasses] = {
  vtkTimeVaryingSettings::CLASS_1, vtkTimeVaryingSettings::CLASS_2,
  vtkTimeVaryingSettings::CLASS_3A, vtkTimeVaryingSettings::CLASS_3B,
  vtkTimeVaryingSettings::CLASS_4, vtkTimeVaryingSettings::CLASS_5
};

// Calls visit with the values of a float or double array. Returns false for other types.
template <typename Visitor>
bool VisitNumbers(vtkAbstractArray* array, Visitor&& visit)
{
  if (vtkFloatArray* floats = vtkFloatArray::SafeDownCast(array))
  {
    visit(floats->GetPointer(0));
    return true;
  }
  if (vtkDoubleArray* doubles = vtkDoubleArray::SafeDownCast(array))
  {
    visit(doubles->GetPointer(0));
    return true;
  }
  return false;
}

// Moves \a number tuples of an array from index \a from to index \a to.
void MoveTuples(vtkDataArray* array, vtkIdType from, vtkIdType to, vtkIdType number)
{
  const std::size_t size =
    static_cast<std::size_t>(array->GetNumberOfComponents()) * array->GetDataTypeSize();
  char* const values = static_cast<char*>(array->GetVoidPointer(0));
  std::memmove(values + to * size, values + from * size, number * size);
}
}

// A range of simplices of a slab.
struct ProjectedTetrahedra::Block
{
  const Slab* TheSlab;
  vtkIdType First;
  vtkIdType Last;
  // Index of the first simplex, counted over all slabs.
  vtkIdType FirstIndex;
  // Numbers of thick points and tetrahedra. ConvertCountsToOffsets() replaces them with start
  // indices.
  vtkIdType ThickPoints = 0;
  vtkIdType Tetrahedra = 0;
  std::array<vtkIdType, SimplexSigns::NumberOfClasses> Classes{};
  vtkIdType Inverted = 0;

  void Add(const SimplexProjection& projection)
  {
    this->Inverted += projection.IsInverted();
    if (!projection.IsFlat())
    {
      const SimplexSigns::Cut& cut = projection.GetSigns().GetDecomposition();
      ++this->ThickPoints;
      this->Tetrahedra += cut.NumberOfTetrahedra;
      this->Classes[cut.Class] += cut.NumberOfTetrahedra;
    }
  }
};

// Consecutive simplices and their projections.
struct ProjectedTetrahedra::Batch
{
  const Simplex* Simplices;
  int Number;
  SimplexProjection::Corners Corners[BatchSize];
  SimplexProjection Projections[BatchSize];
  // Index of the first thick point of the batch.
  vtkIdType ThickPoint;

  // Calls visit(simplex, thickPoint) for the simplices that are not degenerate.
  template <typename Visitor>
  void ForEach(Visitor&& visit) const
  {
    vtkIdType thickPoint = this->ThickPoint;
    for (int s = 0; s < this->Number; ++s)
    {
      if (!this->Projections[s].IsFlat())
      {
        visit(s, thickPoint++);
      }
    }
  }
};

ProjectedTetrahedra::ProjectedTetrahedra(
  const ExtractionContext& context, const TimeVaryingMesh& mesh, vtkUnstructuredGrid* output)
  : Context(context)
  , Mesh(mesh)
  , Output(output)
  , BasePoints(mesh.GetPoints()->GetNumberOfPoints())
{
}

ProjectedTetrahedra::~ProjectedTetrahedra() = default;

double ProjectedTetrahedra::EstimateNumber(const TimeVaryingMesh& mesh)
{
  constexpr vtkIdType maximumBatches = 32;
  const Slab& slab = mesh.GetSlabs().back();
  const vtkIdType number = static_cast<vtkIdType>(slab.Flats.GetSize());
  SimplexProjection::Corners corners[BatchSize];
  SimplexProjection projections[BatchSize];
  vtkIdType projected = 0;
  vtkIdType tetrahedra = 0;
  const vtkIdType step = std::max<vtkIdType>(BatchSize, number / maximumBatches);
  for (vtkIdType first = 0; first < number; first += step)
  {
    const int size = static_cast<int>(std::min<vtkIdType>(BatchSize, number - first));
    mesh.GetProjected(slab.Simplices.GetData() + first, size, corners);
    SimplexProjection::Project(corners, slab.Flats.GetData() + first, size, projections);
    for (int s = 0; s < size; ++s)
    {
      tetrahedra += projections[s].IsFlat() ? 0 : projections[s].GetNumberOfTetrahedra();
    }
    projected += size;
  }
  return projected > 0
    ? static_cast<double>(tetrahedra) * static_cast<double>(number) / static_cast<double>(projected)
    : 0.0;
}

bool ProjectedTetrahedra::Fill(TimeVaryingReport& report)
{
  this->MakeBlocks();
  this->AllocatePoints();
  const vtkIdType blocks = static_cast<vtkIdType>(this->Blocks.size());
  if (!this->Context.Run(blocks, 0.0, 0.7,
        [this](vtkIdType first, vtkIdType last)
        {
          for (vtkIdType b = first; b < last; ++b)
          {
            this->ProjectBlock(this->Blocks[b]);
          }
        }))
  {
    return false;
  }
  for (Block& block : this->Blocks)
  {
    this->ConvertCountsToOffsets(block, report);
  }
  this->RemoveGaps();
  this->AllocateTetrahedra();
  if (!this->Context.Run(blocks, 0.7, 1.0,
        [this](vtkIdType first, vtkIdType last)
        {
          for (vtkIdType b = first; b < last; ++b)
          {
            this->WriteBlock(this->Blocks[b]);
          }
        }))
  {
    return false;
  }
  this->FillNonNumericArrays();
  this->Output->SetCells(VTK_TETRA, this->Cells.MakeCells());
  return true;
}

void ProjectedTetrahedra::MakeBlocks()
{
  constexpr vtkIdType size = 512;
  for (const Slab& slab : this->Mesh.GetSlabs())
  {
    const vtkIdType number = static_cast<vtkIdType>(slab.Simplices.GetSize());
    for (vtkIdType first = 0; first < number; first += size)
    {
      this->Blocks.push_back(
        { &slab, first, std::min(first + size, number), this->Simplices + first });
    }
    this->Simplices += number;
  }
}

void ProjectedTetrahedra::AllocatePoints()
{
  const vtkIdType points = this->BasePoints + this->Simplices;
  this->Signs.Allocate(this->Simplices);
  this->Points.TakeReference(vtkPoints::New(this->Mesh.GetPoints()->GetDataType()));
  this->Points->SetNumberOfPoints(points);
  OutputAllocation::PreferLargePages(this->Points->GetData());
  this->Output->SetPoints(this->Points);
  VisitNumbers(this->Points->GetData(), [this](auto* values) { this->CopyPoints(values); });
  vtkPointData* to = this->Output->GetPointData();
  vtkPointData* from = this->Mesh.GetArrays();
  for (int a = 0; a < from->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = from->GetAbstractArray(a);
    ExtractionArrays::AddArrayLike(from, array, to, this->MakeArray(array));
  }
  to->AddArray(this->MakeArray(this->Mesh.GetTimes()));
  this->Thickness->SetName("DeltaT");
  this->Thickness->SetNumberOfValues(points);
  OutputAllocation::PreferLargePages(this->Thickness);
  double* thickness = this->Thickness->GetPointer(0);
  vtkSMPTools::Fill(thickness, thickness + this->BasePoints, 0.0);
  to->AddArray(this->Thickness);
  this->Heaviest.Allocate(this->Others.empty() ? 0 : this->Simplices);
}

template <typename Value>
void ProjectedTetrahedra::CopyPoints(Value* values)
{
  ParallelFor(0, this->BasePoints, ThreadGrain,
    [this, values](vtkIdType p)
    {
      const SimplexProjection::Point x = this->Mesh.GetProjected(p);
      for (int axis = 0; axis < 3; ++axis)
      {
        values[3 * p + axis] = static_cast<Value>(x[axis]);
      }
    });
}

// Creates a point array. Its values at the thick points are written later.
vtkSmartPointer<vtkAbstractArray> ProjectedTetrahedra::MakeArray(vtkAbstractArray* from)
{
  vtkSmartPointer<vtkAbstractArray> created;
  created.TakeReference(from->NewInstance());
  created->SetName(from->GetName());
  created->SetNumberOfComponents(from->GetNumberOfComponents());
  created->SetNumberOfTuples(this->BasePoints + this->Simplices);
  if (vtkDataArray* numbers = vtkDataArray::SafeDownCast(created))
  {
    OutputAllocation::PreferLargePages(numbers);
  }
  created->InsertTuples(0, this->BasePoints, 0, from);
  const int components = from->GetNumberOfComponents();
  if (!VisitNumbers(
        created, [this, components](auto* values) { this->AddMeans(values, components); }))
  {
    this->Others.push_back(created);
  }
  return created;
}

template <typename Value>
void ProjectedTetrahedra::AddMeans(Value* values, int components)
{
  this->Means.push_back(
    [values, components](const Batch& batch)
    {
      batch.ForEach(
        [&](int s, vtkIdType thickPoint)
        {
          const Simplex& simplex = batch.Simplices[s];
          const auto& weights = batch.Projections[s].GetWeights();
          for (int c = 0; c < components; ++c)
          {
            double mean = 0.0;
            for (int p = 0; p < NumberOfPoints; ++p)
            {
              // Skip values with zero weight, which may be NaN or infinite.
              const double part = weights[p] * values[simplex[p] * components + c];
              mean += weights[p] == 0.0 ? 0.0 : part;
            }
            values[thickPoint * components + c] = static_cast<Value>(mean);
          }
        });
    });
}

void ProjectedTetrahedra::ProjectBlock(Block& block)
{
  const Slab& slab = *block.TheSlab;
  double* const thickness = this->Thickness->GetPointer(0);
  Batch batch;
  for (vtkIdType first = block.First; first < block.Last; first += BatchSize)
  {
    const vtkIdType index = block.FirstIndex + first - block.First;
    batch.Simplices = slab.Simplices.GetData() + first;
    batch.Number = static_cast<int>(std::min<vtkIdType>(BatchSize, block.Last - first));
    batch.ThickPoint = this->BasePoints + block.FirstIndex + block.ThickPoints;
    this->Mesh.GetProjected(batch.Simplices, batch.Number, batch.Corners);
    SimplexProjection::Project(
      batch.Corners, slab.Flats.GetData() + first, batch.Number, batch.Projections);
    for (int s = 0; s < batch.Number; ++s)
    {
      const SimplexProjection& projection = batch.Projections[s];
      block.Add(projection);
      this->Signs[index + s] = projection.IsFlat() ? SimplexSigns() : projection.GetSigns();
      if (!this->Others.empty())
      {
        const auto& weights = projection.GetWeights();
        this->Heaviest[index + s] = static_cast<std::uint8_t>(
          std::max_element(weights.begin(), weights.end()) - weights.begin());
      }
    }
    VisitNumbers(this->Points->GetData(), [&](auto* values) { this->WritePoints(batch, values); });
    batch.ForEach([&](int s, vtkIdType thickPoint)
      { thickness[thickPoint] = batch.Projections[s].GetThickness(); });
    for (const MeanWriter& write : this->Means)
    {
      write(batch);
    }
  }
}

template <typename Value>
void ProjectedTetrahedra::WritePoints(const Batch& batch, Value* values) const
{
  batch.ForEach(
    [&](int s, vtkIdType thickPoint)
    {
      double x[3];
      batch.Projections[s].GetThickPoint(batch.Corners[s], x);
      for (int axis = 0; axis < 3; ++axis)
      {
        values[3 * thickPoint + axis] = static_cast<Value>(x[axis]);
      }
    });
}

// Adds the counts of a block to the report and replaces them with the indices where the output of
// the block starts.
void ProjectedTetrahedra::ConvertCountsToOffsets(Block& block, TimeVaryingReport& report)
{
  report.FlatSimplices += block.Last - block.First - block.ThickPoints;
  report.InvertedSimplices += block.Inverted;
  for (std::size_t c = 0; c < block.Classes.size(); ++c)
  {
    report.Tetrahedra[c] += block.Classes[c];
  }
  const vtkIdType thickPoints = block.ThickPoints;
  const vtkIdType tetrahedra = block.Tetrahedra;
  block.ThickPoints = this->BasePoints + this->ThickPoints;
  block.Tetrahedra = this->Tetrahedra;
  this->ThickPoints += thickPoints;
  this->Tetrahedra += tetrahedra;
}

void ProjectedTetrahedra::RemoveGaps()
{
  if (this->ThickPoints == this->Simplices)
  {
    return;
  }
  const vtkIdType points = this->BasePoints + this->ThickPoints;
  vtkPointData* arrays = this->Output->GetPointData();
  const auto shorten = [&](vtkAbstractArray* array)
  {
    vtkDataArray* numbers = vtkDataArray::SafeDownCast(array);
    const bool isFilledLater =
      std::find(this->Others.begin(), this->Others.end(), array) != this->Others.end();
    for (std::size_t b = 0; b < this->Blocks.size() && !isFilledLater; ++b)
    {
      const vtkIdType begin = this->Blocks[b].ThickPoints;
      const vtkIdType end = b + 1 < this->Blocks.size() ? this->Blocks[b + 1].ThickPoints : points;
      MoveTuples(numbers, this->BasePoints + this->Blocks[b].FirstIndex, begin, end - begin);
    }
    array->Resize(points);
  };
  shorten(this->Points->GetData());
  for (int a = 0; a < arrays->GetNumberOfArrays(); ++a)
  {
    shorten(arrays->GetAbstractArray(a));
  }
}

void ProjectedTetrahedra::AllocateTetrahedra()
{
  this->Cells.Allocate(this->Tetrahedra, 4, this->BasePoints + this->ThickPoints);
  this->Classes =
    OutputCellArrays::Add<vtkUnsignedCharArray>(this->Output, "SimplexClass", this->Tetrahedra)
      ->GetPointer(0);
  this->Items =
    OutputCellArrays::Add<vtkIntArray>(this->Output, "IntervalId", this->Tetrahedra)->GetPointer(0);
  this->Slabs =
    OutputCellArrays::Add<vtkIntArray>(this->Output, "TimeSlab", this->Tetrahedra)->GetPointer(0);
}

void ProjectedTetrahedra::WriteBlock(const Block& block)
{
  const Slab& slab = *block.TheSlab;
  const Simplex* const simplices = slab.Simplices.GetData() + block.First;
  const SimplexSigns* const signs = this->Signs.GetData() + block.FirstIndex;
  const vtkIdType number = block.Last - block.First;
  vtkIdType tetrahedron = block.Tetrahedra;
  this->Cells.Visit(
    [&](auto* values)
    {
      using Id = std::decay_t<decltype(*values)>;
      Id* next = values + 4 * tetrahedron;
      vtkIdType thickPoint = block.ThickPoints;
      for (vtkIdType s = 0; s < number; ++s)
      {
        const Simplex& simplex = simplices[s];
        signs[s].ForEachTetrahedron(
          [&](int a, int b, int c)
          {
            next[0] = static_cast<Id>(simplex[a]);
            next[1] = static_cast<Id>(simplex[b]);
            next[2] = static_cast<Id>(simplex[c]);
            next[3] = static_cast<Id>(thickPoint);
            next += 4;
          });
        thickPoint += signs[s].GetDecomposition().NumberOfTetrahedra > 0 ? 1 : 0;
      }
    });
  for (vtkIdType s = 0; s < number; ++s)
  {
    const SimplexSigns::Cut& cut = signs[s].GetDecomposition();
    std::fill_n(this->Classes + tetrahedron, cut.NumberOfTetrahedra, ClassNames[cut.Class]);
    std::fill_n(this->Items + tetrahedron, cut.NumberOfTetrahedra, slab.GetItem(block.First + s));
    tetrahedron += cut.NumberOfTetrahedra;
  }
  std::fill(this->Slabs + block.Tetrahedra, this->Slabs + tetrahedron, slab.Number);
}

// Copies values that cannot be averaged from the point with the largest weight.
void ProjectedTetrahedra::FillNonNumericArrays()
{
  if (this->Others.empty())
  {
    return;
  }
  for (const Block& block : this->Blocks)
  {
    vtkIdType thickPoint = block.ThickPoints;
    for (vtkIdType s = block.First; s < block.Last; ++s)
    {
      const vtkIdType index = block.FirstIndex + s - block.First;
      if (this->Signs[index].GetDecomposition().NumberOfTetrahedra > 0)
      {
        const vtkIdType heaviest = block.TheSlab->Simplices[s][this->Heaviest[index]];
        for (vtkAbstractArray* array : this->Others)
        {
          array->SetTuple(thickPoint, heaviest, array);
        }
        ++thickPoint;
      }
    }
  }
}

}
