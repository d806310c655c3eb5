// SPDX-License-Identifier: BSD-3-Clause
// The ranges of codes around the cells of a row, against a loop over each cell's corners.
#include "Reference/Checks/ReferenceCheck.h"

#include "Scalars/RowKernels.h"

#include <algorithm>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace
{

using namespace reference;
using Code = interlume::RowKernels::Code;

constexpr Code Mixed = 65535;

/// Eight rows of codes below \a codes; long runs are of one code in all rows.
std::vector<std::vector<Code>> MakeRows(std::size_t points, unsigned codes, std::mt19937& random)
{
  std::vector<std::vector<Code>> rows(8, std::vector<Code>(points));
  Code run = 0;
  for (std::size_t i = 0; i < points; ++i)
  {
    const bool isRun = random() % 8 != 0;
    run = random() % 16 == 0 ? static_cast<Code>(random() % codes) : run;
    for (std::vector<Code>& row : rows)
    {
      row[i] = isRun ? run : static_cast<Code>(random() % codes);
    }
  }
  return rows;
}

void CheckRow(int number, unsigned codes, std::mt19937& random, Check& check)
{
  const auto cells = static_cast<std::size_t>(number);
  const std::vector<std::vector<Code>> rows = MakeRows(cells + 1, codes, random);
  const Code* starts[8];
  std::transform(
    rows.begin(), rows.end(), starts, [](const std::vector<Code>& row) { return row.data(); });
  std::vector<Code> least(cells + 1);
  std::vector<Code> greatest(cells + 1);
  std::vector<Code> all(cells);
  interlume::RowKernels::FindRanges(starts, number, least.data(), greatest.data(), all.data());
  for (std::size_t i = 0; i < cells; ++i)
  {
    std::vector<Code> corners;
    for (const std::vector<Code>& row : rows)
    {
      corners.insert(corners.end(), { row[i], row[i + 1] });
    }
    const auto [low, high] = std::minmax_element(corners.begin(), corners.end());
    const std::string name = "cell " + std::to_string(i) + " of " + std::to_string(number);
    check.Equal(least[i], *low, name + ": least");
    check.Equal(greatest[i], *high, name + ": greatest");
    check.Equal(all[i], *low == *high ? *low : Mixed, name + ": of all");
  }
}

}

int TestRowKernels(int, char*[])
{
  Check check;
  std::mt19937 random(7);
  for (const int number : { 1, 2, 7, 8, 15, 16, 17, 31, 33, 100, 512 })
  {
    for (const unsigned codes : { 2U, 5U, 40000U })
    {
      CheckRow(number, codes, random, check);
    }
  }
  return check.Result();
}
