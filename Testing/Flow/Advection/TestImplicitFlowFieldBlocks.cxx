// SPDX-License-Identifier: BSD-3-Clause
// vtkImplicitFlowField on composite data: streamlines cross blocks and have the same results as in
// a single grid. Also tests hidden and duplicate cells, arrays, samples, and errors of blocks.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceExecution.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Flow/ReferenceFlowGrid.h"

#include "vtkFlowStatus.h"
#include "vtkImplicitFlowField.h"
#include "vtkTerminationPlane.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSphereSource.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace
{

using namespace reference;
using Grid = vtkSmartPointer<vtkDataSet>;

Vector Shear(const Vector& x)
{
  return { { 1.0, 0.25 * x[2], 0.125 } };
}

/// Returns an image with cells of width 1. It has \a cells cells along x, from x = \a start, and
/// covers [0, 4] in y and z.
Grid MakeImage(int start, int cells)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(cells + 1, 5, 5);
  image->SetOrigin(start, 0.0, 0.0);
  AddVectors(image, Shear);
  return image;
}

Grid MakeMoved(const vtkSmartPointer<vtkPointSet>& grid, int start)
{
  MovePoints(grid, [start](const Vector& x) { return Vector{ { x[0] + start, x[1], x[2] } }; });
  AddVectors(grid, Shear);
  return grid;
}

Grid MakeStructured(int start, int cells)
{
  return MakeMoved(MakeStructuredGrid({ { cells, 4, 4 } }), start);
}

Grid MakeMesh(MeshKind kind, int start, int cells)
{
  return MakeMoved(MakeFlowMesh(kind, { { cells, 4, 4 } }), start);
}

/// Returns blocks in a nested tree with empty blocks in between.
vtkSmartPointer<vtkMultiBlockDataSet> MakeBlocks(const std::vector<Grid>& grids)
{
  vtkNew<vtkMultiBlockDataSet> inner;
  auto outer = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  outer->SetBlock(0, vtkNew<vtkUnstructuredGrid>());
  outer->SetBlock(1, inner);
  for (std::size_t i = 0; i < grids.size(); ++i)
  {
    inner->SetBlock(static_cast<unsigned int>(2 * i + 1), grids[i]);
  }
  return outer;
}

vtkSmartPointer<vtkImplicitFlowField> NewFilter(vtkDataObject* input)
{
  vtkNew<vtkTerminationPlane> plane;
  plane->SetOrigin(0.0, -4.0, -4.0);
  plane->SetPoint1(0.0, 8.0, -4.0);
  plane->SetPoint2(0.0, -4.0, 8.0);
  auto filter = vtkSmartPointer<vtkImplicitFlowField>::New();
  filter->SetInputDataObject(input);
  filter->AddTerminationSurface(plane);
  return filter;
}

vtkDataSet* Update(vtkImplicitFlowField* filter)
{
  filter->Update();
  return vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
}

double GetValue(vtkDataSet* data, const char* name, vtkIdType id, int component = 0)
{
  return data->GetPointData()->GetArray(name)->GetComponent(id, component);
}

/// Checks that each sample has the same result as the sample of \a whole at its position.
void CheckSame(vtkDataSet* found, vtkDataSet* whole, Check& check)
{
  for (vtkIdType id = 0; id < found->GetNumberOfPoints(); ++id)
  {
    const vtkIdType same = whole->FindPoint(found->GetPoint(id));
    for (const char* name : { "FlowStatus", "TerminationId", "AdvectionTime" })
    {
      check.Near(GetValue(found, name, id), GetValue(whole, name, same), 1e-12, name, 1.0);
    }
    for (int c = 0; c < 2; ++c)
    {
      check.Near(GetValue(found, "TerminationUV", id, c), GetValue(whole, "TerminationUV", same, c),
        1e-12, "place", 1.0);
    }
  }
}

