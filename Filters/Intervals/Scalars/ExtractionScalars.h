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
 * @brief   codes and edge weights from scalars of any type
 *
 * This is all that an extraction needs of the scalars; the rest of it does not depend on their
 * type.
 */
class ExtractionScalars
{
public:
  using Code = ExtractionValues::Code;

  /// Makes the object for one grid. \a scalars are as ExtractionDispatch::MakeContiguous gives
  /// them. \a nonFinite has a mark for each point whose value counts as NaN, or is null if no
  /// point has one. All arguments must outlive the result.
  static std::unique_ptr<ExtractionScalars> Make(vtkDataArray* scalars,
    const ExtractionValues& values, const unsigned char* nonFinite = nullptr);

  /**
   * Makes the object for two grids of \a split points each: ids from \a split on are points of the
   * second. Only crossings are placed. Arrays of different types are taken as double.
   */
  static std::unique_ptr<ExtractionScalars> MakePair(
    vtkDataArray* first, vtkDataArray* second, vtkIdType split, const ExtractionValues& values);

  virtual ~ExtractionScalars() = default;

  /// Computes the codes of points first ... first + number - 1. Returns whether all values are
  /// finite.
  virtual bool Classify(vtkIdType first, vtkIdType number, Code* codes) const = 0;

  /// Sets the bits of a row of \a number points from \a first on, against the least isovalue.
  /// Returns what there is besides Above.
  virtual BitRows::Kinds Compare(
    vtkIdType first, vtkIdType number, const BitRows::Row& row) const = 0;

  /**
   * Puts crossings in their places. On entry Near < Far are the ends of the edge and Weight is the
   * number of the isovalue that crosses it; where Near equals Far nothing is done.
   */
  virtual void Place(ExtractionPoint* points, vtkIdType number) const = 0;
};

}

#endif
