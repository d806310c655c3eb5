// SPDX-License-Identifier: BSD-3-Clause
#include "Streams/PartitionedStructuredField.h"

#include "Streams/PartitionBoundaryFaces.h"
#include "Streams/PartitionedInterfaces.h"

#include <utility>

namespace interlume
{

void PartitionedStructuredField::Join(RankExchange& exchange)
{
  this->BuildTree([this](const CellLocation& location) { return this->IsHere(location); },
    [&exchange](double bounds[6]) { exchange.Unite(bounds); });
  this->Boxes.Build(exchange, this->GetTree().GetBounds());
  this->FindSeams(exchange);
}

void PartitionedStructuredField::FindSeams(RankExchange& exchange)
{
  int first[3];
  int last[3];
  this->GetOwnedCellRange(first, last);
  const std::vector<vtkIdType> own = this->GetBoundaryFaces(first, last);
  std::vector<BoundaryFace> outside;
  for (const vtkIdType face : own)
  {
    outside.push_back(BoundaryFace::Of(*this, face));
  }
  PartitionBoundaryFaces faces(std::move(outside), this->GetPositions(), exchange);
  if (own.empty())
  {
    this->SetSeams({}, {});
    return;
  }
  faces.FindLinks(false);
  std::vector<vtkIdType> all;
  for (const BoundaryFace& face : faces.GetAll())
  {
    all.push_back(face.Face);
  }
  this->SetSeams(GetSeams(own, all, faces.GetLinks()), faces.GetMatchGaps());
}

NonconformingInterfaces PartitionedStructuredField::FindNonconformingInterfaces(
  RankExchange& exchange) const
{
  int first[3];
  int last[3];
  this->GetOwnedCellRange(first, last);
  return PartitionedInterfaces::Find(
    *this, this->RemoveSeamFaces(this->GetBoundaryFaces(first, last)), exchange)
    .Open;
}

}
