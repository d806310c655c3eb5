// SPDX-License-Identifier: BSD-3-Clause
#ifndef StabilityCase_h
#define StabilityCase_h

#include <limits>
#include <string>
#include <vector>

/**
 * One extreme that a test put in, and what came out of it.
 */
struct StabilityCase
{
  /// The public class that was given the extreme.
  std::string Class;
  /// Short and unique within a test, such as `range-1e-30`.
  std::string Name;
  /// What is extreme about the input.
  std::string Extreme;
  /// What should happen.
  std::string Expected;
  /// What happened, in words or as the number compared with Bound.
  std::string Measured;
  /// The largest value of the number measured that passes; NaN where the case is yes or no.
  double Bound = std::numeric_limits<double>::quiet_NaN();
  bool Passed = false;
  /// Where several methods could be chosen from, as for stiff fields: which one was, and its steps.
  /// Empty elsewhere.
  std::string Method;
  /// The test it comes from.
  std::string Test;
};

/// The numbers of cases of a class: all, those that passed, and those compared with a bound.
struct StabilityCount
{
  std::string Class;
  int Cases = 0;
  int Passed = 0;
  int Measured = 0;
};

/// Counts the cases of each class, by name.
std::vector<StabilityCount> CountByClass(const std::vector<StabilityCase>& cases);

/**
 * @class   StabilityCatalogue
 * @brief   by which a test with label `stability` reports its cases
 *
 * A test makes one of these, names the class, reports each case, and returns GetExitCode():
 *
 * @code
 * StabilityCatalogue catalogue("TestStabilityValues", argc, argv);
 * catalogue.SetClass("vtkIntervalVolume");
 * catalogue.Measure("range-1e-30", "values within 1e-30", "volume as at scale 1", error, 1e-12);
 * catalogue.Check("missing-array", "no such array", "error names it", message, named && empty);
 * return catalogue.GetExitCode();
 * @endcode
 *
 * Every case prints one line. All cases of the test are kept in the file `<test>.stability.json`,
 * in the folder named by the environment variable INTERLUME_STABILITY_DIR, else by the argument
 * that follows `-T`; with neither there is no file. The file is written anew after every case, so
 * that a crash leaves the cases before it, and says whether the test came to its end.
 * `interlume-bench report` gathers the files.
 */
class StabilityCatalogue
{
public:
  StabilityCatalogue(const std::string& test, int argc, char* argv[]);

  /// Names the public class that the cases after this are of.
  void SetClass(const std::string& name);

  /**
   * Reports a case that passes when 0 <= |measured| <= bound; NaN fails. Returns whether it passed.
   * Throws std::logic_error without a class.
   */
  bool Measure(const std::string& name, const std::string& extreme, const std::string& expected,
    double measured, double bound, const std::string& method = {});

  /**
   * Reports a case that is right or wrong, with what was seen in words. Returns \a passed. Throws
   * std::logic_error without a class.
   */
  bool Check(const std::string& name, const std::string& extreme, const std::string& expected,
    const std::string& measured, bool passed, const std::string& method = {});

  /**
   * Ends the catalogue. Returns EXIT_SUCCESS when there was a case and every case passed.
   */
  int GetExitCode();

  /**
   * Returns the cases of the tests that \a folder/tests.txt names, in its order, then as reported.
   * That file has a line for each test: its name, a tab, and its program. Throws
   * std::runtime_error with all that is wrong where the file is missing or empty, and for each test
   * whose cases are missing, none, those of a run that did not come to its end or was before its
   * program was made anew, or not such a catalogue, and for cases of a test that is not named.
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
