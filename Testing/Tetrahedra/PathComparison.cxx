// SPDX-License-Identifier: BSD-3-Clause
#include "Tetrahedra/PathComparison.h"

#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Pictures/PictureSettings.h"
#include "Support/Pictures/ReferenceRay.h"
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
using Place = std::array<double, 2>;

constexpr double SoftwareBound = 1e-3;
constexpr double PathBound = 2.0 / 255.0;
/// In pixels. Corners are rounded to 1/256, and thin silhouettes are drawn wider by this.
constexpr double SilhouetteWidth = 1.0 / 64.0;
/// The lattice of the reference: an odd number, so that it meets every phase of a regular mesh.
constexpr int Stride = 7;

/// The largest difference of a channel of two pixels; infinite where one is no number.
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

double Cross(const Place& a, const Place& b, const Place& p)
{
  return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

double GetDistance(const Place& a, const Place& b, const Place& p)
{
  const double edge[2] = { b[0] - a[0], b[1] - a[1] };
  const double square = edge[0] * edge[0] + edge[1] * edge[1];
  const double along = edge[0] * (p[0] - a[0]) + edge[1] * (p[1] - a[1]);
  const double share = square > 0.0 ? std::clamp(along / square, 0.0, 1.0) : 0.0;
  return std::hypot(p[0] - a[0] - share * edge[0], p[1] - a[1] - share * edge[1]);
}

/// Where the tetrahedra of a grid are in a picture.
class Silhouettes
{
public:
  explicit Silhouettes(const PictureCase& what)
  {
    const PixelRays rays(what.Camera, what.Settings.Size);
    std::vector<Place> points;
    for (vtkIdType id = 0; id < what.Grid->GetNumberOfPoints(); ++id)
    {
      const double* x = what.Grid->GetPoint(id);
      const auto place = rays.Project({ x[0], x[1], x[2] });
      points.push_back(place ? *place : Place{ { -1e9, -1e9 } });
    }
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < what.Grid->GetNumberOfCells(); ++cell)
    {
      what.Grid->GetCellPoints(cell, ids);
      this->Corners.push_back({ { points[ids->GetId(0)], points[ids->GetId(1)],
        points[ids->GetId(2)], points[ids->GetId(3)] } });
    }
  }

  /// The distance of a pixel's centre from the nearest edge of a silhouette.
  double GetDistance(int i, int j) const
  {
    const Place pixel = { { i + 0.5, j + 0.5 } };
    double least = std::numeric_limits<double>::infinity();
    for (const std::array<Place, 4>& corners : this->Corners)
    {
      for (int a = 0; a < 4; ++a)
      {
        for (int b = 0; b < a; ++b)
        {
          least = std::min(least, GetDistance(corners, a, b, pixel));
        }
      }
    }
    return least;
  }

private:
  /// From the edge between corners a and b; infinite where it is within the silhouette.
  static double GetDistance(const std::array<Place, 4>& corners, int a, int b, const Place& pixel)
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
    // Seen edge-on a face's sides are rounding.
    const double size = std::hypot(corners[b][0] - corners[a][0], corners[b][1] - corners[a][1]);
    const double rounding = SilhouetteWidth * size;
    const bool isWithin = std::abs(sides[0]) > rounding && std::abs(sides[1]) > rounding &&
      (sides[0] > 0.0) != (sides[1] > 0.0);
    return isWithin ? std::numeric_limits<double>::infinity() : distance;
  }

  std::vector<std::array<Place, 4>> Corners;
};

std::string GetPlace(int i, int j)
{
  return " at " + std::to_string(i) + "," + std::to_string(j);
}

}

void ComparePaths(
  const PictureCase& what, const std::string& name, Check& check, double shareOfSilhouettePixels)
{
  const RgbaPicture software = DrawByPath(Mapper::SOFTWARE_PATH, what);
  const RgbaPicture openGL = DrawByPath(Mapper::OPENGL_PATH, what);
  const int width = what.Settings.Size[0];
  const int height = what.Settings.Size[1];
  PictureCase wanted = what;
  std::vector<std::array<int, 2>> apart;
  for (const auto& [j, i] : AllIndices(height, width))
  {
    const double distance = GetDistance(software.At(i, j), openGL.At(i, j));
    wanted.Settings.Wanted.push_back(
      distance > SoftwareBound || (i % Stride == 0 && j % Stride == 0));
    if (distance > PathBound)
    {
      apart.push_back({ { i, j } });
    }
  }
  check.That(LargestAlpha(openGL) > 0.1, name + ": something is seen");

  const RgbaPicture expected = DrawByReference(wanted);
  double error = 0.0;
  std::string place;
  for (const auto& [j, i] : AllIndices(height, width))
  {
    const double distance = wanted.Settings.Wanted[static_cast<std::size_t>(j) * width + i]
      ? GetDistance(software.At(i, j), expected.At(i, j))
      : 0.0;
    if (distance > error)
    {
      error = distance;
      place = GetPlace(i, j);
    }
  }
  check.Near(error, 0.0, SoftwareBound, name + ": software path" + place, 1.0);

  if (!apart.empty())
  {
    const Silhouettes shapes(what);
    // More are wrong anyway.
    const std::size_t most = std::min<std::size_t>(apart.size(), 200);
    for (std::size_t p = 0; p < most; ++p)
    {
      const double distance = shapes.GetDistance(apart[p][0], apart[p][1]);
      check.That(distance <= SilhouetteWidth,
        name + ": paths differ" + GetPlace(apart[p][0], apart[p][1]) + ", " +
          std::to_string(distance) + " pixels from a silhouette");
    }
  }
  const double all = static_cast<double>(width) * height;
  check.That(static_cast<double>(apart.size()) <= std::max(16.0, shareOfSilhouettePixels * all),
    name + ": paths differ in " + std::to_string(apart.size()) + " pixels");
  std::cout << name << ": software " << error << place << ", paths differ in " << apart.size()
            << " silhouette pixels\n";
}

void ComparePathsAlongAxes(
  PictureCase what, const std::string& name, Check& check, double shareOfSilhouettePixels)
{
  for (bool parallel : { false, true })
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      for (double sign : { -1.0, 1.0 })
      {
        Point3 direction = { { 0.0, 0.0, 0.0 } };
        direction[axis] = sign;
        what.Camera = LookAt(what.Grid, direction, parallel);
        ComparePaths(what,
          name + (parallel ? ", parallel, along " : ", perspective, along ") +
            (sign > 0.0 ? "+" : "-") + "xyz"[axis],
          check, shareOfSilhouettePixels);
      }
    }
  }
}

}
