// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Flow/ReferenceAdvection.h"

#include "Advection/Advection.h"
#include "vtkMath.h"

#include <cmath>
#include <sstream>

namespace reference
{

namespace
{

template <typename Walker>
interlume::AdvectionResult AdvectIn(
  const Walker& field, const interlume::AdvectionOptions& options, const Position& start)
{
  interlume::Advection<Walker> advection(field, options);
  interlume::AdvectionResult result;
  advection.Follow(start.data(), result);
  return result;
}

}

interlume::AdvectionResult Advect(
  const SingleCellWalker& field, const interlume::AdvectionOptions& options, Position start)
{
  return AdvectIn(field, options, start);
}

interlume::AdvectionResult Advect(
  const BoxWalker& field, const interlume::AdvectionOptions& options, Position start)
{
  return AdvectIn(field, options, start);
}

OwningAdvectionOptions ForwardOptions()
{
  OwningAdvectionOptions options;
  options.SetBackward(false);
  return options;
}

OwningAdvectionOptions ForwardOptions(const std::vector<vtkSmartPointer<FormulaSurface>>& surfaces)
{
  OwningAdvectionOptions options = ForwardOptions();
  options.OwnedSurfaces = surfaces;
  int id = 0;
  for (const auto& surface : surfaces)
  {
    id += 10;
    options.Surfaces.push_back({ surface, id });
  }
  return options;
}

int NumberOfSteps(const interlume::AdvectionResult& result)
{
  return result.Steps + result.RejectedSteps + result.StiffSteps + result.RejectedStiffSteps;
}

double Distance(const double a[3], const Position& b)
{
  return std::sqrt(vtkMath::Distance2BetweenPoints(a, b.data()));
}

std::string Describe(const interlume::AdvectionResult& result)
{
  std::ostringstream text;
  text << vtkFlowStatus::GetName(result.Status) << " " << result.Id << " at ("
       << result.Parameters[0] << ", " << result.Parameters[1] << "), time " << result.Time
       << " after " << NumberOfSteps(result) << " steps";
  return text.str();
}

}
