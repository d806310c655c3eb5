// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Tetrahedra/ReferenceTetrahedra.h"

#include "Support/Arrays/ReferenceIndices.h"

#include "vtkCellArray.h"
#include "vtkDelaunay3D.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace reference
{
namespace
{
using Point = std::array<double, 3>;

double GetVolume(const interlume::TetrahedraMesh& mesh, const std::uint32_t* corners)
{
  double e[3][3];
  for (const auto& [i, axis] : AllIndices(3, 3))
  {
    e[i][axis] = mesh.GetPoint(corners[i + 1])[axis] - mesh.GetPoint(corners[0])[axis];
  }
  return (e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) +
           e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2]) +
           e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0])) /
    6.0;
}

void AppendSix(interlume::TetrahedraMesh& mesh, const std::uint32_t* cube)
{
  int axes[3] = { 1, 2, 4 };
  do
  {
    int corner = 0;
    mesh.Corners.push_back(cube[0]);
    for (const int axis : axes)
    {
      corner += axis;
      mesh.Corners.push_back(cube[corner]);
    }
  } while (std::next_permutation(axes, axes + 3));
}

void AppendFive(interlume::TetrahedraMesh& mesh, const std::uint32_t* cube, bool isOdd)
{
  static constexpr int pieces[5][4] = { { 0, 1, 2, 4 }, { 3, 1, 2, 7 }, { 5, 1, 4, 7 },
    { 6, 2, 4, 7 }, { 1, 2, 4, 7 } };
  for (const auto& piece : pieces)
  {
    for (const int corner : piece)
    {
      mesh.Corners.push_back(cube[isOdd ? corner ^ 1 : corner]);
    }
  }
}
}

interlume::TetrahedraMesh MakeCubeMesh(const CubeMeshSettings& form)
{
  const int n = form.Cubes;
  interlume::TetrahedraMesh mesh;
  std::mt19937 random(form.Seed);
  std::uniform_real_distribution<double> shift(-form.Jitter / n, form.Jitter / n);
  for (int k = 0; k <= n; ++k)
  {
    for (int j = 0; j <= n; ++j)
    {
      for (int i = 0; i <= n; ++i)
      {
        const bool isInner =
          std::min({ i, j, k }) > 0 && std::max({ i, j, k }) < n && form.Jitter > 0.0;
        for (const int index : { i, j, k })
        {
          mesh.Points.push_back(
            -0.5 + static_cast<double>(index) / n + (isInner ? shift(random) : 0.0));
        }
      }
    }
  }
  for (const auto& [k, j, i] : AllIndices(n, n, n))
  {
    if (form.IsIn &&
      !form.IsIn({ { (i + 0.5) / n - 0.5, (j + 0.5) / n - 0.5, (k + 0.5) / n - 0.5 } }))
    {
      continue;
    }
    std::uint32_t cube[8];
    for (int corner = 0; corner < 8; ++corner)
    {
      cube[corner] =
        (i + (corner & 1)) + (n + 1) * ((j + (corner >> 1 & 1)) + (n + 1) * (k + (corner >> 2)));
    }
    if (form.Pieces == 5)
    {
      AppendFive(mesh, cube, (i + j + k) & 1);
    }
    else
    {
      AppendSix(mesh, cube);
    }
  }
  return mesh;
}

void Distort(interlume::TetrahedraMesh& mesh, double reach, int rounds, unsigned int seed)
{
  std::vector<std::vector<std::uint32_t>> users(mesh.Points.size() / 3);
  for (std::uint32_t i = 0; i < mesh.Corners.size(); ++i)
  {
    users[mesh.Corners[i]].push_back(i / 4);
  }
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-reach, reach);
  // Moved tetrahedra keep at least 1e-5 of the mean volume, so they may become thin but not
  // degenerate.
  const double minimumVolume = 1e-5 / std::max<std::uint32_t>(1, mesh.GetNumberOfTetrahedra());
  for (std::size_t move = 0; move < rounds * users.size(); ++move)
  {
    const std::size_t point = move % users.size();
    double* p = &mesh.Points[3 * point];
    const Point old = { { p[0], p[1], p[2] } };
    if (std::max({ std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) }) >= 0.5)
    {
      continue;
    }
    std::vector<double> volumes;
    for (const std::uint32_t t : users[point])
    {
      volumes.push_back(GetVolume(mesh, mesh.GetCorners(t)));
    }
    bool isValid = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      p[axis] += shift(random);
      isValid = isValid && std::abs(p[axis]) < 0.499;
    }
    for (std::size_t i = 0; i < volumes.size() && isValid; ++i)
    {
      const double volume = GetVolume(mesh, mesh.GetCorners(users[point][i]));
      isValid = std::abs(volume) > minimumVolume && (volume > 0.0) == (volumes[i] > 0.0);
    }
    if (!isValid)
    {
      std::copy(old.begin(), old.end(), p);
    }
  }
}

