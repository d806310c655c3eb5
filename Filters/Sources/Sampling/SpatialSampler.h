// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SpatialSampler_h
#define interlume_SpatialSampler_h

#include "vtkSpatialObject.h"

namespace interlume
{

/**
 * @class   SpatialSampler
 * @brief   samples a spatial object along rows of an image
 *
 * Positions are computed from indices only. Therefore values do not depend on the requested extent.
 */
class SpatialSampler
{
public:
  SpatialSampler(const vtkSpatialObject* object, const double origin[3], const double spacing[3],
    int numberOfSubsamples);

  /// Computes the mean of the subsamples for each of \a number points along i, starting at (i, j,
  /// k). \a number is at most vtkSpatialObject::SpanLength.
  void SampleSpan(const int ijk[3], int number, vtkSpatialObject::Sample* means) const;

private:
  /// Adds the samples at one offset from each point, with colors multiplied by densities.
  void Add(
    const int ijk[3], const double offset[3], int number, vtkSpatialObject::Sample* sums) const;
  /// Returns the offset of a subsample from the point, relative to the spacing.
  double GetOffset(int subsample) const;

  const vtkSpatialObject* Object;
  double Origin[3];
  double Spacing[3];
  int NumberOfSubsamples;
};

}

#endif
