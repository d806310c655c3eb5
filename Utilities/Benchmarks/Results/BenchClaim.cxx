// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Results/BenchClaim.h"

#include "Benchmarks/Measures/BenchTiming.h"

#include <algorithm>
#include <cstddef>

namespace
{
/// Returns the case of \a row, followed by the fields in which it differs from other rows of the
/// same case.
std::string NameAmong(const std::vector<const BenchRow*>& rows, const BenchRow& row)
{
  const auto differs = [&](const auto& get)
  {
    return std::any_of(rows.begin(), rows.end(),
      [&](const BenchRow* other) { return other->Case == row.Case && get(*other) != get(row); });
  };
  std::string name = row.Case;
  if (differs([](const BenchRow& one) { return one.Method; }))
  {
    name += ", " + row.Method;
  }
  if (differs([](const BenchRow& one) { return one.Parameter; }))
  {
    name += ", " + row.GetParameterText();
  }
  if (differs([](const BenchRow& one) { return one.Baseline; }))
  {
    name += ", " + row.Baseline;
  }
  return name;
}

BenchClaim MakeClaim(const std::string& text, const std::vector<BenchRow>& rows,
  const std::function<std::optional<double>(const BenchRow&)>& number,
  const std::function<bool(double)>& isMet)
{
  BenchClaim claim;
  claim.Text = text;
  std::vector<const BenchRow*> concerned;
  for (const BenchRow& row : rows)
  {
    if (const std::optional<double> measured = number(row))
    {
      concerned.push_back(&row);
      claim.Cases.push_back({ {}, *measured, isMet(*measured) });
    }
  }
  for (std::size_t i = 0; i < concerned.size(); ++i)
  {
    claim.Cases[i].Case = NameAmong(concerned, *concerned[i]);
  }
  return claim;
}
}

bool BenchClaim::IsMet() const
{
  return std::all_of(
    this->Cases.begin(), this->Cases.end(), [](const Measured& measured) { return measured.Met; });
}

nlohmann::ordered_json BenchClaim::ToJson() const
{
  nlohmann::ordered_json json;
  json["text"] = this->Text;
  json["met"] = this->IsMet();
  json["cases"] = nlohmann::ordered_json::array();
  for (const Measured& measured : this->Cases)
  {
    json["cases"].push_back(
      { { "case", measured.Case }, { "number", measured.Number }, { "met", measured.Met } });
  }
  return json;
}

BenchClaim BenchClaim::AtLeast(const std::string& text, double bound,
  const std::vector<BenchRow>& rows,
  const std::function<std::optional<double>(const BenchRow&)>& number)
{
  return MakeClaim(text, rows, number, [bound](double measured) { return measured >= bound; });
}

BenchClaim BenchClaim::AtMost(const std::string& text, double bound,
  const std::vector<BenchRow>& rows,
  const std::function<std::optional<double>(const BenchRow&)>& number)
{
  return MakeClaim(text, rows, number, [bound](double measured) { return measured <= bound; });
}

std::function<std::optional<double>(const BenchRow&)> RatioWithOneThread(
  const std::string& method, const std::string& baseline)
{
  return [method, baseline](const BenchRow& row) -> std::optional<double>
  {
    const bool concerned =
      row.Method == method && row.Baseline == baseline && row.Parameter == ThreadsParameter(1);
    return concerned ? row.GetRatio() : std::nullopt;
  };
}

std::function<std::optional<double>(const BenchRow&)> RatioOf(const std::string& method)
{
  return [method](const BenchRow& row)
  { return row.Method == method ? row.GetRatio() : std::nullopt; };
}

std::function<std::optional<double>(const BenchRow&)> CountOf(
  const std::string& method, const std::string& count)
{
  return [method, count](const BenchRow& row) -> std::optional<double>
  {
    if (row.Method != method || !row.Counts.contains(count))
    {
      return std::nullopt;
    }
    return row.Counts[count].get<double>();
  };
}
