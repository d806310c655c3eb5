// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Report/ReportTables.h"

#include "Pages/HtmlText.h"

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
  AddText(cells, "peer", row.Peer);
  AddNumber(cells, "peer seconds", row.PeerSeconds);
  AddNumber(cells, "ratio", row.GetRatio());
  for (const auto& count : row.Counts.items())
  {
    AddJson(cells, count.key(), count.value());
  }
  return cells;
}

std::vector<std::string> ColumnsOf(const Cells& cells)
{
  std::vector<std::string> columns;
  for (const auto& cell : cells)
  {
    columns.push_back(cell.first);
  }
  return columns;
}

std::string TableOf(const std::vector<Cells>& rows)
{
  std::ostringstream html;
  html << "<div class=\"wide\"><table><tr>";
  for (const std::string& column : ColumnsOf(rows.front()))
  {
    html << "<th>" << html::Escaped(column) << "</th>";
  }
  html << "</tr>\n";
  for (const Cells& cells : rows)
  {
    html << "<tr>";
    for (const auto& cell : cells)
    {
      html << (cell.second.IsNumber ? "<td class=\"number\">" : "<td>") << cell.second.Text
           << "</td>";
    }
    html << "</tr>\n";
  }
  html << "</table></div>\n";
  return html.str();
}

std::string Verdict(bool isGood, const std::string& text)
{
  return isGood ? text : "<span class=\"failed\">" + text + "</span>";
}
}

namespace html
{
std::string TableOf(const std::vector<BenchClaim>& claims)
{
  if (claims.empty())
  {
    return {};
  }
  std::ostringstream html;
  html << "<div class=\"wide\"><table><tr><th>wanted</th><th>measured</th></tr>\n";
  for (const BenchClaim& claim : claims)
  {
    html << "<tr><td>" << Escaped(claim.Text) << "</td><td>";
    const char* separator = "";
    for (const BenchClaim::Measured& measured : claim.Cases)
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

std::string TablesOf(const std::vector<BenchRow>& rows)
{
  std::string html;
  std::vector<Cells> table;
  for (const BenchRow& row : rows)
  {
    const Cells cells = CellsOf(row);
    if (!table.empty() && ColumnsOf(cells) != ColumnsOf(table.front()))
    {
      html += TableOf(table);
      table.clear();
    }
    table.push_back(cells);
  }
  return table.empty() ? html : html + TableOf(table);
}

std::string TableOf(const std::vector<StabilityCase>& cases)
{
  if (cases.empty())
  {
    return {};
  }
  std::ostringstream html;
  html << "<div class=\"wide\"><table><tr><th>test</th><th>case</th><th>what is extreme</th>"
       << "<th>expected</th><th>measured</th><th>bound</th><th>passed</th></tr>\n";
  for (const StabilityCase& oneCase : cases)
  {
    html << "<tr><td>" << Escaped(oneCase.Test) << "</td><td>" << Escaped(oneCase.Name)
         << "</td><td>" << Escaped(oneCase.Extreme) << "</td><td>" << Escaped(oneCase.Expected)
         << "</td><td>" << Escaped(oneCase.Measured) << "</td><td class=\"number\">"
         << (std::isnan(oneCase.Bound) ? "" : Number(oneCase.Bound)) << "</td><td>"
         << Verdict(oneCase.Passed, oneCase.Passed ? "yes" : "no") << "</td></tr>\n";
  }
  html << "</table></div>\n";
  return html.str();
}
}
