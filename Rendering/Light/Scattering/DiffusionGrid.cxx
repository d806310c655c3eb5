// SPDX-License-Identifier: BSD-3-Clause
#include "Scattering/DiffusionGrid.h"

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>

namespace interlume
{

namespace
{

std::size_t Index(const glm::ivec3& cells, int i, int j, int k)
{
  return static_cast<std::size_t>(i) +
    static_cast<std::size_t>(cells.x) *
    (static_cast<std::size_t>(j) + static_cast<std::size_t>(cells.y) * static_cast<std::size_t>(k));
}

/// Calls \a work(k) for each layer of cells, in parallel if there are enough cells.
template <typename Work>
void ForLayers(const glm::ivec3& cells, Work&& work)
{
  const auto range = [&work](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType k = begin; k < end; ++k)
    {
      work(static_cast<int>(k));
    }
  };
  constexpr int minimumCells = 8192;
  if (cells.x * cells.y * cells.z < minimumCells)
  {
    range(0, cells.z);
    return;
  }
  vtkSMPTools::For(0, cells.z, 4, range);
}

/// Returns the dot product. It is summed per layer so that the result does not depend on the number
/// of threads.
double Product(const glm::ivec3& cells, const std::vector<double>& a, const std::vector<double>& b)
{
  std::vector<double> sums(static_cast<std::size_t>(cells.z));
  ForLayers(cells,
    [&](int k)
    {
      double sum = 0.0;
      const std::size_t end = Index(cells, 0, 0, k + 1);
      for (std::size_t i = Index(cells, 0, 0, k); i < end; ++i)
      {
        sum += a[i] * b[i];
      }
      sums[static_cast<std::size_t>(k)] = sum;
    });
  double sum = 0.0;
  for (const double layer : sums)
  {
    sum += layer;
  }
  return sum;
}

/// Sets \a a to s a + t b.
void Combine(
  const glm::ivec3& cells, double s, std::vector<double>& a, double t, const std::vector<double>& b)
{
  ForLayers(cells,
    [&](int k)
    {
      const std::size_t end = Index(cells, 0, 0, k + 1);
      for (std::size_t i = Index(cells, 0, 0, k); i < end; ++i)
      {
        a[i] = s * a[i] + t * b[i];
      }
    });
}

}

DiffusionGrid::DiffusionGrid(const glm::ivec3& cells)
  : Levels(1)
{
  Allocate(this->Levels.front(), cells);
}

void DiffusionGrid::Allocate(Level& level, const glm::ivec3& cells)
{
  const std::size_t number = Index(cells, 0, 0, cells.z);
  level.Cells = cells;
  for (std::vector<double>& coupling : level.Coupling)
  {
    coupling.assign(number, 0.0);
  }
  level.Sink.assign(number, 0.0);
  level.Inverse.assign(number, 0.0);
  level.Solution.assign(number, 0.0);
  level.Source.assign(number, 0.0);
}

void DiffusionGrid::Coarsen(const Level& fine, Level& coarse)
{
  const glm::ivec3 cells = fine.Cells;
  Allocate(coarse, (cells + 1) / 2);
  glm::ivec3 cell(0);
  for (cell.z = 0; cell.z < cells.z; ++cell.z)
  {
    for (cell.y = 0; cell.y < cells.y; ++cell.y)
    {
      for (cell.x = 0; cell.x < cells.x; ++cell.x)
      {
        const std::size_t from = Index(cells, cell.x, cell.y, cell.z);
        const std::size_t to = Index(coarse.Cells, cell.x / 2, cell.y / 2, cell.z / 2);
        coarse.Sink[to] += fine.Sink[from];
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          if (cell[static_cast<int>(axis)] % 2 == 1)
          {
            coarse.Coupling[axis][to] += 0.5 * fine.Coupling[axis][from];
          }
        }
      }
    }
  }
}

void DiffusionGrid::Prepare()
{
  this->Levels.resize(1);
  while (std::max({ this->Levels.back().Cells.x, this->Levels.back().Cells.y,
           this->Levels.back().Cells.z }) > 2)
  {
    Level coarse;
    Coarsen(this->Levels.back(), coarse);
    this->Levels.push_back(std::move(coarse));
  }
  for (Level& level : this->Levels)
  {
    const glm::ivec3 cells = level.Cells;
    const std::array<std::size_t, 3> stride = { { 1, static_cast<std::size_t>(cells.x),
      static_cast<std::size_t>(cells.x) * static_cast<std::size_t>(cells.y) } };
    std::vector<double> sum = level.Sink;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      for (std::size_t i = 0; i < sum.size(); ++i)
      {
        const double coupling = level.Coupling[axis][i];
        if (coupling > 0.0)
        {
          sum[i] += coupling;
          sum[i + stride[axis]] += coupling;
        }
      }
    }
    for (std::size_t i = 0; i < sum.size(); ++i)
    {
      level.Inverse[i] = sum[i] > 0.0 ? 1.0 / sum[i] : 0.0;
    }
  }
}

