// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceWalker_h
#define ReferenceWalker_h

#include "Support/Checks/LargestError.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Flow/ReferenceFlowGrid.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "Fields/FieldDispatch.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

/**
 * Checks for all types of cell walkers. They use only the public interface of a walker.
 */
namespace reference
{

/// Calls \a function with a cell walker for the field \a vectors on \a data. Errors fail the test.
template <typename Function>
void CallWithWalker(vtkDataSet* data, vtkDataArray* vectors, Check& check, Function&& function)
{
  const interlume::Error error = interlume::FieldDispatch::Execute(data, vectors, {}, function);
  check.That(!error, error.GetMessage());
}

template <typename Walker>
Vector PositionOf(const Walker& walker, const Vector& p)
{
  Vector x;
  walker.GetPosition(p.data(), x.data());
  return x;
}

/// Returns dx/dt at p.
template <typename Walker>
Vector VelocityOf(const Walker& walker, const Vector& p)
{
  Vector rate;
  Vector v;
  walker.GetVelocity(p.data(), rate.data());
  walker.GetWorldVector(p.data(), rate.data(), v.data());
  return v;
}

/// Returns whether p is in the cell, up to rounding error.
template <typename Walker>
bool IsInside(const Walker& walker, const Vector& p)
{
  for (int face = 0; face < walker.GetNumberOfFaces(); ++face)
  {
    if (walker.GetFaceDistance(face, p.data()) < -1e-15)
    {
      return false;
    }
  }
  return true;
}

/// Returns the largest component of |a - b| / scale.
template <std::size_t N>
double GetDifference(const std::array<double, N>& a, const std::array<double, N>& b, double scale)
{
  double worst = 0.0;
  for (std::size_t i = 0; i < N; ++i)
  {
    KeepLargest(worst, std::abs(a[i] - b[i]) / scale);
  }
  return worst;
}

template <std::size_t N>
double GetLargest(const std::array<double, N>& a)
{
  double largest = 0.0;
  for (const double one : a)
  {
    KeepLargest(largest, std::abs(one));
  }
  return largest;
}

/// Returns the largest absolute value of the bounds.
inline double GetExtent(vtkDataSet* data)
{
  std::array<double, 6> bounds;
  data->GetBounds(bounds.data());
  return GetLargest(bounds);
}

/// Compares cell id, position, velocity and gradient at random points of every cell with those of
/// VTK's cell classes. The points are also located from the cell of the point before. Set \a
/// hasGradient to false where VTK's gradient is not usable: in tiny cells, and in voxels of an
/// image with a direction matrix.
template <typename Walker>
void CheckLocations(Walker walker, vtkDataSet* data, vtkDataArray* vectors, int samples,
  double tolerance, Check& check, bool hasGradient = true)
{
  Random random(7);
  const double extent = GetExtent(data);
  double position = 0.0;
  double velocity = 0.0;
  double gradient = 0.0;
  int misplaced = 0;
  int notFound = 0;
  Walker second = walker;
  bool isInCell = false;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    for (int i = 0; i < samples; ++i)
    {
      const CellSample sample = SampleCell(data, vectors, cell, random, hasGradient);
      Vector p;
      if (!walker.Locate(sample.Position.data(), p.data()))
      {
        ++notFound;
        continue;
      }
      Vector q = p;
      isInCell = isInCell ? second.LocateNearby(sample.Position.data(), q.data())
                          : second.Locate(sample.Position.data(), q.data());
      KeepLargest(position, GetDifference(PositionOf(second, q), sample.Position, extent));
      misplaced += !isInCell || second.GetCell() != cell;
      misplaced += walker.GetCell() != cell || !IsInside(walker, p) || !walker.IsFinite();
      KeepLargest(position, GetDifference(PositionOf(walker, p), sample.Position, extent));
      KeepLargest(velocity, GetDifference(VelocityOf(walker, p), sample.Velocity, 1.0));
      std::array<double, 9> found;
      walker.GetVelocityGradient(p.data(), found.data());
      if (hasGradient)
      {
        KeepLargest(gradient, GetDifference(found, sample.Gradient, GetLargest(sample.Gradient)));
      }
    }
  }
  check.Equal(notFound, 0, "points of cells that are not found");
  check.Equal(misplaced, 0, "points found in another cell or outside");
  check.Near(position, 0.0, 1e-12, "position of a located point", 1.0);
  check.Near(velocity, 0.0, tolerance, "velocity equals VTK's", 1.0);
  if (hasGradient)
  {
    check.Near(gradient, 0.0, 100.0 * tolerance, "velocity gradient equals VTK's", 1.0);
  }
}

