// SPDX-License-Identifier: BSD-3-Clause
#ifndef FlowMethods_h
#define FlowMethods_h

#include "Benchmarks/Flow/FlowCases.h"
#include "Benchmarks/Flow/VelocityInterpolation.h"
#include "Benchmarks/Measures/BenchTiming.h"

#include "vtkImplicitFlowField.h"
#include "vtkInterlumeReport.h"
#include "vtkSmartPointer.h"
#include "vtkStreamTracer.h"
#include "vtkType.h"

#include <array>
#include <string>
#include <vector>

/**
 * Backward integration of streamlines with vtkImplicitFlowField or vtkStreamTracer, and the
 * endpoints of these streamlines.
 */
namespace flow
{
inline const char* const Baseline = "streamtracer";
inline const char* const Norm = "mean distance of the ends from the streamlines";

/// Limits of the integration time and number of steps of vtkImplicitFlowField, and of the length of
/// streamlines of vtkStreamTracer. They are large, so that rows show the cost of explicit methods
/// in stiff fields.
constexpr double MaximumTime = 5.0;
constexpr double MaximumLength = 12.0;
constexpr int MaximumSteps = 100000;

/// Endpoint of one streamline and the time to reach it.
struct End
{
  bool HasResult = false;
  double Time = 0.0;
  std::array<double, 3> Position{};
};

/// Endpoints of all streamlines of a run.
struct MethodResult
{
  std::vector<End> Ends;
  vtkIdType Steps = 0;
  /// Sum of the integration times of all streamlines.
  double Time = 0.0;
};

/**
 * Returns a filter, not yet executed, that traces from the seeds to the box. \a tolerance is
 * MaximumError divided by the maximum speed of the field. GetFlowFieldResult() returns the
 * endpoints. Their HasResult is true if the streamline reached the box.
 */
vtkSmartPointer<vtkImplicitFlowField> NewFlowField(
  const Case& what, int integrator, double tolerance);
MethodResult GetFlowFieldResult(const Case& what, vtkImplicitFlowField* filter);

/// Updates the filter with one thread and returns the run time.
BenchSeconds TimeWithOneThread(vtkAlgorithm* filter);

/// Settings of vtkStreamTracer.
struct TracerSettings
{
  /// RUNGE_KUTTA2, RUNGE_KUTTA4 or RUNGE_KUTTA45 of vtkStreamTracer.
  int Integrator = vtkStreamTracer::RUNGE_KUTTA4;
  /// MaximumError for RUNGE_KUTTA45, otherwise the step in cell lengths.
  double Parameter = 0.5;
  /// Search method for the next cell after a streamline leaves a cell.
  CellSearch Search = CellSearch::CLOSEST_POINT;

  std::string GetName() const;
};

/**
 * Returns a filter, not yet executed, that traces from the seeds without computing vorticity. A
 * streamline stops when a step ends outside the box. GetTracerResult() returns the last points
 * inside the box as endpoints. \a what must outlive the filter.
 */
vtkSmartPointer<vtkStreamTracer> NewTracer(const Case& what, const TracerSettings& settings);
/// Returns work that creates and executes a new tracer.
BenchWork MakeTracerWork(const Case& what, const TracerSettings& settings);
MethodResult GetTracerResult(const Case& what, vtkStreamTracer* tracer);
}

#endif
