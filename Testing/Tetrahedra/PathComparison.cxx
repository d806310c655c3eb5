// SPDX-License-Identifier: BSD-3-Clause
#include "Tetrahedra/PathComparison.h"

#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Images/CameraSettings.h"
#include "Support/Images/ReferenceRay.h"
#include "Support/Images/VolumeStage.h"
#include "Support/Checks/ReferenceCheck.h"

#include "vtkCamera.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <vector>

namespace reference
{

namespace
{

using Mapper = vtkTimeWeightedTetrahedraMapper;
using Position = std::array<double, 2>;

constexpr double SoftwareBound = 1e-3;
constexpr double PathBound = 2.0 / 255.0;
/// Maximum distance in pixels from a silhouette edge to the center of a pixel in which the paths
/// may differ. OpenGL rounds corners to 1/256 pixel and widens thin silhouettes by up to this
/// distance.
constexpr double SilhouetteWidth = 1.0 / 64.0;
/// The reference computes every seventh pixel along each axis. The stride is odd so that the pixels
/// are not always at the same position in the cells of a regular mesh.
constexpr int Stride = 7;

/// Returns the largest channel difference of two pixels, or infinity if any is not finite.
double GetDistance(const double* a, const double* b)
{
  double largest = 0.0;
  for (int channel = 0; channel < 4; ++channel)
  {
    const double distance = std::abs(a[channel] - b[channel]);
    largest = std::isfinite(distance) ? std::max(largest, distance)
                                      : std::numeric_limits<double>::infinity();
  }
  return largest;
}

double Cross(const Position& a, const Position& b, const Position& p)
{
  return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

double GetDistance(const Position& a, const Position& b, const Position& p)
{
  const double edge[2] = { b[0] - a[0], b[1] - a[1] };
  const double square = edge[0] * edge[0] + edge[1] * edge[1];
  const double along = edge[0] * (p[0] - a[0]) + edge[1] * (p[1] - a[1]);
  const double fraction = square > 0.0 ? std::clamp(along / square, 0.0, 1.0) : 0.0;
  return std::hypot(p[0] - a[0] - fraction * edge[0], p[1] - a[1] - fraction * edge[1]);
}

/// The silhouettes of a grid's tetrahedra in an image.
class Silhouettes
{
public:
  explicit Silhouettes(const ImageCase& what)
  {
    const PixelRays rays(what.Camera, what.Settings.Size);
    std::vector<Position> points;
    for (vtkIdType id = 0; id < what.Grid->GetNumberOfPoints(); ++id)
    {
      const double* x = what.Grid->GetPoint(id);
      const auto position = rays.Project({ x[0], x[1], x[2] });
      points.push_back(position ? *position : Position{ { -1e9, -1e9 } });
    }
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < what.Grid->GetNumberOfCells(); ++cell)
    {
      what.Grid->GetCellPoints(cell, ids);
      this->Corners.push_back({ { points[ids->GetId(0)], points[ids->GetId(1)],
        points[ids->GetId(2)], points[ids->GetId(3)] } });
    }
  }

  /// Returns the distance in pixels between a pixel's center and the closest silhouette edge.
  double GetDistance(int i, int j) const
  {
    const Position pixel = { { i + 0.5, j + 0.5 } };
    double smallest = std::numeric_limits<double>::infinity();
    for (const std::array<Position, 4>& corners : this->Corners)
    {
      for (int a = 0; a < 4; ++a)
      {
        for (int b = 0; b < a; ++b)
        {
          smallest = std::min(smallest, GetDistance(corners, a, b, pixel));
        }
      }
    }
    return smallest;
  }

private:
  /// Returns the distance from \a pixel to the edge between corners a and b. Returns infinity if
  /// the edge is close but lies inside the silhouette.
  static double GetDistance(
    const std::array<Position, 4>& corners, int a, int b, const Position& pixel)
  {
    const double distance = reference::GetDistance(corners[a], corners[b], pixel);
    if (distance > SilhouetteWidth)
    {
      return distance;
    }
    double sides[2];
    int side = 0;
    for (int k = 0; k < 4; ++k)
    {
      if (k != a && k != b)
      {
        sides[side++] = Cross(corners[a], corners[b], corners[k]);
      }
    }
    // The edge is inside if the other two corners are on different sides of it. If a face is seen
    // edge-on, rounding errors decide the side, so the edge counts as part of the silhouette.
    const double size = std::hypot(corners[b][0] - corners[a][0], corners[b][1] - corners[a][1]);
    const double rounding = SilhouetteWidth * size;
    const bool isWithin = std::abs(sides[0]) > rounding && std::abs(sides[1]) > rounding &&
      (sides[0] > 0.0) != (sides[1] > 0.0);
    return isWithin ? std::numeric_limits<double>::infinity() : distance;
  }

  std::vector<std::array<Position, 4>> Corners;
};

std::string FormatPixel(int i, int j)
{
  return " at " + std::to_string(i) + "," + std::to_string(j);
}

void Compare(VolumeStage& stage, const ImageCase& what, const std::string& name, Check& check,
  double silhouetteFraction)
{
  const RgbaImage software = DrawByPath(Mapper::SOFTWARE_PATH, what, stage);
  const RgbaImage openGL = DrawByPath(Mapper::OPENGL_PATH, what, stage);
  const int width = what.Settings.Size[0];
  const int height = what.Settings.Size[1];
  ImageCase sampled = what;
  std::vector<std::array<int, 2>> different;
  for (const auto& [j, i] : AllIndices(height, width))
  {
    const double distance = GetDistance(software.At(i, j), openGL.At(i, j));
    sampled.Settings.Wanted.push_back(
      distance > SoftwareBound || (i % Stride == 0 && j % Stride == 0));
    if (distance > PathBound)
    {
      different.push_back({ { i, j } });
    }
  }
  check.That(LargestAlpha(openGL) > 0.1, name + ": the volume is visible");

  const RgbaImage expected = DrawReference(sampled);
  double error = 0.0;
  std::string position;
  for (const auto& [j, i] : AllIndices(height, width))
  {
    const double distance = sampled.Settings.Wanted[static_cast<std::size_t>(j) * width + i]
      ? GetDistance(software.At(i, j), expected.At(i, j))
      : 0.0;
    if (distance > error)
    {
      error = distance;
      position = FormatPixel(i, j);
    }
  }
  check.Near(error, 0.0, SoftwareBound, name + ": software path" + position, 1.0);

  if (!different.empty())
  {
    const Silhouettes shapes(what);
    // If more pixels differ, the test below fails anyway.
    const std::size_t count = std::min<std::size_t>(different.size(), 200);
    for (std::size_t p = 0; p < count; ++p)
    {
      const double distance = shapes.GetDistance(different[p][0], different[p][1]);
      check.That(distance <= SilhouetteWidth,
        name + ": paths differ" + FormatPixel(different[p][0], different[p][1]) + ", " +
          std::to_string(distance) + " pixels from a silhouette edge");
    }
  }
  const double all = static_cast<double>(width) * height;
  check.That(static_cast<double>(different.size()) <= std::max(16.0, silhouetteFraction * all),
    name + ": paths differ in " + std::to_string(different.size()) + " pixels");
  std::cout << name << ": software " << error << position << ", paths differ in "
            << different.size() << " silhouette pixels\n";
}

}

void CompareRenderPaths(
  const ImageCase& what, const std::string& name, Check& check, double silhouetteFraction)
{
  VolumeStage stage(what.Settings.Size);
  Compare(stage, what, name, check, silhouetteFraction);
}

void CompareRenderPathsAlongAxes(
  ImageCase what, const std::string& name, Check& check, double silhouetteFraction)
{
  VolumeStage stage(what.Settings.Size);
  for (bool parallel : { false, true })
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      for (double sign : { -1.0, 1.0 })
      {
        Point3 direction = { { 0.0, 0.0, 0.0 } };
        direction[axis] = sign;
        what.Camera = LookAt(what.Grid, direction, parallel);
        Compare(stage, what,
          name + (parallel ? ", parallel, along " : ", perspective, along ") +
            (sign > 0.0 ? "+" : "-") + "xyz"[axis],
          check, silhouetteFraction);
      }
    }
  }
}

}