/// Compares GetJacobian(), GetWorldVector() and GetVelocityGradient() with finite differences in
/// local coordinates.
template <typename Walker>
void CheckDerivatives(
  Walker walker, vtkDataSet* data, vtkDataArray* vectors, double tolerance, Check& check)
{
  Random random(11);
  double rates = 0.0;
  double positions = 0.0;
  double gradients = 0.0;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    const CellSample sample = SampleCell(data, vectors, cell, random);
    Vector p;
    if (!check.That(walker.Locate(sample.Position.data(), p.data()), "the point is found"))
    {
      continue;
    }
    std::array<double, 9> jacobian;
    std::array<double, 9> gradient;
    walker.GetJacobian(p.data(), jacobian.data());
    walker.GetVelocityGradient(p.data(), gradient.data());
    const double scale = GetLargest(jacobian);
    for (int j = 0; j < 3; ++j)
    {
      constexpr double step = 1e-5;
      Vector before = p;
      Vector after = p;
      before[j] -= step;
      after[j] += step;
      Vector rateBefore;
      Vector rateAfter;
      walker.GetVelocity(before.data(), rateBefore.data());
      walker.GetVelocity(after.data(), rateAfter.data());
      const Vector moved = PositionOf(walker, after) - PositionOf(walker, before);
      const Vector changed = VelocityOf(walker, after) - VelocityOf(walker, before);
      Vector along{};
      along[j] = 2.0 * step;
      Vector world;
      walker.GetWorldVector(p.data(), along.data(), world.data());
      KeepLargest(positions, GetDifference(world, moved, GetLargest(moved)));
      for (int i = 0; i < 3; ++i)
      {
        const double expected = (rateAfter[i] - rateBefore[i]) / (2.0 * step);
        KeepLargest(rates, std::abs(jacobian[3 * i + j] - expected) / scale);
        const double product = vtkMath::Dot(&gradient[3 * i], moved.data());
        KeepLargest(
          gradients, std::abs(product - changed[i]) / (GetLargest(gradient) * GetLargest(moved)));
      }
    }
  }
  check.Near(rates, 0.0, tolerance, "the Jacobian equals finite differences", 1.0);
  check.Near(positions, 0.0, tolerance, "world vectors equal finite differences", 1.0);
  check.Near(gradients, 0.0, tolerance, "the velocity gradient equals finite differences", 1.0);
}

/// Checks that a walker reproduces the linear field GetLinearVector(x / unit) and its gradient.
template <typename Walker>
void CheckLinear(Walker walker, vtkDataSet* data, vtkDataArray* vectors, double unit,
  double tolerance, Check& check)
{
  Random random(13);
  double velocities = 0.0;
  double gradients = 0.0;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    const CellSample sample = SampleCell(data, vectors, cell, random);
    Vector p;
    if (!check.That(walker.Locate(sample.Position.data(), p.data()), "the point is found"))
    {
      continue;
    }
    const Vector expected = GetLinearVector((1.0 / unit) * sample.Position);
    KeepLargest(velocities, GetDifference(VelocityOf(walker, p), expected, GetLargest(expected)));
    std::array<double, 9> gradient;
    walker.GetVelocityGradient(p.data(), gradient.data());
    gradient *= unit;
    KeepLargest(gradients, GetDifference(gradient, GetLinearGradient(), 1.0));
  }
  check.Near(velocities, 0.0, tolerance, "a linear field is reproduced", 1.0);
  check.Near(gradients, 0.0, 1000.0 * tolerance, "the gradient of a linear field", 1.0);
}

