// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_AdvectionState_h
#define interlume_AdvectionState_h

#include "Advection/AdvectionOptions.h"
#include "Advection/RecurrenceTest.h"
#include "Advection/StagnationTest.h"
#include "Advection/StepController.h"
#include "Advection/StiffnessTest.h"

#include <vector>

namespace interlume
{

/**
 * @class   StreamlineState
 * @brief   fixed-size part of AdvectionState, which can be copied bytewise
 */
struct StreamlineState
{
  AdvectionEnd Result;
  vtkIdType Cell = -1;
  double Point[3] = { 0.0, 0.0, 0.0 };
  /// If true, only Cell and Result.Position are valid.
  bool IsAtStart = true;
  /// Size of the first cell in world units.
  double Size = 0.0;
  double Time = 0.0;
  /// Duration of the next step as allowed by the error control.
  double Step = 0.0;
  /// Cell that the streamline left at the last crossing, and number of faces crossed since Time
  /// last increased.
  vtkIdType CellBefore = -1;
  int Crossings = 0;
  StepController Controller;
  StiffnessTest Stiffness;
  StagnationTest Stagnation;
  RecurrenceTest Recurrence;
};

/**
 * @class   AdvectionState
 * @brief   complete state of a streamline that enters a cell
 *
 * The state allows another process to continue the streamline. A step reads only one cell.
 * Therefore a resumed streamline is bit-identical to an uninterrupted one.
 */
struct AdvectionState
{
  StreamlineState Values;
  /// The numbers that SurfaceCrossing and PathIntegrals save.
  std::vector<double> Numbers;
};

}

#endif
