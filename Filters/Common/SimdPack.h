// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SimdPack_h
#define interlume_SimdPack_h

#include <cstddef>
#include <utility>

// The ABI of vector results does not matter, since all functions that return vectors are inlined.
// GCC inlines them recursively into the callers of SimdDispatch. Clang inlines direct calls only,
// so functions that return a pack or a mask need INTERLUME_RETURNS_VECTOR.
#if defined(__clang__)
#pragma clang diagnostic ignored "-Wpsabi"
#define INTERLUME_RETURNS_VECTOR [[gnu::always_inline]]
#else
#if defined(__GNUC__)
#pragma GCC diagnostic ignored "-Wpsabi"
#endif
#define INTERLUME_RETURNS_VECTOR
#endif

namespace interlume
{

/// Vector types with two or four lanes: doubles, masks (all bits of a lane are set or clear), and
/// unsigned integers for bit operations.
template <int Width>
struct SimdTypes;

#define INTERLUME_SIMD_TYPES(number)                                                          \
  template <>                                                                                 \
  struct SimdTypes<number>                                                                    \
  {                                                                                           \
    /* Without AVX the compiler would use a smaller alignment than code compiled for AVX2. */ \
    using Numbers = double __attribute__((vector_size(8 * (number)), aligned(8 * (number)))); \
    using Mask = long long __attribute__((vector_size(8 * (number)), aligned(8 * (number)))); \
    using Bits =                                                                              \
      unsigned long long __attribute__((vector_size(8 * (number)), aligned(8 * (number))));   \
  };
INTERLUME_SIMD_TYPES(2)
INTERLUME_SIMD_TYPES(4)
#undef INTERLUME_SIMD_TYPES

/**
 * @class   SimdPack
 * @brief   a SIMD vector of two or four doubles
 *
 * In each lane, an operation gives exactly the same result as for a double. With AVX2 an operation
 * on four lanes is one instruction, otherwise two or four. Compile code that uses this class with
 * -ffp-contract=off, so that no operations are fused. Eight lanes are not supported, since
 * compilers compare their lanes one by one, and two vectors of four lanes are as fast.
 */
template <int Width>
struct SimdPack
{
  static constexpr int Number = Width;
  static constexpr int Size = 8 * Number;
  using Numbers = typename SimdTypes<Width>::Numbers;
  using Mask = typename SimdTypes<Width>::Mask;
  using Bits = typename SimdTypes<Width>::Bits;

  alignas(Size) Numbers Values;

  SimdPack() = default;
  /// The constructors and the assignment copy the whole vector at once. By default, compilers copy
  /// the structure in halves, which stalls a subsequent load of the vector.
  [[gnu::always_inline]] SimdPack(const Numbers& values)
    : Values(values)
  {
  }
  [[gnu::always_inline]] SimdPack(const SimdPack& other)
    : Values(other.Values)
  {
  }
  [[gnu::always_inline]] SimdPack& operator=(const SimdPack& other)
  {
    this->Values = other.Values;
    return *this;
  }

  [[gnu::always_inline]] static SimdPack Of(double value) { return { value - Numbers{} }; }
  /// Returns a pack with the lanes get(0), get(1), ...
  template <typename Get>
  [[gnu::always_inline]] static SimdPack OfEach(Get&& get)
  {
    return SimdPack::OfEach(get, std::make_index_sequence<Width>());
  }

  [[gnu::always_inline]] double Get(int lane) const { return this->Values[lane]; }
  [[gnu::always_inline]] void Set(int lane, double value) { this->Values[lane] = value; }