/**
 * @class   LineWalk
 * @brief   moves a walker along a straight line from cell to cell
 *
 * In each cell, Newton's method finds the local coordinates of points on the line.
 */
template <typename Walker>
class LineWalk
{
public:
  LineWalk(Walker walker, const Vector& start, const Vector& direction)
    : Stand(walker)
    , Start(start)
    , Direction(direction)
  {
  }

  /// Returns false if the start is outside the grid or the walk stops making progress.
  bool Run(double maximumTime)
  {
    if (!this->Stand.Locate(this->Start.data(), this->P.data()))
    {
      return false;
    }
    this->Cells.push_back(this->Stand.GetCell());
    int idle = 0;
    while (this->Time < maximumTime)
    {
      const double before = this->Time;
      const int face = this->FindFace(maximumTime);
      if (face < 0)
      {
        return true;
      }
      const Vector here = PositionOf(this->Stand, this->P);
      Vector p = this->P;
      if (!this->Stand.Cross(face, p.data()))
      {
        this->EndFace = face;
        this->HasEnded = true;
        return true;
      }
      this->P = p;
      this->Cells.push_back(this->Stand.GetCell());
      KeepLargest(this->WorstJump, GetNorm(PositionOf(this->Stand, p) - here));
      idle = this->Time > before ? 0 : idle + 1;
      if (idle > 60)
      {
        return false;
      }
    }
    return true;
  }

  Walker Stand;
  Vector P{};
  double Time = 0.0;
  std::vector<vtkIdType> Cells;
  double WorstJump = 0.0;
  bool HasEnded = false;
  int EndFace = -1;

private:
  Vector GetTarget(double time) const { return this->Start + time * this->Direction; }

  // Converts a world vector x at p to a change of local coordinates.
  Vector GetLocalVector(const Vector& p, const Vector& x) const
  {
    Vector columns[3];
    for (int j = 0; j < 3; ++j)
    {
      Vector along{};
      along[j] = 1.0;
      this->Stand.GetWorldVector(p.data(), along.data(), columns[j].data());
    }
    const double volume = Det(columns[0], columns[1], columns[2]);
    return { { Det(x, columns[1], columns[2]) / volume, Det(columns[0], x, columns[2]) / volume,
      Det(columns[0], columns[1], x) / volume } };
  }

  static double Det(const Vector& a, const Vector& b, const Vector& c)
  {
    return Dot(a, Cross(b, c));
  }

  Vector FindLocalPoint(double time, Vector p) const
  {
    for (int i = 0; i < 6; ++i)
    {
      const Vector step =
        this->GetLocalVector(p, this->GetTarget(time) - PositionOf(this->Stand, p));
      p += step;
      if (GetLargest(step) < 1e-15)
      {
        break;
      }
    }
    return p;
  }

  // Advances to the point where the line leaves the cell. Returns the face, or -1 if the line ends
  // first.
  int FindFace(double maximumTime)
  {
    constexpr double onFace = 1e-12;
    const Vector rate = this->GetLocalVector(this->P, this->Direction);
    const double largest = GetLargest(rate);
    for (int face = 0; face < this->Stand.GetNumberOfFaces(); ++face)
    {
      const Vector ahead = this->P + (1e-3 / largest) * rate;
      const double here = this->Stand.GetFaceDistance(face, this->P.data());
      if (here <= onFace && this->Stand.GetFaceDistance(face, ahead.data()) < here - 1e-9)
      {
        return face;
      }
    }
    while (this->Time < maximumTime)
    {
      const double step = 0.1 / GetLargest(this->GetLocalVector(this->P, this->Direction));
      const Vector next = this->FindLocalPoint(this->Time + step, this->P);
      double first = this->Time + step;
      Vector position = next;
      int exit = -1;
      for (int face = 0; face < this->Stand.GetNumberOfFaces(); ++face)
      {
        if (this->Stand.GetFaceDistance(face, next.data()) < -onFace)
        {
          double low = this->Time;
          double high = this->Time + step;
          for (int i = 0; i < 60; ++i)
          {
            const double midpoint = 0.5 * (low + high);
            const Vector p = this->FindLocalPoint(midpoint, this->P);
            (this->Stand.GetFaceDistance(face, p.data()) < 0.0 ? high : low) = midpoint;
          }
          if (exit < 0 || low < first)
          {
            first = low;
            exit = face;
            position = this->FindLocalPoint(low, this->P);
          }
        }
      }
      this->Time = first;
      this->P = position;
      if (exit >= 0)
      {
        return exit;
      }
    }
    return -1;
  }