/// Blocks of any kind in any tree yield the results of a single image.
void TestTrees(Check& check)
{
  auto filter = NewFilter(MakeImage(0, 4));
  vtkNew<vtkImageData> whole;
  whole->DeepCopy(Update(filter));
  vtkNew<vtkPartitionedDataSet> partitions;
  partitions->SetPartition(0, MakeMesh(MeshKind::Hexahedra, 0, 3));
  partitions->SetPartition(1, MakeStructured(3, 1));
  vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetPartition(0, 1, MakeImage(0, 1));
  collection->SetPartition(2, 0, MakeStructured(1, 2));
  collection->SetPartition(3, 0, MakeImage(3, 1));
  const std::vector<std::pair<std::string, vtkSmartPointer<vtkDataObject>>> trees = {
    { "two images", MakeBlocks({ MakeImage(0, 2), MakeImage(2, 2) }) },
    { "images in another order",
      MakeBlocks({ MakeImage(3, 1), MakeImage(0, 2), MakeImage(2, 1) }) },
    { "two meshes",
      MakeBlocks(
        { MakeMesh(MeshKind::Tetrahedra6, 0, 2), MakeMesh(MeshKind::Tetrahedra6, 2, 2) }) },
    { "partitions", partitions }, { "collection", collection }
  };
  for (const auto& tree : trees)
  {
    check.SetContext(tree.first);
    filter->SetInputDataObject(tree.second);
    check.That(UpdateAndGetErrors(filter).empty(), "no messages");
    vtkDataSet* output = Update(filter);
    check.That(vtkUnstructuredGrid::SafeDownCast(output) != nullptr, "one unstructured grid");
    check.Equal(output->GetNumberOfPoints(), whole->GetNumberOfPoints(), "no duplicate samples");
    CheckSame(output, whole, check);
    check.Equal(filter->GetReport()->GetCount("SurfaceIds"), 0, "id of the surface");
    check.That(
      filter->GetReport()->GetNumber("SamplesBySurface") > 60, "streamlines reach the plane");
    const vtkIdType all = output->GetNumberOfCells();
    filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
    filter->SetSampleDimensions(1, 1, 1);
    output = Update(filter);
    check.That(vtkImageData::SafeDownCast(output) != nullptr, "an image of samples");
    check.Near(output->GetPoint(0)[0], 2.0, 0.0, "bounds of all blocks", 1.0);
    check.Near(GetValue(output, "AdvectionTime", 0), 2.0, 1e-12, "time from the center");
    filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_FIELD);
    // The pieces together contain all cells without duplicates.
    vtkIdType cells = 0;
    for (int piece = 0; piece < 3; ++piece)
    {
      filter->UpdatePiece(piece, 3, 0);
      output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
      CheckSame(output, whole, check);
      cells += output->GetNumberOfCells();
    }
    check.Equal(cells, all, "cells of all pieces");
  }
  check.SetContext("");
}

void SetGhosts(vtkDataSet* grid, int attributes, unsigned char ghost,
  const std::function<bool(vtkIdType)>& isGhost)
{
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  const vtkIdType number = grid->GetNumberOfElements(attributes);
  for (vtkIdType id = 0; id < number; ++id)
  {
    ghosts->InsertNextValue(isGhost(id) ? ghost : 0);
  }
  grid->GetAttributes(attributes)->AddArray(ghosts);
}

