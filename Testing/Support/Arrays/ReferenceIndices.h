// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceIndices_h
#define ReferenceIndices_h

#include <array>       // for indices
#include <cstddef>     // for sizes
#include <type_traits> // for the type of sizes

namespace reference
{

/**
 * @class   IndexRange
 * @brief   range over all index tuples of a multidimensional array, in row-major order
 *
 * @code
 * for (const auto& [j, i] : AllIndices(picture.Height, picture.Width))
 * @endcode
 */
template <typename T, std::size_t N>
class IndexRange
{
public:
  class Iterator
  {
  public:
    Iterator(const std::array<T, N>& sizes, T first)
      : Sizes(sizes)
    {
      this->Indices[0] = first;
    }

    const std::array<T, N>& operator*() const { return this->Indices; }
    bool operator!=(const Iterator& other) const { return this->Indices != other.Indices; }
    Iterator& operator++()
    {
      std::size_t axis = N - 1;
      while (++this->Indices[axis] == this->Sizes[axis] && axis > 0)
      {
        this->Indices[axis--] = T(0);
      }
      return *this;
    }

  private:
    std::array<T, N> Sizes;
    std::array<T, N> Indices{};
  };

  explicit IndexRange(const std::array<T, N>& sizes)
    : Sizes(sizes)
  {
  }

  Iterator begin() const
  {
    for (const T size : this->Sizes)
    {
      if (size <= T(0))
      {
        return this->end();
      }
    }
    return { this->Sizes, T(0) };
  }
  Iterator end() const { return { this->Sizes, this->Sizes[0] }; }

private:
  std::array<T, N> Sizes;
};

/// Returns the range of all index tuples with each index below its size.
template <typename... Size>
auto AllIndices(Size... sizes)
{
  using T = std::common_type_t<Size...>;
  const std::array<T, sizeof...(sizes)> all = { { static_cast<T>(sizes)... } };
  return IndexRange<T, sizeof...(sizes)>(all);
}

}

#endif
