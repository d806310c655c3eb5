// SPDX-License-Identifier: BSD-3-Clause
#ifndef GrowthQuantity_h
#define GrowthQuantity_h

#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/Suites/BenchOptions.h"
#include "Benchmarks/Tetrahedra/TetrahedraMethods.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

/**
 * What the suite `growth` measures: cost against N.
 */
namespace growth
{
/**
 * The exponent of N that is expected, from Least to Most where two terms share the cost, and why.
 */
struct Theory
{
  double Least;
  double Most;
  std::string Reason;
};

/**
 * One way to do the work of a size.
 */
struct Execution
{
  /// By what was made anew, so that nothing is kept from run to run: its memory is measured.
  BenchWork Fresh;
  /// What is timed; Fresh where it is empty. It comes after Fresh.
  BenchWork Timed;
  /// Drops what Fresh keeps beyond the object that it returns; may be empty.
  std::function<void()> Forget;
};

/**
 * The work of one size, with its input made.
 */
struct Job
{
  Execution Measured;
  /// What is taken off both time and memory: the same without what N counts.
  std::optional<Execution> Without;
  /// N, known after an execution at the latest.
  std::function<double()> GetN;
  double InputKib = 0.0;
};

/**
 * Something that cost grows with.
 */
struct Quantity
{
  /// The case of its rows.
  std::string Name;
  /// What N counts, for the axis of the plot.
  std::string Counted;
  /// What is executed, for the report.
  std::string Work;
  /// What Make is called with, from the smallest.
  std::vector<int> Sizes;
  /// Of the processor time of all threads.
  Theory Time;
  Theory Memory;
  std::function<Job(int size, const BenchOptions& options)> Make;
};

///@{
/**
 * Extraction from the wavelet, which has the same waves at every size: the interval volume and the
 * contour against cells, the interval volume of one size against threads.
 */
Quantity MakeCells(const BenchOptions& options);
Quantity MakeContour(const BenchOptions& options);
Quantity MakeThreads(const BenchOptions& options);
///@}

///@{
/**
 * vtkTimeVaryingIntervalVolume against 4-simplices, of a growing interval on one grid; against the
 * cells of a gyroid that moves; and against the slabs between its time steps, which have equal
 * work. Also vtkTimeSlabWriter on these slabs, into a temporary directory.
 */
Quantity MakeSimplices(const BenchOptions& options);
Quantity MakeCellsInTime(const BenchOptions& options);
Quantity MakeSteps(const BenchOptions& options);
Quantity MakeWrittenSteps(const BenchOptions& options);
///@}

///@{
/**
 * Memory of the first frame of a new mapper and time of later frames, each after a small turn.
 * Lights are measured over the same image without shadows.
 */
Quantity MakeTetrahedra(const BenchOptions& options, const tetrahedra::RenderPath& path);
Quantity MakeSlices(const BenchOptions& options);
Quantity MakeLights(const BenchOptions& options);
///@}

/// vtkImplicitFlowField against samples.
Quantity MakeSamples(const BenchOptions& options);

/**
 * Every quantity, with the sizes of \a options, in the order of the report.
 */
std::vector<Quantity> MakeQuantities(const BenchOptions& options);
}

#endif
