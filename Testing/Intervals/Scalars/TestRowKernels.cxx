// SPDX-License-Identifier: BSD-3-Clause
// SIMD kernels compared with scalar loops: the ranges of codes at the points of each cell in a row,
// codes of values, marks of codes, and tests for finite values.
#include "Support/Checks/ReferenceCheck.h"

#include "Scalars/RowKernels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace
{

using namespace reference;
using Code = interlume::RowKernels::Code;

constexpr Code Mixed = 65535;

/// Returns eight rows of codes below \a codes. In long runs of points, all rows have the same code.
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
    check.Equal(least[i], *low, name + ": minimum");
    check.Equal(greatest[i], *high, name + ": maximum");
    check.Equal(all[i], *low == *high ? *low : Mixed, name + ": all cells");
  }
}

template <typename T>
void CheckValues(int number, std::mt19937& random, Check& check)
{
  using interlume::RowKernels::AreFinite;
  const T infinity = std::numeric_limits<T>::infinity();
  const T lost[] = { std::numeric_limits<T>::quiet_NaN(), infinity, -infinity };
  // Many of the values equal a threshold.
  const T thresholds[] = { T(3), std::nextafter(T(3), infinity), T(6), T(7) };
  std::vector<T> values(static_cast<std::size_t>(number));
  std::generate(values.begin(), values.end(), [&]() { return static_cast<T>(random() % 10); });
  const std::string name = std::to_string(number) + " values";
  check.That(AreFinite(values.data(), number), name + " are finite");
  for (int i = 0; i < number; ++i)
  {
    std::vector<T> changed = values;
    changed[static_cast<std::size_t>(i)] = lost[i % 3];
    check.That(
      !AreFinite(changed.data(), number), name + ": " + std::to_string(i) + " is not finite");
    values[static_cast<std::size_t>(i)] =
      i % 5 == 0 ? lost[i % 3] : values[static_cast<std::size_t>(i)];
  }
  for (const int count : { 2, 4 })
  {
    std::vector<Code> codes(values.size());
    interlume::RowKernels::Classify(values.data(), number, thresholds, count, codes.data());
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      const auto reached = std::count_if(
        thresholds, thresholds + count, [&](T threshold) { return values[i] >= threshold; });
      check.Equal(codes[i], reached, name + ": code " + std::to_string(i));
    }
  }
}

void CheckMarks(int number, int count, std::mt19937& random, Check& check)
{
  std::vector<Code> codes(static_cast<std::size_t>(number));
  std::generate(codes.begin(), codes.end(),
    [&]() { return static_cast<Code>(random() % static_cast<unsigned>(count + 1)); });
  std::vector<std::uint8_t> ofCodes{ 1 };
  std::vector<std::uint8_t> steps;
  for (int step = 0; step < count; ++step)
  {
    ofCodes.push_back(static_cast<std::uint8_t>(random()));
    steps.push_back(static_cast<std::uint8_t>(ofCodes.back() - ofCodes[ofCodes.size() - 2]));
  }
  std::vector<std::uint8_t> marks(codes.size());
  interlume::RowKernels::FillMarks(codes.data(), number, steps.data(), count, marks.data());
  for (std::size_t i = 0; i < codes.size(); ++i)
  {
    check.Equal(
      marks[i], ofCodes[codes[i]], "mark " + std::to_string(i) + " of " + std::to_string(number));
  }
}

}

int TestRowKernels(int, char*[])
{
  Check check;
  std::mt19937 random(7);
  for (const int number : { 1, 2, 7, 8, 15, 16, 17, 31, 33, 100, 512 })
  {
    CheckValues<float>(number, random, check);
    CheckValues<double>(number, random, check);
    CheckMarks(number, 3, random, check);
    CheckMarks(number, 5, random, check);
    for (const unsigned codes : { 2U, 5U, 40000U })
    {
      CheckRow(number, codes, random, check);
    }
  }
  return check.Result();
}