/// Hidden cells of a block stop streamlines. Duplicates of another block's cells do not stop them.
void TestGhosts(Check& check)
{
  const auto isLast = [](vtkIdType cell) { return cell % 2 == 1; };
  for (const unsigned char ghost :
    { vtkDataSetAttributes::HIDDENCELL, vtkDataSetAttributes::REFINEDCELL })
  {
    auto first = MakeImage(0, 2);
    SetGhosts(first, vtkDataObject::CELL, ghost, isLast);
    auto filter = NewFilter(MakeBlocks({ first, MakeImage(2, 2) }));
    vtkDataSet* output = Update(filter);
    check.Equal(output->GetNumberOfCells(), 48, "cells that are not hidden");
    check.Equal(output->GetNumberOfPoints(), 125, "points of these cells");
    check.That(output->GetPointGhostArray() == nullptr && output->GetCellGhostArray() == nullptr,
      "no ghost arrays");
    for (vtkIdType id = 0; id < output->GetNumberOfPoints(); ++id)
    {
      const bool isBehind = output->GetPoint(id)[0] > 1.5;
      check.That(!isBehind || GetValue(output, "FlowStatus", id) == vtkFlowStatus::LEFT_DOMAIN,
        "hidden cells form a hole");
    }
    check.Equal(filter->GetReport()->GetCount("SurfaceIds"), 0, "id of the surface");
    check.That(
      filter->GetReport()->GetNumber("SamplesBySurface") > 20, "streamlines before the hole");
  }
  // Hidden cells may have types that fields do not support.
  auto mesh = MakeFlowMesh(MeshKind::Hexahedra, { { 2, 4, 4 } });
  AddVectors(mesh, Shear);
  const vtkIdType corners[3] = { 0, 1, 2 };
  mesh->InsertNextCell(VTK_TRIANGLE, 3, corners);
  SetGhosts(mesh, vtkDataObject::CELL, vtkDataSetAttributes::HIDDENCELL,
    [](vtkIdType cell) { return cell == 32; });
  auto mixed = NewFilter(MakeBlocks({ mesh, MakeImage(2, 2) }));
  check.That(UpdateAndGetErrors(mixed).empty(), "a hidden triangle");
  check.Equal(Update(mixed)->GetNumberOfCells(), 64, "cells without the triangle");
  // A block that overlaps the next block by one layer of duplicate cells, as readers of parallel
  // files produce.
  auto filter = NewFilter(MakeImage(0, 4));
  vtkNew<vtkImageData> whole;
  whole->DeepCopy(Update(filter));
  auto more = MakeImage(0, 3);
  SetGhosts(more, vtkDataObject::CELL, vtkDataSetAttributes::DUPLICATECELL,
    [](vtkIdType cell) { return cell % 3 == 2; });
  auto next = MakeImage(2, 2);
  SetGhosts(next, vtkDataObject::CELL, 0, isLast);
  filter->SetInputDataObject(MakeBlocks({ more, next }));
  vtkDataSet* output = Update(filter);
  check.That(
    output->GetCellGhostArray() == nullptr, "no ghost array, although both blocks have one");
  check.Equal(output->GetNumberOfCells(), 64, "cells without duplicates");
  check.Equal(output->GetNumberOfPoints(), 125, "points without duplicates");
  CheckSame(output, whole, check);
  // Points hidden in one block may have any value. They do not hide points of another block.
  auto hidden = MakeImage(0, 3);
  SetGhosts(hidden, vtkDataObject::POINT, vtkDataSetAttributes::HIDDENPOINT,
    [](vtkIdType point) { return point % 4 == 3; });
  vtkDataArray* vectors = hidden->GetPointData()->GetVectors();
  for (vtkIdType point = 3; point < hidden->GetNumberOfPoints(); point += 4)
  {
    vectors->SetComponent(point, 0, -1.0);
  }
  filter->SetInputDataObject(MakeBlocks({ hidden, MakeImage(2, 2) }));
  output = Update(filter);
  check.Equal(output->GetNumberOfCells(), 64, "cells without hidden points");
  CheckSame(output, whole, check);
}

template <typename Array>
void AddArray(vtkDataSetAttributes* data, const char* name, vtkIdType number, double first)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfTuples(number);
  for (vtkIdType i = 0; i < number; ++i)
  {
    array->SetComponent(i, 0, first + static_cast<double>(i));
  }
  data->AddArray(array);
}

/// Arrays that exist in all blocks are passed. At points that blocks share, the values of the first
/// block are used.
void TestArrays(Check& check)
{
  auto first = MakeImage(0, 2);
  auto second = MakeImage(2, 2);
  AddArray<vtkDoubleArray>(first->GetPointData(), "Both", 75, 0.0);
  AddArray<vtkDoubleArray>(second->GetPointData(), "Other", 75, 0.0);
  AddArray<vtkDoubleArray>(second->GetPointData(), "Both", 75, 1000.0);
  AddArray<vtkDoubleArray>(first->GetPointData(), "One", 75, 0.0);
  AddArray<vtkIntArray>(first->GetCellData(), "Number", 32, 0.0);
  AddArray<vtkIntArray>(second->GetCellData(), "Number", 32, 1000.0);
  auto filter = NewFilter(MakeBlocks({ first, second }));
  filter->AddMeanArray("Both");
  vtkDataSet* output = Update(filter);
  check.That(output->GetPointData()->GetArray("One") == nullptr, "an array of only one block");
  check.Equal(output->GetNumberOfPoints(), 125, "samples");
  for (vtkIdType id = 0; id < output->GetNumberOfPoints(); ++id)
  {
    const double* x = output->GetPoint(id);
    const bool isFirst = x[0] <= 2.0;
    const double row = 3.0 * (x[1] + 5.0 * x[2]);
    check.Near(GetValue(output, "Both", id), isFirst ? x[0] + row : 1000.0 + x[0] - 2.0 + row, 0.0,
      "the value of the first block with the point");
  }
  auto* numbers = vtkIntArray::SafeDownCast(output->GetCellData()->GetArray("Number"));
  check.That(numbers != nullptr, "a cell array with its type");
  for (vtkIdType cell = 0; numbers && cell < 64; ++cell)
  {
    double bounds[6];
    output->GetCellBounds(cell, bounds);
    const double row = 2.0 * (bounds[2] + 4.0 * bounds[4]);
    check.Near(static_cast<double>(numbers->GetValue(cell)),
      bounds[0] < 1.5 ? bounds[0] + row : 998.0 + bounds[0] + row, 0.0, "the id of the input cell");
  }
  auto type = [&](const Grid& one, const Grid& other)
  {
    filter->SetInputDataObject(MakeBlocks({ one, other }));
    filter->RemoveAllMeanArrays();
    return vtkUnstructuredGrid::SafeDownCast(Update(filter))->GetPoints()->GetDataType();
  };
  const auto makeFloats = [](int start)
  {
    auto grid = MakeStructured(start, 2);
    vtkNew<vtkPoints> floats;
    floats->SetDataTypeToFloat();
    for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
    {
      floats->InsertNextPoint(grid->GetPoint(id));
    }
    vtkPointSet::SafeDownCast(grid)->SetPoints(floats);
    return grid;
  };
  check.Equal(type(makeFloats(0), makeFloats(2)), VTK_FLOAT, "single-precision coordinates");
  check.Equal(type(makeFloats(0), MakeImage(2, 2)), VTK_DOUBLE, "mixed coordinates");
  check.Equal(first->GetPointData()->GetNumberOfArrays(), 3, "the input is unchanged");
}

