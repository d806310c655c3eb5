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
 * @brief   the part of AdvectionState that has a fixed size, and can be copied as bytes
 */
struct StreamlineState
{
  AdvectionEnd Result;
  vtkIdType Cell = -1;
  double Point[3] = { 0.0, 0.0, 0.0 };
  /// If true, nothing is known except the cell of the start.
  bool IsAtStart = true;
  /// The size of the first cell, in world units.
  double Size = 0.0;
  double Time = 0.0;
  /// The time of a step that the error allows.
  double Step = 0.0;
  /// The cell that the last step has left, and the number of faces crossed since a step took time.
  vtkIdType CellBefore = -1;
  int Crossings = 0;
  StepController Controller;
  StiffnessTest Stiffness;
  StagnationTest Stagnation;
  RecurrenceTest Recurrence;
};

/**
 * @class   AdvectionState
 * @brief   all that is known of a streamline that enters a cell, to continue it elsewhere
 *
 * Steps never see more than one cell. Therefore a streamline that continues from its state in the
 * cell has the bytes of one that was not interrupted.
 */
struct AdvectionState
{
  StreamlineState Values;
  /// What is known of each surface, and the sums of further quantities.
  std::vector<double> Numbers;
};

}

#endif
