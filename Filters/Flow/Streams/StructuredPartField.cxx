// SPDX-License-Identifier: BSD-3-Clause
#include "Streams/StructuredPartField.h"

#include "Streams/MessageBytes.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>

namespace interlume
{

namespace
{
constexpr int Corners = 8;

/// Adds a position to a box that begins empty.
void Add(const double x[3], double box[6])
{
  for (int axis = 0; axis < 3; ++axis)
  {
    box[2 * axis] = std::min(box[2 * axis], x[axis]);
    box[2 * axis + 1] = std::max(box[2 * axis + 1], x[axis]);
  }
}

void Clear(double box[6])
{
  for (int i = 0; i < 6; ++i)
  {
    box[i] = i % 2 ? -VTK_DOUBLE_MAX : VTK_DOUBLE_MAX;
  }
}

const int* GetFaceCorners(vtkIdType face)
{
  return CellShape::Of(CellShape::HEXAHEDRON).Faces[face % 8].Corners;
}
}

void StructuredPartField::Join(RankExchange& exchange)
{
  this->BuildTree([this](const Place& place) { return this->IsHere(place); },
    [&exchange](double bounds[6]) { exchange.Unite(bounds); });
  this->Boxes.Build(exchange, this->GetTree().GetBounds());
  this->FindSeams(exchange);
}

std::uint64_t StructuredPartField::GetOrder(const Place& place) const
{
  Trilinear points;
  this->GetPoints(place, points);
  double box[6];
  Clear(box);
  for (const auto& corner : points.C)
  {
    Add(corner, box);
  }
  return this->GetTree().GetOrder(box);
}

StructuredPartField::OutsideFace StructuredPartField::GetOutsideFace(vtkIdType face) const
{
  OutsideFace outside;
  outside.Face = face;
  Trilinear points;
  this->GetPoints(this->GetPlace(face / 8), points);
  for (int corner = 0; corner < Corners; ++corner)
  {
    std::copy_n(points.C[corner], 3, outside.Cell[corner]);
  }
  return outside;
}

std::vector<StructuredPartField::OutsideFace> StructuredPartField::ShareFaces(
  const std::vector<vtkIdType>& faces, RankExchange& exchange) const
{
  struct Reach
  {
    double Middle[3];
    double Tolerance;
  };
  std::vector<OutsideFace> all;
  std::vector<Reach> reaches;
  double box[6];
  Clear(box);
  std::vector<double> largestTolerance{ 0.0 };
  for (const vtkIdType face : faces)
  {
    all.push_back(this->GetOutsideFace(face));
    double corners[4][3];
    double own[6];
    Clear(own);
    for (int i = 0; i < 4; ++i)
    {
      std::copy_n(all.back().Cell[GetFaceCorners(face)[i]], 3, corners[i]);
      Add(corners[i], own);
      Add(corners[i], box);
    }
    Reach reach;
    double largest = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      reach.Middle[axis] = 0.5 * own[2 * axis] + 0.5 * own[2 * axis + 1];
      largest = std::max({ largest, -own[2 * axis], own[2 * axis + 1] });
    }
    reach.Tolerance =
      FaceLinks::GetTolerance(FaceExtent::Of(corners, 4, all.back().Cell, Corners).Width, largest,
        this->GetPositions().GetRounding(largest));
    largestTolerance[0] = std::max(largestTolerance[0], reach.Tolerance);
    reaches.push_back(reach);
  }
  exchange.Maximize(largestTolerance);
  RankBoxes boxes;
  boxes.Build(exchange, faces.empty() ? nullptr : box);
  bool isSent = false;
  exchange.Run(
    [&](const RankExchange::Bytes& received, std::vector<RankExchange::Bytes>& sent)
    {
      const std::size_t own = faces.size();
      for (std::size_t i = 0; !isSent && i < own; ++i)
      {
        // A process needs to know the faces that are the same as its own, and all that those are
        // the same as.
        boxes.ForEachAt(reaches[i].Middle, reaches[i].Tolerance + largestTolerance[0],
          [&](int rank)
          {
            if (rank != exchange.GetRank())
            {
              MessageBytes::Put(sent[static_cast<std::size_t>(rank)], all[i]);
            }
          });
      }
      isSent = true;
      for (const char* at = received.data(); at < received.data() + received.size();)
      {
        all.emplace_back();
        MessageBytes::Get(at, all.back());
      }
      return true;
    });
  return all;
}

