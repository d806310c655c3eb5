#include "vtkSpaceTimeOutput.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkExtractionArrays.h"
#include "vtkFloatArray.h"
#include "vtkPoints.h"
#include "vtkSpaceTimeMesh.h"
#include "vtkSpaceTimeReport.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <vector>

namespace
{
using Simplex = vtkSpaceTimeMesh::Simplex;
using Slab = vtkSpaceTimeMesh::Slab;
constexpr int NumberOfPoints = vtkSimplexProjection::NumberOfPoints;

constexpr unsigned char ClassNames[vtkSimplexProjection::NumberOfClasses] = {
  vtkTimeVaryingIntervalVolume::CLASS_1, vtkTimeVaryingIntervalVolume::CLASS_2,
  vtkTimeVaryingIntervalVolume::CLASS_3A, vtkTimeVaryingIntervalVolume::CLASS_3B,
  vtkTimeVaryingIntervalVolume::CLASS_4, vtkTimeVaryingIntervalVolume::CLASS_5
};

template <typename Array>
Array* AddCellArray(vtkUnstructuredGrid* output, const char* name, vtkIdType number)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfValues(number);
  vtkExtractionMemory::PreferLargePages(array);
  output->GetCellData()->AddArray(array);
  return array;
}

int GetItem(const Slab& slab, vtkIdType simplex)
{
  return slab.Items.GetSize() > 0 ? slab.Items[simplex] : 0;
}

// Where the thick point and the tetrahedra of a simplex begin.
struct Place
{
  vtkIdType Point;
  vtkIdType Tetrahedron;
};

// What some simplices of a slab add up to.
struct Sums
{
  Place Size{ 0, 0 };
  std::array<vtkIdType, vtkSimplexProjection::NumberOfClasses> Classes{};
  vtkIdType Flat = 0;
  vtkIdType Inverted = 0;

  void Add(const vtkSimplexProjection& projection)
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

class TetrahedraFiller
{
public:
  TetrahedraFiller(const vtkSpaceTimeMesh& mesh, vtkUnstructuredGrid* output)
    : Mesh(mesh)
    , Output(output)
    , BasePoints(mesh.GetPoints()->GetNumberOfPoints())
  {
  }

  void Fill(vtkSpaceTimeReport& report)
  {
    this->FindPlaces(report);
    this->FillPoints();
    vtkPointData* to = this->Output->GetPointData();
    vtkPointData* from = this->Mesh.GetArrays();
    for (int a = 0; a < from->GetNumberOfArrays(); ++a)
    {
      vtkAbstractArray* array = from->GetAbstractArray(a);
      vtkExtractionArrays::AddLike(from, array, to, this->MakeArray(array));
    }
    to->AddArray(this->MakeArray(this->Mesh.GetTimes()));
    this->FillThickness();
    this->FillCells();
  }

private:
  // Counts by blocks, then goes through each block once more from where it begins.
  void FindPlaces(vtkSpaceTimeReport& report)
  {
    constexpr vtkIdType blockSize = 8192;
    for (const Slab& slab : this->Mesh.GetSlabs())
    {
      const vtkIdType number = static_cast<vtkIdType>(slab.Simplices.GetSize());
      std::vector<Sums> blocks((number + blockSize - 1) / blockSize);
      const auto forBlocks = [&](auto&& visit)
      {
        vtkSMPTools::For(0, static_cast<vtkIdType>(blocks.size()),
          [&](vtkIdType first, vtkIdType last)
          {
            for (vtkIdType s = first * blockSize; s < std::min(last * blockSize, number); ++s)
            {
              visit(blocks[s / blockSize], s);
            }
          });
      };
      forBlocks([&](Sums& block, vtkIdType s) { block.Add(slab.Projections[s]); });
      for (Sums& block : blocks)
      {
        this->Begin(block, report);
      }
      this->Places.emplace_back();
      this->Places.back().Allocate(number);
      forBlocks(
        [&](Sums& block, vtkIdType s)
        {
          this->Places.back()[s] = { this->BasePoints + block.Size.Point, block.Size.Tetrahedron };
          block.Add(slab.Projections[s]);
        });
    }
  }

