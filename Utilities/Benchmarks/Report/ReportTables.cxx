// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Report/ReportTables.h"

#include "Benchmarks/Results/ErrorFront.h"
#include "Support/Pages/HtmlText.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <utility>

namespace
{
/// A table cell.
struct Cell
{
  std::string Html;
  bool IsNumber = false;
};

/// A table row as named cells, in the order of the columns.
using Cells = std::vector<std::pair<std::string, Cell>>;

std::string Number(double number)
{
  std::ostringstream text;
  const bool isInteger = number == std::floor(number) && std::abs(number) < 1e15;
  if (isInteger)
  {
    text << std::fixed;
  }
  text << std::setprecision(isInteger ? 0 : 4) << number;
  return text.str();
}

Cell CellOf(const nlohmann::ordered_json& json)
{
  return json.is_number()
    ? Cell{ Number(json.get<double>()), true }
    : Cell{ html::Escaped(json.is_string() ? json.get<std::string>() : json.dump()) };
}

Cells CellsOf(const BenchRow& row)
{
  static const std::pair<const char*, const char*> names[] = { { "case", "case" },
    { "method", "method" }, { "parameter", "parameter" }, { "error_norm", "error norm" },
    { "error", "error" }, { "seconds", "seconds" }, { "runs", "runs" }, { "peer", "peer" },
    { "peer_seconds", "peer seconds" }, { "peer_runs", "peer runs" }, { "ratio", "ratio" } };
  const nlohmann::ordered_json json = row.ToJson();
  Cells cells;
  for (const auto& [field, name] : names)
  {
    if (json.contains(field))
    {
      cells.push_back({ name, CellOf(json[field]) });
    }
  }
  for (const auto& count : row.Counts.items())
  {
    cells.push_back({ count.key(), CellOf(count.value()) });
  }
  return cells;
}

/// Returns the names of the cells in all rows, without duplicates. A new name is inserted after the
/// name that precedes it in its row.
std::vector<std::string> ColumnsOf(const std::vector<Cells>& rows)
{
  std::vector<std::string> columns;
  for (const Cells& cells : rows)
  {
    auto next = columns.begin();
    for (const auto& cell : cells)
    {
      const auto found = std::find(columns.begin(), columns.end(), cell.first);
      next = (found == columns.end() ? columns.insert(next, cell.first) : found) + 1;
    }
  }
  return columns;
}

std::string MakeTable(const std::vector<Cells>& rows)
{
  if (rows.empty())
  {
    return {};
  }
  const std::vector<std::string> columns = ColumnsOf(rows);
  std::ostringstream html;
  html << "<div class=\"wide\"><table><tr>";
  for (const std::string& column : columns)
  {
    html << "<th>" << html::Escaped(column) << "</th>";
  }
  for (const Cells& cells : rows)
  {
    html << "</tr>\n<tr>";
    for (const std::string& column : columns)
    {
      const auto found = std::find_if(
        cells.begin(), cells.end(), [&](const auto& named) { return named.first == column; });
      const Cell cell = found == cells.end() ? Cell() : found->second;
      html << (cell.IsNumber ? "<td class=\"number\">" : "<td>") << cell.Html << "</td>";
    }
  }
  html << "</tr>\n</table></div>\n";
  return html.str();
}

template <typename Item>
std::string MakeTable(const std::vector<Item>& items, Cells (*cellsOf)(const Item&))
{
  std::vector<Cells> rows(items.size());
  std::transform(items.begin(), items.end(), rows.begin(), cellsOf);
  return MakeTable(rows);
}

std::string Verdict(bool isGood, const std::string& text)
{
  return isGood ? text : "<span class=\"failed\">" + text + "</span>";
}

Cells CellsOf(const html::SuiteClaim& claim)
{
  std::string measured;
  for (const BenchClaim::Measured& one : claim.Claim.Cases)
  {
    const std::string number = Number(one.Number) + (one.Met ? "" : " (not met)");
    measured +=
      (measured.empty() ? "" : ", ") + html::Escaped(one.Case) + " " + Verdict(one.Met, number);
  }
  const std::string suite = html::Escaped(claim.Suite);
  return { { "suite", { "<a href=\"#" + suite + "\">" + suite + "</a>" } },
    { "target", { html::Escaped(claim.Claim.Text) } }, { "measured", { measured } } };
}

Cells CellsOf(const StabilityCase& one)
{
  using html::Escaped;
  return { { "class", { Escaped(one.Class) } }, { "case", { Escaped(one.Name) } },
    { "extreme input", { Escaped(one.Extreme) } }, { "expected", { Escaped(one.Expected) } },
    { "measured", { Escaped(one.Measured) } },
    { "bound", { std::isnan(one.Bound) ? "" : Number(one.Bound), true } },
    { "method and steps", { Escaped(one.Method) } },
    { "passed", { Verdict(one.Passed, one.Passed ? "yes" : "no") } },
    { "test", { Escaped(one.Test) } } };
}

Cells CellsOf(const StabilityCount& count)
{
  return { { "class", { html::Escaped(count.Class) } },
    { "cases", { std::to_string(count.Cases), true } },
    { "compared with a bound", { std::to_string(count.Measured), true } },
    { "passed", { Verdict(count.Passed == count.Cases, std::to_string(count.Passed)), true } } };
}
}

