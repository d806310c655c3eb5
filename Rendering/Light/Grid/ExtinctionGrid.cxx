// SPDX-License-Identifier: BSD-3-Clause
#include "Grid/ExtinctionGrid.h"

#include "Grid/ExtinctionSampler.h"
#include "Plan/ClipRegion.h"
#include "Space/BoxCorners.h"
#include "Space/UnitSpace.h"
#include "Space/UnitVector.h"
#include "Volume/MaterialTable.h"
#include "Volume/VolumeBlocks.h"
#include "Volume/VolumeSamples.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace interlume
{

namespace
{
// Maximum number of samples in all cells together, and along each axis of a single cell.
constexpr double MaximumSamples = 4e6;
constexpr int MaximumSteps = 8;

using Box = std::array<std::array<double, 2>, 3>;

// Finds the bounding box of the visible blocks, clipped to the box of the clip region, in texture
// coordinates. Returns false if no block is visible.
bool FindBox(const ExtinctionGrid::Volume& volume, Box& box)
{
  const std::array<int, 3>& size = volume.Blocks.GetSize();
  std::array<std::array<int, 2>, 3> seen{};
  seen.fill({ { std::numeric_limits<int>::max(), -1 } });
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        const std::array<int, 3> at{ { i, j, k } };
        for (std::size_t axis = 0; axis < 3 && volume.Blocks.IsVisible(i, j, k); ++axis)
        {
          seen[axis][0] = std::min(seen[axis][0], at[axis]);
          seen[axis][1] = std::max(seen[axis][1], at[axis]);
        }
      }
    }
  }
  box = volume.Region.Box;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (seen[axis][1] < 0)
    {
      return false;
    }
    // The outermost blocks extend to the boundary of the medium.
    const std::vector<double> borders = volume.Blocks.GetBorders(static_cast<int>(axis));
    if (seen[axis][0] > 0)
    {
      box[axis][0] = std::max(box[axis][0], borders[static_cast<std::size_t>(seen[axis][0])]);
    }
    if (seen[axis][1] + 1 < size[axis])
    {
      box[axis][1] = std::min(box[axis][1], borders[static_cast<std::size_t>(seen[axis][1]) + 1]);
    }
    if (!(box[axis][1] > box[axis][0]))
    {
      return false;
    }
  }
  return true;
}

// Returns the directions of the edges of a volume's box, or the world axes if the edges are not
// orthogonal.
glm::dmat3 FindAxes(const ExtinctionGrid::Volume& volume)
{
  constexpr double tolerance = 1e-6;
  glm::dmat3 axes;
  bool isOrthogonal = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    const glm::dvec3 edge(volume.Space.UnitFromTexture[axis]);
    axes[axis] = edge / Vectors::SafeLength(edge);
    for (int other = 0; other < axis; ++other)
    {
      isOrthogonal = isOrthogonal && std::abs(glm::dot(axes[axis], axes[other])) < tolerance;
    }
  }
  return isOrthogonal ? axes : glm::dmat3(1.0);
}

glm::dmat3 FindAxes(const std::vector<const ExtinctionGrid::Volume*>& volumes)
{
  constexpr double parallel = 1.0 - 1e-9;
  const glm::dmat3 axes = FindAxes(*volumes[0]);
  for (const ExtinctionGrid::Volume* volume : volumes)
  {
    const glm::dmat3 others = FindAxes(*volume);
    for (int axis = 0; axis < 3; ++axis)
    {
      if (std::abs(glm::dot(axes[axis], others[axis])) < parallel)
      {
        return glm::dmat3(1.0);
      }
    }
  }
  return axes;
}
}

