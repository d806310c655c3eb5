// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SpatialSampler_h
#define interlume_SpatialSampler_h

#include "vtkSpatialObject.h"

namespace interlume
{

/**
 * @class   SpatialSampler
 * @brief   the values of a spatial object along rows of an image
 *
 * Positions come from indices alone, so that a value does not depend on the extent it is made in.
 */
class SpatialSampler
{
public:
  SpatialSampler(const vtkSpatialObject* object, const double origin[3], const double spacing[3],
    int numberOfSubsamples);

  /// Computes the mean samples of \a number points from (i, j, k) on along i, of up to SpanLength.
  void SampleSpan(const int ijk[3], int number, vtkSpatialObject::Sample* means) const;

private:
  /// Adds the samples at places inside the cells, with the colours multiplied by the densities.
  void Add(
    const int ijk[3], const double place[3], int number, vtkSpatialObject::Sample* sums) const;
  /// Returns the offset of a subsample from the point, in spacings.
  double GetPlace(int subsample) const;

  const vtkSpatialObject* Object;
  double Origin[3];
  double Spacing[3];
  int NumberOfSubsamples;
};

}

#endif
