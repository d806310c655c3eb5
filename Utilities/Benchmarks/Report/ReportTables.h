// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReportTables_h
#define ReportTables_h

#include "Benchmarks/Results/BenchClaim.h"
#include "Benchmarks/Results/BenchRow.h"
#include "Pages/StabilityCase.h"

#include <string>
#include <vector>

/**
 * The parts of the report's page, as HTML. Nothing to show gives an empty text.
 */
namespace html
{
/**
 * What is claimed, and for each case what was measured; what is not met stands out.
 */
std::string TableOf(const std::vector<BenchClaim>& claims);

/**
 * One table for every run of rows that have the same fields.
 */
std::string TablesOf(const std::vector<BenchRow>& rows);

/**
 * The stability catalogue.
 */
std::string TableOf(const std::vector<StabilityCase>& cases);
}

#endif
