// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Results/BenchResults.h"

#include "Benchmarks/Results/BenchMachine.h"

#include "vtkVersion.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>

BenchResults BenchResults::MakeForThisMachine(const BenchOptions& options)
{
  BenchResults results;
  results.Machine = DescribeMachine();
  results.Vtk = vtkVersion::GetVTKVersion();
  results.Conditions = DescribeConditions(options);
  return results;
}

BenchResults BenchResults::Read(const std::string& path)
{
  std::ifstream file(path);
  if (!file)
  {
    throw std::runtime_error("Cannot read the file " + path);
  }
  try
  {
    const auto json = nlohmann::ordered_json::parse(file);
    BenchResults results;
    results.Machine = json.at("machine");
    results.Vtk = json.at("vtk");
    results.Conditions = json.at("conditions");
    results.Suites = json.at("suites");
    for (const auto& row : json.at("rows"))
    {
      results.Rows.push_back(BenchRow::FromJson(row));
    }
    return results;
  }
  catch (const nlohmann::json::exception& error)
  {
    throw std::runtime_error("Cannot parse the file " + path + ": " + error.what());
  }
}

void BenchResults::Write(const std::string& path, bool hasSpans) const
{
  nlohmann::ordered_json json;
  json["machine"] = this->Machine;
  json["vtk"] = this->Vtk;
  json["conditions"] = this->Conditions;
  json["suites"] = this->Suites;
  json["rows"] = nlohmann::ordered_json::array();
  for (const BenchRow& row : this->Rows)
  {
    json["rows"].push_back(row.ToJson(hasSpans));
  }
  std::ofstream file(path);
  file << json.dump(1) << "\n";
  if (!file)
  {
    throw std::runtime_error("Cannot write the file " + path);
  }
}

void BenchResults::SetClaims(const std::string& suite, const std::vector<BenchClaim>& claims)
{
  nlohmann::ordered_json& all = this->Suites[suite]["claims"];
  all = nlohmann::ordered_json::array();
  for (const BenchClaim& claim : claims)
  {
    all.push_back(claim.ToJson());
  }
}

std::vector<BenchRow> BenchResults::RowsOf(const std::string& suite) const
{
  std::vector<BenchRow> rows;
  std::copy_if(this->Rows.begin(), this->Rows.end(), std::back_inserter(rows),
    [&suite](const BenchRow& row) { return row.Suite == suite; });
  return rows;
}
