// SPDX-License-Identifier: BSD-3-Clause
#include "Surfaces/SurfaceContacts.h"

#include "Common/Vectors.h"
#include "Surfaces/PlanarTriangulation.h"
#include "Surfaces/TrianglePairs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

namespace interlume
{

namespace
{
using Vectors::Difference;

double Length(const glm::dvec3& v)
{
  return std::sqrt(glm::dot(v, v));
}

/// Returns the distance of \a x from the line from \a a to \a b. \a along is the line parameter of
/// the nearest position, 0 at \a a and 1 at \a b.
double DistanceFromLine(const double* x, const double* a, const double* b, double& along)
{
  const glm::dvec3 line = Difference(b, a);
  const glm::dvec3 toX = Difference(x, a);
  along = glm::dot(toX, line) / glm::dot(line, line);
  return Length(toX - along * line);
}
}

SurfaceContacts::SurfaceContacts(ClosedSurface& surface, double tolerance)
  : Surface(surface)
  , Tolerance(tolerance)
{
}

int SurfaceContacts::GetCorner(int t, int i) const
{
  return this->Surface.Triangles[t].Points[i % 3];
}

SurfaceContacts::Edge SurfaceContacts::GetEdge(int t, int i) const
{
  const int a = this->GetCorner(t, i);
  const int b = this->GetCorner(t, i + 1);
  return { { std::min(a, b), std::max(a, b) } };
}

bool SurfaceContacts::HasCorner(int t, int p) const
{
  return this->GetCorner(t, 0) == p || this->GetCorner(t, 1) == p || this->GetCorner(t, 2) == p;
}

glm::dvec3 SurfaceContacts::GetNormal(int t) const
{
  return glm::normalize(this->Surface.GetNormal(this->Surface.Triangles[t].Points));
}

bool SurfaceContacts::Find()
{
  this->FirstCells = { { std::numeric_limits<vtkIdType>::max(), 0 } };
  this->Crossings.clear();
  this->Merged.clear();
  this->PointsOnEdges.clear();
  this->PointsInside.clear();
  this->EdgesInside.clear();
  this->Parents.resize(this->Surface.Triangles.size());
  std::iota(this->Parents.begin(), this->Parents.end(), 0);
  TrianglePairs::ForEach(
    this->Surface, this->Tolerance, [this](int s, int t) { this->FindPairContacts(s, t); });
  return this->FirstCells[0] != std::numeric_limits<vtkIdType>::max();
}

void SurfaceContacts::RecordContact(int s, int t)
{
  const auto cells = std::minmax(this->Surface.Triangles[s].Cell, this->Surface.Triangles[t].Cell);
  this->FirstCells =
    std::min(this->FirstCells, std::array<vtkIdType, 2>{ { cells.first, cells.second } });
}

void SurfaceContacts::FindPairContacts(int s, int t)
{
  // Distances of the corners of each triangle from the plane of the other triangle.
  std::array<std::array<double, 3>, 2> distances;
  std::array<bool, 2> isInPlane{ { true, true } };
  for (int side = 0; side < 2; ++side)
  {
    const int of = side == 0 ? s : t;
    const int from = side == 0 ? t : s;
    const glm::dvec3 normal = this->GetNormal(from);
    bool isAbove = true;
    bool isBelow = true;
    for (int i = 0; i < 3; ++i)
    {
      const int p = this->GetCorner(of, i);
      double& distance = distances[side][i];
      distance = this->HasCorner(from, p)
        ? 0.0
        : glm::dot(normal, Difference(this->GetPoint(p), this->GetPoint(this->GetCorner(from, 0))));
      const bool isCommon = this->HasCorner(from, p);
      isAbove = isAbove && (isCommon || distance > this->Tolerance);
      isBelow = isBelow && (isCommon || distance < -this->Tolerance);
      isInPlane[side] = isInPlane[side] && std::abs(distance) <= this->Tolerance;
    }
    if (isAbove || isBelow)
    {
      return;
    }
  }
  const bool isCoplanar = isInPlane[0] && isInPlane[1];
  if (isCoplanar && !this->DoOverlap(s, t))
  {
    // Coplanar triangles that do not overlap may still touch at points and edges.
    this->FindPoints(s, t, distances[0]);
    this->FindPoints(t, s, distances[1]);
    return;
  }
  if (isCoplanar)
  {
    this->RecordContact(s, t);
    this->Parents[std::max(this->FindRoot(s), this->FindRoot(t))] =
      std::min(this->FindRoot(s), this->FindRoot(t));
  }
  this->FindPoints(s, t, distances[0]);
  this->FindPoints(t, s, distances[1]);
  this->FindCrossings(s, t);
  if (!isCoplanar)
  {
    this->FindEdgesInside(s, t, distances[0]);
    this->FindEdgesInside(t, s, distances[1]);
  }
}

bool SurfaceContacts::DoOverlap(int s, int t) const
{
  const glm::dvec3 normal = this->GetNormal(t);
  for (int of : { s, t })
  {
    for (int i = 0; i < 3; ++i)
    {
      const glm::dvec3 axis = glm::normalize(glm::cross(normal,
        Difference(
          this->GetPoint(this->GetCorner(of, i + 1)), this->GetPoint(this->GetCorner(of, i)))));
      std::array<double, 2> lower{ { HUGE_VAL, HUGE_VAL } };
      std::array<double, 2> upper{ { -HUGE_VAL, -HUGE_VAL } };
      for (int side = 0; side < 2; ++side)
      {
        for (int k = 0; k < 3; ++k)
        {
          const double along =
            glm::dot(axis, glm::make_vec3(this->GetPoint(this->GetCorner(side == 0 ? s : t, k))));
          lower[side] = std::min(lower[side], along);
          upper[side] = std::max(upper[side], along);
        }
      }
      if (upper[0] <= lower[1] + this->Tolerance || upper[1] <= lower[0] + this->Tolerance)
      {
        return false;
      }
    }
  }
  return true;
}

void SurfaceContacts::FindPoints(int s, int t, const std::array<double, 3>& distances)
{
  for (int i = 0; i < 3; ++i)
  {
    const int p = this->GetCorner(s, i);
    if (std::abs(distances[i]) > this->Tolerance || this->HasCorner(t, p))
    {
      continue;
    }
    const double* x = this->GetPoint(p);
    const glm::dvec3 normal = this->GetNormal(t);
    bool isInside = true;
    bool isRecorded = false;
    for (int k = 0; k < 3 && !isRecorded; ++k)
    {
      const int a = this->GetCorner(t, k);
      const int b = this->GetCorner(t, k + 1);
      double along = 0.0;
      const double distance = DistanceFromLine(x, this->GetPoint(a), this->GetPoint(b), along);
      if (Length(Difference(x, this->GetPoint(a))) <= this->Tolerance)
      {
        this->Merged[std::max(a, p)] = std::min(a, p);
        isRecorded = true;
      }
      else if (distance <= this->Tolerance && along > 0.0 && along < 1.0 &&
        Length(Difference(x, this->GetPoint(b))) > this->Tolerance)
      {
        this->PointsOnEdges[this->GetEdge(t, k)].insert(p);
        isRecorded = true;
      }
      isInside = isInside &&
        glm::dot(normal,
          glm::cross(Difference(this->GetPoint(b), this->GetPoint(a)),
            Difference(x, this->GetPoint(a)))) > 0.0;
    }
    if (isInside && !isRecorded)
    {
      this->PointsInside[t].insert(p);
      isRecorded = true;
    }
    if (isRecorded)
    {
      this->RecordContact(s, t);
    }
  }
}

void SurfaceContacts::FindCrossings(int s, int t)
{
  for (int i = 0; i < 3; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Edge e = this->GetEdge(s, i);
      const Edge f = this->GetEdge(t, k);
      if (e[0] == f[0] || e[0] == f[1] || e[1] == f[0] || e[1] == f[1])
      {
        continue;
      }
      const glm::dvec3 a = glm::make_vec3(this->GetPoint(e[0]));
      const glm::dvec3 c = glm::make_vec3(this->GetPoint(f[0]));
      const glm::dvec3 u = Difference(this->GetPoint(e[1]), this->GetPoint(e[0]));
      const glm::dvec3 v = Difference(this->GetPoint(f[1]), this->GetPoint(f[0]));
      const glm::dvec3 cross = glm::cross(u, v);
      const double square = glm::dot(cross, cross);
      if (!(square > 1e-24 * glm::dot(u, u) * glm::dot(v, v)))
      {
        continue;
      }
      const double along = glm::dot(glm::cross(c - a, v), cross) / square;
      const double other = glm::dot(glm::cross(c - a, u), cross) / square;
      const glm::dvec3 x = a + along * u;
      const glm::dvec3 y = c + other * v;
      const auto isEnd = [this](const glm::dvec3& position, const Edge& edge)
      {
        return Length(position - glm::make_vec3(this->GetPoint(edge[0]))) <= this->Tolerance ||
          Length(position - glm::make_vec3(this->GetPoint(edge[1]))) <= this->Tolerance;
      };
      if (along > 0.0 && along < 1.0 && other > 0.0 && other < 1.0 &&
        Length(x - y) <= this->Tolerance && !isEnd(x, e) && !isEnd(y, f))
      {
        this->Crossings[e < f ? std::make_pair(e, f) : std::make_pair(f, e)] = x;
        this->RecordContact(s, t);
      }
    }
  }
}

