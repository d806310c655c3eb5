// SPDX-License-Identifier: BSD-3-Clause
// Composite input yields composite output with the same structure, including empty leaves. The
// simplices of each leaf equal the result of extracting that leaf separately.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Intervals/ReferenceExtraction.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceGrid.h"
#include "Support/Meshes/ReferenceLattice.h"
#include "Support/Meshes/ReferenceMesh.h"

#include "vtkCompositeDataIterator.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkImageData.h"
#include "vtkIntervalVolume.h"
#include "vtkIsotableContour.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkUnstructuredGrid.h"

namespace
{

using namespace reference;

const Interval Range = { 0.3, 0.6 };

vtkSmartPointer<vtkUnstructuredGrid> MakeGrid(MeshKind kind, unsigned int seed)
{
  auto mesh = MakeMesh(kind, { 3, 2, 2 });
  AddRandomField(mesh, seed);
  return mesh;
}

vtkSmartPointer<vtkImageData> MakeVoxels()
{
  auto image = MakeImage({ 3, 4, 2 });
  AddRandomField(image, 4);
  return image;
}

vtkSmartPointer<vtkDataObjectTree> MakeMultiBlock()
{
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetNumberOfBlocks(3);
  inner->SetBlock(0, MakeGrid(MeshKind::Mixed, 1));
  inner->SetBlock(2, MakeVoxels());
  auto outer = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  outer->SetNumberOfBlocks(4);
  outer->SetBlock(0, inner);
  outer->SetBlock(1, MakeGrid(MeshKind::Kelvin, 2));
  outer->SetBlock(3, vtkSmartPointer<vtkUnstructuredGrid>::New());
  return outer;
}

vtkSmartPointer<vtkDataObjectTree> MakePartitions()
{
  auto partitions = vtkSmartPointer<vtkPartitionedDataSet>::New();
  partitions->SetPartition(0, MakeGrid(MeshKind::Wedges, 1));
  partitions->SetPartition(1, MakeVoxels());
  return partitions;
}

vtkSmartPointer<vtkDataObjectTree> MakeCollection()
{
  auto collection = vtkSmartPointer<vtkPartitionedDataSetCollection>::New();
  collection->SetPartitionedDataSet(0, vtkPartitionedDataSet::SafeDownCast(MakePartitions()));
  collection->SetPartition(1, 0, MakeGrid(MeshKind::Pyramids, 6));
  return collection;
}

void CheckTree(vtkDataObjectTree* input, Check& check)
{
  vtkNew<vtkIntervalVolume> volume;
  volume->SetInputDataObject(input);
  volume->SetInterval(0, Range[0], Range[1]);
  volume->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  volume->GenerateBoundariesOn();
  volume->Update();
  vtkNew<vtkIsotableContour> contour;
  contour->SetInputDataObject(input);
  contour->SetValue(0, Range[0]);
  contour->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  contour->Update();
  vtkDataObjectTree* outputs[] = { vtkDataObjectTree::SafeDownCast(volume->GetOutputDataObject(0)),
    vtkDataObjectTree::SafeDownCast(volume->GetOutputDataObject(1)),
    vtkDataObjectTree::SafeDownCast(contour->GetOutputDataObject(0)) };
  for (vtkDataObjectTree* output : outputs)
  {
    if (!check.That(output != nullptr, "the output is composite"))
    {
      return;
    }
    check.That(std::string(output->GetClassName()) == input->GetClassName(),
      "the output has the class of the input");
  }
  vtkIdType cells = 0;
  vtkSmartPointer<vtkCompositeDataIterator> leaves;
  leaves.TakeReference(input->NewIterator());
  for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
  {
    auto* leaf = vtkDataSet::SafeDownCast(leaves->GetCurrentDataObject());
    check.SetContext(std::string(input->GetClassName()) + ", leaf " +
      std::to_string(leaves->GetCurrentFlatIndex()));
    cells += leaf->GetNumberOfCells();
    vtkUnstructuredGrid* found[3];
    for (int i = 0; i < 3; ++i)
    {
      found[i] = vtkUnstructuredGrid::SafeDownCast(outputs[i]->GetDataSet(leaves));
      if (!found[i] && leaf->GetNumberOfCells() > 0)
      {
        check.That(false, "the leaf is in the output");
        return;
      }
    }
    if (leaf->GetNumberOfCells() == 0)
    {
      continue;
    }
    const Extraction expected = ExtractIntervals(leaf, { Range });
    const ContourExtraction expectedContour = ExtractContours(leaf, { Range[0] });
    check.That(expected.Volume->GetNumberOfCells() > 0, "the leaf has tetrahedra");
    for (const std::string& difference :
      { FindDifference(found[0], expected.Volume), FindDifference(found[1], expected.Surface),
        FindDifference(found[2], expectedContour.Surface) })
    {
      check.That(difference.empty(), difference);
    }
  }
  check.SetContext(input->GetClassName());
  check.Equal(
    volume->GetReport()->GetCount("Cells"), cells, "the report counts the cells of all leaves");
  check.Equal(contour->GetReport()->GetCount("Cells"), cells,
    "the contour's report counts the cells of all leaves");
  volume->Modified();
  volume->Update();
  check.Equal(volume->GetReport()->GetCount("Cells"), cells,
    "the report counts the cells of the last execution only");
}

}

int TestIntervalVolumeComposite(int, char*[])
{
  Check check;
  for (const vtkSmartPointer<vtkDataObjectTree>& tree :
    { MakeMultiBlock(), MakePartitions(), MakeCollection() })
  {
    CheckTree(tree, check);
  }
  return check.Result();
}