namespace html
{
std::string MakeCollapsedSection(const std::string& summary, const std::string& content)
{
  return content.empty()
    ? content
    : "<details><summary>" + summary + "</summary>\n" + content + "</details>\n";
}

std::string FiguresOf(const std::vector<SuitePlot>& questions)
{
  std::ostringstream figures;
  int withDefault = 0;
  int onFront = 0;
  for (const SuitePlot& question : questions)
  {
    const BenchPlot& plot = question.Plot;
    const std::optional<double> over = GetCostRelativeToFront(plot);
    const bool isOnFront = over && *over <= FrontTolerance;
    withDefault += over ? 1 : 0;
    onFront += isOnFront ? 1 : 0;
    figures << "<figure id=\"" << Escaped(plot.Name) << "\"><h3>" << Escaped(plot.Question)
            << "</h3>\n<p class=\"answer\">"
            << (over ? Verdict(isOnFront, Escaped(SummaryOf(plot)))
                     : "The default settings are not among the measured points.")
            << "</p>\n<a href=\"" << Escaped(plot.Name) << ".svg\"><img src=\""
            << Escaped(plot.Name) << ".svg\" alt=\"" << Escaped(plot.Title)
            << "\"></a>\n<figcaption>" << Escaped(plot.Conditions) << " Rows: <a href=\"#"
            << Escaped(question.Suite) << "\">" << Escaped(question.Suite)
            << "</a>.</figcaption></figure>\n";
  }
  std::ostringstream html;
  html << "<p>" << questions.size() << " questions; the default, ringed, is on the Pareto front in "
       << onFront << " of " << withDefault
       << " plots that contain it: no other point has an error at most as large in less time, with "
          "a tolerance of "
       << std::lround(100.0 * (FrontTolerance - 1.0)) << " % of the time.</p>\n"
       << "<div class=\"plots\">\n"
       << figures.str() << "</div>\n";
  return html.str();
}

std::string TableOf(const std::vector<SuiteClaim>& claims)
{
  if (claims.empty())
  {
    return {};
  }
  std::vector<SuiteClaim> sorted = claims;
  const auto firstMet = std::stable_partition(
    sorted.begin(), sorted.end(), [](const SuiteClaim& claim) { return !claim.Claim.IsMet(); });
  return "<p>" + std::to_string(sorted.end() - firstMet) + " of " + std::to_string(sorted.size()) +
    " claims are met in every case.</p>\n" + MakeTable<SuiteClaim>(sorted, CellsOf);
}

std::string TableOf(const std::vector<BenchRow>& rows)
{
  return MakeTable<BenchRow>(rows, CellsOf);
}

std::string TableOf(const std::vector<StabilityCase>& cases)
{
  return MakeTable<StabilityCase>(cases, CellsOf);
}

std::string TableOf(const std::vector<StabilityCount>& counts)
{
  return MakeTable<StabilityCount>(counts, CellsOf);
}
}
