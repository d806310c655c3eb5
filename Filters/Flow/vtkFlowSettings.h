// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkFlowSettings_h
#define vtkFlowSettings_h

#include <string> // for array names
#include <vector> // for lists of names

/**
 * @class   vtkFlowSettings
 * @brief   settings of vtkImplicitFlowField, with their defaults
 *
 * The filter inherits from this struct, so that VTK's setter macros work and the settings can be
 * passed on together. See the setters of vtkImplicitFlowField for their meaning.
 *
 * @sa vtkImplicitFlowField
 */
struct vtkFlowSettings
{
  /// BACKWARD follows streamlines against the vectors, FORWARD along them.
  enum Directions
  {
    BACKWARD = 0,
    FORWARD = 1
  };

  enum Integrators
  {
    /// DORMAND_PRINCE, and ROSENBROCK where the field is stiff.
    AUTOMATIC = 0,
    /// Order 5(4) with dense output of order 4.
    DORMAND_PRINCE = 1,
    /// Classical method, error estimated by step doubling.
    RUNGE_KUTTA_4 = 2,
    /// RODAS, order 4(3), L-stable.
    ROSENBROCK = 3
  };

  bool DomainFaces = false;
  int DomainFaceId = 1000;
  int Direction = BACKWARD;
  int Integrator = AUTOMATIC;
  double MaximumError = 0.0;
  double MaximumTime = 0.0;
  int MaximumNumberOfSteps = 0;
  double MinimumSpeed = 0.0;
  double ArrivalTolerance = 0.01;
  bool ComputeMaximumSpeed = false;
  bool ComputeArcLength = false;
  bool ComputeMeanVorticity = false;
  bool ComputeLocalAttributes = false;
  std::vector<std::string> MeanArrays;
  bool InterpolateStreamlines = false;
  bool StoreStepCounts = false;
  int RefinementLevels = 0;
  int SamplingChecks = 1000;
};

#endif
