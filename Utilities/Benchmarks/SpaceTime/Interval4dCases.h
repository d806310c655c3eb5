// SPDX-License-Identifier: BSD-3-Clause
#ifndef Interval4dCases_h
#define Interval4dCases_h

#include "Benchmarks/Data/StoredTimeSteps.h"
#include "Benchmarks/Suites/BenchOptions.h"

#include "vtkSmartPointer.h"

#include <optional>
#include <string>
#include <vector>

class vtkTimeVaryingIntervalVolume;

/**
 * Input data of the suite `interval4d`.
 */
namespace interval4d
{
/// Counts stated in table 3.4 of C. Zhang's dissertation (Ohio State 2006) for the original data,
/// which the case replaces.
struct StatedCounts
{
  vtkIdType Simplices;
  vtkIdType Tetrahedra;
};

/**
 * Time steps in memory, each with one point array, and the interval to extract.
 */
struct Case
{
  std::string Name;
  vtkSmartPointer<StoredTimeSteps> Steps;
  double Lower = 0.0;
  double Upper = 0.0;
  /// Empty for `mug`, and for other cases with fewer points than in full runs.
  std::optional<StatedCounts> Stated;

  vtkIdType GetNumberOfCells() const;

  /// Returns a filter for these steps that has not been executed yet. Only the output of port 0 is
  /// generated.
  vtkSmartPointer<vtkTimeVaryingIntervalVolume> NewFilter() const;
};

/// The case for which claims about run times are checked.
inline const char* const ClaimedCase = "vortex-2";

/**
 * Returns the names of the cases of the given size, in the order in which they are reported.
 */
std::vector<std::string> GetCaseNames(const BenchOptions& options);

/**
 * Returns a case. Intervals are chosen so that the number of 4-simplices is close to the number
 * stated in the dissertation:
 * - `vortex-2`, `vortex-3`: vtkAnalyticFieldSource VORTEX at times 0 and 1, or 0, 1 and 2, 128^3
 *   points, 0.6 <= f <= 0.85;
 * - `wave-2`: vtkAnalyticFieldSource WAVE at times 0 and 1 in its documented bounds, 40 x 20 x 20
 *   points, 0.77 <= f <= 0.97;
 * - `cylinder-2`: vtkTaperedCylinderSource at times 0 and 1, 64 x 64 x 32 points, 0.9915 <= density
 *   <= 0.9925;
 * - `delta-2`: vtkDeltaWingSource at times 0 and 1, 111 x 126 x 51 points, 0.38 <= loss <= 0.7;
 * - `mug`: the file mug.ex2, 11 steps of 2,476 unstructured hexahedra, 0.3 <= diffused <= 0.5.
 * Quick and tiny cases may have fewer points, except delta-2 and mug. Throws std::runtime_error if
 * the case does not exist or its file cannot be read.
 */
Case MakeCase(const std::string& name, const BenchOptions& options);
}

#endif
