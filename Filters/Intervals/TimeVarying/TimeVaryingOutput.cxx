// SPDX-License-Identifier: BSD-3-Clause
#include "TimeVarying/TimeVaryingOutput.h"

#include "Arrays/ExtractionArrays.h"
#include "TimeVarying/TimeVaryingMesh.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPoints.h"
#include "vtkTimeVaryingReport.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <functional>
#include <vector>

namespace interlume
{

namespace
{
using Simplex = TimeVaryingMesh::Simplex;
using Slab = TimeVaryingMesh::Slab;
constexpr int NumberOfPoints = SimplexProjection::NumberOfPoints;

constexpr unsigned char ClassNames[SimplexProjection::NumberOfClasses] = {
  vtkTimeVaryingSettings::CLASS_1, vtkTimeVaryingSettings::CLASS_2,
  vtkTimeVaryingSettings::CLASS_3A, vtkTimeVaryingSettings::CLASS_3B,
  vtkTimeVaryingSettings::CLASS_4, vtkTimeVaryingSettings::CLASS_5
};

template <typename Array>
Array* AddCellArray(vtkUnstructuredGrid* output, const char* name, vtkIdType number)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfValues(number);
  ExtractionMemory::PreferLargePages(array);
  output->GetCellData()->AddArray(array);
  return array;
}

int GetItem(const Slab& slab, vtkIdType simplex)
{
  return slab.Items.GetSize() > 0 ? slab.Items[simplex] : 0;
}

// The places where the thick point and the tetrahedra of a simplex begin.
struct Place
{
  vtkIdType Point;
  vtkIdType Tetrahedron;
};

// The sums over some simplices of a slab.
struct Sums
{
  Place Size{ 0, 0 };
  std::array<vtkIdType, SimplexProjection::NumberOfClasses> Classes{};
  vtkIdType Flat = 0;
  vtkIdType Inverted = 0;

  void Add(const SimplexProjection& projection)
  {
    this->Inverted += projection.IsInverted();
    this->Flat += projection.IsFlat();
    if (!projection.IsFlat())
    {
      const int number = projection.GetNumberOfTetrahedra();
      ++this->Size.Point;
      this->Size.Tetrahedron += number;
      this->Classes[projection.GetClass()] += number;
    }
  }
};

// Some simplices of a slab.
struct Block
{
  const Slab* TheSlab;
  vtkIdType First;
  vtkIdType Last;
  // The sums over the simplices; then the places where they begin.
  Sums Content;
};

// Writes the mean of an array at a thick point.
using MeanWriter =
  std::function<void(const Simplex&, const SimplexProjection&, vtkIdType thickPoint)>;

// Projects every simplex twice, to count and to write: that takes less time than to keep what five
// weights and a thickness take.
class TetrahedraFiller
{
public:
  TetrahedraFiller(
    const ExtractionContext& context, const TimeVaryingMesh& mesh, vtkUnstructuredGrid* output)
    : Context(context)
    , Mesh(mesh)
    , Output(output)
    , BasePoints(mesh.GetPoints()->GetNumberOfPoints())
  {
  }

  bool Fill(vtkTimeVaryingReport& report)
  {
    this->MakeBlocks();
    const vtkIdType blocks = static_cast<vtkIdType>(this->Blocks.size());
    const bool counted = this->Context.Run(blocks, 0.0, 0.4,
      [this](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType b = first; b < last; ++b)
        {
          Block& block = this->Blocks[b];
          for (vtkIdType s = block.First; s < block.Last; ++s)
          {
            block.Content.Add(this->Project(*block.TheSlab, s));
          }
        }
      });
    if (!counted)
    {
      return false;
    }
    for (Block& block : this->Blocks)
    {
      this->Begin(block.Content, report);
    }
    this->Allocate();
    const bool written = this->Context.Run(blocks, 0.4, 1.0,
      [this](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType b = first; b < last; ++b)
        {
          this->WriteBlock(this->Blocks[b]);
        }
      });
    if (written)
    {
      this->FillOthers();
      this->Output->SetCells(VTK_TETRA, this->Cells.MakeCells());
    }
    return written;
  }

