// SPDX-License-Identifier: BSD-3-Clause
#ifndef FunctionMedium_h
#define FunctionMedium_h

#include "Support/Transport/TransportMedium.h"

#include <functional>

namespace reference
{

/**
 * @class   FunctionMedium
 * @brief   a medium by formulas
 */
class FunctionMedium : public TransportMedium
{
public:
  using Extinction = std::function<double(const glm::dvec3&)>;
  using Albedo = std::function<glm::dvec3(const glm::dvec3&)>;

  /// The \a extinction is nowhere outside of \a range, and counts within the box alone.
  FunctionMedium(const glm::dvec3& lower, const glm::dvec3& upper, const ExtinctionRange& range,
    const Extinction& extinction, const Albedo& albedo);

  /// Matter that is the same everywhere between z = 0 and \a thickness, without end in x and y.
  static FunctionMedium Slab(double thickness, double extinction, const glm::dvec3& albedo);

  double GetExtinction(const glm::dvec3& place) const override { return this->GetValue(place); }
  glm::dvec3 GetAlbedo(const glm::dvec3& place) const override { return this->GetColor(place); }

private:
  Extinction GetValue;
  Albedo GetColor;
};

}

#endif
