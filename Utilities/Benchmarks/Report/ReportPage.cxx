// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Report/ReportPage.h"

#include "Benchmarks/Costs/CostRows.h"
#include "Benchmarks/Results/BenchMachine.h"
#include "Support/Pages/HtmlText.h"

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>

namespace
{
const char* const Style = R"(
:root { color-scheme: light; }
body { font: 16px/1.5 system-ui, sans-serif; color: #222; background: #fafafa; margin: 0 auto;
  max-width: 1180px; padding: 2rem 1.5rem 4rem; }
h1, h2 { line-height: 1.2; font-weight: 600; }
h2 { margin-top: 3rem; border-bottom: 1px solid #ccc; padding-bottom: .3rem; }
nav a { margin-right: 1.2rem; }
.plots { display: grid; grid-template-columns: repeat(auto-fit, minmax(480px, 1fr)); gap: 1rem; }
figure { margin: 0; }
figure h3 { font-size: 16px; margin: .8rem 0 .2rem; }
figcaption, .answer { font-size: 14px; margin: .2rem 0 .5rem; }
.plots img { width: 100%; border: 1px solid #ddd; background: #fff; }
.wide { overflow-x: auto; margin: 1.2rem 0; }
table { border-collapse: collapse; background: #fff; font-size: 14px; }
th, td { border: 1px solid #ddd; padding: .25rem .6rem; text-align: left; vertical-align: top; }
th { background: #f0f0f0; font-weight: 600; }
td.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
.failed { color: #a00; font-weight: 600; }
summary { cursor: pointer; }
)";
/// Returns the rows of interlume-bench-costs: a table with a summary of each feature over all
/// scenes, then a collapsed section with the rows of each scene. The result is empty if there are
/// no rows.
std::string CostsOf(const BenchResults& results)
{
  std::vector<BenchRow> rows = results.RowsOf(costs::Suite);
  const auto scenes = std::stable_partition(
    rows.begin(), rows.end(), [](const BenchRow& row) { return row.Case == costs::AllScenes; });
  if (scenes == rows.begin())
  {
    return {};
  }
  const std::vector<BenchRow> ofScenes(scenes, rows.end());
  rows.erase(scenes, rows.end());
  return "<p>Resources that remain of each feature that a gallery scene does not use, after the "
         "feature was switched on and off again: the largest numbers of all scenes. ms is the "
         "remaining processor time, relative to the same scene without the feature. Columns with "
         "the prefix on_ are the cost while the feature is on, as medians. " +
    html::Escaped(MachineInOneLine(results.Machine, results.Vtk)) + "; " +
    html::Escaped(ConditionsInOneLine(results.Conditions)) + "; " +
    html::Escaped(results.Conditions.value("command", "")) + ".</p>\n" + html::TableOf(rows) +
    html::MakeCollapsedSection(
      std::to_string(ofScenes.size()) + " rows of scenes", html::TableOf(ofScenes));
}
}

ReportPage::ReportPage(const BenchResults& results)
  : Results(results)
{
}

void ReportPage::AddSuite(const BenchSuite& suite, const std::vector<BenchPlot>& plots)
{
  const std::string name = suite.Name;
  const std::vector<BenchRow> rows = this->Results.RowsOf(name);
  std::ostringstream text;
  text << "<h2 id=\"" << name << "\">" << html::Escaped(name) << "</h2>\n<p>"
       << html::Escaped(suite.Title) << ".</p>\n<ul>\n";
  for (const std::string& paragraph : suite.Description)
  {
    text << "<li>" << html::Escaped(paragraph) << "</li>\n";
  }
  text << "</ul>\n<div class=\"plots\">\n";
  for (const BenchPlot& plot : plots)
  {
    if (plot.Question.empty())
    {
      text << "<a href=\"" << plot.Name << ".svg\"><img src=\"" << plot.Name << ".svg\" alt=\""
           << html::Escaped(plot.Title) << "\"></a>\n";
    }
    else
    {
      this->Questions.push_back({ name, plot });
    }
  }
  text << "</div>\n"
       << html::MakeCollapsedSection(std::to_string(rows.size()) + " rows", html::TableOf(rows));
  this->Body += text.str();
  for (const BenchClaim& claim : suite.CheckClaims(rows))
  {
    this->Claims.push_back({ name, claim });
  }
}

void ReportPage::AddStabilityCatalog(const std::vector<StabilityCase>& cases)
{
  const auto passed = std::count_if(
    cases.begin(), cases.end(), [](const StabilityCase& oneCase) { return oneCase.Passed; });
  std::ostringstream text;
  const std::vector<StabilityCount> counts = CountByClass(cases);
  text << "<h2 id=\"stability\">stability</h2>\n<p>" << passed << " of " << cases.size()
       << " cases of extreme and stiff inputs passed.</p>\n"
       << html::MakeCollapsedSection(
            std::to_string(counts.size()) + " classes", html::TableOf(counts))
       << html::MakeCollapsedSection(std::to_string(cases.size()) + " cases", html::TableOf(cases));
  this->Body += text.str();
}

void ReportPage::AddCosts(const BenchResults& costs)
{
  this->Body += "<h2 id=\"costs\">Cost of unused features</h2>\n" + CostsOf(costs);
  for (const BenchClaim& claim : costs::CheckClaims(costs.RowsOf(costs::Suite)))
  {
    this->Claims.push_back({ "costs", claim });
  }
  this->HasCosts = true;
}

void ReportPage::Write(const std::string& path) const
{
  std::set<std::string> named;
  std::ofstream file(path);
  file << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
       << "<title>Interlume: measurements</title>\n<style>" << Style
       << "</style>\n</head>\n<body>\n<h1>Interlume: measurements</h1>\n<p>"
       << html::Escaped(MachineInOneLine(this->Results.Machine, this->Results.Vtk)) << "; "
       << html::Escaped(this->Results.Machine.value("system", "")) << "; "
       << html::Escaped(ConditionsInOneLine(this->Results.Conditions)) << ".</p>\n"
       << "<p>Times are wall times, medians of the number of runs in the column runs. A method and "
          "its baselines (column peer) run alternately in the same process. The ratio is the "
          "baseline's time divided by the method's time: above 1, the method is faster. The same "
          "numbers are in <a "
          "href=\"rows.json\">rows.json</a>.</p>\n<nav><a href=\"#claims\">claims</a><a "
          "href=\"#questions\">questions</a>";
  for (const BenchRow& row : this->Results.Rows)
  {
    if (named.insert(row.Suite).second)
    {
      file << "<a href=\"#" << row.Suite << "\">" << html::Escaped(row.Suite) << "</a>";
    }
  }
  file << (this->HasCosts ? "<a href=\"#costs\">unused features</a>" : "")
       << "<a href=\"#stability\">stability</a></nav>\n<h2 id=\"claims\">claims</h2>\n"
       << html::TableOf(this->Claims) << "<h2 id=\"questions\">questions</h2>\n"
       << html::FiguresOf(this->Questions) << this->Body << "</body>\n</html>\n";
  if (!file)
  {
    throw std::runtime_error("Cannot write the file " + path);
  }
}
