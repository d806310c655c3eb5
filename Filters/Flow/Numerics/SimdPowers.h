// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SimdPowers_h
#define interlume_SimdPowers_h

#include "Common/SimdPack.h"

namespace interlume
{

/**
 * @class   SimdPowers
 * @brief   computes log2(x) and 2^x of SIMD packs to seven digits
 *
 * Unlike the functions of a math library, the results are the same on every machine and for any
 * number of lanes. Arguments of the logarithm and results of the power must be positive normal
 * numbers.
 */
struct SimdPowers
{
  /// Returns the binary logarithm with an error of at most 1e-7.
  template <typename SimdPack>
  [[gnu::always_inline]] static SimdPack Log2(const SimdPack& x)
  {
    using Bits = typename SimdPack::Bits;
    using Numbers = typename SimdPack::Numbers;
    // The mantissa is scaled to [sqrt(1/2), sqrt(2)). To convert the exponent to a double, its bits
    // become the low bits of a number near 2^52, from which 2^52 and the exponent bias are
    // subtracted.
    constexpr unsigned long long lowest = 0x3fe6a09e667f3bcdULL;
    const Bits bits = Bits(x.Values) + (0x4000000000000000ULL - lowest);
    const SimdPack exponent = { Numbers((bits >> 52) | 0x4330000000000000ULL) -
      4503599627371520.0 };
    const SimdPack mantissa = { Numbers((bits & 0x000fffffffffffffULL) + lowest) };
    const SimdPack s = (mantissa + -1.0) / (mantissa + 1.0);
    const SimdPack square = s * s;
    return exponent +
      s *
      (square *
          (square * (0.41219858311113246 * square + 0.5770780163555854) + 0.9617966939259757) +
        2.8853900817779268);
  }

  /// Returns 2^x with a relative error of at most 2e-7.
  template <typename SimdPack>
  [[gnu::always_inline]] static SimdPack Exp2(const SimdPack& x)
  {
    using Bits = typename SimdPack::Bits;
    // The addition rounds x to an integer, which is then in the low bits of the sum.
    constexpr double rounding = 6755399441055744.0;
    const SimdPack sum = x + rounding;
    const SimdPack part = x - (sum + -rounding);
    const Bits exponent = (Bits(sum.Values) << 52) + 0x3ff0000000000000ULL;
    const SimdPack power = part *
        (part *
            (part *
                (part *
                    (part * (1.5403530393381610e-4 * part + 1.3333558146428443e-3) +
                      9.6181291076284772e-3) +
                  5.5504108664821580e-2) +
              2.4022650695910071e-1) +
          6.9314718055994531e-1) +
      1.0;
    return SimdPack{ typename SimdPack::Numbers(exponent) } * power;
  }
};

}

#endif
