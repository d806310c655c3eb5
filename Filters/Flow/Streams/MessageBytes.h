// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_MessageBytes_h
#define interlume_MessageBytes_h

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

namespace interlume
{

/// Serialization of trivially copyable values, for messages between processes on machines of the
/// same architecture.
namespace MessageBytes
{
template <typename Value>
void Put(std::vector<char>& bytes, const Value& value)
{
  static_assert(std::is_trivially_copyable_v<Value>, "values are sent bytewise");
  const char* first = reinterpret_cast<const char*>(&value);
  bytes.insert(bytes.end(), first, first + sizeof(Value));
}

inline void Put(std::vector<char>& bytes, const std::vector<double>& numbers)
{
  Put(bytes, static_cast<std::uint64_t>(numbers.size()));
  const char* first = reinterpret_cast<const char*>(numbers.data());
  bytes.insert(bytes.end(), first, first + numbers.size() * sizeof(double));
}

/// Reads a value at \a at and advances \a at past it.
template <typename Value>
void Get(const char*& at, Value& value)
{
  static_assert(std::is_trivially_copyable_v<Value>, "values are sent bytewise");
  std::memcpy(static_cast<void*>(&value), at, sizeof(Value));
  at += sizeof(Value);
}

inline void Get(const char*& at, std::vector<double>& numbers)
{
  std::uint64_t number = 0;
  Get(at, number);
  numbers.resize(static_cast<std::size_t>(number));
  if (number > 0)
  {
    std::memcpy(numbers.data(), at, numbers.size() * sizeof(double));
    at += numbers.size() * sizeof(double);
  }
}
}

}

#endif
