// SPDX-License-Identifier: BSD-3-Clause
#include "Topology/CellZeros.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace interlume
{

namespace
{
using Values = MultilinearCell::Values;

// Tolerances in parametric coordinates: maximum distance outside the cell, minimum uncertainty of a
// regular zero, and minimum uncertainty of a degenerate zero.
constexpr double Margin = 1e-9;
constexpr double Tolerance = 1e-7;
constexpr double DegenerateTolerance = 1e-5;
// Rounding error of a value relative to the largest value.
constexpr double Noise = 4e-15;
constexpr int MaximumLevel = 24;
constexpr std::size_t MaximumNumberOfBoxes = 512;

// Computes the inverse of a matrix after equilibrating its rows and columns. Returns false if it is
// singular.
bool Invert(const double matrix[9], double inverse[9])
{
  double scaled[3][3];
  double rows[3];
  double columns[3];
  for (int i = 0; i < 3; ++i)
  {
    rows[i] = vtkMath::Norm(matrix + 3 * i);
    if (!(rows[i] > 0.0))
    {
      return false;
    }
  }
  for (int j = 0; j < 3; ++j)
  {
    double column[3];
    for (int i = 0; i < 3; ++i)
    {
      column[i] = matrix[3 * i + j] / rows[i];
    }
    columns[j] = vtkMath::Norm(column);
    if (!(columns[j] > 0.0))
    {
      return false;
    }
    for (int i = 0; i < 3; ++i)
    {
      scaled[i][j] = column[i] / columns[j];
    }
  }
  if (!(std::abs(vtkMath::Determinant3x3(scaled)) > 1e-13))
  {
    return false;
  }
  double solution[3][3];
  vtkMath::Invert3x3(scaled, solution);
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      inverse[3 * i + j] = solution[i][j] / (columns[i] * rows[j]);
    }
  }
  return true;
}

void Multiply(const double matrix[9], const double x[3], double product[3])
{
  for (int i = 0; i < 3; ++i)
  {
    product[i] = vtkMath::Dot(matrix + 3 * i, x);
  }
}

// Returns the sum of the absolute values in a row.
double GetRowSum(const double matrix[9], int i)
{
  return std::abs(matrix[3 * i]) + std::abs(matrix[3 * i + 1]) + std::abs(matrix[3 * i + 2]);
}

// Returns whether a component with rounding error \a noise has the same sign at all corners.
bool HasOneSign(const Values& values, int component, double noise)
{
  double lower = values[0][component];
  double upper = lower;
  for (int corner = 1; corner < 8; ++corner)
  {
    lower = std::min(lower, values[corner][component]);
    upper = std::max(upper, values[corner][component]);
  }
  return lower > noise || upper < -noise;
}

// Returns an upper bound, over the cube, of the norm (largest absolute row sum) of the derivatives
// minus the identity.
double GetDistanceFromIdentity(const Values& values)
{
  double largest = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    double sum = 0.0;
    for (int j = 0; j < 3; ++j)
    {
      double entry = 0.0;
      for (int corner = 0; corner < 8; ++corner)
      {
        if (((corner >> j) & 1) == 0)
        {
          const double derivative = values[corner + (1 << j)][i] - values[corner][i];
          entry = std::max(entry, std::abs(derivative - (i == j ? 1.0 : 0.0)));
        }
      }
      sum += entry;
    }
    largest = std::max(largest, sum);
  }
  return largest;
}

double GetDistance(const double a[3], const double b[3])
{
  return std::max({ std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2]) });
}

constexpr double Center[3] = { 0.5, 0.5, 0.5 };
}

bool CellZeros::HasZeroEdge(const Values& values) const
{
  const int(*edges)[2] = nullptr;
  const int number = MultilinearCell::GetEdges(this->Shape, edges);
  const auto isZero = [&values](int corner)
  { return values[corner][0] == 0.0 && values[corner][1] == 0.0 && values[corner][2] == 0.0; };
  return std::any_of(edges, edges + number,
    [&isZero](const int* edge) { return isZero(edge[0]) && isZero(edge[1]); });
}

