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
 * The sampling positions are called columns. Most functions are linear between most columns, so
 * that a shader needs only the values at two columns. If the function is constant in the interval
 * between two columns except for an edge, which is a step or a steep ramp, the start and end of the
 * edge are stored as well. For any other shape, such as a peak, the nodes in the interval are
 * stored in a breakpoint list, which the shader searches. Steps and peaks thus have accurate
 * positions even if they are much narrower than the interval.
 *
 * Errors up to 1e-3 of the largest value are accepted. Inside an edge, errors may reach 1e-2 of the
 * largest value, averaged over the interval. Smooth curves therefore need neither edges nor lists,
 * and the shaders then contain no code for them.
 *
 * A list consists of texels of four floats. The first float of the first texel is the number of
 * linear pieces. For one channel, one texel per piece follows: start and end of the piece as
 * fractions of the interval, and the values there. For three channels, one texel per node follows:
 * its position as a fraction of the interval, and three values. Two nodes at the same position form
 * a step.
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

  /// Mapping applied to each channel, and its inverse. Errors are measured in unmapped values.
  struct Mapping
  {
    std::function<double(double)> Map;
    std::function<double(double)> Invert;
  };

  /**
   * Samples \a nodes over \a range, including its ends, and appends breakpoint lists to \a bends.
   * Texel 0 of \a bends is not part of a list, since index 0 means that there is no list. If the
   * mapping is nonlinear, linear pieces are bisected until their error is at most 1e-4 of the
   * largest value.
   */
  TransferColumns(const TransferNodes& nodes, Channels channels, const Range& range,
    const Mapping& mapping, std::vector<float>& bends);

  std::vector<Value> Values;
  /// For each column, the index of the first texel of the breakpoint list for the interval to the
  /// next column, or 0 if there is no list.
  std::vector<int> Bends;
  /// For each column, start and end of the edge in the interval to the next column, as fractions of
  /// the interval, or 0 and 1 if there is no edge.
  std::vector<std::array<float, 2>> Edges;
};

}

#endif
