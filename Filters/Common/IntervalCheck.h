// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_IntervalCheck_h
#define interlume_IntervalCheck_h

#include <cmath>
#include <sstream>
#include <string>

namespace interlume
{

namespace IntervalCheck
{
/// Returns why lower ... upper is not an interval, as a sentence that begins with its \a name, or
/// nothing.
inline std::string Find(const std::string& name, double lower, double upper)
{
  std::ostringstream what;
  if (!std::isfinite(lower) || !std::isfinite(upper))
  {
    what << name << " [" << lower << ", " << upper << "] is not finite.";
  }
  else if (lower > upper)
  {
    what << name << " has lower value " << lower << " above its upper value " << upper << ".";
  }
  return what.str();
}
}

}

#endif
