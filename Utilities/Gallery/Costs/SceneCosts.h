// SPDX-License-Identifier: BSD-3-Clause
#ifndef SceneCosts_h
#define SceneCosts_h

#include <string>
#include <vector>

namespace gallery
{
struct Scene;

/**
 * Costs of executing a filter or of rendering a panel. For rendering, buffers, bytes and words are
 * counted in OpenGL. For filters, arrays and bytes are counted in the outputs.
 */
struct Costs
{
  /// Passes reported by mappers and render passes, or number of executions of a filter.
  double Passes = 0.0;
  double Buffers = 0.0;
  double Bytes = 0.0;
  double Words = 0.0;
  double Arrays = 0.0;
  /// Processor time of all threads, which other programs do not affect.
  double Seconds = 0.0;
};
/// Returns \a one minus \a other.
Costs Subtract(const Costs& one, const Costs& other);

/**
 * A feature that an object of a scene does not use: its cost while it is off and while it is on.
 */
struct FeatureCosts
{
  std::string Class;
  std::string Feature;
  /// Feature::Own before the feature was first switched on, while it was on, and after it was
  /// switched off.
  double OwnOff = 0.0;
  double OwnOn = 0.0;
  double OwnAfter = 0.0;
  /// Costs after the feature was switched off again, minus the costs before it was first switched
  /// on.
  Costs Left;
  /// Costs while the feature is on, minus the costs before it was first switched on.
  Costs Added;
  /// Median time of an object whose feature was never switched on, in seconds.
  double Seconds = 0.0;
  /// Noise of the times, in seconds: the larger of the interquartile ranges of the differences of
  /// pairs before the first feature was switched on and after this feature was switched off.
  double Noise = 0.0;
  /// Number of pairs of runs in the medians of Left and of Added.
  int Pairs = 0;
  int PairsOn = 0;

  /// Returns true if Left.Seconds does not exceed Noise.
  bool IsWithinNoise() const;
};

struct CostSettings
{
  /// Size of a panel in pixels.
  int Width = 320;
  int Height = 200;
  /// Pairs of runs for each state. 0 measures no times.
  int Pairs = 5;
  /// Time limit for each state in seconds. At least two pairs are measured.
  double Limit = 10.0;
  /// If not empty, measures only the features of this class.
  std::string OnlyClass;
};

/**
 * Builds a scene, draws its panels, and switches every feature that is off on and off again in the
 * first object that supports it. Returns one entry for each combination of a filter or mapper class
 * of the scene and a feature that is off.
 *
 * To measure times, the scene is built twice. Features are switched only in one copy. Runs of an
 * object alternate with runs of its counterpart in the other copy. They are repeated in each state:
 * before the first feature is switched on (which measures the difference between the copies), while
 * a feature is on, and after it is switched off again. Each state is rendered in a new window,
 * after one rendering in another window.
 */
std::vector<FeatureCosts> MeasureSceneCosts(const Scene& scene, const CostSettings& settings);
}

#endif
