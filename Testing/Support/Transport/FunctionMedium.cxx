// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Transport/FunctionMedium.h"

namespace reference
{

FunctionMedium::FunctionMedium(const glm::dvec3& lower, const glm::dvec3& upper,
  const ExtinctionRange& range, const Extinction& extinction, const Albedo& albedo)
  : GetValue(extinction)
  , GetColor(albedo)
{
  this->SetCells(lower, upper, { { 1, 1, 1 } }, { range });
}

FunctionMedium FunctionMedium::Slab(double thickness, double extinction, const glm::dvec3& albedo)
{
  constexpr double never = std::numeric_limits<double>::infinity();
  return FunctionMedium(
    { -never, -never, 0.0 }, { never, never, thickness }, { extinction, extinction },
    [extinction](const glm::dvec3&) { return extinction; },
    [albedo](const glm::dvec3&) { return albedo; });
}

}
