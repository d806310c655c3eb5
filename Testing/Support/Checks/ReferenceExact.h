// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceExact_h
#define ReferenceExact_h

#include <array>  // for points
#include <vector> // for the terms

namespace reference
{

/**
 * @class   Exact
 * @brief   number with exact sums, differences and products, stored as a sum of nonoverlapping
 * doubles
 *
 * After J. Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric
 * predicates", 1997. Results are exact unless a value overflows or becomes subnormal.
 */
class Exact
{
public:
  Exact() = default;
  Exact(double value);

  Exact operator+(const Exact& other) const;
  Exact operator-(const Exact& other) const;
  Exact operator*(const Exact& other) const;

  /// Returns the sign: -1, 0 or 1.
  int Sign() const;
  /// Returns the value rounded to long double, up to an error in the last bit.
  long double Round() const;

private:
  void Add(double value);

  std::vector<double> Terms; ///< nonzero, sorted by increasing magnitude
};

using ExactPoint = std::array<Exact, 3>;

/// Returns six times the signed volume of a tetrahedron. It is positive if the first three points
/// are counterclockwise seen from the fourth.
Exact ExactDeterminant(const std::array<ExactPoint, 4>& points);

}

#endif
