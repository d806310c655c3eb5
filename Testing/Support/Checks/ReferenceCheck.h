// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceCheck_h
#define ReferenceCheck_h

#include <initializer_list> // for the list of checks
#include <string>           // for the labels
#include <type_traits>      // for std::enable_if_t

namespace reference
{

/**
 * @class   Check
 * @brief   collects the failed expectations of one test
 *
 * Prints each failure to standard error with the expected and the found value. Only the first
 * twenty failures of a test are printed; later failures are only counted. A test ends with `return
 * check.Result();`.
 */
class Check
{
public:
  /// Expects \a condition. \a what describes the expectation.
  bool That(bool condition, const std::string& what);
  /// Expects found == expected.
  bool Equal(long long found, long long expected, const std::string& what);
  /// Deleted, because the overload above would truncate floating-point values to integers. Use
  /// Near(), with tolerance 0 to test for equality.
  template <typename Found, typename Expected,
    typename = std::enable_if_t<std::is_floating_point<Found>::value ||
      std::is_floating_point<Expected>::value>>
  bool Equal(Found found, Expected expected, const std::string& what) = delete;
  /// Expects |found - expected| <= tolerance * max(|expected|, scale).
  bool Near(
    double found, double expected, double tolerance, const std::string& what, double scale = 0.0);
  /// Expects \a text to contain \a part.
  bool Contains(const std::string& text, const std::string& part);
  /// Sets the prefix of all subsequent failure messages.
  void SetContext(const std::string& context) { this->Context = context; }

  int GetNumberOfFailures() const { return this->Failures; }
  long long GetNumberOfChecks() const { return this->Checks; }
  /// Prints how many checks passed and failed. Returns EXIT_SUCCESS if there was at least one check
  /// and no failure.
  int Result() const;

private:
  void Fail(const std::string& what);

  std::string Context;
  int Failures = 0;
  long long Checks = 0;
};

/// Calls each of \a checks with an empty context, and returns the exit code of the test.
int RunChecks(std::initializer_list<void (*)(Check&)> checks);

}

#endif
