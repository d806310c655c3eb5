// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ExtractionScalars_h
#define interlume_ExtractionScalars_h

#include "Output/ExtractionPoint.h"
#include "Scalars/BitRows.h"
#include "Scalars/ExtractionValues.h"

#include <memory>

class vtkDataArray;

namespace interlume
{

/**
 * @class   ExtractionScalars
 * @brief   computes codes of grid points and weights of edge points from scalars of any type
 *
 * The rest of an extraction is independent of the scalar type.
 */
class ExtractionScalars
{
public:
  using Code = ExtractionValues::Code;

  /// Creates the object for one grid. \a scalars is an array returned by
  /// ExtractionDispatch::MakeContiguous. \a nonFinite, if not null, has an entry per point; the
  /// values of points with nonzero entries are treated as NaN. All arguments must outlive the
  /// result.
  static std::unique_ptr<ExtractionScalars> Make(vtkDataArray* scalars,
    const ExtractionValues& values, const unsigned char* nonFinite = nullptr);

  /**
   * Creates the object for two grids with \a split points each. Ids from \a split on are points of
   * the second grid. Call only Place() on the result. Arrays of different types are converted to
   * double.
   */
  static std::unique_ptr<ExtractionScalars> MakePair(
    vtkDataArray* first, vtkDataArray* second, vtkIdType split, const ExtractionValues& values);

  virtual ~ExtractionScalars() = default;

  /// Computes the codes of points first ... first + number - 1. Returns whether all values are
  /// finite.
  virtual bool Classify(vtkIdType first, vtkIdType number, Code* codes) const = 0;

  /// Sets the bits of a row of \a number points, starting at point \a first, for the smallest
  /// isovalue. Returns which bits other than Above are set.
  virtual BitRows::Kinds Compare(
    vtkIdType first, vtkIdType number, const BitRows::Row& row) const = 0;

  /**
   * Computes the weights of edge points. On entry, Near < Far are the ends of the edge and Weight
   * is the index of the isovalue. On return, Near is the closer end. Points with Near equal to Far
   * are left unchanged.
   */
  virtual void Place(ExtractionPoint* points, vtkIdType number) const = 0;
};

}

#endif
