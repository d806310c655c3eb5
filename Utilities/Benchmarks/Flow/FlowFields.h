// SPDX-License-Identifier: BSD-3-Clause
#ifndef FlowFields_h
#define FlowFields_h

#include "Benchmarks/Flow/FlowCases.h"
#include "Benchmarks/Flow/FlowReference.h"
#include "Benchmarks/Suites/BenchOptions.h"

#include <vector>

/**
 * Fields for the error measurements in the suites `flow` and `flow-sharing`.
 */
namespace flow
{
struct FieldCase
{
  Case What;
  Reference Exact;
  /// Whether the field is a saddle in which explicit methods require a hundred thousand steps.
  bool IsStiff = false;
};

/**
 * Returns fields on images over [-1, 1]^3. The linear fields are `uniform`, `rotation` (around an
 * axis outside the image), `saddle`, `spiral`, and `stiff-<ratio>` (a saddle with this ratio of
 * eigenvalues). Interpolation reproduces them exactly, so their references are formulas. The
 * reference of `source-sink` (with source and sink outside the image), `sphere` and `abc` is
 * TrilinearFlow.
 */
std::vector<FieldCase> MakeFieldCases(const BenchOptions& options);

/**
 * Returns fields on images over [-1, 1]^3. The seeds are those of MakeFieldCases. The fields are
 * `shear` (whose velocity reverses across a layer of thickness 0.1), `rotation`, `source-sink`,
 * `sphere`, `abc`, `hurricane`, and `stiff-1e2`.
 */
std::vector<Case> MakeSharingCases(const BenchOptions& options);
}

#endif