  // Makes the size of a block the place where it begins.
  void Begin(Sums& block, vtkSpaceTimeReport& report)
  {
    report.FlatSimplices += block.Flat;
    report.InvertedSimplices += block.Inverted;
    for (std::size_t c = 0; c < block.Classes.size(); ++c)
    {
      report.Tetrahedra[c] += block.Classes[c];
    }
    const Place size = block.Size;
    block.Size = { this->ThickPoints, this->Tetrahedra };
    this->ThickPoints += size.Point;
    this->Tetrahedra += size.Tetrahedron;
  }

  // Calls visit(slab, simplex, its projection, its place) for each simplex that has tetrahedra.
  template <typename Visitor>
  void ForEach(Visitor&& visit) const
  {
    for (std::size_t i = 0; i < this->Places.size(); ++i)
    {
      const Slab& slab = this->Mesh.GetSlabs()[i];
      vtkSMPTools::For(0, static_cast<vtkIdType>(slab.Simplices.GetSize()),
        [&](vtkIdType first, vtkIdType last)
        {
          for (vtkIdType s = first; s < last; ++s)
          {
            if (!slab.Projections[s].IsFlat())
            {
              visit(slab, s, slab.Projections[s], this->Places[i][s]);
            }
          }
        });
    }
  }

  void FillPoints()
  {
    auto points =
      vtkSmartPointer<vtkPoints>::Take(vtkPoints::New(this->Mesh.GetPoints()->GetDataType()));
    points->SetNumberOfPoints(this->BasePoints + this->ThickPoints);
    vtkExtractionMemory::PreferLargePages(points->GetData());
    vtkSMPTools::For(0, this->BasePoints,
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType p = first; p < last; ++p)
        {
          points->SetPoint(p, this->Mesh.GetProjected(p).data());
        }
      });
    this->ForEach(
      [&](const Slab& slab, vtkIdType s, const vtkSimplexProjection& projection, const Place& place)
      {
        vtkSimplexProjection::Point corners[NumberOfPoints];
        const double* places[NumberOfPoints];
        for (int p = 0; p < NumberOfPoints; ++p)
        {
          corners[p] = this->Mesh.GetProjected(slab.Simplices[s][p]);
          places[p] = corners[p].data();
        }
        double x[3];
        projection.GetThickPoint(places, x);
        points->SetPoint(place.Point, x);
      });
    this->Output->SetPoints(points);
  }

  // An array of the points, with its means at the thick points.
  vtkSmartPointer<vtkAbstractArray> MakeArray(vtkAbstractArray* from) const
  {
    vtkSmartPointer<vtkAbstractArray> made;
    made.TakeReference(from->NewInstance());
    made->SetName(from->GetName());
    made->SetNumberOfComponents(from->GetNumberOfComponents());
    made->SetNumberOfTuples(this->BasePoints + this->ThickPoints);
    made->InsertTuples(0, this->BasePoints, 0, from);
    if (vtkFloatArray* floats = vtkFloatArray::SafeDownCast(made))
    {
      this->FillMeans(floats->GetPointer(0), from->GetNumberOfComponents());
    }
    else if (vtkDoubleArray* doubles = vtkDoubleArray::SafeDownCast(made))
    {
      this->FillMeans(doubles->GetPointer(0), from->GetNumberOfComponents());
    }
    else
    {
      this->CopyHeaviest(made);
    }
    return made;
  }

  template <typename Value>
  void FillMeans(Value* values, int components) const
  {
    this->ForEach(
      [=](const Slab& slab, vtkIdType s, const vtkSimplexProjection& projection, const Place& place)
      {
        const Simplex& simplex = slab.Simplices[s];
        for (int c = 0; c < components; ++c)
        {
          double mean = 0.0;
          for (int p = 0; p < NumberOfPoints; ++p)
          {
            const double weight = projection.GetWeights()[p];
            // What has no weight may not be finite.
            mean += weight == 0.0 ? 0.0 : weight * values[simplex[p] * components + c];
          }
          values[place.Point * components + c] = static_cast<Value>(mean);
        }
      });
  }

  void CopyHeaviest(vtkAbstractArray* array) const
  {
    for (std::size_t i = 0; i < this->Places.size(); ++i)
    {
      const Slab& slab = this->Mesh.GetSlabs()[i];
      for (std::size_t s = 0; s < slab.Simplices.GetSize(); ++s)
      {
        const auto& weights = slab.Projections[s].GetWeights();
        const auto heaviest = std::max_element(weights.begin(), weights.end()) - weights.begin();
        if (!slab.Projections[s].IsFlat())
        {
          array->SetTuple(this->Places[i][s].Point, slab.Simplices[s][heaviest], array);
        }
      }
    }
  }

  void FillThickness()
  {
    vtkNew<vtkDoubleArray> thickness;
    thickness->SetName("DeltaT");
    thickness->SetNumberOfValues(this->BasePoints + this->ThickPoints);
    vtkSMPTools::Fill(thickness->GetPointer(0), thickness->GetPointer(0) + this->BasePoints, 0.0);
    this->ForEach(
      [&](const Slab&, vtkIdType, const vtkSimplexProjection& projection, const Place& place)
      { thickness->SetValue(place.Point, projection.GetThickness()); });
    this->Output->GetPointData()->AddArray(thickness);
  }

  void FillCells()
  {
    vtkSimplexList list;
    list.Allocate(this->Tetrahedra, 4, this->BasePoints + this->ThickPoints);
    auto* classes =
      AddCellArray<vtkUnsignedCharArray>(this->Output, "SimplexClass", this->Tetrahedra);
    auto* items = AddCellArray<vtkIntArray>(this->Output, "IntervalId", this->Tetrahedra);
    auto* slabs = AddCellArray<vtkIntArray>(this->Output, "TimeSlab", this->Tetrahedra);
    this->ForEach(
      [&](const Slab& slab, vtkIdType s, const vtkSimplexProjection& projection, const Place& place)
      {
        const Simplex& simplex = slab.Simplices[s];
        vtkIdType next = place.Tetrahedron;
        projection.ForEachTetrahedron(
          [&](int a, int b, int c)
          {
            const vtkIdType ids[4] = { simplex[a], simplex[b], simplex[c], place.Point };
            list.Write(next++, ids);
          });
        const vtkIdType number = next - place.Tetrahedron;
        std::fill_n(
          classes->GetPointer(place.Tetrahedron), number, ClassNames[projection.GetClass()]);
        std::fill_n(items->GetPointer(place.Tetrahedron), number, GetItem(slab, s));
        std::fill_n(slabs->GetPointer(place.Tetrahedron), number, slab.Number);
      });
    this->Output->SetCells(VTK_TETRA, list.MakeCells());
  }

  const vtkSpaceTimeMesh& Mesh;
  vtkUnstructuredGrid* Output;
  vtkIdType BasePoints;
  vtkIdType ThickPoints = 0;
  vtkIdType Tetrahedra = 0;
  std::vector<vtkExtractionBuffer<Place>> Places;
};