  Vector Start;
  Vector Direction;
};

/// Returns the time at which a line leaves a box.
inline double GetExitTime(const double bounds[6], const Vector& start, const Vector& direction)
{
  double time = VTK_DOUBLE_MAX;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (direction[axis] != 0.0)
    {
      const double bound = bounds[2 * axis + (direction[axis] > 0.0 ? 1 : 0)];
      time = std::min(time, (bound - start[axis]) / direction[axis]);
    }
  }
  return time;
}

/// Walks along a line through a grid that fills its bounding box. Checks that the walk ends where
/// the line leaves the box, and that the position does not jump at cell faces.
template <typename Walker>
void CheckLine(Walker walker, vtkDataSet* data, const Vector& start, const Vector& direction,
  double cellSize, Check& check)
{
  double bounds[6];
  data->GetBounds(bounds);
  const double extent = GetExtent(data);
  const double exit = GetExitTime(bounds, start, direction);
  LineWalk<Walker> walk(walker, start, direction);
  check.That(walk.Run(2.0 * exit), "the walk ends");
  check.That(walk.HasEnded, "the walk reaches the boundary of the grid");
  check.Near(walk.Time, exit, 1e-10, "time at which the line leaves the grid");
  check.Near(walk.WorstJump, 0.0, 1e-12 * cellSize + 1e-15 * extent, "jump across a face", 1.0);
  check.That(std::adjacent_find(walk.Cells.begin(), walk.Cells.end()) == walk.Cells.end(),
    "each face crossing leads to another cell");
}

template <typename Walker>
void CheckLines(Walker walker, vtkDataSet* data, int lines, double cellSize, Check& check)
{
  Random random(17);
  double bounds[6];
  data->GetBounds(bounds);
  for (int line = 0; line < lines; ++line)
  {
    Vector start;
    Vector direction = random.GetDirection();
    for (int axis = 0; axis < 3; ++axis)
    {
      const double width = bounds[2 * axis + 1] - bounds[2 * axis];
      start[axis] = bounds[2 * axis] + random.Get(0.01, 0.99) * width;
      direction[axis] *= width;
    }
    CheckLine(walker, data, start, direction, cellSize, check);
  }
}

/// Checks that every grid point is found at its position, and that a copy of the walker finds it in
/// the same cell.
template <typename Walker>
void CheckPoints(Walker walker, vtkDataSet* data, Check& check)
{
  double bounds[6];
  data->GetBounds(bounds);
  const double extent = GetExtent(data);
  Walker other = walker;
  Random random(19);
  for (vtkIdType point = 0; point < data->GetNumberOfPoints(); ++point)
  {
    Vector x;
    data->GetPoint(point, x.data());
    Vector p;
    Vector again;
    if (!check.That(walker.Locate(x.data(), p.data()), "a point of the grid is found"))
    {
      continue;
    }
    check.That(IsInside(walker, p), "the local coordinates of a grid point are in the cell");
    check.Near(
      GetDifference(PositionOf(walker, p), x, extent), 0.0, 1e-12, "position of a grid point", 1.0);
    Vector otherPoint;
    data->GetPoint(static_cast<vtkIdType>(random.Get(0.0, 0.999) * data->GetNumberOfPoints()),
      otherPoint.data());
    other.Locate(otherPoint.data(), again.data());
    check.That(
      other.Locate(x.data(), again.data()) && other.GetCell() == walker.GetCell() && again == p,
      "a grid point is always found in the same cell");
    // A point on the boundary of the grid must be found despite rounding.
    Vector rounded = x;
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool isUpper = 2.0 * x[axis] > bounds[2 * axis] + bounds[2 * axis + 1];
      rounded[axis] += (isUpper ? 2.0 : -2.0) * DBL_EPSILON * std::abs(x[axis]);
    }
    check.That(other.Locate(rounded.data(), again.data()), "a point rounded outward is found");
    check.Near(GetDifference(PositionOf(other, again), x, extent), 0.0, 1e-12,
      "position of a point rounded outward", 1.0);
  }
}

