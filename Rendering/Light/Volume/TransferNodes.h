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
 * Nodes are in ascending order. Two nodes at one position form a step from the value of the first
 * node on the left to the value of the second on the right. The function is constant before the
 * first node and after the last. If clamping is off, or if there are colors below and above the
 * range, there are steps at the ends.
 *
 * Midpoints are nodes. A sharpness of 1 is a step in those VTK versions that draw one (piecewise
 * functions up to VTK 9.2). Curves (other sharpness, color spaces, logarithmic scales) are bisected
 * until the error of the linear pieces is at most 1e-5, relative to the values at the ends.
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
  /// Convert a function that has points.
  explicit TransferNodes(vtkPiecewiseFunction* function);
  explicit TransferNodes(vtkColorTransferFunction* function);
  ///@}
  /// Creates a ramp over a range.
  TransferNodes(const Range& range, double first, double last);

  const std::vector<Node>& GetNodes() const { return this->Nodes; }

  /// Returns the part of \a range outside which the function keeps its values at the ends of the
  /// part. Steps at the ends of the function are well inside the part. Returns \a range if the
  /// function is constant there.
  Range Limit(const Range& range) const;

  /// Returns true if the first channel changes only by steps in \a range, none of them wider than
  /// \a width.
  bool IsStepwise(const Range& range, double width) const;

  /// Returns the smallest positive value of the first channel at the nodes in \a range and at the
  /// ends of \a range, or 0 if no value is positive.
  double GetSmallestAboveZero(const Range& range) const;

  /// Returns the value at \a x. At a step, returns the value on its right.
  Value Evaluate(double x) const;

  /**
   * Returns the largest value of the first channel in [\a range[0], \a range[1]]. The range also
   * includes nodes up to \a near[0] below and \a near[1] above. If an end lies that close to a
   * node, the node's value replaces the value at the end. An end that equals a node up to rounding
   * error then has the node's value.
   */
  double GetLargest(const Range& range, const Range& near) const;

private:
  /// Type of the curves between points of sharpness 0.
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
  /// Maxima of the first channel over 1, 2, 4, ... successive nodes.
  std::vector<std::vector<double>> Largest;
};

}

#endif
