#ifndef vtkFiniteNumbers_h
#define vtkFiniteNumbers_h

#include <algorithm>
#include <cmath>

/**
 * For settings that a setter takes as they are.
 */
namespace vtkFiniteNumbers
{
inline bool AreFinite(const double* values, int number)
{
  return std::all_of(values, values + number, [](double value) { return std::isfinite(value); });
}

/// Whether a radius or a length can be used.
inline bool IsSize(double value)
{
  return std::isfinite(value) && value > 0.0;
}
}

#endif