private:
  void MakeBlocks()
  {
    constexpr vtkIdType size = 512;
    for (const Slab& slab : this->Mesh.GetSlabs())
    {
      const vtkIdType number = static_cast<vtkIdType>(slab.Simplices.GetSize());
      for (vtkIdType first = 0; first < number; first += size)
      {
        this->Blocks.push_back({ &slab, first, std::min(first + size, number), {} });
      }
    }
  }

  SimplexProjection Project(const Slab& slab, vtkIdType s) const
  {
    return { this->Mesh.GetProjected(slab.Simplices[s]), slab.Flats[s] };
  }

  // Turns the size of a block into the place where it begins.
  void Begin(Sums& block, vtkTimeVaryingReport& report)
  {
    report.FlatSimplices += block.Flat;
    report.InvertedSimplices += block.Inverted;
    for (std::size_t c = 0; c < block.Classes.size(); ++c)
    {
      report.Tetrahedra[c] += block.Classes[c];
    }
    const Place size = block.Size;
    block.Size = { this->BasePoints + this->ThickPoints, this->Tetrahedra };
    this->ThickPoints += size.Point;
    this->Tetrahedra += size.Tetrahedron;
  }

  void Allocate()
  {
    const vtkIdType points = this->BasePoints + this->ThickPoints;
    this->Points.TakeReference(vtkPoints::New(this->Mesh.GetPoints()->GetDataType()));
    this->Points->SetNumberOfPoints(points);
    ExtractionMemory::PreferLargePages(this->Points->GetData());
    this->Output->SetPoints(this->Points);
    vtkSMPTools::For(0, this->BasePoints,
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType p = first; p < last; ++p)
        {
          this->Points->SetPoint(p, this->Mesh.GetProjected(p).data());
        }
      });
    vtkPointData* to = this->Output->GetPointData();
    vtkPointData* from = this->Mesh.GetArrays();
    for (int a = 0; a < from->GetNumberOfArrays(); ++a)
    {
      vtkAbstractArray* array = from->GetAbstractArray(a);
      ExtractionArrays::AddLike(from, array, to, this->MakeArray(array));
    }
    to->AddArray(this->MakeArray(this->Mesh.GetTimes()));
    this->Thickness->SetName("DeltaT");
    this->Thickness->SetNumberOfValues(points);
    ExtractionMemory::PreferLargePages(this->Thickness);
    double* thickness = this->Thickness->GetPointer(0);
    vtkSMPTools::Fill(thickness, thickness + this->BasePoints, 0.0);
    to->AddArray(this->Thickness);
    this->Cells.Allocate(this->Tetrahedra, 4, points);
    this->Classes =
      AddCellArray<vtkUnsignedCharArray>(this->Output, "SimplexClass", this->Tetrahedra);
    this->Items = AddCellArray<vtkIntArray>(this->Output, "IntervalId", this->Tetrahedra);
    this->Slabs = AddCellArray<vtkIntArray>(this->Output, "TimeSlab", this->Tetrahedra);
  }

  // Makes an array of the points; its values at the thick points are yet to be written.
  vtkSmartPointer<vtkAbstractArray> MakeArray(vtkAbstractArray* from)
  {
    vtkSmartPointer<vtkAbstractArray> made;
    made.TakeReference(from->NewInstance());
    made->SetName(from->GetName());
    made->SetNumberOfComponents(from->GetNumberOfComponents());
    made->SetNumberOfTuples(this->BasePoints + this->ThickPoints);
    if (vtkDataArray* numbers = vtkDataArray::SafeDownCast(made))
    {
      ExtractionMemory::PreferLargePages(numbers);
    }
    made->InsertTuples(0, this->BasePoints, 0, from);
    if (vtkFloatArray* floats = vtkFloatArray::SafeDownCast(made))
    {
      this->AddMeans(floats->GetPointer(0), from->GetNumberOfComponents());
    }
    else if (vtkDoubleArray* doubles = vtkDoubleArray::SafeDownCast(made))
    {
      this->AddMeans(doubles->GetPointer(0), from->GetNumberOfComponents());
    }
    else
    {
      this->Others.push_back(made);
    }
    return made;
  }

  template <typename Value>
  void AddMeans(Value* values, int components)
  {
    this->Means.push_back(
      [values, components](
        const Simplex& simplex, const SimplexProjection& projection, vtkIdType thickPoint)
      {
        for (int c = 0; c < components; ++c)
        {
          double mean = 0.0;
          for (int p = 0; p < NumberOfPoints; ++p)
          {
            const double weight = projection.GetWeights()[p];
            // A value without weight may not be finite.
            mean += weight == 0.0 ? 0.0 : weight * values[simplex[p] * components + c];
          }
          values[thickPoint * components + c] = static_cast<Value>(mean);
        }
      });
  }

  void WriteBlock(const Block& block)
  {
    const Slab& slab = *block.TheSlab;
    Place place = block.Content.Size;
    for (vtkIdType s = block.First; s < block.Last; ++s)
    {
      const Simplex& simplex = slab.Simplices[s];
      const TimeVaryingMesh::Corners corners = this->Mesh.GetProjected(simplex);
      const SimplexProjection projection(corners, slab.Flats[s]);
      if (projection.IsFlat())
      {
        continue;
      }
      const double* places[NumberOfPoints];
      std::transform(corners.begin(), corners.end(), places,
        [](const SimplexProjection::Point& corner) { return corner.data(); });
      double x[3];
      projection.GetThickPoint(places, x);
      this->Points->SetPoint(place.Point, x);
      this->Thickness->SetValue(place.Point, projection.GetThickness());
      for (const MeanWriter& write : this->Means)
      {
        write(simplex, projection, place.Point);
      }
      const vtkIdType first = place.Tetrahedron;
      projection.ForEachTetrahedron(
        [&](int a, int b, int c)
        {
          const vtkIdType ids[4] = { simplex[a], simplex[b], simplex[c], place.Point };
          this->Cells.Write(place.Tetrahedron++, ids);
        });
      const vtkIdType number = place.Tetrahedron - first;
      std::fill_n(this->Classes->GetPointer(first), number, ClassNames[projection.GetClass()]);
      std::fill_n(this->Items->GetPointer(first), number, GetItem(slab, s));
      std::fill_n(this->Slabs->GetPointer(first), number, slab.Number);
      ++place.Point;
    }
  }

  // Fills in values that have no mean by those of the point with the most weight.
  void FillOthers()
  {
    for (const Block& block : this->Blocks)
    {
      vtkIdType thickPoint = block.Content.Size.Point;
      for (vtkIdType s = block.First; s < block.Last && !this->Others.empty(); ++s)
      {
        const SimplexProjection projection = this->Project(*block.TheSlab, s);
        if (projection.IsFlat())
        {
          continue;
        }
        const auto& weights = projection.GetWeights();
        const auto heaviest = std::max_element(weights.begin(), weights.end()) - weights.begin();
        for (vtkAbstractArray* array : this->Others)
        {
          array->SetTuple(thickPoint, block.TheSlab->Simplices[s][heaviest], array);
        }
        ++thickPoint;
      }
    }
  }

  const ExtractionContext& Context;
  const TimeVaryingMesh& Mesh;
  vtkUnstructuredGrid* Output;
  vtkIdType BasePoints;
  vtkIdType ThickPoints = 0;
  vtkIdType Tetrahedra = 0;
  std::vector<Block> Blocks;
  vtkSmartPointer<vtkPoints> Points;
  vtkNew<vtkDoubleArray> Thickness;
  std::vector<MeanWriter> Means;
  std::vector<vtkAbstractArray*> Others;
  SimplexList Cells;
  vtkUnsignedCharArray* Classes = nullptr;
  vtkIntArray* Items = nullptr;
  vtkIntArray* Slabs = nullptr;
};

