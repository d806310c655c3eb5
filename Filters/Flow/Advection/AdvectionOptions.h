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
 * @brief   termination surfaces and settings of Advection
 *
 * Advection requires that the caller has replaced all automatic settings with values.
 */
struct AdvectionOptions : vtkFlowSettings
{
  AdvectionOptions()
  {
    this->MaximumError = 1e-6;
    this->MaximumTime = VTK_DOUBLE_MAX;
    this->MaximumNumberOfSteps = 10000;
  }
  /// Copies the settings. The caller must replace automatic values.
  explicit AdvectionOptions(const vtkFlowSettings& settings)
    : vtkFlowSettings(settings)
  {
  }

  bool IsBackward() const { return this->Direction == BACKWARD; }
  void SetBackward(bool isBackward) { this->Direction = isBackward ? BACKWARD : FORWARD; }

  /// Surface on which Update has been called, and the id of its first part.
  struct Surface
  {
    const vtkTerminationSurface* Shape;
    int Id;
  };
  std::vector<Surface> Surfaces;
  /// Arrays to average along the streamline, as indices for CellWalker's Interpolate().
  std::vector<int> MeanNumbers;
};

/**
 * @class   AdvectionEnd
 * @brief   end point and other results of one streamline, without the averages of arrays
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
  /// Number of steps, included in Steps, that SimdDormandPrince took.
  int SimdSteps = 0;
  int Evaluations = 0;
  int JacobianEvaluations = 0;
  int DistanceEvaluations = 0;
  /// Tolerance that was applied if the streamline reached a surface at the boundary of the field,
  /// or 0 if it intersected the surface.
  double Nearness = 0.0;
  int Cells = 0;

  /// Returns the number of all steps, including rejected ones.
  int GetNumberOfSteps() const
  {
    return this->Steps + this->RejectedSteps + this->StiffSteps + this->RejectedStiffSteps;
  }
};

/**
 * @class   AdvectionResult
 * @brief   end point and other results of one streamline, including the averages of arrays
 */
struct AdvectionResult : AdvectionEnd
{
  std::vector<double> Means;
};

}

#endif
