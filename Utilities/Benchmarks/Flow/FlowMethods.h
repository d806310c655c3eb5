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
 * The two ways of following streamlines backward, and where they end.
 */
namespace flow
{
inline const char* const Peer = "streamtracer";

/// The most that a streamline goes on, in time, in length and in our steps: explicit methods are
/// to show what they take where a field is stiff.
constexpr double LongestTime = 5.0;
constexpr double LongestWay = 12.0;
constexpr int MostSteps = 100000;

/// Where and when one streamline ends.
struct End
{
  bool HasAnswer = false;
  double Time = 0.0;
  std::array<double, 3> Place{};
};

/// All streamlines of a run.
struct Answer
{
  std::vector<End> Ends;
  vtkIdType Steps = 0;
  /// The sum of all times.
  double Time = 0.0;
};

/**
 * vtkImplicitFlowField from the seeds to the box, not yet run. \a tolerance: MaximumError over the
 * largest speed of the field. Ready with the answer: those that reached the box.
 */
vtkSmartPointer<vtkImplicitFlowField> NewAdvection(
  const Case& what, int integrator, double tolerance);
Answer ReadAdvection(const Case& what, vtkImplicitFlowField* filter);

/// Returns a count of a report, as an integer for JSON.
inline vtkIdType GetCount(vtkInterlumeReport* report, const char* name)
{
  return static_cast<vtkIdType>(report->GetNumber(name));
}

/// Wall seconds of an update by one thread.
BenchSeconds RunOnce(vtkAlgorithm* filter);

/// How vtkStreamTracer is set.
struct TracerSettings
{
  /// One of vtkStreamTracer's: RUNGE_KUTTA2, RUNGE_KUTTA4 or RUNGE_KUTTA45.
  int Integrator = vtkStreamTracer::RUNGE_KUTTA4;
  /// RUNGE_KUTTA45: MaximumError; the others: the step in lengths of a cell.
  double Parameter = 0.5;
  /// How cells are found where the last one is left.
  CellSearch Search = CellSearch::CLOSEST_POINT;

  std::string GetName() const;
};

/**
 * vtkStreamTracer from the seeds until a step ends outside of the box, without vorticity, not yet
 * run. Its answers are its last points inside the box. \a what has to outlive it.
 */
vtkSmartPointer<vtkStreamTracer> NewTracer(const Case& what, const TracerSettings& settings);
/// A new one at each run.
BenchWork MakeTracing(const Case& what, const TracerSettings& settings);
Answer ReadTracer(const Case& what, vtkStreamTracer* tracer);
}

#endif