// Shares the points and point arrays of the mesh itself.
void ShareArrays(const TimeVaryingMesh& mesh, vtkUnstructuredGrid* output)
{
  output->SetPoints(mesh.GetPoints());
  output->GetPointData()->ShallowCopy(mesh.GetArrays());
  output->GetPointData()->AddArray(mesh.GetTimes());
}
}

bool TimeVaryingOutput::FillTetrahedra(const ExtractionContext& context,
  const TimeVaryingMesh& mesh, vtkUnstructuredGrid* output, vtkTimeVaryingReport& report)
{
  return !mesh.GetPoints() || TetrahedraFiller(context, mesh, output).Fill(report);
}

void TimeVaryingOutput::FillBoundary(
  const TimeVaryingMesh& mesh, vtkUnstructuredGrid* output, vtkTimeVaryingReport& report)
{
  if (!mesh.GetPoints())
  {
    return;
  }
  ShareArrays(mesh, output);
  const auto& cells = mesh.GetBoundary();
  const vtkIdType number = static_cast<vtkIdType>(cells.size());
  auto* kinds = AddCellArray<vtkIntArray>(output, "BoundaryKind", number);
  auto* items = AddCellArray<vtkIntArray>(output, "IntervalId", number);
  auto* slabs = AddCellArray<vtkIntArray>(output, "TimeSlab", number);
  vtkNew<vtkUnsignedCharArray> types;
  types->SetNumberOfValues(number);
  vtkNew<vtkCellArray> list;
  list->AllocateEstimate(number, 4);
  for (vtkIdType c = 0; c < number; ++c)
  {
    const TimeVaryingMesh::BoundaryCell& cell = cells[c];
    const bool isTriangle = cell.Ids[3] < 0;
    list->InsertNextCell(isTriangle ? 3 : 4, cell.Ids.data());
    types->SetValue(c, isTriangle ? VTK_TRIANGLE : VTK_TETRA);
    kinds->SetValue(c, cell.Kind);
    items->SetValue(c, cell.Item);
    slabs->SetValue(c, cell.Slab);
    ++report.Boundaries[cell.Kind];
  }
  output->SetCells(types, list);
}

