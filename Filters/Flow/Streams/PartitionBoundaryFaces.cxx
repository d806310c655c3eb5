// SPDX-License-Identifier: BSD-3-Clause
#include "Streams/PartitionBoundaryFaces.h"

#include "Cells/FaceExtent.h"
#include "Streams/MessageBytes.h"
#include "Streams/ProcessBounds.h"

#include "vtkBoundingBox.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <numeric>

namespace interlume
{

namespace
{
constexpr int MaximumCorners = 8;

/// Center of a face, and the distance within which another face may match it.
struct Reach
{
  double Center[3];
  double Tolerance;

  Reach(const BoundaryFace& face, const ArrayRows& positions, vtkBoundingBox& all)
  {
    const CellShape::Face& shape = face.GetShape();
    double corners[4][3];
    vtkBoundingBox box;
    for (int i = 0; i < shape.NumberOfCorners; ++i)
    {
      std::copy_n(face.Cell[shape.Corners[i]], 3, corners[i]);
      box.AddPoint(corners[i]);
    }
    all.AddBox(box);
    double largest = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double lower = box.GetMinPoint()[axis];
      const double upper = box.GetMaxPoint()[axis];
      this->Center[axis] = 0.5 * lower + 0.5 * upper;
      largest = std::max({ largest, -lower, upper });
    }
    const int size = CellShape::Of(face.Shape).NumberOfCorners;
    this->Tolerance =
      FaceLinks::GetTolerance(FaceExtent::Of(corners, shape.NumberOfCorners, face.Cell, size).Width,
        largest, positions.GetRoundingError(largest));
  }
};

/// Returns an id for each position. Equal positions have the same id. \a representatives receives
/// the index of one position for each id.
std::vector<vtkIdType> Merge(
  const std::vector<const double*>& positions, std::vector<vtkIdType>& representatives)
{
  std::vector<vtkIdType> order(positions.size());
  std::iota(order.begin(), order.end(), 0);
  const auto get = [&positions](vtkIdType i) { return positions[static_cast<std::size_t>(i)]; };
  vtkSMPTools::Sort(order.begin(), order.end(),
    [&get](vtkIdType i, vtkIdType j)
    { return std::lexicographical_compare(get(i), get(i) + 3, get(j), get(j) + 3); });
  std::vector<vtkIdType> ids(positions.size());
  for (const vtkIdType i : order)
  {
    if (representatives.empty() || !std::equal(get(i), get(i) + 3, get(representatives.back())))
    {
      representatives.push_back(i);
    }
    ids[static_cast<std::size_t>(i)] = static_cast<vtkIdType>(representatives.size()) - 1;
  }
  return ids;
}
}

PartitionBoundaryFaces::PartitionBoundaryFaces(
  std::vector<BoundaryFace>&& own, const ArrayRows& positions, RankExchange& exchange)
  : NumberOfOwn(own.size())
  , Faces(std::move(own))
  , Positions(positions)
{
  this->ExchangeFaces(exchange);
}

void PartitionBoundaryFaces::ExchangeFaces(RankExchange& exchange)
{
  std::vector<Reach> reaches;
  vtkBoundingBox box;
  std::vector<double> largestTolerance{ 0.0 };
  for (const BoundaryFace& face : this->Faces)
  {
    reaches.emplace_back(face, this->Positions, box);
    largestTolerance[0] = std::max(largestTolerance[0], reaches.back().Tolerance);
  }
  exchange.ReduceMax(largestTolerance);
  double bounds[6];
  box.GetBounds(bounds);
  ProcessBounds boxes;
  boxes.Build(exchange, this->Faces.empty() ? nullptr : bounds);
  bool isSent = false;
  exchange.Run(
    [&](const RankExchange::Bytes& received, std::vector<RankExchange::Bytes>& sent)
    {
      for (std::size_t i = 0; !isSent && i < this->NumberOfOwn; ++i)
      {
        // A process needs all faces that match its own faces, and all faces that match those in
        // turn. Therefore add the tolerances.
        boxes.ForEachAt(reaches[i].Center, reaches[i].Tolerance + largestTolerance[0],
          [&](int rank)
          {
            if (rank != exchange.GetRank())
            {
              MessageBytes::Put(sent[static_cast<std::size_t>(rank)], this->Faces[i]);
            }
          });
      }
      isSent = true;
      for (const char* at = received.data(); at < received.data() + received.size();)
      {
        this->Faces.emplace_back();
        MessageBytes::Get(at, this->Faces.back());
      }
      return true;
    });
}

void PartitionBoundaryFaces::FindLinks(bool isMerged)
{
  // The corners of a face's cell start at index MaximumCorners times the index of the face.
  std::vector<const double*> corners;
  for (const BoundaryFace& face : this->Faces)
  {
    for (const auto& corner : face.Cell)
    {
      corners.push_back(corner);
    }
  }
  std::vector<vtkIdType> representatives;
  std::vector<vtkIdType> ids;
  if (isMerged)
  {
    ids = Merge(corners, representatives);
  }
  else
  {
    ids.resize(corners.size());
    std::iota(ids.begin(), ids.end(), 0);
    representatives = ids;
  }
  vtkSmartPointer<vtkDataArray> points;
  if (this->Positions.GetFloats())
  {
    points = vtkSmartPointer<vtkFloatArray>::New();
  }
  else
  {
    points = vtkSmartPointer<vtkDoubleArray>::New();
  }
  points->SetNumberOfComponents(3);
  points->SetNumberOfTuples(static_cast<vtkIdType>(representatives.size()));
  for (std::size_t i = 0; i < representatives.size(); ++i)
  {
    points->SetTuple(
      static_cast<vtkIdType>(i), corners[static_cast<std::size_t>(representatives[i])]);
  }
  ArrayRows positions;
  positions.Build(points);
  const auto getId = [&ids](vtkIdType face, int corner)
  { return ids[static_cast<std::size_t>(face * MaximumCorners + corner)]; };
  this->Links.assign(this->Faces.size(), FaceLinks::Link{ -1, 0, false });
  FaceLinks::Find(
    static_cast<vtkIdType>(this->Faces.size()), 1,
    [this, &getId](vtkIdType i, FaceLinks::Block& block)
    {
      const CellShape::Face& shape = this->Get(i).GetShape();
      block.Corners[0] = shape.NumberOfCorners;
      for (int corner = 0; corner < shape.NumberOfCorners; ++corner)
      {
        block.Points[0][corner] = getId(i, shape.Corners[corner]);
      }
    },
    [this, &getId](vtkIdType i, vtkIdType* cell)
    {
      const int number = CellShape::Of(this->Get(i).Shape).NumberOfCorners;
      for (int corner = 0; corner < number; ++corner)
      {
        cell[corner] = getId(i, corner);
      }
      return number;
    },
    positions,
    [this](vtkIdType i, const FaceLinks::Link& link)
    { this->Links[static_cast<std::size_t>(i)] = link; });
}

FaceLinks::MatchGaps PartitionBoundaryFaces::GetMatchGaps() const
{
  FaceLinks::MatchGaps gaps;
  for (std::size_t i = 0; i < std::min(this->NumberOfOwn, this->Links.size()); ++i)
  {
    const FaceLinks::Link& link = this->Links[i];
    if (link.Face >= 0)
    {
      const bool isFirst = this->Faces[i].Face < this->Get(link.Face).Face;
      gaps.Number += link.Gap > 0.0 && isFirst ? 1 : 0;
      gaps.LargestGap = std::max(gaps.LargestGap, link.Gap);
    }
  }
  return gaps;
}

}
