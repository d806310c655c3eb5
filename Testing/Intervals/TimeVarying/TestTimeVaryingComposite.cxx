// SPDX-License-Identifier: BSD-3-Clause
// Composite steps yield composite outputs with the same structure, including empty leaves. The
// simplices of each leaf equal the result of extracting that leaf separately.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Meshes/ReferenceGrid.h"
#include "Support/Meshes/ReferenceLattice.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/TimeVarying/ReferenceTemporal.h"
#include "Support/TimeVarying/ReferenceTimeVarying.h"

#include "vtkCompositeDataIterator.h"
#include "vtkDataObjectTree.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkTimeVaryingIntervalVolume.h"
#include "vtkUnstructuredGrid.h"

#include <functional>

namespace
{

using namespace reference;

const std::vector<double> Times = { 0, 1, 1.75 };
const TimeVaryingSettings Settings = { { { 0.3, 0.6 } } };

/// Returns settings for the union of an interval of each array.
TimeVaryingSettings MakeUnion()
{
  TimeVaryingSettings settings = Settings;
  settings.Criteria = { { "g", 0.4, 0.7 } };
  settings.CriteriaOperation = vtkTimeVaryingIntervalVolume::UNION;
  return settings;
}

/// Returns the time steps of each leaf of a composite dataset.
std::vector<TimeSteps> MakeLeaves()
{
  std::vector<TimeSteps> leaves;
  for (MeshKind kind : { MeshKind::Mixed, MeshKind::Kelvin, MeshKind::Wedges })
  {
    leaves.push_back(RepeatGrid(MakeMesh(kind, { 2, 2, 2 }), Times));
  }
  leaves.push_back(RepeatGrid(MakeImage({ 2, 3, 2 }), Times));
  for (size_t i = 0; i < leaves.size(); ++i)
  {
    AddRandomTimeField(leaves[i], static_cast<unsigned int>(i + leaves.size()), "g");
    AddRandomTimeField(leaves[i], static_cast<unsigned int>(i));
  }
  return leaves;
}

using Leaf = std::function<vtkDataSet*(int)>;
using Tree = std::function<vtkSmartPointer<vtkDataObjectTree>(const Leaf&)>;

vtkSmartPointer<vtkDataObjectTree> MakeMultiBlock(const Leaf& leaf)
{
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetNumberOfBlocks(3);
  inner->SetBlock(0, leaf(0));
  inner->SetBlock(2, leaf(3));
  auto outer = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  outer->SetNumberOfBlocks(4);
  outer->SetBlock(0, inner);
  outer->SetBlock(1, leaf(1));
  outer->SetBlock(3, vtkNew<vtkUnstructuredGrid>());
  return outer;
}

vtkSmartPointer<vtkDataObjectTree> MakeCollection(const Leaf& leaf)
{
  vtkNew<vtkPartitionedDataSet> partitions;
  partitions->SetPartition(0, leaf(2));
  partitions->SetPartition(1, leaf(3));
  auto collection = vtkSmartPointer<vtkPartitionedDataSetCollection>::New();
  collection->SetPartitionedDataSet(0, partitions);
  collection->SetPartition(1, 0, leaf(0));
  return collection;
}

void CheckTree(const Tree& tree, const TimeVaryingSettings& settings, Check& check)
{
  const std::vector<TimeSteps> leaves = MakeLeaves();
  TimeSteps steps;
  for (size_t i = 0; i < Times.size(); ++i)
  {
    steps.push_back({ Times[i], tree([&](int leaf) { return GetDataSet(leaves[leaf][i]); }) });
  }
  auto* first = vtkDataObjectTree::SafeDownCast(steps.front().Data);
  check.SetContext(first->GetClassName());
  vtkNew<TimeStepSource> source;
  source->SetSteps(steps);
  vtkNew<vtkTimeVaryingIntervalVolume> filter;
  filter->SetInputConnection(source->GetOutputPort());
  Apply(settings, filter);
  filter->Update();
  check.That(source->GetMaximumStepsInMemory() <= 2, "at most two steps exist at a time");
  vtkDataObjectTree* outputs[3];
  for (int port = 0; port < 3; ++port)
  {
    outputs[port] = vtkDataObjectTree::SafeDownCast(filter->GetOutputDataObject(port));
    if (!check.That(
          outputs[port] && std::string(outputs[port]->GetClassName()) == first->GetClassName(),
          "the output is composite and has the class of the input"))
    {
      return;
    }
  }
  vtkIdType cells = 0;
  int compared = 0;
  vtkSmartPointer<vtkCompositeDataIterator> at;
  at.TakeReference(first->NewIterator());
  for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
  {
    vtkDataObject* data = at->GetCurrentDataObject();
    check.SetContext(
      std::string(first->GetClassName()) + ", leaf " + std::to_string(at->GetCurrentFlatIndex()));
    for (const TimeSteps& leaf : leaves)
    {
      if (leaf.front().Data != data)
      {
        continue;
      }
      cells += 2 * GetDataSet(leaf.front())->GetNumberOfCells();
      ++compared;
      const TimeVaryingExtraction expected = ExtractTimeVarying(leaf, settings);
      vtkUnstructuredGrid* const grids[3] = { expected.Tetrahedra, expected.Boundaries,
        expected.Simplices };
      check.That(grids[2]->GetNumberOfCells() > 0, "the leaf has 4-simplices");
      for (int port = 0; port < 3; ++port)
      {
        auto* found = vtkUnstructuredGrid::SafeDownCast(outputs[port]->GetDataSet(at));
        if (check.That(found != nullptr, "the leaf is in the output"))
        {
          const std::string difference = FindDifference(found, grids[port]);
          check.That(difference.empty(), "port " + std::to_string(port) + ": " + difference);
        }
      }
    }
  }
  check.SetContext(first->GetClassName());
  check.Equal(compared, 3, "leaves compared");
  check.Equal(filter->GetReport()->GetCount("Cells"), cells,
    "the report counts the cells of all leaves and slabs");
  filter->Modified();
  filter->Update();
  check.Equal(filter->GetReport()->GetCount("Cells"), cells,
    "the report counts the cells of the last execution only");
}

/// Changes the input from a grid to a composite dataset and back. The output type changes with it.
void CheckChange(Check& check)
{
  check.SetContext("grid, tree, grid");
  const std::vector<TimeSteps> leaves = MakeLeaves();
  TimeSteps trees;
  for (size_t i = 0; i < Times.size(); ++i)
  {
    trees.push_back(
      { Times[i], MakeMultiBlock([&](int leaf) { return GetDataSet(leaves[leaf][i]); }) });
  }
  vtkNew<TimeStepSource> source;
  vtkNew<vtkTimeVaryingIntervalVolume> filter;
  filter->SetInputConnection(source->GetOutputPort());
  Apply(Settings, filter);
  for (const TimeSteps& steps : { leaves[0], trees, leaves[3], leaves[0] })
  {
    source->SetSteps(steps);
    filter->Update();
    for (int port = 0; port < 3; ++port)
    {
      check.That(filter->GetOutputDataObject(port)->IsA(
                   GetDataSet(steps.front()) ? "vtkUnstructuredGrid" : "vtkMultiBlockDataSet"),
        "the output has the type of the input");
    }
  }
  const std::string difference =
    FindDifference(filter->GetOutput(), ExtractTimeVarying(leaves[0], Settings).Tetrahedra);
  check.That(difference.empty(), difference);
}

}

int TestTimeVaryingComposite(int, char*[])
{
  Check check;
  for (const TimeVaryingSettings& settings : { Settings, MakeUnion() })
  {
    CheckTree(MakeMultiBlock, settings, check);
    CheckTree(MakeCollection, settings, check);
  }
  CheckChange(check);
  return check.Result();
}
