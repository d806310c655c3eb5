// SPDX-License-Identifier: BSD-3-Clause
#ifndef CurvedGridSource_h
#define CurvedGridSource_h

#include "vtkAnalyticFlowSource.h"

#include "vtkNew.h"
#include "vtkStructuredGridAlgorithm.h"

#include <functional>

/**
 * An analytic flow on a structured grid, for any requested extent.
 */
class CurvedGridSource : public vtkStructuredGridAlgorithm
{
public:
  static CurvedGridSource* New();
  vtkTypeMacro(CurvedGridSource, vtkStructuredGridAlgorithm);

  /// Computes the position of a point from its indices, which are mapped to the range 0 to 1 over
  /// the whole extent.
  using Shape = std::function<void(const double part[3], double x[3])>;
  /// @{ A closed ring around an axis whose first and last angles differ by rounding errors, a ring
  /// with its innermost points on the axis, and a bent box.
  static void Ring(const double part[3], double x[3]);
  static void Pole(const double part[3], double x[3]);
  static void Bow(const double part[3], double x[3]);
  ///@}

  vtkNew<vtkAnalyticFlowSource> Flow;
  Shape GetPosition = Bow;
  int WholeExtent[6] = { 2, 16, -3, 15, 1, 11 };
  int PointType = VTK_DOUBLE;
  /// Hides some cells and some points.
  bool IsBlanked = false;

protected:
  CurvedGridSource() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;
};

#endif
