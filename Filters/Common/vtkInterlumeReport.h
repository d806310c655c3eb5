// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkInterlumeReport_h
#define vtkInterlumeReport_h

#include "InterlumeCommonModule.h" // for the export macro
#include "vtkFieldData.h"

#include <string> // for names and texts

/**
 * @class   vtkInterlumeReport
 * @brief   named values that describe the last execution of a filter or mapper
 *
 * GetReport() of a filter or mapper returns its report, whose values are replaced by each
 * execution. The documentation of the filter or mapper lists the values to act on. Names of other
 * values, for tests and benchmarks, may change.
 *
 * Each value is an array of vtkFieldData: vtkIdTypeArray for counts, sizes in bytes, ids and flags
 * (0 or 1), vtkDoubleArray for other numbers, vtkStringArray for texts. Most have one entry. In
 * Python, interlume.report(filter) returns them as a dictionary.
 */
class INTERLUMECOMMON_EXPORT vtkInterlumeReport : public vtkFieldData
{
public:
  static vtkInterlumeReport* New();
  vtkTypeMacro(vtkInterlumeReport, vtkFieldData);
  /// Prints a line `Name: value` for each value.
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Returns whether there is a value of that name.
  bool Has(const std::string& name) { return this->GetAbstractArray(name.c_str()) != nullptr; }

  /// Returns the number of entries of a value, or 0 if there is no value of that name.
  vtkIdType GetSize(const std::string& name);

  ///@{
  /**
   * Return an entry of a value, a number or a text. Without a value of that name and kind, or
   * without that entry, an error is reported and NaN or an empty text is returned.
   */
  double GetNumber(const std::string& name, vtkIdType entry = 0);
  std::string GetText(const std::string& name, vtkIdType entry = 0);
  ///@}

  /// Returns whether two reports have the same names with the same values, NaN included, in the
  /// same order.
  bool IsEqual(vtkInterlumeReport* other);

protected:
  vtkInterlumeReport();
  ~vtkInterlumeReport() override;

private:
  vtkInterlumeReport(const vtkInterlumeReport&) = delete;
  void operator=(const vtkInterlumeReport&) = delete;
};

#endif