void SurfaceContacts::FindEdgesInside(int s, int t, const std::array<double, 3>& distances)
{
  for (int i = 0; i < 3; ++i)
  {
    const Edge edge = this->GetEdge(s, i);
    if (std::abs(distances[i]) <= this->Tolerance &&
      std::abs(distances[(i + 1) % 3]) <= this->Tolerance &&
      !(this->HasCorner(t, edge[0]) && this->HasCorner(t, edge[1])))
    {
      this->EdgesInside[t].insert(edge);
    }
  }
}

int SurfaceContacts::FindRoot(int t)
{
  while (this->Parents[t] != t)
  {
    this->Parents[t] = this->Parents[this->Parents[t]];
    t = this->Parents[t];
  }
  return t;
}

void SurfaceContacts::AddPart(int t, const std::array<int, 3>& points, int layers)
{
  ClosedSurface::Triangle part = this->Surface.Triangles[t];
  part.Points = points;
  part.Layers = layers;
  this->Result.push_back(part);
}

Error SurfaceContacts::Split()
{
  // Repeat, since merging points can bring other points within the tolerance of each other.
  for (int round = 0; round < 4 && !this->Merged.empty(); ++round)
  {
    this->Surface.MergePoints(this->Merged);
    this->Find();
  }
  this->AddCrossings();
  std::map<int, std::vector<int>> groups;
  const int number = static_cast<int>(this->Parents.size());
  for (int t = 0; t < number; ++t)
  {
    groups[this->FindRoot(t)].push_back(t);
  }
  for (const auto& group : groups)
  {
    const int t = group.first;
    const bool isTouched = group.second.size() > 1 || this->PointsInside.count(t) > 0 ||
      this->EdgesInside.count(t) > 0 || this->PointsOnEdges.count(this->GetEdge(t, 0)) > 0 ||
      this->PointsOnEdges.count(this->GetEdge(t, 1)) > 0 ||
      this->PointsOnEdges.count(this->GetEdge(t, 2)) > 0;
    if (isTouched)
    {
      if (Error error = this->SplitCoplanarTriangles(group.second))
      {
        return error;
      }
    }
    else
    {
      this->Result.push_back(this->Surface.Triangles[t]);
    }
  }
  this->Surface.Triangles = std::move(this->Result);
  return {};
}