void TimeVaryingOutput::FillSimplices(const TimeVaryingMesh& mesh, vtkUnstructuredGrid* output)
{
  if (!mesh.GetPoints())
  {
    return;
  }
  ShareArrays(mesh, output);
  vtkIdType number = 0;
  for (const Slab& slab : mesh.GetSlabs())
  {
    number += static_cast<vtkIdType>(slab.Simplices.GetSize());
  }
  number += static_cast<vtkIdType>(mesh.GetStepVolume().size());
  SimplexList list;
  list.Allocate(number, NumberOfPoints, mesh.GetPoints()->GetNumberOfPoints());
  auto* items = AddCellArray<vtkIntArray>(output, "IntervalId", number);
  auto* slabs = AddCellArray<vtkIntArray>(output, "TimeSlab", number);
  auto* atStep = AddCellArray<vtkUnsignedCharArray>(output, "AtStep", number);
  vtkIdType next = 0;
  for (const Slab& slab : mesh.GetSlabs())
  {
    for (std::size_t s = 0; s < slab.Simplices.GetSize(); ++s, ++next)
    {
      list.Write(next, slab.Simplices[s].data());
      items->SetValue(next, GetItem(slab, static_cast<vtkIdType>(s)));
      slabs->SetValue(next, slab.Number);
      atStep->SetValue(next,
        slab.Ties[s] ? vtkTimeVaryingSettings::NOTHING_AT_STEP
                     : vtkTimeVaryingSettings::FACES_AT_STEP);
    }
  }
  for (const TimeVaryingMesh::BoundaryCell& cell : mesh.GetStepVolume())
  {
    const vtkIdType ids[NumberOfPoints] = { cell.Ids[0], cell.Ids[1], cell.Ids[2], cell.Ids[3],
      cell.Ids[3] };
    list.Write(next, ids);
    items->SetValue(next, cell.Item);
    slabs->SetValue(next, cell.Slab);
    atStep->SetValue(next++, vtkTimeVaryingSettings::TETRAHEDRON_AT_STEP);
  }
  output->SetCells(VTK_POLY_VERTEX, list.MakeCells());
}

}
