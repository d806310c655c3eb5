// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReportPage_h
#define ReportPage_h

#include "Benchmarks/Report/ReportTables.h"
#include "Benchmarks/Results/BenchPlot.h"
#include "Benchmarks/Results/BenchResults.h"
#include "Benchmarks/Suites/BenchSuite.h"
#include "Support/Pages/StabilityCase.h"

#include <string>
#include <vector>

/**
 * The page of `interlume-bench report`: what was measured on, all claims with those that are not
 * met first, the questions, each with its plot and the sentence that answers it, then a section for
 * each suite with its description and its other plots, its rows folded below, what scenes of the
 * gallery pay, and the stability catalogue, folded too.
 */
class ReportPage
{
public:
  explicit ReportPage(const BenchResults& results);

  /**
   * A section with the rows of \a suite, its claims and \a plots, which are drawn in PNG files
   * beside the page.
   */
  void AddSuite(const BenchSuite& suite, const std::vector<BenchPlot>& plots);

  /// What interlume-bench-costs wrote, with its claims.
  void AddCosts(const BenchResults& costs);

  void AddCatalogue(const std::vector<StabilityCase>& cases);

  /**
   * Throws std::runtime_error, with the path, where the file cannot be written.
   */
  void Write(const std::string& path) const;

private:
  const BenchResults& Results;
  std::vector<html::SuiteClaim> Claims;
  std::vector<html::SuitePlot> Questions;
  std::string Body;
  bool HasCosts = false;
};

#endif
