// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkInterlumeReport_h
#define vtkInterlumeReport_h

#include "InterlumeCommonModule.h" // for the export macro
#include "vtkFieldData.h"

#include <string> // for names and text

/**
 * @class   vtkInterlumeReport
 * @brief   named values that describe the last execution of a filter or mapper
 *
 * GetReport() of a filter or mapper returns its report. Each execution replaces the values. The
 * class documentation of the filter or mapper lists the values intended for applications. Other
 * values are for tests and benchmarks, and their names may change.
 *
 * Each value is an array of vtkFieldData: vtkIdTypeArray for counts, sizes in bytes, ids and flags
 * (0 or 1), vtkDoubleArray for other numbers, and vtkStringArray for text. Most values have one
 * entry. In Python, interlume.report(filter) returns the values as a dictionary.
 */
class INTERLUMECOMMON_EXPORT vtkInterlumeReport : public vtkFieldData
{
public:
  static vtkInterlumeReport* New();
  vtkTypeMacro(vtkInterlumeReport, vtkFieldData);
  /// Print one line `Name: value` per value.
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Return whether the report has a value with the given name.
  bool Has(const std::string& name) { return this->GetAbstractArray(name.c_str()) != nullptr; }

  /// Return the number of entries of a value, or 0 if there is no value with the given name.
  vtkIdType GetSize(const std::string& name);

  ///@{
  /**
   * Return an entry of a value as a number, a count or text. If the value or entry does not exist
   * or has another type, report an error and return NaN, -1 or an empty string.
   */
  double GetNumber(const std::string& name, vtkIdType entry = 0);
  vtkIdType GetCount(const std::string& name, vtkIdType entry = 0);
  std::string GetText(const std::string& name, vtkIdType entry = 0);
  ///@}

  /// Return whether \a other has the same names in the same order, with equal values. NaN equals
  /// NaN.
  bool IsEqual(vtkInterlumeReport* other);

protected:
  vtkInterlumeReport();
  ~vtkInterlumeReport() override;

private:
  vtkInterlumeReport(const vtkInterlumeReport&) = delete;
  void operator=(const vtkInterlumeReport&) = delete;
};

#endif
