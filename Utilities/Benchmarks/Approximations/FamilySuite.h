// SPDX-License-Identifier: BSD-3-Clause
#ifndef FamilySuite_h
#define FamilySuite_h

#include "Benchmarks/Approximations/Approximation.h"
#include "Benchmarks/Suites/BenchSuite.h"

#include <string>
#include <vector>

namespace approximations
{
/**
 * A suite whose cases are questions, each with a plot of errors against run times.
 */
class FamilySuite : public BenchSuite
{
public:
  FamilySuite(const std::string& name, const std::string& title, const std::string& description,
    const std::vector<Family>& families);

  std::string GetName() const override { return this->Name; }
  std::string GetTitle() const override { return this->Title; }
  std::vector<std::string> GetDescription() const override;
  void Run(const BenchOptions& options, BenchRows& rows) const override;
  std::vector<BenchPlot> MakePlots(const std::vector<BenchRow>& rows) const override;
  std::vector<BenchClaim> CheckClaims(const std::vector<BenchRow>& rows) const override;

private:
  std::string Name;
  std::string Title;
  std::string Description;
  std::vector<Family> Families;
};
}

#endif
