// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SampleIntegration_h
#define interlume_SampleIntegration_h

#include "Samples/SampleArrays.h"
#include "Samples/TerminationSides.h"
#include "Streams/StageContext.h"

#include "vtkSMPThreadLocal.h"

class vtkDataSet;
class vtkTerminationSurface;

namespace interlume
{

class SampleOrder;

/**
 * @class   SampleIntegration
 * @brief   follows the streamlines of samples, along a curve that fills space or level by level
 *
 * This is the first stage of an execution, and runs again after each level of refinement.
 */
class SampleIntegration
{
public:
  /// The progress when the samples of all levels are followed.
  static constexpr double ProgressEnd = 0.98;

  SampleIntegration(StageContext& context, vtkDataSet* samples);

  /// Follows the samples from \a first on, which a level of refinement has added, and finds on
  /// which side of their surface samples are. Returns false if the execution was aborted.
  bool Run(vtkDataSet* samples, vtkIdType first, int level);

private:
  bool Follow(const SampleOrder& order);
  /// Follows samples of a regular grid level by level: some take the results of those around them.
  bool FollowShared(const int dimensions[3]);
  void Take(vtkIdType id, const AdvectionResult& result);
  void FindSides();
  double GetProgress() const;
  bool IsShared(int dimensions[3]) const;
  /// Returns the surface with this id, and the part of it; null for faces of the domain.
  const vtkTerminationSurface* FindSurface(int id, int& part) const;
  /// Returns the distance of two places on the surface with this id.
  double GetDistance(int id, const double first[2], const double other[2]) const;

  StageContext& Context;
  double ProgressStart;
  TerminationSides Sides;
  // What is integrated now.
  vtkDataSet* Samples = nullptr;
  SampleArrays Arrays;
  vtkSMPThreadLocal<FlowReport>* Reports = nullptr;
  int Level = 0;
  vtkIdType Number = 0;
  vtkIdType Done = 0;
};

}

#endif
