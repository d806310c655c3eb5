// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_AdvectionOptions_h
#define interlume_AdvectionOptions_h

#include "vtkFlowStatus.h"
#include "vtkType.h"

#include <vector>

class vtkTerminationSurface;

namespace interlume
{

/**
 * @class   AdvectionOptions
 * @brief   the surfaces and settings that Advection follows streamlines with; values as in
 * vtkImplicitFlowField, none automatic
 */
struct AdvectionOptions
{
  /// A surface that is up to date, and the id of its first part.
  struct Surface
  {
    const vtkTerminationSurface* Shape;
    int Id;
  };
  std::vector<Surface> Surfaces;
  bool HasDomainFaces = false;
  int DomainFaceId = 0;
  bool IsBackward = true;
  int Integrator = 0;
  double MaximumError = 1e-6;
  double MaximumTime = VTK_DOUBLE_MAX;
  int MaximumNumberOfSteps = 10000;
  double MinimumSpeed = 0.0;
  double ArrivalTolerance = 0.01;
  /// The further quantities that are kept; arrays are given by their numbers in the walker.
  bool HasMaximumSpeed = false;
  bool HasArcLength = false;
  bool HasMeanVorticity = false;
  std::vector<int> MeanArrays;
};

/**
 * @class   AdvectionResult
 * @brief   how one streamline ended
 */
struct AdvectionResult
{
  int Status = vtkFlowStatus::OUTSIDE;
  int Id = -1;
  double Parameters[2] = { 0.0, 0.0 };
  double Time = 0.0;
  double Position[3] = { 0.0, 0.0, 0.0 };
  double MaximumSpeed = 0.0;
  double ArcLength = 0.0;
  double MeanVorticity = 0.0;
  std::vector<double> Means;
  int Steps = 0;
  int RejectedSteps = 0;
  int StiffSteps = 0;
  int RejectedStiffSteps = 0;
  int Evaluations = 0;
  int JacobianEvaluations = 0;
  int DistanceEvaluations = 0;
  /// The distance from the surface, where the streamline did not meet it but ended near it at the
  /// end of the field.
  double Nearness = 0.0;
  int Cells = 0;
};

}

#endif