void SurfaceContacts::AddCrossings()
{
  std::vector<double>& points = this->Surface.Points.Coordinates;
  for (const auto& crossing : this->Crossings)
  {
    std::set<int>& first = this->PointsOnEdges[crossing.first.first];
    std::set<int>& second = this->PointsOnEdges[crossing.first.second];
    // If more than two edges cross at one position, all get the same point.
    int point = -1;
    for (const std::set<int>* list : { &first, &second })
    {
      for (int p : *list)
      {
        point = Length(glm::make_vec3(&points[3 * p]) - crossing.second) <= 4 * this->Tolerance
          ? p
          : point;
      }
    }
    if (point < 0)
    {
      point = static_cast<int>(points.size() / 3);
      points.insert(
        points.end(), glm::value_ptr(crossing.second), glm::value_ptr(crossing.second) + 3);
    }
    first.insert(point);
    second.insert(point);
  }
}

std::vector<int> SurfaceContacts::PointsAlong(const Edge& edge) const
{
  std::vector<int> points{ edge[0], edge[1] };
  const auto found = this->PointsOnEdges.find(edge);
  if (found != this->PointsOnEdges.end())
  {
    points.insert(points.end() - 1, found->second.begin(), found->second.end());
    const auto along = [&](int p)
    {
      return glm::dot(Difference(this->GetPoint(p), this->GetPoint(edge[0])),
        Difference(this->GetPoint(edge[1]), this->GetPoint(edge[0])));
    };
    std::sort(
      points.begin() + 1, points.end() - 1, [&along](int a, int b) { return along(a) < along(b); });
  }
  return points;
}

