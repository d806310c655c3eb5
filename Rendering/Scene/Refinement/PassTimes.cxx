// SPDX-License-Identifier: BSD-3-Clause
#include "Refinement/PassTimes.h"

#include "Refinement/ImageRefinement.h"

#include <cmath>

namespace interlume
{

namespace
{
// Values that ChooseCoarseness may return.
constexpr std::array<double, 7> COARSENESS_FACTORS{ { 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0 } };
}

double PassTimes::ChooseCoarseness(double seconds, double lastCoarseness, double allocated)
{
  const double full = seconds * std::pow(lastCoarseness, 3.0);
  for (const double coarseness : COARSENESS_FACTORS)
  {
    if (full <= allocated * std::pow(coarseness, 3.0))
    {
      return coarseness;
    }
  }
  return COARSENESS_FACTORS.back();
}

double PassTimes::GetFinalSeconds(const std::array<int, 2>& size, double estimate)
{
  if (size != this->Size)
  {
    *this = PassTimes();
    this->Size = size;
  }
  if (!this->IsFinalMeasured)
  {
    this->FinalSeconds = estimate;
  }
  return this->FinalSeconds;
}

double PassTimes::Choose(double seconds) const
{
  return this->CoarseSeconds > 0.0 && seconds <= ImageRefinement::FIRST_SECONDS
    ? ChooseCoarseness(this->CoarseSeconds, this->Coarseness, seconds)
    : ChooseCoarseness(this->FinalSeconds, 1.0, seconds);
}

void PassTimes::Add(double coarseness, double seconds)
{
  if (coarseness > 1.0)
  {
    this->CoarseSeconds = seconds;
    this->Coarseness = coarseness;
  }
  else
  {
    this->FinalSeconds = seconds;
    this->IsFinalMeasured = true;
  }
}

}
