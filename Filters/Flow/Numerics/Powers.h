// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_Powers_h
#define interlume_Powers_h

#include "Common/Lanes.h"

namespace interlume
{

/**
 * @class   Powers
 * @brief   logarithms and powers of two to seven digits, for lanes
 *
 * The same on each machine and for any number of lanes, which the functions of a mathematical
 * library are not. Arguments are normal numbers above 0, and exponents whose power is one.
 */
struct Powers
{
  /// Returns the binary logarithm, with an error of at most 1e-7.
  template <typename Lanes>
  [[gnu::always_inline]] static Lanes GetLogarithm(const Lanes& x)
  {
    using Bits = typename Lanes::Bits;
    using Numbers = typename Lanes::Numbers;
    // The mantissa is brought to [root 1/2, root 2), the exponent comes as the last bits of a
    // number as large as 2^52, 1024 being 0.
    constexpr unsigned long long least = 0x3fe6a09e667f3bcdULL;
    const Bits bits = Bits(x.Values) + (0x4000000000000000ULL - least);
    const Lanes whole = { Numbers((bits >> 52) | 0x4330000000000000ULL) - 4503599627371520.0 };
    const Lanes mantissa = { Numbers((bits & 0x000fffffffffffffULL) + least) };
    const Lanes s = (mantissa + -1.0) / (mantissa + 1.0);
    const Lanes square = s * s;
    return whole +
      s *
      (square *
          (square * (0.41219858311113246 * square + 0.5770780163555854) + 0.9617966939259757) +
        2.8853900817779268);
  }

  /// Returns 2^x, with an error of at most 2e-7 of it.
  template <typename Lanes>
  [[gnu::always_inline]] static Lanes GetPower(const Lanes& x)
  {
    using Bits = typename Lanes::Bits;
    // The sum rounds to a whole number, which the last bits are.
    constexpr double rounding = 6755399441055744.0;
    const Lanes sum = x + rounding;
    const Lanes part = x - (sum + -rounding);
    const Bits exponent = (Bits(sum.Values) << 52) + 0x3ff0000000000000ULL;
    const Lanes power = part *
        (part *
            (part *
                (part *
                    (part * (1.5403530393381610e-4 * part + 1.3333558146428443e-3) +
                      9.6181291076284772e-3) +
                  5.5504108664821580e-2) +
              2.4022650695910071e-1) +
          6.9314718055994531e-1) +
      1.0;
    return Lanes{ typename Lanes::Numbers(exponent) } * power;
  }
};

}

#endif
