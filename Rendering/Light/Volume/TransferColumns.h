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
 * @brief   a transfer function sampled at regular positions, with its breakpoints in between
 *
 * Most functions are linear between most columns, so that a shader needs only two values. If the
 * function changes from one value to the other in a part of the interval (a step or a steep edge),
 * that part is stored as well. For anything else, such as a peak, a list stores the function's
 * nodes in the interval, and the shader searches it. Therefore steps and peaks have their exact
 * positions even if they are narrow compared with the range in single precision.
 *
 * Differences below 1e-3 of the largest value are ignored. Inside an edge, errors up to 1e-2 of the
 * largest value, averaged over the interval, are accepted. A smooth curve therefore needs neither
 * edges nor lists, and shaders of functions without them have no code for them.
 *
 * A list consists of four-float texels. The first float of the first texel is the number of linear
 * pieces. For one channel, one texel per piece follows: start and end as fractions of the interval,
 * and the values there. For three channels, one texel per node follows, one more than pieces: the
 * fraction and three values. Two nodes at one fraction form a step.
 */
struct TransferColumns
{
  static constexpr int Columns = 4096;
  /// Resolution of edges: their ends are multiples of 1 / EdgePositions.
  static constexpr int EdgePositions = 4095;
  using Range = TransferNodes::Range;
  using Value = TransferNodes::Value;

  enum Channels
  {
    ONE,
    THREE
  };

  /// Mapping of each channel, and its inverse. Errors are measured before the mapping.
  struct Mapping
  {
    std::function<double(double)> Map;
    std::function<double(double)> Invert;
  };

  /**
   * Samples \a nodes over \a range, ends included, and appends lists to \a bends. The first texel
   * of \a bends belongs to no list. If the mapping is nonlinear, pieces of lists are bisected until
   * their error is at most 1e-4.
   */
  TransferColumns(const TransferNodes& nodes, Channels channels, const Range& range,
    const Mapping& mapping, std::vector<float>& bends);

  std::vector<Value> Values;
  /// For each column, the first texel of the list for the interval to the next column, or 0 if
  /// there is no list.
  std::vector<int> Bends;
  /// For each column, start and end of the edge as fractions of the interval to the next column, or
  /// 0 and 1 if there is no edge.
  std::vector<std::array<float, 2>> Edges;
};

}

#endif
