// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_RefinementLevels_h
#define interlume_RefinementLevels_h

#include "vtkIntervalList.h"

#include <functional>
#include <string>
#include <vector>

class vtkAbstractArray;
class vtkDataObject;
class vtkDataSet;

namespace interlume
{

struct ExtractionReport;

/// Returns the array that a filter processes in a dataset, and its association.
using ArrayFinder = std::function<vtkAbstractArray*(vtkDataSet* input, int& association)>;

/**
 * @class   RefinementLevels
 * @brief   checks the levels of an AMR dataset, which are extracted independently
 *
 * Finds cells with output that are covered by cells of a finer level, and faces between two levels
 * that an isovalue intersects, where the surfaces of the levels do not match. Other datasets are
 * ignored.
 */
class RefinementLevels
{
public:
  /// Counts such cells and faces and adds the counts to \a report. An isosurface is an interval of
  /// zero width.
  static void Count(vtkDataObject* input, const std::vector<vtkIntervalList::Interval>& intervals,
    const ArrayFinder& findArray, ExtractionReport& report);

  /// Returns warnings for nonzero counts.
  static std::vector<std::string> GetWarnings(const ExtractionReport& report);
};

}

#endif
