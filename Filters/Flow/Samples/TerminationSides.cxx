// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/TerminationSides.h"

#include "Cells/MultilinearCell.h"
#include "Common/Vectors.h"

#include "vtkDataSet.h"
#include "vtkFlowStatus.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPThreadLocalObject.h"
#include "vtkSMPTools.h"
#include "vtkTerminationSurface.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace interlume
{

namespace
{
constexpr float None = std::numeric_limits<float>::quiet_NaN();
// Factor that allows for the rounding error of distances, which are stored as floats.
constexpr double Rounding = 1.0 + 1e-6;

double GetDiagonal(vtkDataSet* data, vtkIdList* corners)
{
  double lower[3];
  double upper[3];
  data->GetPoint(corners->GetId(0), lower);
  std::copy_n(lower, 3, upper);
  for (const vtkIdType corner : *corners)
  {
    double x[3];
    data->GetPoint(corner, x);
    for (int i = 0; i < 3; ++i)
    {
      lower[i] = std::min(lower[i], x[i]);
      upper[i] = std::max(upper[i], x[i]);
    }
  }
  return Vectors::SafeLength(Vectors::Difference(upper, lower));
}

// Distances from a surface to the nearest corners of a cell above and below the surface.
struct Gap
{
  float Above = std::numeric_limits<float>::infinity();
  float Below = std::numeric_limits<float>::infinity();
  bool IsOff = false;

  void Add(float distance)
  {
    // A corner on the surface counts for both sides.
    this->Above = distance >= 0.0F ? std::min(this->Above, distance) : this->Above;
    this->Below = distance <= 0.0F ? std::min(this->Below, -distance) : this->Below;
    this->IsOff = this->IsOff || distance != 0.0F;
  }
  bool IsCrossed() const { return this->IsOff && std::isfinite(this->Above + this->Below); }
};
}

TerminationSides::TerminationSides(const AdvectionOptions& options, const double bounds[6])
  : IsBackward(options.IsBackward())
  , Scale(MultilinearCell::GetScale(
      std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] })))
{
  for (const AdvectionOptions::Surface& surface : options.Surfaces)
  {
    for (int part = 0; part < surface.Shape->GetNumberOfParts(); ++part)
    {
      this->Surfaces[surface.Id + part].push_back(surface.Shape);
    }
  }
}

void TerminationSides::SetNumberOfSamples(vtkIdType number)
{
  this->Distances.resize(static_cast<std::size_t>(number), None);
}

const vtkTerminationSurface* TerminationSides::FindNearest(
  int id, const double x[3], double& distance) const
{
  const auto found = this->Surfaces.find(id);
  const vtkTerminationSurface* nearest = nullptr;
  if (found == this->Surfaces.end())
  {
    return nearest;
  }
  const bool isOne = found->second.size() == 1;
  for (const vtkTerminationSurface* surface : found->second)
  {
    const double own = surface->EvaluateDistance(x);
    if ((!nearest || std::abs(own) < std::abs(distance)) &&
      (isOne || surface->ProjectsOntoSurface(x)))
    {
      nearest = surface;
      distance = own;
    }
  }
  return nearest;
}

void TerminationSides::Add(vtkIdType sample, const double x[3], const AdvectionResult& result)
{
  double distance = 0.0;
  if (result.Status != vtkFlowStatus::REACHED_SURFACE || !this->FindNearest(result.Id, x, distance))
  {
    return;
  }
  const double smallest = std::numeric_limits<float>::min();
  // Treat a distance within the arrival tolerance as 0: rounding may have moved a sample on the
  // field's boundary past a surface there.
  const bool isOff = result.Time > 0.0 && std::abs(distance) > result.Nearness;
  this->Distances[static_cast<std::size_t>(sample)] = isOff
    ? static_cast<float>(
        std::copysign(std::max(smallest, this->Scale * std::abs(distance)), distance))
    : 0.0F;
}

std::vector<vtkIdType> TerminationSides::FindCutCellCorners(
  vtkDataSet* samples, const int* ids) const
{
  const vtkIdType cells = this->Surfaces.empty() ? 0 : samples->GetNumberOfCells();
  vtkSMPThreadLocalObject<vtkIdList> lists;
  vtkSMPThreadLocal<std::vector<vtkIdType>> found;
  if (cells > 0)
  {
    // The first call builds a cache in the dataset, so it must precede the parallel loop.
    samples->GetCellPoints(0, lists.Local());
  }
  vtkSMPTools::For(0, cells,
    [&](vtkIdType first, vtkIdType last)
    {
      vtkIdList* corners = lists.Local();
      std::vector<vtkIdType>& own = found.Local();
      for (vtkIdType cell = first; cell < last; ++cell)
      {
        samples->GetCellPoints(cell, corners);
        Gap gap;
        bool isOne = corners->GetNumberOfIds() > 0;
        for (vtkIdType i = 0; i < corners->GetNumberOfIds() && isOne; ++i)
        {
          const float distance = this->Distances[static_cast<std::size_t>(corners->GetId(i))];
          isOne = !std::isnan(distance) && ids[corners->GetId(i)] == ids[corners->GetId(0)];
          gap.Add(distance);
        }
        if (isOne && gap.IsCrossed() &&
          gap.Above + gap.Below <= Rounding * (this->Scale * GetDiagonal(samples, corners)))
        {
          own.insert(own.end(), corners->begin(), corners->end());
        }
      }
    });
  std::vector<vtkIdType> all;
  for (const std::vector<vtkIdType>& own : found)
  {
    all.insert(all.end(), own.begin(), own.end());
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

signed char TerminationSides::GetSide(
  vtkIdType sample, int id, const double x[3], const double velocity[3]) const
{
  double distance = 0.0;
  const vtkTerminationSurface* surface = this->FindNearest(id, x, distance);
  if (!surface || this->Distances[static_cast<std::size_t>(sample)] == 0.0F ||
    !surface->ProjectsOntoSurface(x))
  {
    return 0;
  }
  double normal[3];
  surface->EvaluateNormal(x, normal);
  const double speed = vtkMath::Dot(normal, velocity);
  const int side = distance < 0.0 ? -1 : 1;
  const bool isToward = side * (this->IsBackward ? -speed : speed) < 0.0;
  return static_cast<signed char>(side * (isToward ? vtkFlowStatus::TOWARD : vtkFlowStatus::AWAY));
}

}