double DiffusionGrid::SumOverNeighbors(
  const Level& level, const std::vector<double>& x, int i, int j, int k)
{
  const glm::ivec3& cells = level.Cells;
  const std::size_t row = static_cast<std::size_t>(cells.x);
  const std::size_t layer = row * static_cast<std::size_t>(cells.y);
  const std::size_t at = Index(cells, i, j, k);
  double sum = 0.0;
  sum += i > 0 ? level.Coupling[0][at - 1] * x[at - 1] : 0.0;
  sum += i + 1 < cells.x ? level.Coupling[0][at] * x[at + 1] : 0.0;
  sum += j > 0 ? level.Coupling[1][at - row] * x[at - row] : 0.0;
  sum += j + 1 < cells.y ? level.Coupling[1][at] * x[at + row] : 0.0;
  sum += k > 0 ? level.Coupling[2][at - layer] * x[at - layer] : 0.0;
  sum += k + 1 < cells.z ? level.Coupling[2][at] * x[at + layer] : 0.0;
  return sum;
}

void DiffusionGrid::Smooth(Level& level, int color)
{
  const glm::ivec3& cells = level.Cells;
  ForLayers(cells,
    [&level, &cells, color](int k)
    {
      for (int j = 0; j < cells.y; ++j)
      {
        for (int i = (j + k + color) % 2; i < cells.x; i += 2)
        {
          const std::size_t at = Index(cells, i, j, k);
          level.Solution[at] = level.Inverse[at] *
            (level.Source[at] + SumOverNeighbors(level, level.Solution, i, j, k));
        }
      }
    });
}

void DiffusionGrid::Multiply(
  const Level& level, const std::vector<double>& x, std::vector<double>& y)
{
  const glm::ivec3& cells = level.Cells;
  ForLayers(cells,
    [&level, &cells, &x, &y](int k)
    {
      for (int j = 0; j < cells.y; ++j)
      {
        for (int i = 0; i < cells.x; ++i)
        {
          const std::size_t at = Index(cells, i, j, k);
          y[at] = level.Inverse[at] > 0.0
            ? x[at] / level.Inverse[at] - SumOverNeighbors(level, x, i, j, k)
            : 0.0;
        }
      }
    });
}

void DiffusionGrid::RunVCycle(std::size_t number)
{
  Level& level = this->Levels[number];
  std::fill(level.Solution.begin(), level.Solution.end(), 0.0);
  if (number + 1 == this->Levels.size())
  {
    // The coarsest level has at most eight cells, so smoothing solves it.
    for (int sweep = 0; sweep < 40; ++sweep)
    {
      Smooth(level, 0);
      Smooth(level, 1);
      Smooth(level, 1);
      Smooth(level, 0);
    }
    return;
  }
  Smooth(level, 0);
  Smooth(level, 1);
  Level& coarse = this->Levels[number + 1];
  std::fill(coarse.Source.begin(), coarse.Source.end(), 0.0);
  const glm::ivec3& cells = level.Cells;
  ForLayers(coarse.Cells,
    [&](int kk)
    {
      for (int k = 2 * kk; k < std::min(2 * kk + 2, cells.z); ++k)
      {
        for (int j = 0; j < cells.y; ++j)
        {
          for (int i = 0; i < cells.x; ++i)
          {
            const std::size_t at = Index(cells, i, j, k);
            // Cells of checkerboard color 1 were smoothed last and have a residual of 0.
            if ((i + j + k) % 2 == 0 && level.Inverse[at] > 0.0)
            {
              coarse.Source[Index(coarse.Cells, i / 2, j / 2, kk)] += level.Source[at] -
                level.Solution[at] / level.Inverse[at] +
                SumOverNeighbors(level, level.Solution, i, j, k);
            }
          }
        }
      }
    });
  this->RunVCycle(number + 1);
  ForLayers(cells,
    [&](int k)
    {
      for (int j = 0; j < cells.y; ++j)
      {
        for (int i = 0; i < cells.x; ++i)
        {
          level.Solution[Index(cells, i, j, k)] +=
            coarse.Solution[Index(coarse.Cells, i / 2, j / 2, k / 2)];
        }
      }
    });
  Smooth(level, 1);
  Smooth(level, 0);
}

double DiffusionGrid::Solve(const std::vector<double>& b, std::vector<double>& x, double tolerance,
  int maximumCycles, int& cycles)
{
  Level& fine = this->Levels.front();
  const glm::ivec3& cells = fine.Cells;
  cycles = 0;
  const double size = std::sqrt(Product(cells, b, b));
  if (!(size > 0.0))
  {
    std::fill(x.begin(), x.end(), 0.0);
    return 0.0;
  }
  std::vector<double> residual(b.size());
  std::vector<double> image(b.size());
  std::vector<double> direction(b.size(), 0.0);
  Multiply(fine, x, residual);
  Combine(cells, -1.0, residual, 1.0, b);
  double left = std::sqrt(Product(cells, residual, residual)) / size;
  double before = 0.0;
  while (left > tolerance && cycles < maximumCycles)
  {
    fine.Source = residual;
    this->RunVCycle(0);
    const double product = Product(cells, residual, fine.Solution);
    Combine(cells, before > 0.0 ? product / before : 0.0, direction, 1.0, fine.Solution);
    before = product;
    Multiply(fine, direction, image);
    const double curvature = Product(cells, direction, image);
    if (!(curvature > 0.0 && std::isfinite(curvature)))
    {
      break;
    }
    Combine(cells, 1.0, x, product / curvature, direction);
    Combine(cells, 1.0, residual, -product / curvature, image);
    left = std::sqrt(Product(cells, residual, residual)) / size;
    ++cycles;
  }
  return left;
}

}
