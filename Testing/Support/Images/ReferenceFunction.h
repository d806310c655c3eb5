// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceFunction_h
#define ReferenceFunction_h

#include <array>  // for colors
#include <vector> // for nodes

class vtkColorTransferFunction;
class vtkPiecewiseFunction;

namespace reference
{

/**
 * @class   PiecewiseLinearFunction
 * @brief   piecewise linear transfer function in double precision
 *
 * The values are colors. An opacity function has three equal components. The function jumps where
 * two nodes have the same position.
 */
class PiecewiseLinearFunction
{
public:
  using Value = std::array<double, 3>;

  PiecewiseLinearFunction() = default;
  /// Throw std::invalid_argument if a midpoint or sharpness is not VTK's default, the color space
  /// is not RGB, or the scale is logarithmic.
  explicit PiecewiseLinearFunction(vtkColorTransferFunction* function);
  explicit PiecewiseLinearFunction(vtkPiecewiseFunction* function);

  /// Appends the positions strictly between 0 and 1 where an argument that changes linearly from \a
  /// begin to \a end passes a node.
  void AppendNodes(double begin, double end, std::vector<double>& positions) const;

  /// Evaluates at \a x the linear piece that contains \a inside.
  Value Evaluate(double x, double inside) const;
  Value Evaluate(double x) const { return this->Evaluate(x, x); }

private:
  struct Node
  {
    double X;
    Value Y;
  };

  std::vector<Node> Nodes;
  bool Clamping = true; ///< if true, constant outside the nodes, otherwise 0
};

}

#endif
