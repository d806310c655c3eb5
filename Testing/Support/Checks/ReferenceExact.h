// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceExact_h
#define ReferenceExact_h

#include <array>  // for points
#include <vector> // for the terms

namespace reference
{

/**
 * @class   Exact
 * @brief   a sum of doubles that do not overlap: exact sums, differences and products
 *
 * As in J. Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric
 * predicates", 1997. Exact as long as nothing overflows or becomes subnormal.
 */
class Exact
{
public:
  Exact() = default;
  Exact(double value);

  Exact operator+(const Exact& other) const;
  Exact operator-(const Exact& other) const;
  Exact operator*(const Exact& other) const;

  /// -1, 0 or 1.
  int Sign() const;
  /// Rounded to nearest, but for the last place.
  long double Round() const;

private:
  void Add(double value);

  std::vector<double> Terms; ///< none 0, of growing magnitude
};

using ExactPoint = std::array<Exact, 3>;

/// Six times the signed volume of a tetrahedron, as Determinant has it.
Exact ExactDeterminant(const std::array<ExactPoint, 4>& points);

}

#endif
