// SPDX-License-Identifier: BSD-3-Clause
#include "Cases/TransformedPieces.h"

#include <algorithm>
#include <cstdint>

namespace interlume
{

namespace
{
using Slot = TransformedPieces::Slot;
// One bit per edge of the lifted cell (the prism over the cell): lower edges, upper edges, then
// vertical edges, which represent the vertices.
using EdgeSet = std::uint64_t;

struct Polygon
{
  Slot Side;
  std::vector<Slot> Points;
  EdgeSet Edges;
};

struct Piece
{
  std::vector<Slot> Points;
  std::vector<Polygon> Faces;
  EdgeSet Edges;
};

class Mover
{
public:
  Mover(const CellSymmetries::Symmetry& symmetry, int vertices, int edges)
    : Symmetry(symmetry)
    , Vertices(vertices)
    , Edges(edges)
  {
  }

  std::vector<Slot> Move(const std::vector<Slot>& pieces) const
  {
    std::vector<Piece> moved;
    for (const Slot* at = pieces.data(); at != pieces.data() + pieces.size();)
    {
      moved.push_back(this->MovePiece(at));
    }
    Sort(moved);
    std::vector<Slot> result;
    result.reserve(pieces.size());
    for (const Piece& piece : moved)
    {
      Append(piece.Points, result);
      result.push_back(static_cast<Slot>(piece.Faces.size()));
      for (const Polygon& face : piece.Faces)
      {
        result.push_back(face.Side);
        Append(face.Points, result);
      }
    }
    return result;
  }

private:
  // Returns the edge of the lifted cell that a slot represents.
  int GetEdge(Slot slot) const
  {
    return slot < this->Vertices ? 2 * this->Edges + slot : slot - this->Vertices;
  }

  template <typename Faces>
  static void Sort(Faces& faces)
  {
    std::sort(
      faces.begin(), faces.end(), [](const auto& a, const auto& b) { return a.Edges < b.Edges; });
  }

  static void Append(const std::vector<Slot>& points, std::vector<Slot>& result)
  {
    result.push_back(static_cast<Slot>(points.size()));
    result.insert(result.end(), points.begin(), points.end());
  }

  // Reads a list of points, preceded by its length, and returns their images under the symmetry.
  std::vector<Slot> MovePoints(const Slot*& at, EdgeSet& edges) const
  {
    const int number = *at++;
    std::vector<Slot> points(number);
    edges = 0;
    for (Slot& point : points)
    {
      point = this->Symmetry.Slots[*at++];
      edges |= EdgeSet(1) << this->GetEdge(point);
    }
    return points;
  }

  Piece MovePiece(const Slot*& at) const
  {
    Piece piece;
    piece.Points = this->MovePoints(at, piece.Edges);
    std::sort(piece.Points.begin(), piece.Points.end(),
      [this](Slot a, Slot b) { return this->GetEdge(a) < this->GetEdge(b); });
    piece.Faces.resize(*at++);
    for (Polygon& face : piece.Faces)
    {
      face.Side = *at++;
      face.Points = this->MovePoints(at, face.Edges);
      if (this->Symmetry.Reverses)
      {
        std::reverse(face.Points.begin(), face.Points.end());
      }
      this->Rotate(face.Points);
    }
    Sort(piece.Faces);
    return piece;
  }

  // Rotates a polygon so that it starts with its largest side, as in CasePatch. Each end of a side
  // has the index of a lifted edge; sides are compared by the larger index, then by the smaller
  // one. If the first end of the largest side has the larger index, the polygon ends with this side
  // instead.
  void Rotate(std::vector<Slot>& points) const
  {
    const int number = static_cast<int>(points.size());
    int best = 0;
    EdgeSet greatest = 0;
    for (int i = 0; i < number; ++i)
    {
      const EdgeSet side = (EdgeSet(1) << this->GetEdge(points[i])) |
        (EdgeSet(1) << this->GetEdge(points[(i + 1) % number]));
      if (side > greatest)
      {
        greatest = side;
        best = i;
      }
    }
    const bool isForward = this->GetEdge(points[best]) < this->GetEdge(points[(best + 1) % number]);
    const int first = isForward ? best : (best + 2) % number;
    std::rotate(points.begin(), points.begin() + first, points.end());
  }

  const CellSymmetries::Symmetry& Symmetry;
  int Vertices;
  int Edges;
};
}

std::vector<TransformedPieces::Slot> TransformedPieces::Move(const std::vector<Slot>& pieces,
  const CellSymmetries::Symmetry& symmetry, int vertices, int edges)
{
  return Mover(symmetry, vertices, edges).Move(pieces);
}

}
