// SPDX-License-Identifier: BSD-3-Clause
#ifndef StabilityChecks_h
#define StabilityChecks_h

#include "Support/Pages/StabilityCase.h" // for the catalogue

#include <functional>
#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataArray;

/**
 * What most cases of extreme input of a filter ask of it.
 */
namespace stability
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Runs \a tests with the catalogue of a test and returns its exit code. Cases are of a class until
/// a test names another.
int RunCases(const std::string& test, const std::string& className, int argc, char* argv[],
  std::initializer_list<void (*)(StabilityCatalogue&)> tests);

/// What a filter and its executive said.
struct Messages
{
  std::string Errors;
  std::string Warnings;
};
Messages UpdateFilter(vtkAlgorithm* filter);

/// Returns whether no output has points.
bool IsEmpty(vtkAlgorithm* filter);

/// Reports that a filter says all of \a words in an error, has empty outputs, and works once
/// \a mend is called.
void ReportRefused(StabilityCatalogue& catalogue, vtkAlgorithm* filter, const std::string& name,
  const std::string& extreme, const std::vector<std::string>& words,
  const std::function<void()>& mend);
inline void ReportRefused(StabilityCatalogue& catalogue, vtkAlgorithm* filter,
  const std::string& name, const std::string& extreme, const char* words,
  const std::function<void()>& mend)
{
  ReportRefused(catalogue, filter, name, extreme, std::vector<std::string>{ words }, mend);
}

/// Reports that a filter gives no error, empty outputs, and a warning with \a words.
void ReportEmpty(StabilityCatalogue& catalogue, vtkAlgorithm* filter, const std::string& name,
  const std::string& extreme, const std::string& words);

/// Returns the number of values of an array that are not from lower to upper, NaN among them; NaN
/// without an array or values.
double CountOutside(vtkDataArray* array, double lower, double upper);

/// A number in few letters.
std::string Short(double value);

}

#endif
