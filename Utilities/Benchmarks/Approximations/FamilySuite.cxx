// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Approximations/FamilySuite.h"

namespace approximations
{
FamilySuite::FamilySuite(const std::string& name, const std::string& title,
  const std::string& description, const std::vector<Family>& families)
  : Name(name)
  , Title(title)
  , Description(description)
  , Families(families)
{
}

std::vector<std::string> FamilySuite::GetDescription() const
{
  return { this->Description,
    "default 1 in the counts: what is done where nobody asks for anything, and where the size is "
    "that of the data its finest; peer 1: by VTK. The other counts are sizes." };
}

void FamilySuite::Run(const BenchOptions& options, BenchRows& rows) const
{
  for (const Family& family : this->Families)
  {
    family.AddRows(family.Asked, options, rows);
  }
}

std::vector<BenchPlot> FamilySuite::MakePlots(const std::vector<BenchRow>& rows) const
{
  std::vector<BenchPlot> plots;
  for (const Family& family : this->Families)
  {
    plots.push_back(MakePlot(family.Asked, rows));
  }
  return plots;
}

std::vector<BenchClaim> FamilySuite::CheckClaims(const std::vector<BenchRow>& rows) const
{
  return { CheckDefaults(this->Families, rows) };
}
}
