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
 * @brief   a transfer function as straight pieces from node to node
 *
 * Nodes ascend. Two at one place are a step, from the first one's value on the left to the second
 * one's on the right; before the first node and after the last the function has their values.
 * Clamping that is off, and colours below and above the range, are steps at the ends. Midpoints are
 * nodes, sharpness of 1 a step where VTK makes one of it (its piecewise functions do up to
 * VTK 9.2); what is curved (other sharpness, colour spaces, logarithmic scales) is halved until
 * straight pieces are within 1e-5 of it, relative to its ends.
 *
 * Values have three channels, equal ones for a vtkPiecewiseFunction.
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
  /// Takes the nodes of a function that has points.
  explicit TransferNodes(vtkPiecewiseFunction* function);
  explicit TransferNodes(vtkColorTransferFunction* function);
  ///@}
  /// Makes a ramp over a range.
  TransferNodes(const Range& range, double first, double last);

  const std::vector<Node>& GetNodes() const { return this->Nodes; }

  /// Returns the part of \a range outside which the function has the values of the part's ends,
  /// steps at the function's own ends well inside it; all of \a range where the function is level
  /// there.
  Range Limit(const Range& range) const;

  /// Returns whether the first channel changes by steps alone in \a range, none of them wider than
  /// \a width.
  bool IsStepwise(const Range& range, double width) const;

  /// The smallest value above 0 of the first channel at the nodes in \a range and at its ends; 0
  /// where there is none.
  double GetSmallestAboveZero(const Range& range) const;

  /// The value at \a x: to the right of a step there.
  Value Evaluate(double x) const;

  /**
   * Returns the largest value of the first channel in [\a range[0], \a range[1]]. Nodes no farther
   * outside than \a near[0] and near[1] count as well, and in place of ends that lie that close to
   * them, so that an end that is a node but for rounding has the node's value.
   */
  double GetLargest(const Range& range, const Range& near) const;

private:
  /// The curves between points of sharpness 0.
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
  /// The largest values of the first channel of 1, 2, 4, ... successive nodes.
  std::vector<std::vector<double>> Largest;
};

}

#endif
