// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkFlowIntegrator_h
#define vtkFlowIntegrator_h

/**
 * @class   vtkFlowIntegrator
 * @brief   the methods that vtkImplicitFlowField follows streamlines by
 *
 * @sa vtkImplicitFlowField
 */
class vtkFlowIntegrator
{
public:
  enum Values
  {
    /// DORMAND_PRINCE, and ROSENBROCK where the field is stiff.
    AUTOMATIC = 0,
    /// Order 5(4) with dense output of order 4.
    DORMAND_PRINCE = 1,
    /// The classical method, its error found by doubling the step.
    RUNGE_KUTTA_4 = 2,
    /// RODAS, order 4(3), L-stable.
    ROSENBROCK = 3
  };
};

#endif