// Points and point arrays of the mesh itself.
void ShareArrays(const vtkSpaceTimeMesh& mesh, vtkUnstructuredGrid* output)
{
  output->SetPoints(mesh.GetPoints());
  output->GetPointData()->ShallowCopy(mesh.GetArrays());
  output->GetPointData()->AddArray(mesh.GetTimes());
}
}

void vtkSpaceTimeOutput::FillTetrahedra(
  const vtkSpaceTimeMesh& mesh, vtkUnstructuredGrid* output, vtkSpaceTimeReport& report)
{
  if (mesh.GetPoints())
  {
    TetrahedraFiller(mesh, output).Fill(report);
  }
}

void vtkSpaceTimeOutput::FillBoundary(
  const vtkSpaceTimeMesh& mesh, vtkUnstructuredGrid* output, vtkSpaceTimeReport& report)
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
    const vtkSpaceTimeMesh::BoundaryCell& cell = cells[c];
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

void vtkSpaceTimeOutput::FillSimplices(const vtkSpaceTimeMesh& mesh, vtkUnstructuredGrid* output)
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
  vtkSimplexList list;
  list.Allocate(number, NumberOfPoints, mesh.GetPoints()->GetNumberOfPoints());
  auto* items = AddCellArray<vtkIntArray>(output, "IntervalId", number);
  auto* slabs = AddCellArray<vtkIntArray>(output, "TimeSlab", number);
  vtkIdType next = 0;
  for (const Slab& slab : mesh.GetSlabs())
  {
    for (std::size_t s = 0; s < slab.Simplices.GetSize(); ++s, ++next)
    {
      list.Write(next, slab.Simplices[s].data());
      items->SetValue(next, GetItem(slab, static_cast<vtkIdType>(s)));
      slabs->SetValue(next, slab.Number);
    }
  }
  output->SetCells(VTK_POLY_VERTEX, list.MakeCells());
}
