// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_IntervalCheck_h
#define interlume_IntervalCheck_h

#include "Common/Error.h"

#include <cmath>
#include <sstream>
#include <string>

namespace interlume
{

namespace IntervalCheck
{
/// Returns an error, as a sentence that starts with \a name, if [\a lower, \a upper] is not a valid
/// interval.
inline Error FindError(const std::string& name, double lower, double upper)
{
  std::ostringstream text;
  if (!std::isfinite(lower) || !std::isfinite(upper))
  {
    text << name << " [" << lower << ", " << upper << "] is not finite.";
    return text.str();
  }
  if (lower > upper)
  {
    text << name << " has lower value " << lower << " above its upper value " << upper << ".";
    return text.str();
  }
  return {};
}
}

}

#endif
