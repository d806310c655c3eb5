#include "vtkHarmonicExtension.h"

#include "vtkLinearFit.h"
#include "vtkTetrahedra.h"
#include "vtkTetrahedronMath.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
/// The residual at which the iteration ends, in parts of the first one.
constexpr double Tolerance = 1e-12;
constexpr int MaximumNumberOfIterations = 5000;

/// The integrals of grad(i) . grad(j) over a tetrahedron, of its four linear basis functions.
std::array<std::array<double, 4>, 4> Stiffness(const std::array<const double*, 4>& x)
{
  using namespace vtkTetrahedronMath;
  // The outward area vector of the triangle opposite each point, times two.
  std::array<Vector, 4> areas;
  for (int i = 0; i < 4; ++i)
  {
    const double* a = x[(i + 1) % 4];
    const double* b = x[(i + 2) % 4];
    const double* c = x[(i + 3) % 4];
    areas[i] = Cross(Difference(b, a), Difference(c, a));
    if (i % 2 != 0)
    {
      areas[i] = { { -areas[i][0], -areas[i][1], -areas[i][2] } };
    }
  }
  const double determinant = Determinant(x[0], x[1], x[2], x[3]);
  std::array<std::array<double, 4>, 4> matrix;
  for (int i = 0; i < 4; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      matrix[i][j] = Dot(areas[i], areas[j]) / (6.0 * determinant);
    }
  }
  return matrix;
}

double Dot(const std::vector<double>& a, const std::vector<double>& b)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    sum += a[i] * b[i];
  }
  return sum;
}
}

vtkHarmonicExtension::vtkHarmonicExtension(const vtkTetrahedra& mesh)
  : Mesh(mesh)
  , Rows(mesh.Origins.size(), -1)
{
  for (std::size_t p = 0; p < mesh.Origins.size(); ++p)
  {
    if (mesh.Origins[p].NumberOfSources == 0)
    {
      this->Rows[p] = static_cast<vtkIdType>(this->Unknowns.size());
      this->Unknowns.push_back(static_cast<vtkIdType>(p));
    }
  }
  struct Entry
  {
    vtkIdType Row, Column;
    double Value;
  };
  std::vector<Entry> entries;
  for (std::size_t t = 0; t < mesh.Tetrahedra.size(); t += 4)
  {
    const vtkIdType* points = &mesh.Tetrahedra[t];
    if (std::all_of(points, points + 4, [this](vtkIdType p) { return this->Rows[p] < 0; }))
    {
      continue;
    }
    const auto matrix = Stiffness({ { &mesh.Points[3 * points[0]], &mesh.Points[3 * points[1]],
      &mesh.Points[3 * points[2]], &mesh.Points[3 * points[3]] } });
    for (int i = 0; i < 4; ++i)
    {
      for (int j = 0; this->Rows[points[i]] >= 0 && j < 4; ++j)
      {
        entries.push_back({ this->Rows[points[i]], points[j], matrix[i][j] });
      }
    }
  }
  std::stable_sort(entries.begin(), entries.end(),
    [](const Entry& a, const Entry& b)
    { return a.Row < b.Row || (a.Row == b.Row && a.Column < b.Column); });
  this->Starts.assign(this->Unknowns.size() + 1, 0);
  this->Diagonal.assign(this->Unknowns.size(), 0.0);
  for (std::size_t e = 0; e < entries.size(); ++e)
  {
    const Entry& entry = entries[e];
    if (e > 0 && entries[e - 1].Row == entry.Row && entries[e - 1].Column == entry.Column)
    {
      this->Entries.back() += entry.Value;
    }
    else
    {
      this->Columns.push_back(entry.Column);
      this->Entries.push_back(entry.Value);
    }
    this->Starts[entry.Row + 1] = static_cast<vtkIdType>(this->Entries.size());
    if (this->Unknowns[entry.Row] == entry.Column)
    {
      this->Diagonal[entry.Row] = this->Entries.back();
    }
  }
}

void vtkHarmonicExtension::Multiply(
  const std::vector<double>& x, std::vector<double>& product) const
{
  for (std::size_t row = 0; row < this->Unknowns.size(); ++row)
  {
    double sum = 0.0;
    for (vtkIdType e = this->Starts[row]; e < this->Starts[row + 1]; ++e)
    {
      const vtkIdType column = this->Rows[this->Columns[e]];
      sum += column >= 0 ? this->Entries[e] * x[column] : 0.0;
    }
    product[row] = sum;
  }
}

void vtkHarmonicExtension::Solve(const std::vector<double>& right, std::vector<double>& x) const
{
  const std::size_t n = right.size();
  std::vector<double> residual = right;
  std::vector<double> scaled(n);
  std::vector<double> product(n);
  const auto precondition = [&]()
  {
    for (std::size_t i = 0; i < n; ++i)
    {
      scaled[i] = residual[i] / this->Diagonal[i];
    }
  };
  precondition();
  std::vector<double> direction = scaled;
  double energy = Dot(residual, scaled);
  const double enough = Tolerance * Tolerance * energy;
  for (int i = 0; i < MaximumNumberOfIterations && energy > enough; ++i)
  {
    if (this->IsCancelled && this->IsCancelled())
    {
      return;
    }
    this->Multiply(direction, product);
    const double step = energy / Dot(direction, product);
    for (std::size_t k = 0; k < n; ++k)
    {
      x[k] += step * direction[k];
      residual[k] -= step * product[k];
    }
    precondition();
    const double next = Dot(residual, scaled);
    for (std::size_t k = 0; k < n; ++k)
    {
      direction[k] = scaled[k] + next / energy * direction[k];
    }
    energy = next;
  }
}

void vtkHarmonicExtension::Extend(std::vector<double>& values) const
{
  if (this->Unknowns.empty())
  {
    return;
  }
  const vtkLinearFit fit(this->Mesh, values);
  double lowest = VTK_DOUBLE_MAX;
  double highest = -VTK_DOUBLE_MAX;
  double largest = 0.0;
  std::vector<double> rest(values.size(), 0.0);
  for (std::size_t p = 0; p < values.size(); ++p)
  {
    if (this->Rows[p] < 0 && std::isfinite(values[p]))
    {
      lowest = std::min(lowest, values[p]);
      highest = std::max(highest, values[p]);
      rest[p] = values[p] - fit(&this->Mesh.Points[3 * p]);
      largest = std::max(largest, std::abs(rest[p]));
    }
  }
  // In parts of the largest, so that no product overflows.
  for (double& value : rest)
  {
    value = largest > 0.0 ? value / largest : 0.0;
  }
  std::vector<double> right(this->Unknowns.size(), 0.0);
  for (std::size_t row = 0; row < right.size(); ++row)
  {
    for (vtkIdType e = this->Starts[row]; e < this->Starts[row + 1]; ++e)
    {
      right[row] -= this->Entries[e] * rest[this->Columns[e]];
    }
  }
  std::vector<double> x(right.size(), 0.0);
  this->Solve(right, x);
  for (std::size_t row = 0; row < right.size(); ++row)
  {
    const vtkIdType p = this->Unknowns[row];
    const double value = largest * x[row] + fit(&this->Mesh.Points[3 * p]);
    values[p] = std::max(lowest, std::min(value, highest));
  }
}
