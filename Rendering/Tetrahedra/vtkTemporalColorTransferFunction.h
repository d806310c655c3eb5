// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTemporalColorTransferFunction_h
#define vtkTemporalColorTransferFunction_h

#include "InterlumeTetrahedraModule.h" // for the export macro
#include "vtkColorTransferFunction.h"

/**
 * @class   vtkTemporalColorTransferFunction
 * @brief   colour by time: what appears, what stays and what fades between time steps
 *
 * This is a colour transfer function of the point array `Time` of vtkTimeVaryingIntervalVolume,
 * whose nodes, RGB with straight lines between them, come from the times of the steps (C. Zhang,
 * dissertation, Ohio State 2006, figures 3.21 and 3.26):
 *
 * - two steps: green at t1, yellow midway, red at t2;
 * - three steps: blue at t1, cyan midway, green at t2, yellow midway, red at t3;
 * - n steps: the map of three steps over u in [0,1]. At step i, from 0, u is i / (n - 1), and
 *   between steps it is linear in time.
 *
 * Added up over the time that a place is within the interval, the colours tell when it was: with
 * three steps and additive blending, blue faded, red appeared, and what stayed is white.
 *
 * Errors (vtkErrorMacro, the nodes stay as they were): fewer than two times, a time that is not
 * finite, times that do not increase or have no number midway between them.
 *
 * @sa vtkTimeWeightedTetrahedraMapper
 */
class INTERLUMETETRAHEDRA_EXPORT vtkTemporalColorTransferFunction : public vtkColorTransferFunction
{
public:
  static vtkTemporalColorTransferFunction* New();
  vtkTypeMacro(vtkTemporalColorTransferFunction, vtkColorTransferFunction);

  ///@{
  /**
   * Replaces all nodes by those for the steps at these times, in units of time. Default: no nodes.
   * Valid: two times or more, finite and increasing.
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
