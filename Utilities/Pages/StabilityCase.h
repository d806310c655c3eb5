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
  /// The test it comes from.
  std::string Test;
};

/**
 * @class   StabilityCatalogue
 * @brief   by which a test with label `stability` reports its cases
 *
 * A test makes one of these, reports each case, and returns GetExitCode():
 *
 * @code
 * StabilityCatalogue catalogue("TestStabilityValues", argc, argv);
 * catalogue.Measure("range-1e-30", "values within 1e-30", "volume as at scale 1", error, 1e-12);
 * catalogue.Check("missing-array", "no such array", "error names it", message, named && empty);
 * return catalogue.GetExitCode();
 * @endcode
 *
 * Every case prints one line. All cases of the test are kept in the file `<test>.stability.json`,
 * in the folder named by the environment variable INTERLUME_STABILITY_DIR, else by the argument
 * that follows `-T`; with neither there is no file. The file is written anew after every case, so
 * that a crash leaves the cases before it. `interlume-bench report` gathers the files.
 */
class StabilityCatalogue
{
public:
  StabilityCatalogue(const std::string& test, int argc, char* argv[]);

  /**
   * Reports a case that passes when 0 <= |measured| <= bound; NaN fails. Returns whether it passed.
   */
  bool Measure(const std::string& name, const std::string& extreme, const std::string& expected,
    double measured, double bound);

  /**
   * Reports a case that is right or wrong, with what was seen in words. Returns \a passed.
   */
  bool Check(const std::string& name, const std::string& extreme, const std::string& expected,
    const std::string& measured, bool passed);

  /**
   * EXIT_SUCCESS when there was a case and every case passed.
   */
  int GetExitCode() const;

  /**
   * The cases of every `*.stability.json` in \a folder, ordered by test, then as reported. Empty
   * where the folder is missing. Throws std::runtime_error, with its name, for a file that is not
   * such a catalogue.
   */
  static std::vector<StabilityCase> Gather(const std::string& folder);

private:
  bool Report(StabilityCase oneCase);
  void Write() const;

  std::string Test;
  std::string Folder;
  std::vector<StabilityCase> Cases;
};

#endif
