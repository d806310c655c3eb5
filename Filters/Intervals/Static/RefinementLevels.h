// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_RefinementLevels_h
#define interlume_RefinementLevels_h

#include "Common/CellArrayConversion.h"
#include "vtkIntervalList.h"

#include <string>
#include <vector>

class vtkDataObject;

namespace interlume
{

struct ExtractionReport;

/**
 * @class   RefinementLevels
 * @brief   checks the levels of an AMR dataset, which are extracted independently
 *
 * Finds cells that have output although a finer level covers them, and faces between two levels
 * that an isovalue intersects. At these faces, the surfaces of the two levels do not match.
 * Datasets other than AMR are ignored.
 */
class RefinementLevels
{
public:
  /// Adds the numbers of covered cells and of intersected faces between levels to \a report. An
  /// isosurface is an interval of zero width.
  static void Count(vtkDataObject* input, const std::vector<vtkIntervalList::Interval>& intervals,
    CellArrayConversion& conversion, ExtractionReport& report);

  /// Returns warnings for nonzero counts.
  static std::vector<std::string> GetWarnings(const ExtractionReport& report);
};

}

#endif
