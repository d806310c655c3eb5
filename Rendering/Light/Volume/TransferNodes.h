// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TransferNodes_h
#define interlume_TransferNodes_h

#include <array>
#include <cstddef>
#include <vector>

class vtkColorTransferFunction;
class vtkPiecewiseFunction;

namespace interlume
{

/**
 * @class   TransferNodes
 * @brief   a transfer function as a piecewise linear function
 *
 * Nodes are in ascending order. Two nodes at the same position form a step from the value of the
 * first node to that of the second. The function is constant before the first node and after the
 * last. If the VTK function is not clamped, or has colors below or above its range, there are steps
 * at the ends.
 *
 * Midpoints become nodes. A sharpness of 1 becomes a step if it is one in the VTK version in use
 * (piecewise functions up to VTK 9.2). Curves, which result from the sharpness, the color space or
 * a logarithmic scale, are bisected until the error of the linear pieces is at most 1e-5, relative
 * to the values at the ends.
 *
 * Values have three channels, which are equal for a vtkPiecewiseFunction.
 */
class TransferNodes
{
public:
  using Value = std::array<double, 3>;
  using Range = std::array<double, 2>;

  struct Node
  {
    double X;
    Value Y;
  };

  TransferNodes() = default;
  ///@{
  /// Convert \a function, which must have at least one point.
  explicit TransferNodes(vtkPiecewiseFunction* function);
  explicit TransferNodes(vtkColorTransferFunction* function);
  ///@}
  /// Creates a ramp from \a first to \a last over \a range.
  TransferNodes(const Range& range, double first, double last);

  const std::vector<Node>& GetNodes() const { return this->Nodes; }

  /// Returns the part of \a range between the first and last node, outside which the function is
  /// constant. If the function begins or ends with a step, the part extends past it by a margin. If
  /// the part is empty or too narrow, returns \a range.
  Range ClipRange(const Range& range) const;

  /// Returns true if the first channel changes only in steps in \a range. Ramps up to \a width wide
  /// count as steps.
  bool IsStepwise(const Range& range, double width) const;

  /// Returns the smallest positive value of the first channel at the nodes in \a range and at the
  /// ends of \a range, or 0 if no value is positive.
  double GetSmallestAboveZero(const Range& range) const;

  /// Returns the value at \a x. At a step, returns the value to the right of the step.
  Value Evaluate(double x) const;

  /**
   * Returns the largest value of the first channel in [\a range[0], \a range[1]]. An end of the
   * range may differ from a node by rounding errors: nodes up to \a near[0] below and \a near[1]
   * above the range are included, and if there is a node that close to an end, the value at the end
   * itself is ignored.
   */
  double GetLargest(const Range& range, const Range& near) const;

private:
  /// Shape of the function between two points with a sharpness of 0.
  enum Curve
  {
    STRAIGHT,
    CURVED,
    LOGARITHMIC
  };

  template <std::size_t Channels, typename Transfer, typename Function>
  void AddFunction(Transfer* transfer, const Function& function, Curve curve);
  template <typename Function>
  void AddCurve(const Function& function, const Node& a, const Node& b, double scale, int depth);
  template <typename Function>
  void AddSegment(const Function& function, const Node& a, const Node& b, double midpoint,
    double sharpness, bool steps, Curve curve);
  void Add(double x, const Value& y);
  void FindLargest();

  std::vector<Node> Nodes;
  /// Largest[i][j] is the maximum of the first channel over the 2^i nodes from node j.
  std::vector<std::vector<double>> Largest;
};

}

#endif