bool ExtinctionGrid::SetBox(const std::vector<Volume>& volumes)
{
  std::vector<Box> boxes;
  std::vector<const Volume*> seen;
  for (const Volume& volume : volumes)
  {
    Box box;
    if (volume.Scatters && FindBox(volume, box))
    {
      boxes.push_back(box);
      seen.push_back(&volume);
    }
  }
  if (seen.empty())
  {
    return false;
  }
  this->Axes = FindAxes(seen);
  glm::dvec3 lower(std::numeric_limits<double>::max());
  glm::dvec3 upper(-std::numeric_limits<double>::max());
  // Shortest voxel edge of all volumes, which determines the number of samples per cell, and
  // shortest cell edge that any of the volumes would have alone.
  double finest = std::numeric_limits<double>::max();
  double smallest = finest;
  // Maximum number of cells along the longest edge.
  double along = seen.size() > 1 ? MaximumSharedCells : 0.0;
  for (std::size_t i = 0; i < seen.size(); ++i)
  {
    glm::dvec3 first(std::numeric_limits<double>::max());
    glm::dvec3 last(-std::numeric_limits<double>::max());
    const BoxCorners corners(seen[i]->Space, boxes[i]);
    for (const glm::dvec3& corner : corners.Get())
    {
      first = glm::min(first, corner * this->Axes);
      last = glm::max(last, corner * this->Axes);
    }
    lower = glm::min(lower, first);
    upper = glm::max(upper, last);
    const double longest = Vectors::InfinityNorm(last - first);
    double voxel = longest;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double edge = Vectors::SafeLength(glm::dvec3(seen[i]->Space.UnitFromTexture[axis]));
      voxel = std::min(voxel, edge / seen[i]->Samples.Size[axis]);
    }
    finest = std::min(finest, voxel);
    const double maximum = std::max(std::ceil(longest / voxel - 1e-6), 1.0);
    const double cells = std::min(static_cast<double>(seen[i]->Cells), maximum);
    smallest = std::min(smallest, longest / cells);
    along = std::max(along, cells);
  }
  const glm::dvec3 extent = upper - lower;
  const double longest = Vectors::InfinityNorm(extent);
  along = seen.size() > 1 ? std::min(along, longest / smallest) : along;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double edge = std::max(extent[axis], 0.5 * longest / along);
    const double count = std::max(std::round(edge / longest * along), 1.0);
    this->Medium.Cells[axis] = static_cast<int>(count);
    this->Medium.CellSize[axis] = edge / count;
    lower[axis] -= 0.5 * (edge - extent[axis]);
  }
  this->Origin = this->Axes * lower;
  const double samples =
    std::cbrt(MaximumSamples / static_cast<double>(this->Medium.GetNumberOfCells()));
  const double steps = std::clamp(std::floor(samples), 2.0, static_cast<double>(MaximumSteps));
  for (int axis = 0; axis < 3; ++axis)
  {
    const double required = std::ceil(this->Medium.CellSize[axis] / finest - 1e-6);
    this->Steps[axis] = static_cast<int>(std::clamp(required, 2.0, steps));
  }
  return true;
}

glm::ivec3 ExtinctionGrid::GetCell(std::size_t index) const
{
  const auto columns = static_cast<std::size_t>(this->Medium.Cells.x);
  const auto rows = static_cast<std::size_t>(this->Medium.Cells.y);
  return { static_cast<int>(index % columns), static_cast<int>(index / columns % rows),
    static_cast<int>(index / columns / rows) };
}

bool ExtinctionGrid::Build(const std::vector<Volume>& volumes)
{
  this->ColorFractions.clear();
  this->Medium = ScatteringMedium();
  if (!this->SetBox(volumes))
  {
    return false;
  }
  const std::size_t number = this->Medium.GetNumberOfCells();
  this->Medium.Extinction.assign(number, 0.0F);
  this->Medium.Albedo.assign(number, glm::vec3(0.0F));
  const bool isColored = std::any_of(volumes.begin(), volumes.end(),
    [](const Volume& volume) { return !volume.Material.Transmission.empty(); });
  this->ColorFractions.assign(isColored ? number : 0, glm::vec3(1.0F));
  const std::vector<ExtinctionSampler> samplers(volumes.begin(), volumes.end());
  const double samples = this->Steps.x * this->Steps.y * this->Steps.z;
  vtkSMPTools::For(0, static_cast<vtkIdType>(number),
    [&](vtkIdType first, vtkIdType last)
    {
      for (auto cell = static_cast<std::size_t>(first); cell < static_cast<std::size_t>(last);
           ++cell)
      {
        const glm::ivec3 at = this->GetCell(cell);
        double extinction = 0.0;
        glm::dvec3 taken(0.0);
        glm::dvec3 scattered(0.0);
        glm::ivec3 step;
        for (step.z = 0; step.z < this->Steps.z; ++step.z)
        {
          for (step.y = 0; step.y < this->Steps.y; ++step.y)
          {
            for (step.x = 0; step.x < this->Steps.x; ++step.x)
            {
              const glm::dvec3 position = this->Medium.CellSize *
                (glm::dvec3(at) + (glm::dvec3(step) + 0.5) / glm::dvec3(this->Steps));
              for (std::size_t i = 0; i < samplers.size(); ++i)
              {
                const ExtinctionSampler::Sample sample = samplers[i].Get(this->ToUnit(position));
                const glm::dvec3 part = 1.0 - sample.Transmission;
                extinction += sample.Extinction;
                taken += sample.Extinction * part;
                scattered +=
                  volumes[i].Scatters ? sample.Extinction * part * sample.Albedo : glm::dvec3(0.0);
              }
            }
          }
        }
        if (extinction > 0.0)
        {
          this->Medium.Extinction[cell] = static_cast<float>(extinction / samples);
          this->Medium.Albedo[cell] = glm::vec3(scattered / extinction);
          if (isColored)
          {
            this->ColorFractions[cell] = glm::vec3(taken / extinction);
          }
        }
      }
    });
  return true;
}

}
