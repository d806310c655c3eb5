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
  InvalidInput, ///< Unusable data or settings. The message explains what to do.
  OutOfMemory,  ///< Not enough main or GPU memory.
  OpenGL,       ///< The OpenGL implementation does not support a feature or failed.
  File,         ///< A file cannot be read or written.
  Process       ///< A separate program, such as TetGen, failed.
};

/**
 * @class   Error
 * @brief   the result of a function that can fail: an error code with a message, or no error
 *
 * Like std::error_code, an Error converts to true if there is an error:
 * `if (Error error = this->ReadArrays(input)) { return error; }`.
 * To report an error, a function returns a message, which implies the code InvalidInput, or an
 * Error with another code. An empty message means no error.
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

  /// Returns this error or, if there is none, the result of calling \a step.
  template <typename Step>
  Error Then(Step&& step) const
  {
    return *this ? *this : Error(std::forward<Step>(step)());
  }

  /// Returns this error, if any, with text added before and after its message.
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