void StructuredPartField::FindSeams(RankExchange& exchange)
{
  int first[3];
  int last[3];
  this->GetOwn(first, last);
  const std::vector<vtkIdType> own = this->GetOutsideFaces(first, last);
  const std::vector<OutsideFace> all = this->ShareFaces(own, exchange);
  if (own.empty())
  {
    this->SetSeams({}, {});
    return;
  }
  vtkSmartPointer<vtkDataArray> points;
  if (this->GetPositions().GetFloats())
  {
    points = vtkSmartPointer<vtkFloatArray>::New();
  }
  else
  {
    points = vtkSmartPointer<vtkDoubleArray>::New();
  }
  points->SetNumberOfComponents(3);
  points->SetNumberOfTuples(static_cast<vtkIdType>(all.size()) * Corners);
  std::vector<vtkIdType> faces;
  for (const OutsideFace& face : all)
  {
    for (int corner = 0; corner < Corners; ++corner)
    {
      points->SetTuple(static_cast<vtkIdType>(faces.size()) * Corners + corner, face.Cell[corner]);
    }
    faces.push_back(face.Face);
  }
  ArrayRows positions;
  positions.Build(points);
  std::vector<FaceLinks::Link> links(all.size(), FaceLinks::Link{ -1, 0, false });
  FaceLinks::Find(
    static_cast<vtkIdType>(all.size()), 1,
    [&faces](vtkIdType i, FaceLinks::Block& block)
    {
      block.Corners[0] = 4;
      for (int corner = 0; corner < 4; ++corner)
      {
        block.Points[0][corner] =
          i * Corners + GetFaceCorners(faces[static_cast<std::size_t>(i)])[corner];
      }
    },
    [](vtkIdType i, vtkIdType* ids)
    {
      for (int corner = 0; corner < Corners; ++corner)
      {
        ids[corner] = i * Corners + corner;
      }
      return Corners;
    },
    positions,
    [&links](vtkIdType i, const FaceLinks::Link& link)
    { links[static_cast<std::size_t>(i)] = link; });
  std::vector<Seam> seams = GetSeams(own, faces, links);
  FaceLinks::Joins joins;
  for (const Seam& seam : seams)
  {
    joins.Number += seam.Link.Gap > 0.0 && seam.Face < seam.Link.Face ? 1 : 0;
    joins.LargestGap = std::max(joins.LargestGap, seam.Link.Gap);
  }
  this->SetSeams(std::move(seams), joins);
}

OpenInterfaces StructuredPartField::FindOpenInterfaces(RankExchange& exchange) const
{
  int first[3];
  int last[3];
  this->GetOwn(first, last);
  const std::vector<vtkIdType> faces = this->WithoutSeams(this->GetOutsideFaces(first, last));
  std::vector<char> isOpen(faces.size(), 0);
  enum class Kind : int
  {
    Position,
    IsOpen
  };
  bool isSent = false;
  exchange.Run(
    [&](const RankExchange::Bytes& received, std::vector<RankExchange::Bytes>& sent)
    {
      for (std::size_t i = 0; !isSent && i < faces.size(); ++i)
      {
        double x[3];
        if (!OpenInterfaces::GetPlaceBeyond(*this, faces[i], x))
        {
          continue;
        }
        isOpen[i] = OpenInterfaces::HasCell(*this, faces[i] / 8, x) ? 1 : 0;
        this->ForEachRankAt(x,
          [&](int rank)
          {
            if (rank != exchange.GetRank() && !isOpen[i])
            {
              RankExchange::Bytes& bytes = sent[static_cast<std::size_t>(rank)];
              MessageBytes::Put(bytes, Kind::Position);
              MessageBytes::Put(bytes, exchange.GetRank());
              MessageBytes::Put(bytes, i);
              MessageBytes::Put(bytes, x[0]);
              MessageBytes::Put(bytes, x[1]);
              MessageBytes::Put(bytes, x[2]);
            }
          });
      }
      isSent = true;
      for (const char* at = received.data(); at < received.data() + received.size();)
      {
        Kind kind;
        int rank = 0;
        std::size_t i = 0;
        MessageBytes::Get(at, kind);
        MessageBytes::Get(at, rank);
        MessageBytes::Get(at, i);
        if (kind == Kind::IsOpen)
        {
          isOpen[i] = 1;
          continue;
        }
        double x[3];
        MessageBytes::Get(at, x);
        if (OpenInterfaces::HasCell(*this, -1, x))
        {
          RankExchange::Bytes& bytes = sent[static_cast<std::size_t>(rank)];
          MessageBytes::Put(bytes, Kind::IsOpen);
          MessageBytes::Put(bytes, exchange.GetRank());
          MessageBytes::Put(bytes, i);
        }
      }
      return true;
    });
  OpenInterfaces found;
  std::vector<vtkIdType> number{ std::count(isOpen.begin(), isOpen.end(), 1) };
  const auto open = std::find(isOpen.begin(), isOpen.end(), 1);
  // The least number is the largest of the negatives.
  std::vector<double> least{ open == isOpen.end()
      ? -VTK_DOUBLE_MAX
      : -static_cast<double>(faces[static_cast<std::size_t>(open - isOpen.begin())] / 8) };
  exchange.Add(number);
  exchange.Maximize(least);
  found.Number = number[0];
  found.FirstCell = found.Number > 0 ? static_cast<vtkIdType>(-least[0]) : -1;
  return found;
}

}
