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
 * @class   AdvectionState
 * @brief   all that is known of a streamline that enters a cell, to go on with it elsewhere
 *
 * Steps never see more than one cell, so that a streamline which goes on from its state in the cell
 * has the bytes of one that was not interrupted. What has a fixed size can be copied as bytes.
 */
struct AdvectionState
{
  struct Fixed
  {
    AdvectionEnd Result;
    vtkIdType Cell = -1;
    double Point[3] = { 0.0, 0.0, 0.0 };
    /// Whether the streamline stands in the cell of its start, and nothing is known but that.
    bool IsAtStart = true;
    double Size = 0.0;
    double Time = 0.0;
    double Step = 0.0;
    vtkIdType CellBefore = -1;
    int Crossings = 0;
    int Evaluations = 0;
    int JacobianEvaluations = 0;
    StepController Controller;
    StiffnessTest Stiffness;
    StagnationTest Stagnation;
    RecurrenceTest Recurrence;
  };
  Fixed Values;
  /// What is known of each surface, and the sums of further quantities.
  std::vector<double> Numbers;
};

}

#endif
