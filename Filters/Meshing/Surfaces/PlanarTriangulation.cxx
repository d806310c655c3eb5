// SPDX-License-Identifier: BSD-3-Clause
#include "Surfaces/PlanarTriangulation.h"

#include <algorithm>
#include <cmath>
#include <deque>

namespace interlume
{

namespace
{
__extension__ typedef __int128 Wide;

constexpr double Steps = 4503599627370496.0; // 2^52
/// The corners of the large triangle around all points have the coordinates -Frame or 2 * Frame, in
/// grid steps.
constexpr std::int64_t Frame = std::int64_t(1) << 54;

int IndexOf(const std::array<int, 3>& list, int value)
{
  return static_cast<int>(std::find(list.begin(), list.end(), value) - list.begin());
}

PlanarTriangulation::Edge Sorted(int a, int b)
{
  return { { std::min(a, b), std::max(a, b) } };
}
}

PlanarTriangulation::PlanarTriangulation(
  const std::vector<Point>& points, const std::vector<Edge>& segments)
{
  const int number = static_cast<int>(points.size());
  Point lower = points.front();
  double size = 0.0;
  for (const Point& x : points)
  {
    lower = { { std::min(lower[0], x[0]), std::min(lower[1], x[1]) } };
  }
  for (const Point& x : points)
  {
    size = std::max({ size, x[0] - lower[0], x[1] - lower[1] });
  }
  for (const Point& x : points)
  {
    this->Positions.push_back({ { std::llround((x[0] - lower[0]) / size * Steps),
      std::llround((x[1] - lower[1]) / size * Steps) } });
  }
  this->Positions.push_back({ { -Frame, -Frame } });
  this->Positions.push_back({ { 2 * Frame, -Frame } });
  this->Positions.push_back({ { -Frame, 2 * Frame } });
  this->TriangleOf.assign(number + 3, 0);
  this->Triangles.push_back({ { { number, number + 1, number + 2 } }, { { -1, -1, -1 } } });
  for (int p = 0; p < number && this->Good; ++p)
  {
    this->AddPoint(p);
  }
  for (const Edge& segment : segments)
  {
    if (this->Good)
    {
      this->AddSegment(segment);
    }
  }
}

int PlanarTriangulation::Orientation(int a, int b, int c) const
{
  const auto& p = this->Positions;
  const Wide area =
    Wide(p[b][0] - p[a][0]) * (p[c][1] - p[a][1]) - Wide(p[c][0] - p[a][0]) * (p[b][1] - p[a][1]);
  return area > 0 ? 1 : area < 0 ? -1 : 0;
}

bool PlanarTriangulation::IsInCircle(int a, int b, int c, int d) const
{
  // The test need not be exact, since an unnecessary flip affects only the quality. The tolerance
  // of the comparison prevents flip cycles.
  std::array<std::array<long double, 3>, 3> rows;
  long double size = 0.0L;
  const std::array<int, 3> corners{ { a, b, c } };
  for (int i = 0; i < 3; ++i)
  {
    const long double x = this->Positions[corners[i]][0] - this->Positions[d][0];
    const long double y = this->Positions[corners[i]][1] - this->Positions[d][1];
    rows[i] = { { x, y, x * x + y * y } };
    size = std::max(size, rows[i][2]);
  }
  const long double determinant = rows[0][0] * (rows[1][1] * rows[2][2] - rows[1][2] * rows[2][1]) -
    rows[0][1] * (rows[1][0] * rows[2][2] - rows[1][2] * rows[2][0]) +
    rows[0][2] * (rows[1][0] * rows[2][1] - rows[1][1] * rows[2][0]);
  return determinant > 1e-12L * size * size;
}

void PlanarTriangulation::Replace(int t, int old, int now)
{
  if (t >= 0)
  {
    this->Triangles[t].Neighbors[IndexOf(this->Triangles[t].Neighbors, old)] = now;
  }
}

int PlanarTriangulation::Locate(int point) const
{
  int t = this->Last;
  for (std::size_t step = 0; step < this->Triangles.size(); ++step)
  {
    const Triangle& triangle = this->Triangles[t];
    int next = t;
    for (int i = 0; i < 3 && next == t; ++i)
    {
      // Start at a different corner in each step so that the walk does not cycle.
      const int k = (i + static_cast<int>(step)) % 3;
      if (this->Orientation(triangle.Points[(k + 1) % 3], triangle.Points[(k + 2) % 3], point) < 0)
      {
        next = triangle.Neighbors[k];
      }
    }
    if (next == t)
    {
      return t;
    }
    t = next;
  }
  for (std::size_t i = 0; i < this->Triangles.size(); ++i)
  {
    const auto& p = this->Triangles[i].Points;
    if (this->Orientation(p[0], p[1], point) >= 0 && this->Orientation(p[1], p[2], point) >= 0 &&
      this->Orientation(p[2], p[0], point) >= 0)
    {
      return static_cast<int>(i);
    }
  }
  return -1;
}

void PlanarTriangulation::AddPoint(int point)
{
  const int t = this->Locate(point);
  if (t < 0)
  {
    this->Good = false;
    return;
  }
  const Triangle oldTriangle = this->Triangles[t];
  int edge = -1;
  for (int i = 0; i < 3; ++i)
  {
    if (this->Positions[oldTriangle.Points[i]] == this->Positions[point])
    {
      this->Good = false;
      return;
    }
    if (this->Orientation(
          oldTriangle.Points[(i + 1) % 3], oldTriangle.Points[(i + 2) % 3], point) == 0)
    {
      edge = i;
    }
  }
  // Connect the point to the three corners. If it is on an edge, one of the new triangles is
  // degenerate, so flip the edge.
  const int second = static_cast<int>(this->Triangles.size());
  const std::array<int, 3> parts{ { t, second, second + 1 } };
  this->Triangles.resize(this->Triangles.size() + 2);
  for (int i = 0; i < 3; ++i)
  {
    const int a = oldTriangle.Points[(i + 1) % 3];
    const int b = oldTriangle.Points[(i + 2) % 3];
    this->Triangles[parts[i]] = { { { point, a, b } },
      { { oldTriangle.Neighbors[i], parts[(i + 1) % 3], parts[(i + 2) % 3] } } };
    if (oldTriangle.Neighbors[i] >= 0 && parts[i] != t)
    {
      this->Replace(oldTriangle.Neighbors[i], t, parts[i]);
    }
    this->TriangleOf[a] = parts[i];
  }
  this->TriangleOf[point] = t;
  this->Last = t;
  std::vector<int> changed(parts.begin(), parts.end());
  if (edge >= 0)
  {
    changed.push_back(this->Triangles[parts[edge]].Neighbors[0]);
    this->Flip(parts[edge], 0);
  }
  this->Legalize(changed, point);
}

void PlanarTriangulation::Flip(int t, int i)
{
  const Triangle one = this->Triangles[t];
  const int u = one.Neighbors[i];
  const Triangle other = this->Triangles[u];
  const int j = IndexOf(other.Neighbors, t);
  const int a = one.Points[i];
  const int b = one.Points[(i + 1) % 3];
  const int c = one.Points[(i + 2) % 3];
  const int d = other.Points[j];
  const int neighborAB = one.Neighbors[(i + 2) % 3];
  const int neighborCA = one.Neighbors[(i + 1) % 3];
  const int neighborBD = other.Neighbors[(j + 1) % 3];
  const int neighborDC = other.Neighbors[(j + 2) % 3];
  this->Triangles[t] = { { { a, b, d } }, { { neighborBD, u, neighborAB } } };
  this->Triangles[u] = { { { a, d, c } }, { { neighborDC, neighborCA, t } } };
  this->Replace(neighborBD, u, t);
  this->Replace(neighborCA, t, u);
  this->TriangleOf[a] = t;
  this->TriangleOf[b] = t;
  this->TriangleOf[d] = t;
  this->TriangleOf[c] = u;
}

void PlanarTriangulation::Legalize(std::vector<int> changed, int point)
{
  while (!changed.empty())
  {
    const int t = changed.back();
    changed.pop_back();
    const Triangle triangle = this->Triangles[t];
    const int i = IndexOf(triangle.Points, point);
    if (i == 3 || triangle.Neighbors[i] < 0)
    {
      continue;
    }
    const int u = triangle.Neighbors[i];
    const int d = this->Triangles[u].Points[IndexOf(this->Triangles[u].Neighbors, t)];
    const int b = triangle.Points[(i + 1) % 3];
    const int c = triangle.Points[(i + 2) % 3];
    if (this->IsInCircle(point, b, c, d) && this->Orientation(point, b, d) > 0 &&
      this->Orientation(point, d, c) > 0)
    {
      this->Flip(t, i);
      changed.push_back(t);
      changed.push_back(u);
    }
  }
}

std::vector<int> PlanarTriangulation::FindAround(int point) const
{
  std::vector<int> around;
  int t = this->TriangleOf[point];
  do
  {
    around.push_back(t);
    t = this->Triangles[t].Neighbors[(IndexOf(this->Triangles[t].Points, point) + 1) % 3];
  } while (t >= 0 && t != around.front());
  return around;
}

bool PlanarTriangulation::FindEdge(int a, int b, int& t, int& i) const
{
  for (int candidate : this->FindAround(a))
  {
    const auto& points = this->Triangles[candidate].Points;
    const int at = IndexOf(points, a);
    if (points[(at + 1) % 3] == b)
    {
      t = candidate;
      i = (at + 2) % 3;
      return true;
    }
  }
  return false;
}

void PlanarTriangulation::AddSegment(const Edge& segment)
{
  const int a = segment[0];
  const int b = segment[1];
  int t = -1;
  int i = -1;
  if (!this->FindEdge(a, b, t, i))
  {
    // Collect the edges that cross the segment, starting at its first end.
    std::deque<Edge> crossing;
    for (int candidate : this->FindAround(a))
    {
      const auto& points = this->Triangles[candidate].Points;
      const int at = IndexOf(points, a);
      if (this->Orientation(a, b, points[(at + 1) % 3]) < 0 &&
        this->Orientation(a, b, points[(at + 2) % 3]) > 0)
      {
        t = candidate;
        i = at;
      }
    }
    this->Good = t >= 0;
    while (this->Good)
    {
      const Triangle& triangle = this->Triangles[t];
      const Edge edge = Sorted(triangle.Points[(i + 1) % 3], triangle.Points[(i + 2) % 3]);
      const int right = triangle.Points[(i + 1) % 3];
      crossing.push_back(edge);
      const int u = triangle.Neighbors[i];
      this->Good = u >= 0 && this->Fixed.count(edge) == 0;
      if (!this->Good)
      {
        break;
      }
      const Triangle& next = this->Triangles[u];
      const int j = IndexOf(next.Neighbors, t);
      const int apex = next.Points[j];
      if (apex == b)
      {
        break;
      }
      const int orientation = this->Orientation(a, b, apex);
      this->Good = orientation != 0;
      // The next crossing edge connects the apex to that end of the current edge that is on the
      // other side of the segment.
      t = u;
      i = orientation > 0 ? IndexOf(next.Points, edge[0] == right ? edge[1] : edge[0])
                          : IndexOf(next.Points, right);
    }
    std::size_t attempts = 10 * (crossing.size() + 10) * (crossing.size() + 10);
    while (this->Good && !crossing.empty())
    {
      const Edge edge = crossing.front();
      crossing.pop_front();
      this->Good = attempts-- > 0 && this->FindEdge(edge[0], edge[1], t, i);
      if (!this->Good)
      {
        break;
      }
      const int u = this->Triangles[t].Neighbors[i];
      const int c = this->Triangles[t].Points[i];
      const int d = this->Triangles[u].Points[IndexOf(this->Triangles[u].Neighbors, t)];
      if (this->Orientation(c, d, edge[0]) * this->Orientation(c, d, edge[1]) >= 0)
      {
        crossing.push_back(edge);
        continue;
      }
      this->Flip(t, i);
      if (c != a && c != b && d != a && d != b &&
        this->Orientation(a, b, c) * this->Orientation(a, b, d) < 0)
      {
        crossing.push_back(Sorted(c, d));
      }
    }
  }
  this->Fixed.insert(Sorted(a, b));
}

}
