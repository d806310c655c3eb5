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
 * @brief   advects samples in the order of a space-filling curve, or level by level
 *
 * This is the first stage of an execution. It runs again after each level of refinement.
 */
class SampleIntegration
{
public:
  /// Progress once the samples of all levels have been advected.
  static constexpr double ProgressEnd = 0.98;

  SampleIntegration(StageContext& context, vtkDataSet* samples);

  /// Advects the samples from \a first on, which a level of refinement has added, and determines
  /// their sides. Returns false if the execution was aborted.
  bool Run(vtkDataSet* samples, vtkIdType first, int level);

private:
  bool Follow(const SampleOrder& order);
  /// Advects samples of a regular grid level by level, and interpolates some of them.
  bool FollowAndInterpolate(const int dimensions[3]);
  void Store(vtkIdType id, const AdvectionResult& result);
  void FindSides();
  double GetProgress() const;
  bool CanInterpolate(int dimensions[3]) const;
  /// Returns the surface with this id, and its part; null for domain faces.
  const vtkTerminationSurface* FindSurface(int id, int& part) const;
  /// Returns the distance between two points on the surface with this id.
  double GetDistance(int id, const double first[2], const double other[2]) const;

  StageContext& Context;
  double ProgressStart;
  TerminationSides Sides;
  // State of the current run.
  vtkDataSet* Samples = nullptr;
  SampleArrays Arrays;
  vtkSMPThreadLocal<FlowReport>* Reports = nullptr;
  int Level = 0;
  vtkIdType Number = 0;
  vtkIdType Done = 0;
};

}

#endif
