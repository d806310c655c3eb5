// SPDX-License-Identifier: BSD-3-Clause
#ifndef PropertySetters_h
#define PropertySetters_h

#include <nlohmann/json.hpp>

#include <functional>
#include <map>
#include <stdexcept>
#include <string>

/// What sets the properties of a proxy on an object, by the properties' names.
template <typename Class>
using Setters = std::map<std::string, std::function<void(Class*, const nlohmann::json&)>>;

/// Calls the setters of an object's properties.
template <typename Class>
void SetProperties(Class* object, const nlohmann::json& values, const Setters<Class>& setters)
{
  for (const auto& property : values.items())
  {
    const auto setter = setters.find(property.key());
    if (setter == setters.end())
    {
      throw std::runtime_error(property.key() + " is no property to set");
    }
    setter->second(object, property.value());
  }
}

/// Sets the intervals of a filter, two bounds each.
template <typename Class>
void SetIntervals(Class* filter, const nlohmann::json& bounds)
{
  const int number = static_cast<int>(bounds.size() / 2);
  filter->SetNumberOfIntervals(number);
  for (int i = 0; i < number; ++i)
  {
    filter->SetInterval(i, bounds[2 * i], bounds[2 * i + 1]);
  }
}

#endif
