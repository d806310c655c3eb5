// SPDX-License-Identifier: BSD-3-Clause
#ifndef FlowFields_h
#define FlowFields_h

#include "Benchmarks/Flow/FlowCases.h"
#include "Benchmarks/Flow/FlowReference.h"
#include "Benchmarks/Suites/BenchOptions.h"

#include <vector>

/**
 * The fields on which the suites `flow` and `flow-sharing` measure errors.
 */
namespace flow
{
struct FieldCase
{
  Case What;
  Reference Exact;
  /// A saddle that explicit methods take a hundred thousand steps in.
  bool IsStiff = false;
};

/**
 * On images over [-1, 1]^3. Linear fields, which interpolation keeps, with formulas as their
 * references: `uniform`, `rotation` around an axis outside of the image, `saddle`, `spiral`, and
 * `stiff-<ratio>`, saddles of that ratio of eigenvalues. With TrilinearFlow: `source-sink`, both
 * outside of the image, `sphere` and `abc`.
 */
std::vector<FieldCase> MakeFieldCases(const BenchOptions& options);

/**
 * On such images too: `shear`, a layer of a tenth of the width in which the velocity turns round,
 * `rotation`, `source-sink`, `sphere`, `abc`, `hurricane`, and `stiff-1e2`. Their seeds are those
 * of MakeFieldCases.
 */
std::vector<Case> MakeSharingCases(const BenchOptions& options);
}

#endif
