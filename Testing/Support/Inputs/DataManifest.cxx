// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Inputs/DataManifest.h"

#include "Support/Inputs/DataFiles.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace interlume
{
namespace
{
std::string Trimmed(const std::string& text)
{
  const std::string blanks = " \t\r`";
  const std::string::size_type first = text.find_first_not_of(blanks);
  if (first == std::string::npos)
  {
    return "";
  }
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string> Columns(const std::string& line)
{
  std::vector<std::string> columns;
  std::istringstream stream(line.substr(1));
  std::string column;
  while (std::getline(stream, column, '|'))
  {
    columns.push_back(Trimmed(column));
  }
  return columns;
}
}

std::vector<DataRow> ReadDataManifest()
{
  const std::string path = DataFile("MANIFEST.md");
  std::ifstream file(path);
  std::vector<DataRow> rows;
  std::string line;
  while (std::getline(file, line))
  {
    if (line.rfind("| `", 0) != 0)
    {
      continue;
    }
    const std::vector<std::string> columns = Columns(line);
    if (columns.size() >= 4)
    {
      rows.push_back({ columns[0], columns[1], columns[2], columns[3] });
    }
  }
  if (rows.empty())
  {
    throw std::runtime_error("The data manifest has no rows: " + path);
  }
  return rows;
}

const DataRow& FindDataRow(const std::vector<DataRow>& rows, const std::string& file)
{
  const auto row = std::find_if(
    rows.begin(), rows.end(), [&file](const DataRow& candidate) { return candidate.File == file; });
  if (row == rows.end())
  {
    throw std::runtime_error(file + " has no row in Data/MANIFEST.md. Add its source and license.");
  }
  return *row;
}
}
