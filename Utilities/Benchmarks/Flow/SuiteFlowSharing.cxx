// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Flow/FlowSharing.h"
#include "Benchmarks/Suites/BenchSuites.h"

namespace
{
class SuiteFlowSharing : public BenchSuite
{
public:
  std::string GetName() const override { return "flow-sharing"; }
  std::string GetTitle() const override
  {
    return "vtkImplicitFlowField, ShareStreamlines: error of what is interpolated, run time";
  }

  std::vector<std::string> GetDescription() const override
  {
    return {
      "shared: about 100,000 samples on an image, with ShareStreamlines against all streamlines, "
      "processor time of one thread; the parameter is MaximumError over the largest speed, in the "
      "stiff saddle too. dense: as many samples in a box a quarter as wide. share: the part of the "
      "samples that are interpolated. Their errors, in units of the tolerance for the time of "
      "their streamline, have median, q99, q999 (99.9 %) and largest; an answer of another status "
      "or id is off by 1e30. within: the part of all answers whose error is at most 10.",
    };
  }

  void Run(const BenchOptions& options, BenchRows& rows) const override
  {
    flow::AddSharingRows(options, rows);
  }

  std::vector<BenchClaim> CheckClaims(const std::vector<BenchRow>& rows) const override
  {
    return flow::CheckSharingClaims(rows);
  }
};
}

std::unique_ptr<BenchSuite> MakeFlowSharingSuite()
{
  return std::make_unique<SuiteFlowSharing>();
}
