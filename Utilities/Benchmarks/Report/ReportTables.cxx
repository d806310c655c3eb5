// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Report/ReportTables.h"

#include "Benchmarks/Results/ErrorFront.h"
#include "Pages/HtmlText.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace
{
std::string Number(double number)
{
  std::ostringstream text;
  const bool whole = number == std::floor(number) && std::abs(number) < 1e15;
  if (whole)
  {
    text << std::fixed << std::setprecision(0) << number;
  }
  else
  {
    text << std::setprecision(4) << number;
  }
  return text.str();
}

/// A table cell: its text and whether it is a number.
struct Cell
{
  std::string Text;
  bool IsNumber = false;
};

/// A row as named cells, in the order of the columns.
using Cells = std::vector<std::pair<std::string, Cell>>;

void AddText(Cells& cells, const char* name, const std::string& text)
{
  if (!text.empty())
  {
    cells.push_back({ name, { html::Escaped(text), false } });
  }
}

void AddNumber(Cells& cells, const std::string& name, const std::optional<double>& number)
{
  if (number)
  {
    cells.push_back({ name, { Number(*number), true } });
  }
}

void AddRuns(Cells& cells, const std::string& name, const std::optional<BenchSeconds>& seconds)
{
  if (seconds)
  {
    AddNumber(cells, name, seconds->Runs);
  }
}

void AddJson(Cells& cells, const std::string& name, const nlohmann::ordered_json& json)
{
  if (json.is_number())
  {
    AddNumber(cells, name, json.get<double>());
  }
  else if (!json.is_null())
  {
    cells.push_back(
      { name, { html::Escaped(json.is_string() ? json.get<std::string>() : json.dump()) } });
  }
}

Cells CellsOf(const BenchRow& row)
{
  Cells cells;
  AddText(cells, "case", row.Case);
  AddText(cells, "method", row.Method);
  AddJson(cells, "parameter", row.Parameter);
  AddText(cells, "error norm", row.ErrorNorm);
  AddNumber(cells, "error", row.Error);
  AddNumber(cells, "seconds", row.Seconds);
  AddRuns(cells, "runs", row.Seconds);
  AddText(cells, "peer", row.Peer);
  AddNumber(cells, "peer seconds", row.PeerSeconds);
  AddRuns(cells, "peer runs", row.PeerSeconds);
  AddNumber(cells, "ratio", row.GetRatio());
  for (const auto& count : row.Counts.items())
  {
    AddJson(cells, count.key(), count.value());
  }
  return cells;
}

/// The fields of all rows; a new one comes after the one that it follows in its row.
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

std::string Verdict(bool isGood, const std::string& text)
{
  return isGood ? text : "<span class=\"failed\">" + text + "</span>";
}
}

namespace html
{
std::string Folded(const std::string& summary, const std::string& content)
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
    const std::optional<double> over = GetCostOverFront(plot);
    const bool isOnFront = over && *over <= FrontTolerance;
    withDefault += over ? 1 : 0;
    onFront += isOnFront ? 1 : 0;
    figures << "<figure id=\"" << Escaped(plot.Name) << "\"><h3>" << Escaped(plot.Question)
            << "</h3>\n<p class=\"answer\">"
            << (over ? Verdict(isOnFront, Escaped(AnswerOf(plot)))
                     : "No point of this size is the default's.")
            << "</p>\n<a href=\"" << Escaped(plot.Name) << ".png\"><img src=\""
            << Escaped(plot.Name) << ".png\" alt=\"" << Escaped(plot.Title)
            << "\"></a>\n<figcaption>" << Escaped(plot.Conditions) << " Rows: <a href=\"#"
            << Escaped(question.Suite) << "\">" << Escaped(question.Suite)
            << "</a>.</figcaption></figure>\n";
  }
  std::ostringstream html;
  html << "<p>" << questions.size() << " questions; the default, ringed, is on the Pareto front in "
       << onFront << " of " << withDefault
       << " plots with its point: no other point has less time and no more error, but for "
       << std::lround(100.0 * (FrontTolerance - 1.0)) << " % of its time.</p>\n"
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
  std::ostringstream html;
  html << "<p>" << sorted.end() - firstMet << " of " << sorted.size()
       << " claims are met in every case.</p>\n<div class=\"wide\"><table><tr><th>suite</th>"
       << "<th>wanted</th><th>measured</th></tr>\n";
  for (const SuiteClaim& claim : sorted)
  {
    html << "<tr><td><a href=\"#" << Escaped(claim.Suite) << "\">" << Escaped(claim.Suite)
         << "</a></td><td>" << Escaped(claim.Claim.Text) << "</td><td>";
    const char* separator = "";
    for (const BenchClaim::Measured& measured : claim.Claim.Cases)
    {
      const std::string number = Number(measured.Number) + (measured.Met ? "" : " (not met)");
      html << separator << Escaped(measured.Case) << " " << Verdict(measured.Met, number);
      separator = ", ";
    }
    html << "</td></tr>\n";
  }
  html << "</table></div>\n";
  return html.str();
}