/// Adds the linear field GetLinearVector(x / unit) to \a data and calls CheckLinear().
inline void CheckLinearField(vtkDataSet* data, double unit, double tolerance, Check& check)
{
  auto linear =
    AddVectors(data, [unit](const Vector& x) { return GetLinearVector((1.0 / unit) * x); });
  CallWithWalker(data, linear, check,
    [&](const auto& walker) { CheckLinear(walker, data, linear, unit, tolerance, check); });
}

/// Checks lines through corners and edges and along faces of a grid of 4 x 4 x 4 unit cubes. \a
/// name is the start of the context of each check.
inline void CheckCornerLines(const std::string& name, vtkDataSet* data, Check& check)
{
  const Vector lines[][2] = { { { { 0.5, 0.5, 0.5 } }, { { 1, 1, 1 } } },
    { { { 3.5, 0.5, 2.5 } }, { { -1, 1, -1 } } }, { { { 0.5, 0.5, 2 } }, { { 1, 1, 0 } } },
    { { { 0.25, 3, 2 } }, { { 1, 0, 0 } } }, { { { 0.25, 2.5, 1.5 } }, { { 1, 0, 0 } } } };
  auto vectors = AddRandomVectors(data, 5);
  CallWithWalker(data, vectors, check,
    [&](const auto& walker)
    {
      for (const auto& line : lines)
      {
        check.SetContext(name + "line from " + std::to_string(line[0][0]));
        CheckLine(walker, data, line[0], line[1], 1.0, check);
      }
    });
}

/// Hides the cells with i = 2 in a grid of 4 x 3 x 3 cells, except the center cell of this layer,
/// which becomes a duplicate cell, as if another piece owned it.
inline void HideLayer(vtkUnsignedCharArray* ghosts)
{
  for (vtkIdType cell = 0; cell < ghosts->GetNumberOfTuples(); ++cell)
  {
    ghosts->SetValue(cell, cell % 4 == 2 ? vtkDataSetAttributes::HIDDENCELL : 0);
  }
  ghosts->SetValue(2 + 4 * (1 + 3 * 1), vtkDataSetAttributes::DUPLICATECELL);
}

/// Checks the walker at the hidden and duplicate cells of HideLayer(). Returns the walk that stops
/// at a hidden cell.
template <typename Walker>
LineWalk<Walker> CheckHiddenLayer(Walker walker, Check& check)
{
  Vector p;
  const Vector hidden = { { 2.5, 0.5, 0.5 } };
  check.That(!walker.Locate(hidden.data(), p.data()), "a hidden cell is not found");
  const Vector edge = { { 2.0, 0.5, 0.5 } };
  check.That(walker.Locate(edge.data(), p.data()) && walker.GetCell() == 1 && p[0] == 1.0,
    "a point on a hidden cell's face is found in the neighbor");
  LineWalk<Walker> through(walker, { { 0.5, 1.5, 1.5 } }, { { 1, 0, 0 } });
  check.That(through.Run(10.0) && through.HasEnded, "a line passes through a duplicate cell");
  check.Near(through.Time, 3.5, 1e-12, "the time at which the line reaches the boundary");
  LineWalk<Walker> stopped(walker, { { 0.5, 0.5, 0.5 } }, { { 1, 0, 0 } });
  check.That(stopped.Run(10.0) && stopped.HasEnded, "a line stops at a hidden cell");
  check.Near(stopped.Time, 1.5, 1e-12, "the time at which the line reaches the hidden cell");
  return stopped;
}

}

#endif