  [[gnu::always_inline]] static SimdPack Select(
    const Mask& mask, const SimdPack& a, const SimdPack& b)
  {
    return { mask ? a.Values : b.Values };
  }
  /// Like std::min and std::max, return the first argument if neither is smaller.
  [[gnu::always_inline]] static SimdPack Min(const SimdPack& a, const SimdPack& b)
  {
    return { b.Values < a.Values ? b.Values : a.Values };
  }
  [[gnu::always_inline]] static SimdPack Max(const SimdPack& a, const SimdPack& b)
  {
    return { a.Values < b.Values ? b.Values : a.Values };
  }
  [[gnu::always_inline]] static SimdPack Abs(const SimdPack& a)
  {
    return { Numbers(Bits(a.Values) & (~0ULL >> 1)) };
  }
  [[gnu::always_inline]] static SimdPack Sqrt(const SimdPack& a)
  {
    SimdPack root;
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
  /// Convert a mask to an integer with one bit per lane, and back.
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
    return SimdPack::GetMask(bits, std::make_index_sequence<Width>());
  }

  [[gnu::always_inline]] friend SimdPack operator+(const SimdPack& a, const SimdPack& b)
  {
    return { a.Values + b.Values };
  }
  [[gnu::always_inline]] friend SimdPack operator-(const SimdPack& a, const SimdPack& b)
  {
    return { a.Values - b.Values };
  }
  [[gnu::always_inline]] friend SimdPack operator*(const SimdPack& a, const SimdPack& b)
  {
    return { a.Values * b.Values };
  }
  [[gnu::always_inline]] friend SimdPack operator/(const SimdPack& a, const SimdPack& b)
  {
    return { a.Values / b.Values };
  }
  [[gnu::always_inline]] friend SimdPack operator-(const SimdPack& a) { return { -a.Values }; }
  [[gnu::always_inline]] friend Mask operator<(const SimdPack& a, const SimdPack& b)
  {
    return Mask(a.Values < b.Values);
  }
  [[gnu::always_inline]] friend Mask operator<=(const SimdPack& a, const SimdPack& b)
  {
    return Mask(a.Values <= b.Values);
  }
  [[gnu::always_inline]] friend Mask operator==(const SimdPack& a, const SimdPack& b)
  {
    return Mask(a.Values == b.Values);
  }

private:
  template <typename Get, std::size_t... Index>
  [[gnu::always_inline]] static SimdPack OfEach(Get&& get, std::index_sequence<Index...>)
  {
    return { Numbers{ static_cast<double>(get(static_cast<int>(Index)))... } };
  }
  template <std::size_t... Index>
  [[gnu::always_inline]] static Mask GetMask(unsigned int bits, std::index_sequence<Index...>)
  {
    return Mask{ -static_cast<long long>(bits >> Index & 1U)... };
  }
};

template <int N>
[[gnu::always_inline]] inline SimdPack<N> operator+(double a, const SimdPack<N>& b)
{
  return SimdPack<N>::Of(a) + b;
}
template <int N>
[[gnu::always_inline]] inline SimdPack<N> operator-(double a, const SimdPack<N>& b)
{
  return SimdPack<N>::Of(a) - b;
}
template <int N>
[[gnu::always_inline]] inline SimdPack<N> operator*(double a, const SimdPack<N>& b)
{
  return SimdPack<N>::Of(a) * b;
}
template <int N>
[[gnu::always_inline]] inline SimdPack<N> operator/(double a, const SimdPack<N>& b)
{
  return SimdPack<N>::Of(a) / b;
}
template <int N>
[[gnu::always_inline]] inline SimdPack<N> operator+(const SimdPack<N>& a, double b)
{
  return a + SimdPack<N>::Of(b);
}
template <int N>
[[gnu::always_inline]] inline typename SimdPack<N>::Mask operator<(const SimdPack<N>& a, double b)
{
  return a < SimdPack<N>::Of(b);
}
template <int N>
[[gnu::always_inline]] inline typename SimdPack<N>::Mask operator<=(const SimdPack<N>& a, double b)
{
  return a <= SimdPack<N>::Of(b);
}
template <int N>
[[gnu::always_inline]] inline typename SimdPack<N>::Mask operator>(const SimdPack<N>& a, double b)
{
  return SimdPack<N>::Of(b) < a;
}

}

#endif
