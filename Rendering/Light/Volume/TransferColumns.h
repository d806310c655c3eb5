// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TransferColumns_h
#define interlume_TransferColumns_h

#include "Volume/TransferNodes.h"

#include <array>
#include <functional>
#include <vector>

namespace interlume
{

/**
 * @class   TransferColumns
 * @brief   a transfer function at even places, and its bends between two of them
 *
 * Most functions are straight between most columns, where two values are all that a shader needs.
 * Where they go from the one to the other in a part of the way, a step or a steep edge, the part is
 * kept as well; where there is more between them, such as a peak, a list of bends has the
 * function's nodes there, which a shader searches. So steps and peaks are where they are, however
 * narrow, in single precision over the range. Values within 1e-3 of the largest value are equal,
 * and within an edge those that are off by 1e-2 of it, averaged over the way: a slow bend needs
 * neither, and shaders of functions without edges or lists have no code for them.
 *
 * A list is texels of four floats, the first of them the number of pieces. For one channel the
 * pieces follow: the shares of the way from column to column, from 0 to 1, at which each begins and
 * ends, and the values there. For three channels one node more than pieces follows: its share and
 * its values; two of one share are a step.
 */
struct TransferColumns
{
  static constexpr int Columns = 4096;
  /// The number of places of an edge: edges begin and end at a multiple of one over this number.
  static constexpr int EdgePlaces = 4095;
  using Range = TransferNodes::Range;
  using Value = TransferNodes::Value;

  enum Channels
  {
    ONE,
    THREE
  };

  /// The mapping of each channel, and its inverse: the function's own values are compared.
  struct Mapping
  {
    std::function<double(double)> Map;
    std::function<double(double)> Invert;
  };

  /**
   * Samples \a nodes over \a range, ends included, and appends to \a bends, whose first texel is no
   * list. Where the mapping bends straight pieces, those of lists are halved until they are within
   * 1e-4.
   */
  TransferColumns(const TransferNodes& nodes, Channels channels, const Range& range,
    const Mapping& mapping, std::vector<float>& bends);

  std::vector<Value> Values;
  /// The lists: for each column the first texel of the list that is for the way to the next one; 0
  /// where that is straight.
  std::vector<int> Bends;
  /// The edges: for each column where its edge begins and ends, as shares of the way; 0 and 1 where
  /// it has none.
  std::vector<std::array<float, 2>> Edges;
};

}

#endif
