// SPDX-License-Identifier: BSD-3-Clause
#ifndef CurvedGridSource_h
#define CurvedGridSource_h

#include "vtkAnalyticFlowSource.h"

#include "vtkNew.h"
#include "vtkStructuredGridAlgorithm.h"

#include <functional>

/**
 * Source of an analytic flow on a curved structured grid, which can produce any requested extent.
 */
class CurvedGridSource : public vtkStructuredGridAlgorithm
{
public:
  static CurvedGridSource* New();
  vtkTypeMacro(CurvedGridSource, vtkStructuredGridAlgorithm);

  /// Computes the position \a x of a point from its indices, which are scaled so that the whole
  /// extent is [0, 1].
  using Shape = std::function<void(const double part[3], double x[3])>;
  /// @{ Shapes: Ring is closed around the z axis, up to rounding errors. PolarGrid is a ring whose
  /// innermost points are on the axis. BentBox is a bent box.
  static void Ring(const double part[3], double x[3]);
  static void PolarGrid(const double part[3], double x[3]);
  static void BentBox(const double part[3], double x[3]);
  ///@}

  vtkNew<vtkAnalyticFlowSource> Flow;
  Shape GetPosition = BentBox;
  int WholeExtent[6] = { 2, 16, -3, 15, 1, 11 };
  int PointType = VTK_DOUBLE;
  /// If true, some cells and some points are hidden.
  bool IsBlanked = false;

protected:
  CurvedGridSource() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;
};

#endif
