// SPDX-License-Identifier: BSD-3-Clause
#ifndef FunctionMedium_h
#define FunctionMedium_h

#include "Support/Transport/TransportMedium.h"

#include <functional>

namespace reference
{

/**
 * @class   FunctionMedium
 * @brief   medium defined by functions of position
 */
class FunctionMedium : public TransportMedium
{
public:
  using Extinction = std::function<double(const glm::dvec3&)>;
  using Albedo = std::function<glm::dvec3(const glm::dvec3&)>;

  /// Creates a medium in the box from \a lower to \a upper. The extinction must be in \a range
  /// everywhere in the box.
  FunctionMedium(const glm::dvec3& lower, const glm::dvec3& upper, const ExtinctionRange& range,
    const Extinction& extinction, const Albedo& albedo);

  /// Returns a homogeneous medium between z = 0 and \a thickness, infinite in x and y.
  static FunctionMedium Slab(double thickness, double extinction, const glm::dvec3& albedo);

  double GetExtinction(const glm::dvec3& position) const override
  {
    return this->GetValue(position);
  }
  glm::dvec3 GetAlbedo(const glm::dvec3& position) const override
  {
    return this->GetColor(position);
  }

private:
  Extinction GetValue;
  Albedo GetColor;
};

}

#endif
