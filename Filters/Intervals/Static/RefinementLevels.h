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

/// Returns the array of a dataset that a filter processes, and its association.
using ArrayFinder = std::function<vtkAbstractArray*(vtkDataSet* input, int& association)>;

/**
 * @class   RefinementLevels
 * @brief   checks the levels of an AMR dataset, which are extracted one by one
 *
 * Finds cells with output that cells of a finer level cover, and faces between cells of two levels
 * that an isovalue crosses: the surfaces of the two levels do not fit together there. Other
 * datasets are ignored.
 */
class RefinementLevels
{
public:
  /// Adds the counts to \a report. An isosurface is an interval of zero width.
  static void Count(vtkDataObject* input, const std::vector<vtkIntervalList::Interval>& intervals,
    const ArrayFinder& findArray, ExtractionReport& report);

  /// Returns warnings for the counts.
  static std::vector<std::string> GetWarnings(const ExtractionReport& report);
};

}

#endif
