// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_Lanes_h
#define interlume_Lanes_h

#include <cstddef>
#include <utility>

// All functions that take or return lanes are inlined, so that it makes no difference how those
// would be handed over.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wpsabi"
#endif

namespace interlume
{

/// The vectors of two or of four lanes: numbers, all bits of a lane or none, and bits.
template <int Width>
struct LaneTypes;

#define INTERLUME_LANE_TYPES(number)                                                           \
  template <>                                                                                  \
  struct LaneTypes<number>                                                                     \
  {                                                                                            \
    /* Without AVX the compiler would align them less than the clones of a function expect. */ \
    using Numbers = double __attribute__((vector_size(8 * (number)), aligned(8 * (number))));  \
    using Mask = long long __attribute__((vector_size(8 * (number)), aligned(8 * (number))));  \
    using Bits =                                                                               \
      unsigned long long __attribute__((vector_size(8 * (number)), aligned(8 * (number))));    \
  };
INTERLUME_LANE_TYPES(2)
INTERLUME_LANE_TYPES(4)
#undef INTERLUME_LANE_TYPES

/**
 * @class   Lanes
 * @brief   several numbers that go the same way at once
 *
 * Each operation is that of double, lane by lane, so that a lane has the bytes that a double would
 * have. With AVX2 an operation of four lanes is one instruction, elsewhere two or four; the code
 * that uses this has to be compiled without contraction to fused operations. There are two or four
 * lanes: compilers compare eight one by one, and two vectors of four are no quicker than one.
 */
template <int Width>
struct Lanes
{
  static constexpr int Number = Width;
  static constexpr int Size = 8 * Number;
  using Numbers = typename LaneTypes<Width>::Numbers;
  using Mask = typename LaneTypes<Width>::Mask;
  using Bits = typename LaneTypes<Width>::Bits;

  alignas(Size) Numbers Values;

  Lanes() = default;
  /// Copied as one: compilers copy a structure in halves, for which a load of the whole has to
  /// wait.
  [[gnu::always_inline]] Lanes(const Numbers& values)
    : Values(values)
  {
  }
  [[gnu::always_inline]] Lanes(const Lanes& other)
    : Values(other.Values)
  {
  }
  [[gnu::always_inline]] Lanes& operator=(const Lanes& other)
  {
    this->Values = other.Values;
    return *this;
  }

  [[gnu::always_inline]] static Lanes Of(double value) { return { value - Numbers{} }; }
  /// Makes lanes of get(0), get(1), ...
  template <typename Get>
  [[gnu::always_inline]] static Lanes OfEach(Get&& get)
  {
    return Lanes::OfEach(get, std::make_index_sequence<Width>());
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
    return { Numbers(Bits(a.Values) & (~0ULL >> 1)) };
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
    long long any = 0;
    for (int i = 0; i < Number; ++i)
    {
      any |= mask[i];
    }
    return any != 0;
  }
  /// Returns the lanes as bits of a number, and back.
  [[gnu::always_inline]] static unsigned int GetBits(const Mask& mask)
  {
    unsigned int bits = 0;
    for (int i = 0; i < Number; ++i)
    {
      bits |= static_cast<unsigned int>(mask[i]) & (1U << i);
    }
    return bits;
  }
  [[gnu::always_inline]] static Mask GetMask(unsigned int bits)
  {
    return Lanes::GetMask(bits, std::make_index_sequence<Width>());
  }

  [[gnu::always_inline]] friend Lanes operator+(const Lanes& a, const Lanes& b)
  {
    return { a.Values + b.Values };
  }
  [[gnu::always_inline]] friend Lanes operator-(const Lanes& a, const Lanes& b)
  {
    return { a.Values - b.Values };
  }
  [[gnu::always_inline]] friend Lanes operator*(const Lanes& a, const Lanes& b)
  {
    return { a.Values * b.Values };
  }
  [[gnu::always_inline]] friend Lanes operator/(const Lanes& a, const Lanes& b)
  {
    return { a.Values / b.Values };
  }
  [[gnu::always_inline]] friend Lanes operator-(const Lanes& a) { return { -a.Values }; }
  [[gnu::always_inline]] friend Mask operator<(const Lanes& a, const Lanes& b)
  {
    return Mask(a.Values < b.Values);
  }
  [[gnu::always_inline]] friend Mask operator<=(const Lanes& a, const Lanes& b)
  {
    return Mask(a.Values <= b.Values);
  }
  [[gnu::always_inline]] friend Mask operator==(const Lanes& a, const Lanes& b)
  {
    return Mask(a.Values == b.Values);
  }

private:
  template <typename Get, std::size_t... Lane>
  [[gnu::always_inline]] static Lanes OfEach(Get&& get, std::index_sequence<Lane...>)
  {
    return { Numbers{ static_cast<double>(get(static_cast<int>(Lane)))... } };
  }
  template <std::size_t... Lane>
  [[gnu::always_inline]] static Mask GetMask(unsigned int bits, std::index_sequence<Lane...>)
  {
    return Mask{ -static_cast<long long>(bits >> Lane & 1U)... };
  }
};

template <int N>
[[gnu::always_inline]] inline Lanes<N> operator+(double a, const Lanes<N>& b)
{
  return Lanes<N>::Of(a) + b;
}
template <int N>
[[gnu::always_inline]] inline Lanes<N> operator-(double a, const Lanes<N>& b)
{
  return Lanes<N>::Of(a) - b;
}
template <int N>
[[gnu::always_inline]] inline Lanes<N> operator*(double a, const Lanes<N>& b)
{
  return Lanes<N>::Of(a) * b;
}
template <int N>
[[gnu::always_inline]] inline Lanes<N> operator/(double a, const Lanes<N>& b)
{
  return Lanes<N>::Of(a) / b;
}
template <int N>
[[gnu::always_inline]] inline Lanes<N> operator+(const Lanes<N>& a, double b)
{
  return a + Lanes<N>::Of(b);
}
template <int N>
[[gnu::always_inline]] inline typename Lanes<N>::Mask operator<(const Lanes<N>& a, double b)
{
  return a < Lanes<N>::Of(b);
}
template <int N>
[[gnu::always_inline]] inline typename Lanes<N>::Mask operator<=(const Lanes<N>& a, double b)
{
  return a <= Lanes<N>::Of(b);
}
template <int N>
[[gnu::always_inline]] inline typename Lanes<N>::Mask operator>(const Lanes<N>& a, double b)
{
  return Lanes<N>::Of(b) < a;
}

}

#endif
