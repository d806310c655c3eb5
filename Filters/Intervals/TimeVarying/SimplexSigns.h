// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SimplexSigns_h
#define interlume_SimplexSigns_h

#include <array>
#include <cstdint>

namespace interlume
{

/**
 * @class   SimplexSigns
 * @brief   the signs of a 4-simplex's dependency, and what of its projection they tell alone
 *
 * See SimplexProjection. They take two bytes: what an output keeps of a projection until its
 * tetrahedra are written.
 */
class SimplexSigns
{
public:
  enum Counts
  {
    NumberOfPoints = 5,
    NumberOfClasses = 6
  };

  /// What follows from the signs.
  struct Cut
  {
    std::uint8_t Class = NumberOfClasses - 1;
    std::uint8_t NumberOfTetrahedra = 0;
    /// The points whose mean is the thick point: those of the side with fewer, or the negative one.
    std::uint8_t NumberOfMeant = 0;
    std::array<std::uint8_t, NumberOfPoints> Meant{};
    /// Three points of each tetrahedron, the fourth of which is the thick point, in the order that
    /// is positive for a simplex that is not inverted.
    std::array<std::array<std::uint8_t, 3>, 6> Tetrahedra{};
  };

  /// Makes signs that are all zero.
  SimplexSigns() = default;

  /// Bit i of \a positive is set where lambda_i is, bit i of \a negative likewise. \a isInverted is
  /// as in SimplexProjection.
  SimplexSigns(unsigned int positive, unsigned int negative, bool isInverted)
    : Bits(static_cast<std::uint16_t>(
        positive | (negative << NumberOfPoints) | (isInverted ? InvertedBit : 0u)))
  {
  }

  /// Returns 1, 0 or -1 for lambda_i.
  int Get(int i) const
  {
    return static_cast<int>((this->Bits >> i) & 1u) -
      static_cast<int>((this->Bits >> (NumberOfPoints + i)) & 1u);
  }
  bool IsInverted() const { return (this->Bits & InvertedBit) != 0; }

  const Cut& GetCut() const { return Cuts[this->Bits & (InvertedBit - 1)]; }

  /**
   * Calls visit(a, b, c) for each tetrahedron of the points a, b, c and the thick point. Its volume
   * has the sign of the determinant of the simplex.
   */
  template <typename Visitor>
  void ForEachTetrahedron(Visitor&& visit) const
  {
    const Cut& cut = this->GetCut();
    const int first = this->IsInverted() ? 1 : 0;
    for (int t = 0; t < cut.NumberOfTetrahedra; ++t)
    {
      const auto& points = cut.Tetrahedra[t];
      visit(points[first], points[1 - first], points[2]);
    }
  }

private:
  static constexpr unsigned int InvertedBit = 1u << (2 * NumberOfPoints);
  using CutArray = std::array<Cut, InvertedBit>;
  static constexpr CutArray MakeCuts();
  static const CutArray Cuts;

  std::uint16_t Bits = 0;
};

}

#endif