Error SurfaceContacts::SplitCoplanarTriangles(const std::vector<int>& members)
{
  const glm::dvec3 normal = glm::abs(this->GetNormal(members.front()));
  const int main = normal.x >= normal.y && normal.x >= normal.z ? 0 : normal.y >= normal.z ? 1 : 2;
  std::vector<int> ids;
  std::map<int, int> indices;
  std::vector<PlanarTriangulation::Point> positions;
  const auto add = [&](int p)
  {
    const auto found = indices.emplace(p, static_cast<int>(ids.size()));
    if (found.second)
    {
      ids.push_back(p);
      positions.push_back(
        { { this->GetPoint(p)[(main + 1) % 3], this->GetPoint(p)[(main + 2) % 3] } });
    }
    return found.first->second;
  };
  // For each segment of an edge, the members that it bounds.
  std::map<Edge, std::vector<int>> pieces;
  const auto addPiece = [&](int p, int q) -> std::vector<int>&
  {
    const int a = add(p);
    const int b = add(q);
    return pieces[{ { std::min(a, b), std::max(a, b) } }];
  };
  for (int t : members)
  {
    for (int i = 0; i < 3; ++i)
    {
      const std::vector<int> points = this->PointsAlong(this->GetEdge(t, i));
      for (std::size_t k = 1; k < points.size(); ++k)
      {
        addPiece(points[k - 1], points[k]).push_back(t);
      }
    }
    const auto inside = this->PointsInside.find(t);
    if (inside != this->PointsInside.end())
    {
      std::for_each(inside->second.begin(), inside->second.end(), add);
    }
  }
  for (int t : members)
  {
    const auto edges = this->EdgesInside.find(t);
    for (const Edge& edge : edges == this->EdgesInside.end() ? std::set<Edge>() : edges->second)
    {
      const std::vector<int> points = this->PointsAlong(edge);
      for (std::size_t k = 1; k < points.size(); ++k)
      {
        if (indices.count(points[k - 1]) > 0 && indices.count(points[k]) > 0)
        {
          addPiece(points[k - 1], points[k]);
        }
      }
    }
  }
  std::vector<Edge> segments;
  for (const auto& piece : pieces)
  {
    segments.push_back(piece.first);
  }
  const PlanarTriangulation plane(positions, segments);
  if (!plane.IsGood())
  {
    return "Cell " + std::to_string(this->Surface.Triangles[members.front()].Cell) +
      " touches other cells in a way that cannot be split. Make the surfaces share their points "
      "there.";
  }
  // A triangle is not split if its only contacts are edges in its plane that miss it.
  const bool isSplit = members.size() > 1 || ids.size() > 3;
  this->NumberOfSplitTriangles += isSplit ? static_cast<vtkIdType>(members.size()) : 0;
  this->AddCoveredTriangles(plane, ids, pieces);
  return {};
}

void SurfaceContacts::AddCoveredTriangles(const PlanarTriangulation& plane,
  const std::vector<int>& ids, const std::map<Edge, std::vector<int>>& pieces)
{
  // Traverse the triangles of the plane, starting outside. Crossing a segment enters or leaves the
  // overlapping surface triangles that the segment bounds.
  const std::vector<PlanarTriangulation::Triangle>& triangles = plane.GetTriangles();
  const auto given = static_cast<int>(ids.size());
  std::vector<std::set<int>> covers(triangles.size());
  std::vector<bool> isVisited(triangles.size(), false);
  std::vector<int> stack;
  for (std::size_t t = 0; t < triangles.size() && stack.empty(); ++t)
  {
    if (*std::max_element(triangles[t].Points.begin(), triangles[t].Points.end()) >= given)
    {
      isVisited[t] = true;
      stack.push_back(static_cast<int>(t));
    }
  }
  while (!stack.empty())
  {
    const int t = stack.back();
    stack.pop_back();
    for (int i = 0; i < 3; ++i)
    {
      const int next = triangles[t].Neighbors[i];
      if (next < 0 || isVisited[next])
      {
        continue;
      }
      const int a = triangles[t].Points[(i + 1) % 3];
      const int b = triangles[t].Points[(i + 2) % 3];
      covers[next] = covers[t];
      const auto piece = pieces.find({ { std::min(a, b), std::max(a, b) } });
      for (int member : piece == pieces.end() ? std::vector<int>() : piece->second)
      {
        if (covers[next].erase(member) == 0)
        {
          covers[next].insert(member);
        }
      }
      isVisited[next] = true;
      stack.push_back(next);
    }
  }
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    const auto& p = triangles[t].Points;
    if (!covers[t].empty() && *std::max_element(p.begin(), p.end()) < given)
    {
      int layers = 0;
      for (int member : covers[t])
      {
        layers += this->Surface.Triangles[member].Layers;
      }
      this->AddPart(*covers[t].rbegin(), { { ids[p[0]], ids[p[1]], ids[p[2]] } }, layers);
    }
  }
}

}
