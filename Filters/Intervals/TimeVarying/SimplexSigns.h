// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SimplexSigns_h
#define interlume_SimplexSigns_h

#include <array>
#include <cstdint>

namespace interlume
{

/**
 * @class   SimplexSigns
 * @brief   signs of the affine dependency of a 4-simplex's projected points, in two bytes
 *
 * The signs determine the tetrahedra of the projection (see SimplexProjection). They are stored for
 * each 4-simplex until its tetrahedra are written.
 */
class SimplexSigns
{
public:
  enum Counts
  {
    NumberOfPoints = 5,
    NumberOfClasses = 6
  };

  /// Properties that follow from the signs.
  struct Cut
  {
    std::uint8_t Class = NumberOfClasses - 1;
    std::uint8_t NumberOfTetrahedra = 0;
    /// The points whose weighted mean is the thick point: the positive or the negative points,
    /// whichever are fewer, or the negative points if their numbers are equal.
    std::uint8_t NumberOfMeanPoints = 0;
    std::array<std::uint8_t, NumberOfPoints> MeanPoints{};
    /// Three points of each tetrahedron; the fourth one is the thick point. In this order, the
    /// tetrahedron is positively oriented if the simplex is not inverted.
    std::array<std::array<std::uint8_t, 3>, 6> Tetrahedra{};
  };

  /// Sets all signs to zero.
  SimplexSigns() = default;

  /// Set bit i of \a positive if lambda_i is positive, and bit i of \a negative if it is negative.
  /// \a isInverted is the value of SimplexProjection::IsInverted().
  SimplexSigns(unsigned int positive, unsigned int negative, bool isInverted)
    : Bits(static_cast<std::uint16_t>(
        positive | (negative << NumberOfPoints) | (isInverted ? InvertedBit : 0u)))
  {
  }

  /// Returns the sign of lambda_i: 1, 0 or -1.
  int Get(int i) const
  {
    return static_cast<int>((this->Bits >> i) & 1u) -
      static_cast<int>((this->Bits >> (NumberOfPoints + i)) & 1u);
  }
  bool IsInverted() const { return (this->Bits & InvertedBit) != 0; }

  const Cut& GetDecomposition() const { return Cuts[this->Bits & (InvertedBit - 1)]; }

  /**
   * Calls visit(a, b, c) for each tetrahedron, which consists of the points a, b, c and the thick
   * point. Its volume has the sign of the determinant of the simplex.
   */
  template <typename Visitor>
  void ForEachTetrahedron(Visitor&& visit) const
  {
    const Cut& cut = this->GetDecomposition();
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
  static constexpr CutArray MakeDecompositions();
  static const CutArray Cuts;

  std::uint16_t Bits = 0;
};

}

#endif
