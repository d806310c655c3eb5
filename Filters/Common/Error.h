// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_Error_h
#define interlume_Error_h

#include <cstddef>
#include <ostream>
#include <string>
#include <utility>

namespace interlume
{

enum class ErrorCode
{
  NoError,
  InvalidInput, ///< Data or settings that cannot be used. The message explains what to do.
  OutOfMemory,  ///< Main memory or the graphics card's memory.
  OpenGL,       ///< The OpenGL implementation lacks a feature or failed.
  File,         ///< A file cannot be read or written.
  Process       ///< A separate program, such as TetGen's, failed.
};

/**
 * @class   Error
 * @brief   the result of a function that can fail: a code and a message for the user, or no error
 *
 * As with std::error_code, an Error is true if there is one:
 * @code
 * if (Error error = this->ReadArrays(input))
 * {
 *   return error;
 * }
 * @endcode
 * A function returns its message, and its code if that is not InvalidInput. An empty message is no
 * error.
 */
class [[nodiscard]] Error
{
public:
  Error() = default;
  Error(const char* message)
    : Error(std::string(message))
  {
  }
  Error(std::nullptr_t) = delete;
  Error(std::string message, ErrorCode code = ErrorCode::InvalidInput)
    : Message(std::move(message))
    , Code(this->Message.empty() ? ErrorCode::NoError : code)
  {
  }

  explicit operator bool() const { return this->Code != ErrorCode::NoError; }
  ErrorCode GetCode() const { return this->Code; }
  const std::string& GetMessage() const& { return this->Message; }
  std::string GetMessage() && { return std::move(this->Message); }

  /// Returns this error or, without one, that of the next step.
  template <typename Step>
  Error Then(Step&& step) const
  {
    return *this ? *this : Error(std::forward<Step>(step)());
  }

  /// Returns an error with the same code and words around its message, or no error.
  Error Within(const std::string& before, const std::string& after = {}) const
  {
    return *this ? Error(before + this->Message + after, this->Code) : Error();
  }

  friend std::ostream& operator<<(std::ostream& os, const Error& error)
  {
    return os << error.Message;
  }

private:
  std::string Message;
  ErrorCode Code = ErrorCode::NoError;
};

}

#endif
