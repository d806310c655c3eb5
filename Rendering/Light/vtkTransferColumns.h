#ifndef vtkTransferColumns_h
#define vtkTransferColumns_h

#include "InterlumeLightModule.h" // for the export macro
#include "vtkTransferNodes.h"

#include <functional>
#include <vector>

/**
 * @class   vtkTransferColumns
 * @brief   a transfer function at even places, and where it bends between two of them
 *
 * Most functions are straight between most columns, where two values are all that a shader needs.
 * Where they are not - a step, a peak, a steep edge, however narrow - the list of bends has the
 * function's nodes between the two columns, which a shader searches: so steps and peaks are where
 * they are, in single precision over the range. Straight is what is within 1e-3 of the largest
 * value: a slow bend needs no list, and shaders of functions without lists have no search.
 *
 * A list is texels of four floats, the first of them the number of pieces. Of one channel, there
 * follow the pieces: the shares of the way from column to column, from 0 to 1, at which each begins
 * and ends, and the values there. Of three channels, one node more than pieces: its share and its
 * values; two of one share are a step.
 */
struct vtkTransferColumns
{
  static constexpr int Columns = 4096;
  using Range = vtkTransferNodes::Range;
  using Value = vtkTransferNodes::Value;

  enum Channels
  {
    ONE,
    THREE
  };

  /// What becomes of each channel, and its inverse: the function's own values are compared.
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
  vtkTransferColumns(const vtkTransferNodes& nodes, Channels channels, const Range& range,
    const Mapping& mapping, std::vector<float>& bends);

  std::vector<Value> Values;
  /// For each column the first texel of the list that is for the way to the next one; 0 where that
  /// is straight.
  std::vector<int> Bends;
};

#endif
