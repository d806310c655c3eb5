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
 * @brief   advects samples in the order of a space-filling curve, or with interpolation
 * (StreamlineInterpolation)
 *
 * This is the first stage of an execution. It runs again after each level of refinement.
 */
class SampleIntegration
{
public:
  /// Progress of the execution after the samples of all refinement levels have been advected.
  static constexpr double ProgressEnd = 0.98;

  SampleIntegration(StageContext& context, vtkDataSet* samples);

  /// Advects the samples with ids from \a first on, which are new at this refinement level, and
  /// determines the sides of all samples. Returns false if the execution was aborted.
  bool Run(vtkDataSet* samples, vtkIdType first, int level);

private:
  bool Follow(const SampleOrder& order);
  /// Advects some of the samples on a grid with the given dimensions, and interpolates the others.
  bool AdvectAndInterpolate(const int dimensions[3]);
  void Store(vtkIdType id, const AdvectionResult& result);
  void FindSides();
  double GetProgress() const;
  bool CanInterpolate(int dimensions[3]) const;
  /// Returns the surface with the given id, and the index of its part with that id; null for domain
  /// faces.
  const vtkTerminationSurface* FindSurface(int id, int& part) const;
  /// Returns the distance between two points, given by (u,v), on the surface with the given id.
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
