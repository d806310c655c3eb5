// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Results/BenchClaim.h"

#include "Benchmarks/Measures/BenchTiming.h"

#include <algorithm>

namespace
{
BenchClaim MakeClaim(const std::string& text, const std::vector<BenchRow>& rows,
  const std::function<std::optional<double>(const BenchRow&)>& number,
  const std::function<bool(double)>& isMet)
{
  BenchClaim claim;
  claim.Text = text;
  for (const BenchRow& row : rows)
  {
    if (const std::optional<double> measured = number(row))
    {
      claim.Cases.push_back({ row.Case, *measured, isMet(*measured) });
    }
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
  const std::string& method, const std::string& peer)
{
  return [method, peer](const BenchRow& row) -> std::optional<double>
  {
    const bool concerned =
      row.Method == method && row.Peer == peer && row.Parameter == ThreadsParameter(1);
    return concerned ? row.GetRatio() : std::nullopt;
  };
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
