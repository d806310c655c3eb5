// SPDX-License-Identifier: BSD-3-Clause
#ifndef StabilityChecks_h
#define StabilityChecks_h

#include "Support/Pages/StabilityCase.h" // for the catalog

#include <functional>
#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataArray;

/**
 * Helpers that run a filter with extreme input and report the result to the stability catalog.
 */
namespace stability
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Runs \a tests with the catalog of the test program \a test and returns the exit code. Cases
/// belong to \a className unless a test sets another class.
int RunCases(const std::string& test, const std::string& className, int argc, char* argv[],
  std::initializer_list<void (*)(StabilityCatalogue&)> tests);

/// Error and warning messages of a filter and its executive.
struct Messages
{
  std::string Errors;
  std::string Warnings;
};
Messages UpdateFilter(vtkAlgorithm* filter);

/// Returns true if no output has points.
bool IsEmpty(vtkAlgorithm* filter);

/// Reports whether a filter has empty outputs and an error that contains all of \a words, and works
/// after \a mend is called.
void ReportRejection(StabilityCatalogue& catalogue, vtkAlgorithm* filter, const std::string& name,
  const std::string& extreme, const std::vector<std::string>& words,
  const std::function<void()>& mend);
inline void ReportRejection(StabilityCatalogue& catalogue, vtkAlgorithm* filter,
  const std::string& name, const std::string& extreme, const char* words,
  const std::function<void()>& mend)
{
  ReportRejection(catalogue, filter, name, extreme, std::vector<std::string>{ words }, mend);
}

/// Reports whether a filter has no error, empty outputs, and a warning that contains \a words.
void ReportEmpty(StabilityCatalogue& catalogue, vtkAlgorithm* filter, const std::string& name,
  const std::string& extreme, const std::string& words);

/// Returns the number of array values, including NaN, outside the range from lower to upper.
/// Returns NaN if the array is null or empty.
double CountOutside(vtkDataArray* array, double lower, double upper);

/// Formats a number with at most six significant digits.
std::string FormatShort(double value);

}

#endif
