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
 * Parts of the report page in HTML. Empty tables and sections are omitted.
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

/// Returns a section that is initially collapsed. \a content is HTML.
std::string MakeCollapsedSection(const std::string& summary, const std::string& content);

/**
 * Returns the number of questions whose default setting is on the Pareto front, and a figure for
 * each question: its plot (a link to the image file), conclusion and conditions.
 */
std::string FiguresOf(const std::vector<SuitePlot>& questions);

/**
 * Returns a table of claims with the measured number in each case. Missed claims come first, and
 * cases that miss the target are highlighted.
 */
std::string TableOf(const std::vector<SuiteClaim>& claims);

/**
 * Returns a table with a column for each field that occurs in the rows, in order of appearance.
 */
std::string TableOf(const std::vector<BenchRow>& rows);

/**
 * Return a table of the stability catalog, and a table of the number of cases per class.
 */
std::string TableOf(const std::vector<StabilityCase>& cases);
std::string TableOf(const std::vector<StabilityCount>& counts);
}

#endif