bool CellZeros::DecideByCorners(const Values& values, bool& isIsolated) const
{
  const int* corners = nullptr;
  const int number = MultilinearCell::GetCorners(this->Shape, corners);
  int vanishing = 0;
  for (int i = 0; i < 3; ++i)
  {
    const auto compare = [&values, i](int a, int b) { return values[a][i] < values[b][i]; };
    const auto range = std::minmax_element(corners, corners + number, compare);
    const double lower = values[*range.first][i];
    const double upper = values[*range.second][i];
    if (lower > 0.0 || upper < 0.0)
    {
      isIsolated = true;
      return true;
    }
    vanishing += lower == 0.0 && upper == 0.0 ? 1 : 0;
  }
  isIsolated = vanishing < 2 && !this->HasZeroEdge(values);
  return !isIsolated;
}

bool CellZeros::Find(MultilinearCell::Shapes shape, const Values& values, std::vector<Zero>& zeros)
{
  zeros.clear();
  this->Shape = shape;
  bool isIsolated = true;
  if (this->DecideByCorners(values, isIsolated))
  {
    return isIsolated;
  }
  for (int i = 0; i < 3; ++i)
  {
    double largest = 0.0;
    for (int corner = 0; corner < 8; ++corner)
    {
      largest = std::max(largest, std::abs(values[corner][i]));
    }
    for (int corner = 0; corner < 8; ++corner)
    {
      this->Normalized[corner][i] = largest > 0.0 ? values[corner][i] / largest : 0.0;
    }
  }
  // All parameters with p2 = 1 map to the apex of a pyramid.
  const double* apex = this->Normalized[4];
  if (shape == MultilinearCell::PYRAMID &&
    std::max({ std::abs(apex[0]), std::abs(apex[1]), std::abs(apex[2]) }) < 1e-13)
  {
    zeros.push_back({ { 0.5, 0.5, 1.0 }, Tolerance, false });
    return true;
  }

  double size = 1.0 + 2.0 * Margin;
  this->Boxes.assign(1, { { -Margin, -Margin, -Margin } });
  for (int level = 0; !this->Boxes.empty(); ++level)
  {
    this->Unresolved.clear();
    for (const Box& box : this->Boxes)
    {
      if (this->Examine(box, size, zeros) == SPLIT)
      {
        this->Unresolved.push_back(box);
      }
    }
    if (this->Unresolved.size() > MaximumNumberOfBoxes)
    {
      zeros.clear();
      return false;
    }
    if (level == MaximumLevel)
    {
      this->AddDegenerateZeros(size, zeros);
      break;
    }
    size *= 0.5;
    this->Boxes.clear();
    for (const Box& part : this->Unresolved)
    {
      for (int corner = 0; corner < 8; ++corner)
      {
        Box box = part;
        for (int j = 0; j < 3; ++j)
        {
          box.Lower[j] += (corner >> j) & 1 ? size : 0.0;
        }
        this->Boxes.push_back(box);
      }
    }
  }
  return true;
}

CellZeros::Findings CellZeros::Examine(const Box& box, double size, std::vector<Zero>& zeros) const
{
  // Skip boxes outside the slanted face of a wedge or a tetrahedron.
  if (MultilinearCell::GetExcess(this->Shape, box.Lower) > 2.0 * Margin)
  {
    return CLEAR;
  }
  Values corners;
  for (int corner = 0; corner < 8; ++corner)
  {
    double p[3];
    for (int j = 0; j < 3; ++j)
    {
      p[j] = box.Lower[j] + ((corner >> j) & 1 ? size : 0.0);
    }
    MultilinearCell::Interpolate(this->Normalized, p, corners[corner]);
  }
  for (int i = 0; i < 3; ++i)
  {
    if (HasOneSign(corners, i, Noise))
    {
      return CLEAR;
    }
  }
  double jacobian[9];
  double inverse[9];
  MultilinearCell::Derive(corners, Center, jacobian);
  if (!Invert(jacobian, inverse))
  {
    return SPLIT;
  }
  Values scaled;
  for (int corner = 0; corner < 8; ++corner)
  {
    Multiply(inverse, corners[corner], scaled[corner]);
  }
  double largestNoise = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double noise = Noise * GetRowSum(inverse, i);
    if (HasOneSign(scaled, i, noise))
    {
      return CLEAR;
    }
    largestNoise = std::max(largestNoise, noise);
  }
  if (largestNoise > 0.25 || GetDistanceFromIdentity(scaled) > 0.5)
  {
    return SPLIT;
  }
  this->Solve(box, size, scaled, zeros);
  return CLEAR;
}

