// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ReportValue_h
#define interlume_ReportValue_h

#include "vtkInterlumeReport.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <initializer_list>
#include <string>
#include <type_traits>

namespace interlume
{

/**
 * @class   ReportValue
 * @brief   converts a named value to an array of a report
 *
 * Values are numbers, texts, and C arrays, std::array and std::vector of them.
 */
class ReportValue
{
public:
  template <typename Value>
  ReportValue(const char* name, const Value& value)
    : Array(MakeArray(value))
  {
    this->Array->SetName(name);
  }

  /// Adds values to a report. Values of the same name are replaced.
  static void Add(vtkInterlumeReport* report, std::initializer_list<ReportValue> values)
  {
    for (const ReportValue& value : values)
    {
      report->AddArray(value.Array);
    }
  }
  /// Replaces all values of a report.
  static void Set(vtkInterlumeReport* report, std::initializer_list<ReportValue> values)
  {
    report->Initialize();
    Add(report, values);
  }

private:
  template <typename Value>
  static vtkSmartPointer<vtkAbstractArray> MakeArray(const Value& value)
  {
    if constexpr (std::is_convertible_v<Value, std::string>)
    {
      return Fill<vtkStringArray, std::string>(&value, &value + 1);
    }
    else if constexpr (std::is_arithmetic_v<Value>)
    {
      return FillNumbers<Value>(&value, &value + 1);
    }
    else
    {
      using Entry = std::decay_t<decltype(*std::begin(value))>;
      if constexpr (std::is_arithmetic_v<Entry>)
      {
        return FillNumbers<Entry>(std::begin(value), std::end(value));
      }
      else
      {
        return Fill<vtkStringArray, std::string>(std::begin(value), std::end(value));
      }
    }
  }
  template <typename Number, typename Iterator>
  static vtkSmartPointer<vtkAbstractArray> FillNumbers(Iterator first, Iterator last)
  {
    if constexpr (std::is_floating_point_v<Number>)
    {
      return Fill<vtkDoubleArray, double>(first, last);
    }
    else
    {
      return Fill<vtkIdTypeArray, vtkIdType>(first, last);
    }
  }
  template <typename Array, typename Entry, typename Iterator>
  static vtkSmartPointer<vtkAbstractArray> Fill(Iterator first, Iterator last)
  {
    auto array = vtkSmartPointer<Array>::New();
    for (; first != last; ++first)
    {
      array->InsertNextValue(static_cast<Entry>(*first));
    }
    return array;
  }

  vtkSmartPointer<vtkAbstractArray> Array;
};

}

#endif
