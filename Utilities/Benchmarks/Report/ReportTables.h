// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReportTables_h
#define ReportTables_h

#include "Benchmarks/Results/BenchClaim.h"
#include "Benchmarks/Results/BenchPlot.h"
#include "Benchmarks/Results/BenchRow.h"
#include "Support/Pages/StabilityCase.h"

#include <string>
#include <vector>

/**
 * Parts of the report page in HTML. Functions return an empty string if there is nothing to show.
 */
namespace html
{
/// A claim and its suite.
struct SuiteClaim
{
  std::string Suite;
  BenchClaim Claim;
};

/// A plot and its suite.
struct SuitePlot
{
  std::string Suite;
  BenchPlot Plot;
};

/// Returns a collapsed section.
std::string Folded(const std::string& summary, const std::string& content);

/**
 * Returns the number of questions whose default setting is on the Pareto front, then each question
 * with its plot (a link to the image file), its conclusion and the plot's conditions.
 */
std::string FiguresOf(const std::vector<SuitePlot>& questions);

/**
 * Returns a table of claims with the measured number of each case. Missed claims come first, and
 * missed cases are highlighted.
 */
std::string TableOf(const std::vector<SuiteClaim>& claims);

/**
 * Returns one table with a column for each field that occurs in the rows, in order of appearance.
 */
std::string TableOf(const std::vector<BenchRow>& rows);

/**
 * Return the table of the stability catalog, and the table of the number of cases per class.
 */
std::string TableOf(const std::vector<StabilityCase>& cases);
std::string TableOf(const std::vector<StabilityCount>& counts);
}

#endif
