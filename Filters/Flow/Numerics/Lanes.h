// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_Lanes_h
#define interlume_Lanes_h

// All functions that take or return lanes are inlined, so that it makes no difference how those
// would be handed over.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wpsabi"
#endif

namespace interlume
{

/**
 * @class   Lanes
 * @brief   four numbers that go the same way at once
 *
 * Each operation is that of double, lane by lane, so that a lane has the bytes that a double would
 * have. With AVX2 an operation is one instruction, elsewhere two or four; the code that uses this
 * has to be compiled without contraction to fused operations.
 */
struct Lanes
{
  static constexpr int Number = 4;
  // Without AVX the compiler would align them less than the AVX2 clones of a function expect.
  static constexpr int Size = Number * sizeof(double);
  using Numbers = double __attribute__((vector_size(Size), aligned(Size)));
  /// All bits of a lane, or none.
  using Mask = long long __attribute__((vector_size(Size), aligned(Size)));

  alignas(Size) Numbers Values;

  [[gnu::always_inline]] static Lanes Of(double value)
  {
    return { Numbers{ value, value, value, value } };
  }
  [[gnu::always_inline]] static Lanes Of(double a, double b, double c, double d)
  {
    return { Numbers{ a, b, c, d } };
  }

  [[gnu::always_inline]] double Get(int lane) const { return this->Values[lane]; }
  [[gnu::always_inline]] void Set(int lane, double value) { this->Values[lane] = value; }

  [[gnu::always_inline]] static Lanes Select(const Mask& mask, const Lanes& a, const Lanes& b)
  {
    return { mask ? a.Values : b.Values };
  }
  /// As std::min and std::max have it: the first where neither is less.
  [[gnu::always_inline]] static Lanes Min(const Lanes& a, const Lanes& b)
  {
    return { b.Values < a.Values ? b.Values : a.Values };
  }
  [[gnu::always_inline]] static Lanes Max(const Lanes& a, const Lanes& b)
  {
    return { a.Values < b.Values ? b.Values : a.Values };
  }
  [[gnu::always_inline]] static Lanes Abs(const Lanes& a)
  {
    return { Numbers(Mask(a.Values) & ~Mask(Numbers{ -0.0, -0.0, -0.0, -0.0 })) };
  }
  [[gnu::always_inline]] static Lanes Sqrt(const Lanes& a)
  {
    Lanes root;
    for (int i = 0; i < Number; ++i)
    {
      root.Values[i] = __builtin_sqrt(a.Values[i]);
    }
    return root;
  }

  [[gnu::always_inline]] static bool IsAny(const Mask& mask)
  {
    return (mask[0] | mask[1] | mask[2] | mask[3]) != 0;
  }
  /// Returns the lanes as bits of a number, and back.
  [[gnu::always_inline]] static unsigned int GetBits(const Mask& mask)
  {
    return static_cast<unsigned int>((mask[0] & 1) | (mask[1] & 2) | (mask[2] & 4) | (mask[3] & 8));
  }
  [[gnu::always_inline]] static Mask GetMask(unsigned int bits)
  {
    const auto expand = [bits](unsigned int lane)
    { return -static_cast<long long>(bits >> lane & 1U); };
    return Mask{ expand(0), expand(1), expand(2), expand(3) };
  }
};

[[gnu::always_inline]] inline Lanes operator+(const Lanes& a, const Lanes& b)
{
  return { a.Values + b.Values };
}
[[gnu::always_inline]] inline Lanes operator-(const Lanes& a, const Lanes& b)
{
  return { a.Values - b.Values };
}
[[gnu::always_inline]] inline Lanes operator-(const Lanes& a)
{
  return { -a.Values };
}
[[gnu::always_inline]] inline Lanes operator*(const Lanes& a, const Lanes& b)
{
  return { a.Values * b.Values };
}
[[gnu::always_inline]] inline Lanes operator*(double a, const Lanes& b)
{
  return { a * b.Values };
}
[[gnu::always_inline]] inline Lanes operator/(const Lanes& a, const Lanes& b)
{
  return { a.Values / b.Values };
}
[[gnu::always_inline]] inline Lanes::Mask operator<(const Lanes& a, const Lanes& b)
{
  return Lanes::Mask(a.Values < b.Values);
}
[[gnu::always_inline]] inline Lanes::Mask operator<=(const Lanes& a, const Lanes& b)
{
  return Lanes::Mask(a.Values <= b.Values);
}
[[gnu::always_inline]] inline Lanes::Mask operator==(const Lanes& a, const Lanes& b)
{
  return Lanes::Mask(a.Values == b.Values);
}
/// Against one number.
[[gnu::always_inline]] inline Lanes::Mask operator<(const Lanes& a, double b)
{
  return Lanes::Mask(a.Values < b);
}
[[gnu::always_inline]] inline Lanes::Mask operator<=(const Lanes& a, double b)
{
  return Lanes::Mask(a.Values <= b);
}
[[gnu::always_inline]] inline Lanes::Mask operator>(const Lanes& a, double b)
{
  return Lanes::Mask(a.Values > b);
}
[[gnu::always_inline]] inline Lanes operator+(const Lanes& a, double b)
{
  return { a.Values + b };
}
[[gnu::always_inline]] inline Lanes operator-(double a, const Lanes& b)
{
  return { a - b.Values };
}
[[gnu::always_inline]] inline Lanes operator/(double a, const Lanes& b)
{
  return { a / b.Values };
}

}

#endif
