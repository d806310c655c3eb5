// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkFlowSettings_h
#define vtkFlowSettings_h

#include <string> // for names of arrays
#include <vector> // for several of them

/**
 * @class   vtkFlowSettings
 * @brief   what vtkImplicitFlowField can be told of its streamlines, with its defaults
 *
 * The filter is made of them, so that VTK's macros for setters serve them, and hands them on as a
 * whole. Each is documented at its setter there.
 *
 * @sa vtkImplicitFlowField
 */
struct vtkFlowSettings
{
  /// The directions are against the vectors and along them.
  enum Directions
  {
    BACKWARD = 0,
    FORWARD = 1
  };

  enum Integrators
  {
    /// DORMAND_PRINCE, and ROSENBROCK where the field is stiff.
    AUTOMATIC = 0,
    /// The method is of order 5(4) with dense output of order 4.
    DORMAND_PRINCE = 1,
    /// The classical method finds its error by doubling the step.
    RUNGE_KUTTA_4 = 2,
    /// RODAS is of order 4(3) and L-stable.
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
  std::vector<std::string> MeanArrays;
  bool ShareStreamlines = false;
  bool KeepSteps = false;
  int RefinementLevels = 0;
  int SamplingChecks = 1000;
};

#endif
