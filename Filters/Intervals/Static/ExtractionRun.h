// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ExtractionRun_h
#define interlume_ExtractionRun_h

#include "Common/Error.h"
#include "Output/ExtractionReport.h"
#include "Output/SizeWarning.h"
#include "Static/EmptyOutputDiagnosis.h"
#include "Static/RefinementLevels.h"

#include <functional>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataArray;
class vtkDataSet;

namespace interlume
{

class ExtractionIndex;

/**
 * @class   ExtractionRun
 * @brief   one execution of an extraction filter over all datasets of its input
 *
 * Checks the scalars of each dataset, accumulates the reports, and issues the errors and warnings
 * of the filter.
 */
class ExtractionRun
{
public:
  /// \a names are one-component arrays that are needed in addition to the scalars. \a index is null
  /// if there is none. \a previewCellLimit is the number of cells of a preview, which needs an
  /// index, or 0. \a sizeWarningLimit is a number of tetrahedra, or 0 for no warning.
  ExtractionRun(vtkAlgorithm* owner, const std::vector<std::string>& names, ExtractionIndex* index,
    vtkIdType previewCellLimit, vtkIdType sizeWarningLimit = 0);

  ExtractionIndex* GetIndex() const { return this->Index; }

  /// Returns true if structured grids are extracted from coarse copies.
  bool IsCoarse() const { return this->Stride > 1; }

  /// Returns the scalars of a dataset. Sets \a input to its coarse copy if there is one, and to a
  /// copy with point arrays if cell arrays are converted. Issues an error and returns null if the
  /// scalars are invalid or if \a findError, which checks the filter's parameters afterward,
  /// returns an error.
  vtkDataArray* FindScalars(vtkDataSet*& input, const std::function<Error()>& findError);

  /// Adds the report of a dataset and issues its warnings, except in previews. \a dimension is the
  /// dimension of the cells that were extracted.
  void Add(vtkDataSet* input, int dimension, int precision, const ExtractionReport& report);

  ExtractionReport& GetReport() { return this->Report; }

  SizeWarning& GetSizeWarning() { return this->Size; }

  EmptyOutputDiagnosis& GetEmptyOutputDiagnosis() { return this->Empty; }

  /// What the filter extracts.
  struct Goal
  {
    /// The intervals to extract; an isosurface is an interval of zero width.
    std::vector<vtkIntervalList::Interval> Intervals;
    /// Arguments of EmptyOutputDiagnosis::Explain().
    std::string Sought;
    std::string Unset;
  };

  /// Finishes the run: checks AMR levels, gathers the load balance if \a gathersBalance is true,
  /// copies the report to \a report, and warns about an empty output if \a warnsIfEmpty is true.
  /// Previews check no levels and do not warn.
  void Finish(const Goal& goal, bool gathersBalance, bool warnsIfEmpty, vtkInterlumeReport* report);

private:
  vtkAlgorithm* Owner;
  ExtractionIndex* Index;
  // Distance between the points of coarse copies; 0 if the run is not a preview.
  int Stride;
  CellArrayConversion Conversion;
  ExtractionReport Report;
  EmptyOutputDiagnosis Empty;
  SizeWarning Size;
};

}

#endif
