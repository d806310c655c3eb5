// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceFunction_h
#define ReferenceFunction_h

#include <array>  // for colours
#include <vector> // for nodes

class vtkColorTransferFunction;
class vtkPiecewiseFunction;

namespace reference
{

/**
 * @class   StraightFunction
 * @brief   a transfer function of straight pieces, in double
 *
 * The values are colours; those of an opacity function have three equal components. Nodes may share
 * a position, where the function jumps.
 */
class StraightFunction
{
public:
  using Value = std::array<double, 3>;

  StraightFunction() = default;
  /// Throw std::invalid_argument for pieces that are not straight: midpoints and sharpness other
  /// than VTK's default, a colour space other than RGB, a logarithmic scale.
  explicit StraightFunction(vtkColorTransferFunction* function);
  explicit StraightFunction(vtkPiecewiseFunction* function);

  /// Appends the places between 0 and 1, excluded, where an argument that goes from \a begin to
  /// \a end passes a node.
  void AppendNodes(double begin, double end, std::vector<double>& places) const;

  /// The value at \a x of the straight piece that \a inside is in.
  Value Evaluate(double x, double inside) const;
  Value Evaluate(double x) const { return this->Evaluate(x, x); }

private:
  struct Node
  {
    double X;
    Value Y;
  };

  std::vector<Node> Nodes;
  bool Clamping = true; ///< to the end values outside the nodes; else 0 there
};

}

#endif
