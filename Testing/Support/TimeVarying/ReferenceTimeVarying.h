// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceTimeVarying_h
#define ReferenceTimeVarying_h

#include "Support/Intervals/ReferenceExtraction.h"  // for the intervals
#include "Support/Meshes/ReferenceVolume.h"         // for the criteria
#include "Support/TimeVarying/ReferenceTemporal.h"  // for the source
#include "Support/TimeVarying/ReferenceTimeSteps.h" // for the steps

#include "vtkNew.h"                       // for the pipeline
#include "vtkTimeVaryingIntervalVolume.h" // for the pipeline

#include <array>  // for the direction
#include <vector> // for the intervals

namespace reference
{

/// Settings of the filter under test, whose output points are always in double precision.
struct TimeVaryingSettings
{
  std::vector<Interval> Intervals;
  std::array<double, 4> Direction = { 0, 0, 0, 1 };
  std::array<int, 2> Steps = { 0, VTK_INT_MAX };
  bool Tetrahedra = true;
  bool Boundaries = true;
  bool Simplices = true;
  std::vector<Range> Criteria = {};
  int CriteriaOperation = vtkIntervalAlgorithm::INTERSECTION;
};

void Apply(const TimeVaryingSettings& settings, vtkTimeVaryingIntervalVolume* filter);

/// A source of time steps, connected to the filter under test.
struct TimeVaryingPipeline
{
  vtkNew<TimeStepSource> Source;
  vtkNew<vtkTimeVaryingIntervalVolume> Filter;

  TimeVaryingPipeline(const TimeSteps& steps, const TimeVaryingSettings& settings);
};

struct TimeVaryingExtraction
{
  vtkSmartPointer<vtkUnstructuredGrid> Tetrahedra; ///< port 0
  vtkSmartPointer<vtkUnstructuredGrid> Boundaries; ///< port 1
  vtkSmartPointer<vtkUnstructuredGrid> Simplices;  ///< port 2
  ReportCopy Report;
};

/// Runs the filter under test once on the active scalars.
TimeVaryingExtraction ExtractTimeVarying(
  const TimeSteps& steps, const TimeVaryingSettings& settings);

}

#endif
