// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Results/BenchRow.h"

#include <iostream>
#include <limits>
#include <sstream>

namespace
{
void PutIf(nlohmann::ordered_json& json, const char* name, const std::string& text)
{
  if (!text.empty())
  {
    json[name] = text;
  }
}

void PutIf(nlohmann::ordered_json& json, const char* name, const std::optional<double>& number)
{
  if (number)
  {
    json[name] = *number;
  }
}

/// Adds to \a json the time, the number of runs and, if \a hasSpans is set, the start and end of
/// each run. \a prefix is the prefix of their names.
void PutSeconds(nlohmann::ordered_json& json, const std::string& prefix,
  const std::optional<BenchSeconds>& seconds, bool hasSpans)
{
  if (seconds)
  {
    json[prefix + "seconds"] = seconds->Value;
    json[prefix + "runs"] = seconds->Runs;
  }
  if (seconds && hasSpans)
  {
    json[prefix + "spans"] = seconds->Spans;
  }
}

std::optional<BenchSeconds> SecondsIn(const nlohmann::ordered_json& json, const std::string& prefix)
{
  return json.contains(prefix + "seconds")
    ? std::optional<BenchSeconds>(
        { json.at(prefix + "seconds").get<double>(), json.at(prefix + "runs").get<int>() })
    : std::nullopt;
}

/// Reads a number. JSON represents NaN and infinity as null.
double NumberOf(const nlohmann::ordered_json& json)
{
  return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

std::optional<double> NumberIn(const nlohmann::ordered_json& json, const char* name)
{
  return json.contains(name) ? std::optional<double>(NumberOf(json.at(name))) : std::nullopt;
}

std::ostream& operator<<(std::ostream& os, const BenchRow& row)
{
  os << row.Suite << "  " << row.Case << "  " << row.Method;
  if (!row.Parameter.is_null())
  {
    os << "  " << row.GetParameterText();
  }
  if (row.Seconds)
  {
    os << "  " << *row.Seconds << " s";
  }
  if (row.BaselineSeconds)
  {
    os << "  " << row.Baseline << " " << *row.BaselineSeconds << " s  ratio " << *row.GetRatio();
  }
  if (row.Error)
  {
    os << "  " << row.ErrorNorm << " " << *row.Error;
  }
  if (!row.Counts.empty())
  {
    os << "  " << row.Counts.dump();
  }
  return os;
}
}

void BenchRow::SetTimes(
  const BenchSeconds& seconds, const std::string& baseline, const BenchSeconds& baselineSeconds)
{
  this->Seconds = seconds;
  this->Baseline = baseline;
  this->BaselineSeconds = baselineSeconds;
}

void BenchRow::SetError(const std::string& norm, double error)
{
  this->ErrorNorm = norm;
  this->Error = error;
}

std::string BenchRow::GetParameterText() const
{
  if (this->Parameter.is_number_float())
  {
    std::ostringstream text;
    text << this->Parameter.get<double>();
    return text.str();
  }
  return this->Parameter.is_string() ? this->Parameter.get<std::string>() : this->Parameter.dump();
}

std::optional<double> BenchRow::GetRatio() const
{
  if (this->Seconds && this->BaselineSeconds && *this->Seconds > 0.0)
  {
    return *this->BaselineSeconds / *this->Seconds;
  }
  return std::nullopt;
}

nlohmann::ordered_json BenchRow::ToJson(bool hasSpans) const
{
  nlohmann::ordered_json json;
  json["suite"] = this->Suite;
  json["case"] = this->Case;
  json["method"] = this->Method;
  if (!this->Parameter.is_null())
  {
    json["parameter"] = this->Parameter;
  }
  PutIf(json, "error", this->Error);
  PutIf(json, "error_norm", this->ErrorNorm);
  PutSeconds(json, "", this->Seconds, hasSpans);
  PutIf(json, "peer", this->Baseline);
  PutSeconds(json, "peer_", this->BaselineSeconds, hasSpans);
  PutIf(json, "ratio", this->GetRatio());
  if (!this->Counts.empty())
  {
    json["counts"] = this->Counts;
  }
  return json;
}

BenchRow BenchRow::FromJson(const nlohmann::ordered_json& json)
{
  BenchRow row;
  row.Suite = json.at("suite");
  row.Case = json.at("case");
  row.Method = json.at("method");
  if (json.contains("parameter"))
  {
    row.Parameter = json.at("parameter");
  }
  row.Error = NumberIn(json, "error");
  row.ErrorNorm = json.value("error_norm", "");
  row.Seconds = SecondsIn(json, "");
  row.Baseline = json.value("peer", "");
  row.BaselineSeconds = SecondsIn(json, "peer_");
  if (json.contains("counts"))
  {
    row.Counts = json.at("counts");
    for (auto& count : row.Counts)
    {
      if (count.is_null())
      {
        count = NumberOf(count);
      }
    }
  }
  return row;
}

BenchRows::BenchRows(const std::string& suite)
  : Suite(suite)
{
}

BenchRow BenchRows::Make(const std::string& theCase, const std::string& method,
  const nlohmann::ordered_json& parameter) const
{
  BenchRow row;
  row.Suite = this->Suite;
  row.Case = theCase;
  row.Method = method;
  row.Parameter = parameter;
  return row;
}

void BenchRows::Add(BenchRow row)
{
  std::cout << row << std::endl;
  this->Rows.push_back(std::move(row));
}
