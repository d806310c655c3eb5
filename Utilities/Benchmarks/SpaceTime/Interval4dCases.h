// SPDX-License-Identifier: BSD-3-Clause
#ifndef Interval4dCases_h
#define Interval4dCases_h

#include "Benchmarks/Data/KeptTimeSteps.h"
#include "Benchmarks/Suites/BenchOptions.h"

#include "vtkSmartPointer.h"

#include <optional>
#include <string>
#include <vector>

class vtkTimeVaryingIntervalVolume;

/**
 * What the suite `interval4d` measures on.
 */
namespace interval4d
{
/// The counts of C. Zhang, dissertation, Ohio State 2006, table 3.4, of the data that a case stands
/// for.
struct StatedCounts
{
  vtkIdType Simplices;
  vtkIdType Tetrahedra;
};

/**
 * Time steps in memory, each with one point array, and the interval that is extracted.
 */
struct Case
{
  std::string Name;
  vtkSmartPointer<KeptTimeSteps> Steps;
  double Lower = 0.0;
  double Upper = 0.0;
  /// Of cases of the full size.
  std::optional<StatedCounts> Stated;

  vtkIdType GetNumberOfCells() const;

  /// The filter on these steps, not yet run; only port 0 is made.
  vtkSmartPointer<vtkTimeVaryingIntervalVolume> NewFilter() const;
};

/// The case that times are promised for.
inline const char* const ClaimedCase = "vortex-2";

/**
 * The names of the cases of that size, in the order of the report.
 */
std::vector<std::string> GetCaseNames(const BenchOptions& options);

/**
 * Makes a case; intervals are chosen so that the number of 4-simplices is near the one stated:
 * - `vortex-2`, `vortex-3`: vtkAnalyticFieldSource VORTEX, so many steps from time 0 a unit apart,
 *   128^3 points, 0.6 <= f <= 0.85;
 * - `wave-2`: WAVE at times 0 and 1 in the bounds given there, 40 x 20 x 20 points, 0.77 <= f <=
 *   0.97;
 * - `cylinder-2`: vtkTaperedCylinderSource at times 0 and 1, 64 x 64 x 32 points, 0.9915 <= density
 *   <= 0.9925;
 * - `delta-2`: vtkDeltaWingSource at times 0 and 1, 111 x 126 x 51 points, 0.38 <= loss <= 0.7.
 * - `mug`: the file mug.ex2, 11 steps of 2,476 unstructured hexahedra, 0.3 <= diffused <= 0.5.
 * Quick and tiny cases may have fewer points, but delta-2 and mug. Throws std::runtime_error where
 * there is no such case or its file cannot be read.
 */
Case MakeCase(const std::string& name, const BenchOptions& options);
}

#endif
