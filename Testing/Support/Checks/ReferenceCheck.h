// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceCheck_h
#define ReferenceCheck_h

#include <initializer_list> // for the checks of a test
#include <string>           // for the labels
#include <type_traits>      // for what Equal refuses

namespace reference
{

/**
 * @class   Check
 * @brief   collects the failed expectations of one test
 *
 * Each failure is printed to standard error with what was expected and what was found; the first
 * twenty of a test in full, the others are only counted. A test ends with `return check.Result();`.
 */
class Check
{
public:
  /// Expects \a condition; \a what says what should hold.
  bool That(bool condition, const std::string& what);
  /// Expects found == expected.
  bool Equal(long long found, long long expected, const std::string& what);
  /// Floating point would be cut to whole numbers; Near compares it, exactly with tolerance 0.
  template <typename Found, typename Expected,
    typename = std::enable_if_t<std::is_floating_point<Found>::value ||
      std::is_floating_point<Expected>::value>>
  bool Equal(Found found, Expected expected, const std::string& what) = delete;
  /// Expects |found - expected| <= tolerance * max(|expected|, scale).
  bool Near(
    double found, double expected, double tolerance, const std::string& what, double scale = 0.0);
  /// Expects \a part somewhere in \a text.
  bool Contains(const std::string& text, const std::string& part);
  /// Text put before each failure printed from now on.
  void SetContext(const std::string& context) { this->Context = context; }

  int GetNumberOfFailures() const { return this->Failures; }
  long long GetNumberOfChecks() const { return this->Checks; }
  /// EXIT_SUCCESS when checks were made and none failed; prints both counts.
  int Result() const;

private:
  void Fail(const std::string& what);

  std::string Context;
  int Failures = 0;
  long long Checks = 0;
};

/// Calls each of \a checks, with an empty context, and returns the exit code of the test.
int RunChecks(std::initializer_list<void (*)(Check&)> checks);

}

#endif