void CellZeros::Solve(
  const Box& box, double size, const Values& scaled, std::vector<Zero>& zeros) const
{
  constexpr int maximumNumberOfSteps = 60;
  double position[3] = { 0.5, 0.5, 0.5 };
  for (int step = 0; step < maximumNumberOfSteps; ++step)
  {
    double correction[3];
    MultilinearCell::Interpolate(scaled, position, correction);
    const double before[3] = { position[0], position[1], position[2] };
    for (int j = 0; j < 3; ++j)
    {
      position[j] = std::max(0.0, std::min(position[j] - correction[j], 1.0));
    }
    if (GetDistance(before, position) < 1e-15)
    {
      break;
    }
  }
  // Newton's method refines the zero to full precision, and leaves the box if the zero is outside.
  Zero zero = { { 0.0, 0.0, 0.0 }, Tolerance, false };
  double* p = zero.Parameters;
  for (int j = 0; j < 3; ++j)
  {
    p[j] = box.Lower[j] + size * position[j];
  }
  double reach = Margin;
  for (int step = 0; step < 3; ++step)
  {
    double jacobian[9];
    double inverse[9];
    double value[3];
    double correction[3];
    MultilinearCell::Derive(this->Normalized, p, jacobian);
    if (!Invert(jacobian, inverse))
    {
      return;
    }
    MultilinearCell::Interpolate(this->Normalized, p, value);
    Multiply(inverse, value, correction);
    for (int j = 0; j < 3; ++j)
    {
      p[j] -= correction[j];
      const double noise = Noise * GetRowSum(inverse, j);
      reach = std::max(reach, 4.0 * noise);
      zero.Tolerance = std::max(zero.Tolerance, 1e3 * noise);
    }
  }
  for (int j = 0; j < 3; ++j)
  {
    if (!(p[j] >= box.Lower[j] - reach && p[j] <= box.Lower[j] + size + reach))
    {
      return;
    }
  }
  if (MultilinearCell::GetExcess(this->Shape, p) <= 2.0 * reach)
  {
    Add(zero, zeros);
  }
}

void CellZeros::Add(const Zero& zero, std::vector<Zero>& zeros)
{
  const auto isSame = [&zero](const Zero& other)
  {
    return GetDistance(zero.Parameters, other.Parameters) <=
      std::max(zero.Tolerance, other.Tolerance);
  };
  if (std::none_of(zeros.begin(), zeros.end(), isSame))
  {
    zeros.push_back(zero);
  }
}

void CellZeros::AddDegenerateZeros(double size, std::vector<Zero>& zeros) const
{
  struct Candidate
  {
    double Residual;
    Zero Location;
  };
  std::vector<Candidate> candidates;
  for (const Box& box : this->Unresolved)
  {
    Candidate candidate = { 0.0, { { 0.0, 0.0, 0.0 }, DegenerateTolerance, true } };
    for (int j = 0; j < 3; ++j)
    {
      candidate.Location.Parameters[j] = box.Lower[j] + 0.5 * size;
    }
    double value[3];
    MultilinearCell::Interpolate(this->Normalized, candidate.Location.Parameters, value);
    candidate.Residual = vtkMath::Norm(value);
    candidates.push_back(candidate);
  }
  std::stable_sort(candidates.begin(), candidates.end(),
    [](const Candidate& a, const Candidate& b) { return a.Residual < b.Residual; });
  for (const Candidate& candidate : candidates)
  {
    Add(candidate.Location, zeros);
  }
}

}