/// A single block yields the same results as its dataset alone.
void TestSingle(Check& check)
{
  for (const Grid& grid :
    { MakeImage(0, 4), MakeStructured(0, 4), MakeMesh(MeshKind::Wedges, 0, 4) })
  {
    check.SetContext(std::string("a single ") + grid->GetClassName());
    auto gridFilter = NewFilter(grid);
    auto filter = NewFilter(MakeBlocks({ grid }));
    gridFilter->DomainFacesOn();
    filter->DomainFacesOn();
    vtkDataSet* expected = Update(gridFilter);
    vtkDataSet* output = Update(filter);
    check.That(vtkUnstructuredGrid::SafeDownCast(output) != nullptr, "an unstructured grid");
    check.Equal(output->GetNumberOfPoints(), expected->GetNumberOfPoints(), "samples");
    check.Equal(output->GetNumberOfCells(), expected->GetNumberOfCells(), "cells");
    CheckSame(output, expected, check);
    check.Equal(filter->GetReport()->GetCount("Steps"), gridFilter->GetReport()->GetCount("Steps"),
      "steps of the specialized walker");
  }
  check.SetContext("");
}

/// Output is bit-identical for any number of threads.
void TestThreads(Check& check)
{
  std::vector<double> known;
  for (int threads : { 1, 4 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads },
      [&]
      {
        auto filter = NewFilter(MakeBlocks({ MakeImage(0, 2), MakeImage(2, 2) }));
        vtkDataSet* output = Update(filter);
        std::vector<double> found;
        for (vtkIdType id = 0; id < output->GetNumberOfPoints(); ++id)
        {
          found.insert(found.end(), output->GetPoint(id), output->GetPoint(id) + 3);
          found.push_back(GetValue(output, "AdvectionTime", id));
        }
        check.That(known.empty() || known == found, "positions and times");
        known = found;
      });
  }
}

void TestErrors(Check& check)
{
  const auto expect = [&](const std::vector<Grid>& grids, const std::string& part)
  {
    auto filter = NewFilter(MakeBlocks(grids));
    filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS,
      grids[0]->GetPointData()->GetVectors()->GetName());
    CheckError(filter, part, check);
  };
  auto other = MakeImage(2, 2);
  other->GetPointData()->GetVectors()->SetName("Other");
  expect({ MakeImage(0, 2), other }, "Block 6 (flat index): The field has no point or cell array");
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  Grid surface = sphere->GetOutput();
  AddVectors(surface, Shear);
  expect({ surface, surface }, "Block 4 (flat index): The field has no three-dimensional cells");
  auto filter = NewFilter(vtkNew<vtkMultiBlockDataSet>());
  AllowWarnings(filter);
  check.That(
    UpdateAndGetErrors(filter).empty(), "a composite input without blocks is not an error");
  filter->Modified();
  check.That(WarningsOf(filter).find("no points") != std::string::npos, "a warning for no blocks");
  check.Equal(Update(filter)->GetNumberOfPoints(), 0, "no output without blocks");
}

}

int TestImplicitFlowFieldBlocks(int, char*[])
{
  Check check;
  TestTrees(check);
  TestGhosts(check);
  TestArrays(check);
  TestSingle(check);
  TestThreads(check);
  TestErrors(check);
  return check.Result();
}
