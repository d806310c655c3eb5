// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTemporalColorTransferFunction_h
#define vtkTemporalColorTransferFunction_h

#include "InterlumeTetrahedraModule.h" // for the export macro
#include "vtkColorTransferFunction.h"

/**
 * @class   vtkTemporalColorTransferFunction
 * @brief map time to colors that distinguish regions that appear, persist or disappear
 *
 * The transfer function maps the point array `Time` of vtkTimeVaryingIntervalVolume to RGB.
 * SetTimes derives its nodes from the times of the time steps, and colors are linear between nodes
 * (C. Zhang, dissertation, Ohio State 2006, figures 3.21 and 3.26):
 *
 * - two steps: green at t1, yellow midway, red at t2;
 * - three steps: blue at t1, cyan midway, green at t2, yellow midway, red at t3;
 * - n steps: the colors of three steps, as a function of u in [0,1]. At step i (from 0), u is i /
 *   (n - 1), and it is linear in time between steps.
 *
 * With additive blending, the sum of the colors over time shows when a location was inside the
 * interval. For three steps, blue regions disappear, red regions appear, and white regions persist.
 *
 * Errors (vtkErrorMacro, the nodes remain unchanged): fewer than two times, a time that is not
 * finite, times that do not increase, and times so close that no floating-point number lies midway
 * between them.
 *
 * @sa vtkTimeWeightedTetrahedraMapper vtkTimeVaryingIntervalVolume
 */
class INTERLUMETETRAHEDRA_EXPORT vtkTemporalColorTransferFunction : public vtkColorTransferFunction
{
public:
  static vtkTemporalColorTransferFunction* New();
  vtkTypeMacro(vtkTemporalColorTransferFunction, vtkColorTransferFunction);

  ///@{
  /**
   * Replace all nodes with the nodes for these time steps. Default: no nodes. Valid: at least two
   * times, finite and increasing.
   */
  void SetTimes(int n, const double* times) VTK_SIZEHINT(times, n);
  void SetTimes(double t1, double t2);
  ///@}

protected:
  vtkTemporalColorTransferFunction() = default;
  ~vtkTemporalColorTransferFunction() override = default;

private:
  vtkTemporalColorTransferFunction(const vtkTemporalColorTransferFunction&) = delete;
  void operator=(const vtkTemporalColorTransferFunction&) = delete;
};

#endif