interlume::TetrahedraMesh MakeDelaunay(int points, unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-0.5, 0.5);
  vtkNew<vtkPoints> coordinates;
  coordinates->SetDataTypeToDouble();
  for (int i = 0; i < points; ++i)
  {
    const double x = uniform(random);
    const double y = uniform(random);
    coordinates->InsertNextPoint(x, y, uniform(random));
  }
  vtkNew<vtkPolyData> input;
  input->SetPoints(coordinates);
  vtkNew<vtkDelaunay3D> delaunay;
  delaunay->SetInputData(input);
  delaunay->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  delaunay->Update();

  interlume::TetrahedraMesh mesh;
  vtkUnstructuredGrid* grid = delaunay->GetOutput();
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    const double* p = grid->GetPoint(i);
    mesh.Points.insert(mesh.Points.end(), p, p + 3);
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    grid->GetCellPoints(cell, ids);
    for (vtkIdType i = 0; i < 4; ++i)
    {
      mesh.Corners.push_back(static_cast<std::uint32_t>(ids->GetId(i)));
    }
    if (std::abs(GetVolume(mesh, &mesh.Corners[mesh.Corners.size() - 4])) < 1e-14)
    {
      mesh.Corners.resize(mesh.Corners.size() - 4);
    }
  }
  return mesh;
}

interlume::TetrahedraMesh SeparateTetrahedra(const interlume::TetrahedraMesh& mesh)
{
  interlume::TetrahedraMesh separate;
  for (const std::uint32_t corner : mesh.Corners)
  {
    const double* p = mesh.GetPoint(corner);
    separate.Points.insert(separate.Points.end(), p, p + 3);
    separate.Corners.push_back(static_cast<std::uint32_t>(separate.Corners.size()));
  }
  return separate;
}

std::uint32_t Append(interlume::TetrahedraMesh& mesh, const std::array<Point, 4>& corners)
{
  for (const Point& corner : corners)
  {
    mesh.Corners.push_back(static_cast<std::uint32_t>(mesh.Points.size() / 3));
    mesh.Points.insert(mesh.Points.end(), corner.begin(), corner.end());
  }
  return mesh.GetNumberOfTetrahedra() - 1;
}

interlume::TetrahedraMesh Shuffle(const interlume::TetrahedraMesh& mesh, unsigned int seed)
{
  std::mt19937 random(seed);
  std::vector<std::uint32_t> sequence(mesh.GetNumberOfTetrahedra());
  std::iota(sequence.begin(), sequence.end(), 0);
  std::shuffle(sequence.begin(), sequence.end(), random);
  interlume::TetrahedraMesh shuffled;
  shuffled.Points = mesh.Points;
  for (const std::uint32_t t : sequence)
  {
    std::array<std::uint32_t, 4> corners;
    std::copy_n(mesh.GetCorners(t), 4, corners.begin());
    std::shuffle(corners.begin(), corners.end(), random);
    shuffled.Corners.insert(shuffled.Corners.end(), corners.begin(), corners.end());
  }
  return shuffled;
}

std::vector<Shape> GetShapes()
{
  const auto radius = [](double x, double y, double z) { return std::sqrt(x * x + y * y + z * z); };
  const auto torus = [](double x, double y, double z)
  { return std::hypot(std::hypot(x, y) - 0.26, z) < 0.12; };
  return {
    { "ball with holes",
      [=](const Point& p)
      {
        return radius(p[0], p[1], p[2]) < 0.48 && radius(p[0] - 0.12, p[1], p[2]) > 0.2 &&
          radius(p[0] + 0.3, p[1], p[2]) > 0.1;
      },
      { { 0.12, 0.01, 0.02 } } },
    { "L", [](const Point& p) { return p[0] < 0.0 || p[1] < 0.0; }, { { 0.31, 0.27, 0.02 } } },
    { "torus", [=](const Point& p) { return torus(p[0], p[1], p[2]); }, { { 0.02, 0.01, 0.03 } } },
    { "linked rings",
      [=](const Point& p)
      {
        return std::hypot(std::hypot(p[0] + 0.14, p[1]) - 0.24, p[2]) < 0.08 ||
          std::hypot(std::hypot(p[0] - 0.14, p[2]) - 0.24, p[1]) < 0.08;
      },
      { { 0.31, 0.27, 0.22 } } },
    { "nested shells",
      [=](const Point& p)
      {
        const double r = radius(p[0], p[1], p[2]);
        return (r > 0.38 && r < 0.49) || (r > 0.2 && r < 0.29) || r < 0.1;
      },
      { { 0.33, 0.01, 0.02 } } },
    { "blocks",
      [](const Point& p)
      {
        const auto isIn = [](double x) { return x - 0.25 * std::floor(x / 0.25) < 0.125; };
        return isIn(p[0]) && isIn(p[1]) && isIn(p[2]);
      },
      { { 0.19, 0.18, 0.2 } } },
  };
}

}
