// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ExtractionRun_h
#define interlume_ExtractionRun_h

#include "Common/Error.h"
#include "Output/ExtractionReport.h"
#include "Static/EmptyResult.h"
#include "Static/RefinementLevels.h"

#include <functional>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataArray;
class vtkDataSet;

namespace interlume
{

/**
 * @class   ExtractionRun
 * @brief   one execution of an extraction filter over all datasets of its input
 *
 * It checks the scalars of each dataset, adds up the reports, and issues the filter's errors and
 * warnings.
 */
class ExtractionRun
{
public:
  ExtractionRun(vtkAlgorithm* owner, ArrayFinder findArray);

  /// Returns the scalars of a dataset. Returns null after an error message if they or, by
  /// \a findError, the filter's parameters are invalid.
  vtkDataArray* FindScalars(vtkDataSet* input, const std::function<Error()>& findError);

  /// Adds the report of a dataset, and gives its warnings.
  void Add(vtkDataSet* input, int precision, const ExtractionReport& report);

  ExtractionReport& GetReport() { return this->Report; }

  EmptyResult& GetEmptyResult() { return this->Empty; }

  /// The intervals to extract.
  struct Goal
  {
    /// An isosurface is an interval of zero width.
    std::vector<vtkIntervalList::Interval> Intervals;
    /// Texts for EmptyResult: the goal, and the reason for an empty output if no goal is set.
    std::string Sought;
    std::string Unset;
  };

  /// Ends the run: checks levels of refinement, gathers the load balance if \a gathersBalance is
  /// true, copies the report to \a report, and warns of an empty output if \a warnsIfEmpty is true.
  void Finish(const Goal& goal, bool gathersBalance, bool warnsIfEmpty, vtkInterlumeReport* report);

private:
  vtkAlgorithm* Owner;
  ArrayFinder FindArray;
  ExtractionReport Report;
  EmptyResult Empty;
};

}

#endif
