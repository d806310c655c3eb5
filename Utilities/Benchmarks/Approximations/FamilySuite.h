// SPDX-License-Identifier: BSD-3-Clause
#ifndef FamilySuite_h
#define FamilySuite_h

#include "Benchmarks/Approximations/Approximation.h"
#include "Benchmarks/Suites/BenchSuite.h"

namespace approximations
{
/// Returns a suite whose cases are questions, each with a plot of errors against run times, and
/// whose target is that each default is on its front.
BenchSuite MakeFamilySuite(const std::string& name, const std::string& title,
  const std::string& description, const std::vector<Family>& families);
}

#endif
