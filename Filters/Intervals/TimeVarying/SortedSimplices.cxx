// SPDX-License-Identifier: BSD-3-Clause
#include "TimeVarying/SortedSimplices.h"

#include "Common/SimdDispatch.h"

#include <algorithm>

namespace interlume
{

namespace
{
// Compilers can vectorize this function: the trip count is constant and there are no branches.
template <typename Key>
inline void SortEach(SortedSimplices<Key>& simplices)
{
  constexpr int step = 16;
  for (int first = 0; first < simplices.Number; first += step)
  {
    for (int s = first; s < first + step; ++s)
    {
      Key a = simplices.Vertices[0][s];
      Key b = simplices.Vertices[1][s];
      Key c = simplices.Vertices[2][s];
      Key d = simplices.Vertices[3][s];
      Key e = simplices.Vertices[4][s];
      Key isOdd = 0;
      const auto exchange = [&isOdd](Key& low, Key& high)
      {
        const Key before = low;
        low = std::min(before, high);
        high = std::max(before, high);
        isOdd ^= static_cast<Key>(low != before ? 1 : 0);
      };
      // Sorting network for five values.
      exchange(a, d);
      exchange(b, e);
      exchange(a, c);
      exchange(b, d);
      exchange(a, b);
      exchange(c, e);
      exchange(b, c);
      exchange(d, e);
      exchange(c, d);
      simplices.Vertices[0][s] = a;
      simplices.Vertices[1][s] = b;
      simplices.Vertices[2][s] = c;
      simplices.Vertices[3][s] = d;
      simplices.Vertices[4][s] = e;
      simplices.Above[s] =
        (a & 1) | ((b & 1) << 1) | ((c & 1) << 2) | ((d & 1) << 3) | ((e & 1) << 4);
      simplices.IsOdd[s] = isOdd;
      simplices.HasEqual[s] = static_cast<Key>(a == b ? 1 : 0) | static_cast<Key>(b == c ? 1 : 0) |
        static_cast<Key>(c == d ? 1 : 0) | static_cast<Key>(d == e ? 1 : 0);
    }
  }
}
}

void SimplexSorting::Sort(SortedSimplices<std::uint32_t>& simplices)
{
  SimdDispatch::Call([&] { SortEach(simplices); });
}

void SimplexSorting::Sort(SortedSimplices<std::int64_t>& simplices)
{
  SimdDispatch::Call([&] { SortEach(simplices); });
}

}
