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
 * The parts of the report's page, as HTML. Nothing to show gives an empty text.
 */
namespace html
{
/// A claim, and the suite that measures it.
struct SuiteClaim
{
  std::string Suite;
  BenchClaim Claim;
};

/// A plot, and the suite that measures it.
struct SuitePlot
{
  std::string Suite;
  BenchPlot Plot;
};

/// What is read by those who ask for it.
std::string Folded(const std::string& summary, const std::string& content);

/**
 * How many defaults are on their front, then each question with its plot, which links to its
 * picture, the sentence that answers it and the plot's conditions.
 */
std::string FiguresOf(const std::vector<SuitePlot>& questions);

/**
 * What is claimed, and for each case what was measured: claims that are not met first, and what is
 * not met stands out.
 */
std::string TableOf(const std::vector<SuiteClaim>& claims);

/**
 * One table, with a column for each field that a row has, in the order that they come in.
 */
std::string TableOf(const std::vector<BenchRow>& rows);

/**
 * The stability catalogue, and the numbers of its cases a class.
 */
std::string TableOf(const std::vector<StabilityCase>& cases);
std::string TableOf(const std::vector<StabilityCount>& counts);
}

#endif
