// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ReportValue_h
#define interlume_ReportValue_h

#include "vtkInterlumeReport.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <cstring>
#include <initializer_list>
#include <string>
#include <type_traits>

namespace interlume
{

/**
 * @class   ReportValue
 * @brief   writes a named value to an array of a report
 *
 * Values are numbers, text, and C arrays, std::array and std::vector of these. A ReportValue refers
 * to its value and must not outlive it. Arrays of the report are reused, since creating them takes
 * noticeable time in filters with small inputs.
 */
class ReportValue
{
public:
  template <typename Value>
  ReportValue(const char* name, const Value& value)
    : Name(name)
    , Address(&value)
    , Write([](const void* address, vtkAbstractArray* old)
        { return WriteArray(*static_cast<const Value*>(address), old); })
  {
  }

  /// Adds values to a report. Existing values with the same names are replaced.
  static void Add(vtkInterlumeReport* report, std::initializer_list<ReportValue> values)
  {
    for (const ReportValue& value : values)
    {
      vtkAbstractArray* old = report->GetAbstractArray(value.Name);
      const vtkSmartPointer<vtkAbstractArray> array = value.Write(value.Address, old);
      if (array != old)
      {
        array->SetName(value.Name);
        report->AddArray(array);
      }
    }
  }
  /// Replaces all values of a report. If the first names in the report match, the values after them
  /// remain, so that a subsequent Add() can reuse their arrays.
  static void Set(vtkInterlumeReport* report, std::initializer_list<ReportValue> values)
  {
    if (!BeginsWith(report, values))
    {
      report->Initialize();
    }
    Add(report, values);
  }

private:
  /// Returns whether the first names in the report are those of \a values, in the same order.
  static bool BeginsWith(vtkInterlumeReport* report, std::initializer_list<ReportValue> values)
  {
    int i = 0;
    for (const ReportValue& value : values)
    {
      const char* name = report->GetArrayName(i++);
      if (!name || std::strcmp(name, value.Name) != 0)
      {
        return false;
      }
    }
    return true;
  }
  template <typename Value>
  static vtkSmartPointer<vtkAbstractArray> WriteArray(const Value& value, vtkAbstractArray* old)
  {
    if constexpr (std::is_convertible_v<Value, std::string>)
    {
      return Fill<vtkStringArray, std::string>(&value, &value + 1, old);
    }
    else if constexpr (std::is_arithmetic_v<Value>)
    {
      return FillNumbers<Value>(&value, &value + 1, old);
    }
    else
    {
      using Entry = std::decay_t<decltype(*std::begin(value))>;
      if constexpr (std::is_arithmetic_v<Entry>)
      {
        return FillNumbers<Entry>(std::begin(value), std::end(value), old);
      }
      else
      {
        return Fill<vtkStringArray, std::string>(std::begin(value), std::end(value), old);
      }
    }
  }
  template <typename Number, typename Iterator>
  static vtkSmartPointer<vtkAbstractArray> FillNumbers(
    Iterator first, Iterator last, vtkAbstractArray* old)
  {
    if constexpr (std::is_floating_point_v<Number>)
    {
      return Fill<vtkDoubleArray, double>(first, last, old);
    }
    else
    {
      return Fill<vtkIdTypeArray, vtkIdType>(first, last, old);
    }
  }
  template <typename Array, typename Entry, typename Iterator>
  static vtkSmartPointer<vtkAbstractArray> Fill(
    Iterator first, Iterator last, vtkAbstractArray* old)
  {
    vtkSmartPointer<Array> array = Array::SafeDownCast(old);
    if (!array)
    {
      array = vtkSmartPointer<Array>::New();
    }
    array->Reset();
    for (; first != last; ++first)
    {
      array->InsertNextValue(static_cast<Entry>(*first));
    }
    array->Modified();
    return array;
  }

  const char* Name;
  const void* Address;
  vtkSmartPointer<vtkAbstractArray> (*Write)(const void*, vtkAbstractArray*);
};

}

#endif
