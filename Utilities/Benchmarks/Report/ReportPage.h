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
 * The HTML page that `interlume-bench report` writes. It starts with the machine, the conditions,
 * and all claims, missed claims first. Next come the questions that plots answer, each with its
 * plot and a conclusion, and then a section for each suite with its description, other plots and
 * collapsed rows. The costs of gallery scenes and the collapsed stability catalog are last.
 */
class ReportPage
{
public:
  explicit ReportPage(const BenchResults& results);

  /**
   * Adds a section with the rows of \a suite and \a plots, which are SVG files next to the page,
   * and adds its claims.
   */
  void AddSuite(const BenchSuite& suite, const std::vector<BenchPlot>& plots);

  /// Adds the rows of interlume-bench-costs and their claims.
  void AddCosts(const BenchResults& costs);

  void AddStabilityCatalog(const std::vector<StabilityCase>& cases);

  /**
   * Throws std::runtime_error with the path if the file cannot be written.
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
