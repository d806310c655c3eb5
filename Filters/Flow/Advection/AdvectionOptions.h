// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_AdvectionOptions_h
#define interlume_AdvectionOptions_h

#include "vtkFlowSettings.h"
#include "vtkFlowStatus.h"
#include "vtkType.h"

#include <vector>

class vtkTerminationSurface;

namespace interlume
{

/**
 * @class   AdvectionOptions
 * @brief   the surfaces and settings that Advection follows streamlines with, none automatic
 */
struct AdvectionOptions : vtkFlowSettings
{
  AdvectionOptions()
  {
    this->MaximumError = 1e-6;
    this->MaximumTime = VTK_DOUBLE_MAX;
    this->MaximumNumberOfSteps = 10000;
  }
  /// Takes the settings over; what is automatic in them is left to be replaced.
  explicit AdvectionOptions(const vtkFlowSettings& settings)
    : vtkFlowSettings(settings)
  {
  }

  bool IsBackward() const { return this->Direction == BACKWARD; }
  void SetBackward(bool isBackward) { this->Direction = isBackward ? BACKWARD : FORWARD; }

  /// A surface that is up to date, and the id of its first part.
  struct Surface
  {
    const vtkTerminationSurface* Shape;
    int Id;
  };
  std::vector<Surface> Surfaces;
  /// The numbers in the walker of the arrays that a mean is taken of.
  std::vector<int> MeanNumbers;
};

/**
 * @class   AdvectionEnd
 * @brief   how one streamline ended, but for means
 */
struct AdvectionEnd
{
  int Status = vtkFlowStatus::OUTSIDE;
  int Id = -1;
  double Parameters[2] = { 0.0, 0.0 };
  double Time = 0.0;
  double Position[3] = { 0.0, 0.0, 0.0 };
  double MaximumSpeed = 0.0;
  double ArcLength = 0.0;
  double MeanVorticity = 0.0;
  int Steps = 0;
  int RejectedSteps = 0;
  int StiffSteps = 0;
  int RejectedStiffSteps = 0;
  /// Those of Steps that LaneSteps took.
  int LaneSteps = 0;
  int Evaluations = 0;
  int JacobianEvaluations = 0;
  int DistanceEvaluations = 0;
  /// The distance from the surface, where the streamline did not meet it but ended near it at the
  /// end of the field.
  double Nearness = 0.0;
  int Cells = 0;

  /// Returns the number of all steps, rejected ones too.
  int GetNumberOfSteps() const
  {
    return this->Steps + this->RejectedSteps + this->StiffSteps + this->RejectedStiffSteps;
  }
};

/**
 * @class   AdvectionResult
 * @brief   how one streamline ended
 */
struct AdvectionResult : AdvectionEnd
{
  std::vector<double> Means;
};

}

#endif
