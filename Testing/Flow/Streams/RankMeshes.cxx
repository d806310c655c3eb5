// SPDX-License-Identifier: BSD-3-Clause
#include "Streams/RankMeshes.h"

#include "Support/Flow/ReferenceFlowGrid.h"
#include "Support/Meshes/ReferencePieceSource.h"

#include "vtkAnalyticFlowSource.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiBlockDataSetAlgorithm.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkUnstructuredGridAlgorithm.h"

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

namespace
{
/// Base class of sources that handle piece requests.
template <typename Algorithm>
class PieceAlgorithm : public Algorithm
{
protected:
  PieceAlgorithm() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    outputs->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
    return 1;
  }
};

class AnyPieceSource : public PieceAlgorithm<vtkUnstructuredGridAlgorithm>
{
public:
  static AnyPieceSource* New();
  vtkTypeMacro(AnyPieceSource, vtkUnstructuredGridAlgorithm);

  RankMeshes::GetPiece GetPiece;

protected:
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    using Pipeline = vtkStreamingDemandDrivenPipeline;
    vtkInformation* info = outputs->GetInformationObject(0);
    const auto piece = this->GetPiece(info->Get(Pipeline::UPDATE_PIECE_NUMBER()),
      std::max(1, info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES())));
    vtkUnstructuredGrid::GetData(info)->ShallowCopy(piece);
    return 1;
  }
};
vtkStandardNewMacro(AnyPieceSource);

class BlockSource : public PieceAlgorithm<vtkMultiBlockDataSetAlgorithm>
{
public:
  static BlockSource* New();
  vtkTypeMacro(BlockSource, vtkMultiBlockDataSetAlgorithm);

  std::vector<vtkSmartPointer<vtkDataSet>> Blocks;

protected:
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    using Pipeline = vtkStreamingDemandDrivenPipeline;
    vtkInformation* info = outputs->GetInformationObject(0);
    const int piece = info->Get(Pipeline::UPDATE_PIECE_NUMBER());
    const int pieces = std::max(1, info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()));
    const auto number = static_cast<int>(this->Blocks.size());
    vtkMultiBlockDataSet* output = vtkMultiBlockDataSet::GetData(info);
    output->SetNumberOfBlocks(static_cast<unsigned int>(number));
    for (int i = number * piece / pieces; i < number * (piece + 1) / pieces; ++i)
    {
      output->SetBlock(static_cast<unsigned int>(i), this->Blocks[static_cast<std::size_t>(i)]);
    }
    return 1;
  }
};
vtkStandardNewMacro(BlockSource);
}

vtkSmartPointer<vtkUnstructuredGrid> RankMeshes::Make(reference::MeshKind kind,
  const std::array<int, 3>& cells, CurvedGridSource::Shape shape, int field, int type)
{
  const auto mesh = reference::MakeFlowMesh(kind, cells);
  reference::MovePoints(mesh,
    [&](const reference::Vector& index)
    {
      reference::Vector part;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        part[axis] = index[axis] / cells[axis];
      }
      reference::Vector x;
      shape(part.data(), x.data());
      return x;
    });
  vtkNew<vtkPoints> points;
  points->SetDataType(type);
  points->GetData()->DeepCopy(mesh->GetPoints()->GetData());
  mesh->SetPoints(points);
  vtkNew<vtkAnalyticFlowSource> flow;
  flow->SetField(field);
  reference::AddVectors(mesh,
    [&](const reference::Vector& x)
    {
      reference::Vector v;
      flow->Evaluate(x.data(), v.data());
      return v;
    })
    ->SetName("Velocity");
  return mesh;
}

void RankMeshes::Shuffle(vtkUnstructuredGrid* mesh)
{
  std::vector<vtkIdType> order(static_cast<std::size_t>(mesh->GetNumberOfCells()));
  std::iota(order.begin(), order.end(), 0);
  std::mt19937 random(1);
  // std::shuffle may differ between standard libraries.
  for (std::size_t i = order.size(); i > 1; --i)
  {
    std::swap(order[i - 1], order[random() % i]);
  }
  vtkNew<vtkUnstructuredGrid> before;
  before->ShallowCopy(mesh);
  vtkNew<vtkUnstructuredGrid> mixed;
  mixed->SetPoints(before->GetPoints());
  mixed->GetPointData()->ShallowCopy(before->GetPointData());
  mixed->Allocate(before->GetNumberOfCells());
  vtkNew<vtkIdList> ids;
  for (const vtkIdType cell : order)
  {
    before->GetCellPoints(cell, ids);
    mixed->InsertNextCell(before->GetCellType(cell), ids);
  }
  mesh->ShallowCopy(mixed);
}

void RankMeshes::Hide(vtkUnstructuredGrid* mesh)
{
  const auto add =
    [](vtkDataSetAttributes* data, vtkIdType number, vtkIdType each, unsigned char mark)
  {
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    ghosts->SetNumberOfValues(number);
    for (vtkIdType i = 0; i < number; ++i)
    {
      ghosts->SetValue(i, i % each == 5 ? mark : 0);
    }
    data->AddArray(ghosts);
  };
  add(mesh->GetCellData(), mesh->GetNumberOfCells(), 17, vtkDataSetAttributes::HIDDENCELL);
  add(mesh->GetPointData(), mesh->GetNumberOfPoints(), 101, vtkDataSetAttributes::HIDDENPOINT);
}

vtkAlgorithm* RankMeshes::MakeSource(vtkUnstructuredGrid* mesh)
{
  reference::PieceSource* source = reference::PieceSource::New();
  source->SetFullData(mesh);
  return source;
}

vtkSmartPointer<vtkUnstructuredGrid> RankMeshes::MakePiece(
  vtkUnstructuredGrid* mesh, int piece, int pieces, int ghostLevels)
{
  const auto source = vtk::TakeSmartPointer(MakeSource(mesh));
  source->UpdateInformation();
  source->UpdatePiece(piece, pieces, ghostLevels);
  return vtkUnstructuredGrid::SafeDownCast(source->GetOutputDataObject(0));
}

vtkAlgorithm* RankMeshes::MakeSource(const GetPiece& getPiece)
{
  AnyPieceSource* source = AnyPieceSource::New();
  source->GetPiece = getPiece;
  return source;
}

vtkAlgorithm* RankMeshes::MakeBlockSource(vtkUnstructuredGrid* mesh, int blocks, bool hasOwnArrays)
{
  BlockSource* source = BlockSource::New();
  for (int i = 0; i < blocks; ++i)
  {
    const auto block = vtkSmartPointer<vtkUnstructuredGrid>::New();
    block->DeepCopy(MakePiece(mesh, i, blocks, 0));
    vtkDataArray* vectors = block->GetPointData()->GetVectors();
    for (vtkIdType point = 0; point < vectors->GetNumberOfTuples(); ++point)
    {
      vectors->SetComponent(point, 0, vectors->GetComponent(point, 0) + 0.01 * i);
    }
    if (hasOwnArrays && 2 * i + 2 < blocks)
    {
      const auto copy = vtk::TakeSmartPointer(vectors->NewInstance());
      copy->DeepCopy(vectors);
      copy->SetName("Own");
      block->GetPointData()->AddArray(copy);
    }
    source->Blocks.push_back(block);
  }
  vtkNew<vtkUnstructuredGrid> flat;
  flat->SetPoints(mesh->GetPoints());
  const vtkIdType corners[3] = { 0, 1, 2 };
  flat->Allocate(1);
  flat->InsertNextCell(VTK_TRIANGLE, 3, corners);
  source->Blocks.insert(source->Blocks.begin(), flat.GetPointer());
  return source;
}
