// SPDX-License-Identifier: BSD-3-Clause
#include "Sampling/SpatialSampler.h"

#include <algorithm>

namespace interlume
{

SpatialSampler::SpatialSampler(const vtkSpatialObject* object, const double origin[3],
  const double spacing[3], int numberOfSubsamples)
  : Object(object)
  , NumberOfSubsamples(numberOfSubsamples)
{
  std::copy_n(origin, 3, this->Origin);
  std::copy_n(spacing, 3, this->Spacing);
}

double SpatialSampler::GetOffset(int subsample) const
{
  return (subsample + 0.5) / this->NumberOfSubsamples - 0.5;
}

void SpatialSampler::Add(
  const int ijk[3], const double offset[3], int number, vtkSpatialObject::Sample* sums) const
{
  double points[vtkSpatialObject::SpanLength][3];
  for (int i = 0; i < number; ++i)
  {
    points[i][0] = this->Origin[0] + (ijk[0] + i + offset[0]) * this->Spacing[0];
    points[i][1] = this->Origin[1] + (ijk[1] + offset[1]) * this->Spacing[1];
    points[i][2] = this->Origin[2] + (ijk[2] + offset[2]) * this->Spacing[2];
  }
  vtkSpatialObject::Sample samples[vtkSpatialObject::SpanLength];
  if (!this->Object->EvaluateSpan(points, number, samples))
  {
    return;
  }
  for (int i = 0; i < number; ++i)
  {
    sums[i].Density += samples[i].Density;
    for (int c = 0; c < 3; ++c)
    {
      sums[i].Color[c] += samples[i].Density * samples[i].Color[c];
    }
  }
}

void SpatialSampler::SampleSpan(const int ijk[3], int number, vtkSpatialObject::Sample* means) const
{
  std::fill_n(means, number, vtkSpatialObject::Sample());
  const int n = this->NumberOfSubsamples;
  for (int s = 0; s < n * n * n; ++s)
  {
    const double offset[3] = { this->GetOffset(s % n), this->GetOffset(s / n % n),
      this->GetOffset(s / (n * n)) };
    this->Add(ijk, offset, number, means);
  }
  const double count = static_cast<double>(n) * n * n;
  for (int i = 0; i < number; ++i)
  {
    if (means[i].Density > 0.0)
    {
      for (double& color : means[i].Color)
      {
        color /= means[i].Density;
      }
      means[i].Density /= count;
    }
  }
}

}
