#ifndef FlowTolerances_h
#define FlowTolerances_h

#include "BenchClaim.h"
#include "BenchOptions.h"
#include "BenchPlot.h"
#include "BenchRow.h"

#include <vector>

/**
 * The part of the suite `flow` about errors that formulas tell: fields that interpolation keeps.
 */
namespace flow
{
/**
 * Each integrator, which is the method, at each tolerance, which is the parameter, by one thread,
 * against the formula of where the field carries a sample in the time that was found. Cases:
 * `uniform`, `saddle`, `spiral`, and `stiff-<ratio>`, saddles of that ratio of eigenvalues.
 */
void AddToleranceRows(const BenchOptions& options, BenchRows& rows);

std::vector<BenchClaim> CheckToleranceClaims(const std::vector<BenchRow>& rows);
/// Error against run time, a plot for each case.
std::vector<BenchPlot> MakeTolerancePlots(const std::vector<BenchRow>& rows);
}

#endif
