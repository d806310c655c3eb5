// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_NamedValue_h
#define interlume_NamedValue_h

#include "vtkIndent.h"

#include <array>
#include <cstddef>
#include <initializer_list>
#include <ostream>
#include <vector>

namespace interlume
{

/**
 * @class   NamedValue
 * @brief   a named value that prints as a line `Name: value`, in PrintSelf and reports
 *
 * Arrays and vectors print with spaces between their values. A NamedValue refers to its value and
 * must not outlive it.
 */
class NamedValue
{
public:
  template <typename Value>
  NamedValue(const char* name, const Value& value)
    : Name(name)
    , Address(&value)
    , Write([](std::ostream& os, const void* address)
        { WriteValue(os, *static_cast<const Value*>(address)); })
  {
  }

  static void Print(std::ostream& os, vtkIndent indent, std::initializer_list<NamedValue> values)
  {
    for (const NamedValue& value : values)
    {
      os << indent << value.Name << ":";
      value.Write(os, value.Address);
      os << "\n";
    }
  }

private:
  template <typename Value>
  static void WriteValue(std::ostream& os, const Value& value)
  {
    os << " " << value;
  }
  template <std::size_t Size>
  static void WriteValue(std::ostream& os, const char (&text)[Size])
  {
    os << " " << text;
  }
  template <typename Value, std::size_t Size>
  static void WriteValue(std::ostream& os, const Value (&values)[Size])
  {
    WriteAll(os, values);
  }
  template <typename Value, std::size_t Size>
  static void WriteValue(std::ostream& os, const std::array<Value, Size>& values)
  {
    WriteAll(os, values);
  }
  template <typename Value>
  static void WriteValue(std::ostream& os, const std::vector<Value>& values)
  {
    WriteAll(os, values);
  }
  template <typename List>
  static void WriteAll(std::ostream& os, const List& values)
  {
    for (const auto& value : values)
    {
      os << " " << value;
    }
  }

  const char* Name;
  const void* Address;
  void (*Write)(std::ostream&, const void*);
};

}

#endif
