// SPDX-License-Identifier: BSD-3-Clause
#ifndef StabilityCase_h
#define StabilityCase_h

#include <limits>
#include <string>
#include <vector>

/**
 * An extreme input of a stability test and its result.
 */
struct StabilityCase
{
  /// Public class under test.
  std::string Class;
  /// Short name, unique within a test, such as `range-1e-30`.
  std::string Name;
  /// Description of the extreme input.
  std::string Extreme;
  /// Expected result.
  std::string Expected;
  /// Observed result: a description, or the number that is compared with Bound.
  std::string Measured;
  /// Largest absolute value that passes, or NaN if the case is not a measurement.
  double Bound = std::numeric_limits<double>::quiet_NaN();
  bool Passed = false;
  /// Selected methods and their numbers of steps, such as `explicit: 7`. Empty if there is no
  /// choice of methods.
  std::string Method;
  std::string Test;
};

/// Numbers of cases of a class: all, passed, and measured (compared with a bound).
struct StabilityCount
{
  std::string Class;
  int Cases = 0;
  int Passed = 0;
  int Measured = 0;
};

/// Counts the cases of each class. The result is sorted by class name.
std::vector<StabilityCount> CountByClass(const std::vector<StabilityCase>& cases);

/**
 * @class   StabilityCatalogue
 * @brief   report of the cases of a test with the label `stability`
 *
 * A test creates a StabilityCatalogue, sets the class, reports each case, and returns
 * GetExitCode():
 *
 * @code
 * StabilityCatalogue catalogue("TestStabilityValues", argc, argv);
 * catalogue.SetClass("vtkIntervalVolume");
 * catalogue.Measure("range-1e-30", "values within 1e-30", "volume as at scale 1", error, 1e-12);
 * catalogue.Check("missing-array", "no such array", "error names it", message, named && empty);
 * return catalogue.GetExitCode();
 * @endcode
 *
 * Every case prints one line. All cases of the test are written to the file
 * `<test>.stability.json`, in the directory given by the environment variable
 * INTERLUME_STABILITY_DIR or else by the argument after `-T`. Without either, no file is written.
 * The file is rewritten after every case, so that the previous cases survive a crash. It also
 * records whether the test ran to completion. `interlume-bench report` reads these files.
 */
class StabilityCatalogue
{
public:
  StabilityCatalogue(const std::string& test, int argc, char* argv[]);

  /// Sets the public class of the cases that follow.
  void SetClass(const std::string& name);

  /**
   * Reports a case that passes if |measured| <= bound. NaN fails. Returns whether the case passed.
   * Throws std::logic_error if no class is set.
   */
  bool Measure(const std::string& name, const std::string& extreme, const std::string& expected,
    double measured, double bound, const std::string& method = {});

  /**
   * Reports a case that is not a measurement, with a description of the observed result. Returns \a
   * passed. Throws std::logic_error if no class is set.
   */
  bool Check(const std::string& name, const std::string& extreme, const std::string& expected,
    const std::string& measured, bool passed, const std::string& method = {});

  /**
   * Marks the report as complete. Returns EXIT_SUCCESS if there was at least one case and all cases
   * passed.
   */
  int GetExitCode();

  /**
   * Returns the cases of the tests listed in \a folder/tests.txt, in the order of that file. Each
   * of its lines is a test name, a tab, and the path of the test's program.
   *
   * Throws std::runtime_error with a list of all problems. It is an error if tests.txt is missing
   * or empty, or if there is a report of a test that is not listed. The report of each listed test
   * must exist, be valid and complete, contain a case, and not be older than the program.
   */
  static std::vector<StabilityCase> Gather(const std::string& folder);

private:
  bool Report(StabilityCase oneCase);
  void Write() const;

  std::string Test;
  std::string Folder;
  std::string Class;
  bool IsAtEnd = false;
  std::vector<StabilityCase> Cases;
};

#endif