std::string TableOf(const std::vector<BenchRow>& rows)
{
  if (rows.empty())
  {
    return {};
  }
  std::vector<Cells> table(rows.size());
  std::transform(rows.begin(), rows.end(), table.begin(), &CellsOf);
  const std::vector<std::string> columns = ColumnsOf(table);
  std::ostringstream html;
  html << "<div class=\"wide\"><table><tr>";
  for (const std::string& column : columns)
  {
    html << "<th>" << Escaped(column) << "</th>";
  }
  html << "</tr>\n";
  for (const Cells& cells : table)
  {
    html << "<tr>";
    for (const std::string& column : columns)
    {
      const auto cell = std::find_if(
        cells.begin(), cells.end(), [&](const auto& named) { return named.first == column; });
      const bool isThere = cell != cells.end();
      html << (isThere && cell->second.IsNumber ? "<td class=\"number\">" : "<td>")
           << (isThere ? cell->second.Text : "") << "</td>";
    }
    html << "</tr>\n";
  }
  html << "</table></div>\n";
  return html.str();
}

std::string TableOf(const std::vector<StabilityCase>& cases)
{
  if (cases.empty())
  {
    return {};
  }
  std::ostringstream html;
  html << "<div class=\"wide\"><table><tr><th>class</th><th>case</th><th>what is extreme</th>"
       << "<th>expected</th><th>measured</th><th>bound</th><th>method and steps</th>"
       << "<th>passed</th><th>test</th></tr>\n";
  for (const StabilityCase& oneCase : cases)
  {
    html << "<tr><td>" << Escaped(oneCase.Class) << "</td><td>" << Escaped(oneCase.Name)
         << "</td><td>" << Escaped(oneCase.Extreme) << "</td><td>" << Escaped(oneCase.Expected)
         << "</td><td>" << Escaped(oneCase.Measured) << "</td><td class=\"number\">"
         << (std::isnan(oneCase.Bound) ? "" : Number(oneCase.Bound)) << "</td><td>"
         << Escaped(oneCase.Method) << "</td><td>"
         << Verdict(oneCase.Passed, oneCase.Passed ? "yes" : "no") << "</td><td>"
         << Escaped(oneCase.Test) << "</td></tr>\n";
  }
  html << "</table></div>\n";
  return html.str();
}

std::string TableOf(const std::vector<StabilityCount>& counts)
{
  if (counts.empty())
  {
    return {};
  }
  std::ostringstream html;
  html
    << "<div class=\"wide\"><table><tr><th>class</th><th>cases</th><th>compared with a bound</th>"
    << "<th>passed</th></tr>\n";
  for (const StabilityCount& count : counts)
  {
    html << "<tr><td>" << Escaped(count.Class) << "</td><td class=\"number\">" << count.Cases
         << "</td><td class=\"number\">" << count.Measured << "</td><td class=\"number\">"
         << Verdict(count.Passed == count.Cases, std::to_string(count.Passed)) << "</td></tr>\n";
  }
  html << "</table></div>\n";
  return html.str();
}
}
