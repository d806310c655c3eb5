#ifndef vtkExtractionScalars_h
#define vtkExtractionScalars_h

#include "vtkExtractionContext.h"

#include <memory>

/**
 * @class   vtkExtractionScalars
 * @brief   codes and edge weights from scalars of any type
 *
 * All that an extraction needs of the scalars; the rest of it does not depend on their type.
 */
class vtkExtractionScalars
{
public:
  using Code = vtkExtractionValues::Code;

  /// \a scalars are as vtkExtractionDispatch::MakeContiguous gives them; they and \a values must outlive the result.
  static std::unique_ptr<vtkExtractionScalars> Make(
    vtkDataArray* scalars, const vtkExtractionValues& values);

  /**
   * The same for two grids of \a split points each: ids from \a split on are points of the second.
   * Only crossings are placed. Arrays of different types are taken as double.
   */
  static std::unique_ptr<vtkExtractionScalars> MakePair(
    vtkDataArray* first, vtkDataArray* second, vtkIdType split, const vtkExtractionValues& values);

  virtual ~vtkExtractionScalars() = default;

  /// The codes of points first ... first + number - 1. Returns whether all are finite.
  virtual bool Classify(vtkIdType first, vtkIdType number, Code* codes) const = 0;

  /**
   * Puts crossings in their places. On entry Near < Far are the ends of the edge and Weight is the
   * number of the isovalue that crosses it; where Near equals Far nothing is done.
   */
  virtual void Place(vtkExtractionPoint* points, vtkIdType number) const = 0;
};

#endif
