// SPDX-License-Identifier: BSD-3-Clause
#ifndef SceneCosts_h
#define SceneCosts_h

#include <string>
#include <vector>

namespace gallery
{
struct Scene;

/**
 * Costs of executing a filter or of rendering a panel. For rendering, Buffers, Bytes and Words are
 * queried from OpenGL. For filters, Arrays and Bytes are those of the outputs.
 */
struct Costs
{
  /// Number of passes reported by mappers and render passes, or number of executions of a filter.
  double Passes = 0.0;
  double Buffers = 0.0;
  double Bytes = 0.0;
  double Words = 0.0;
  double Arrays = 0.0;
  /// CPU time of all threads, which other programs do not affect.
  double Seconds = 0.0;
};
Costs Subtract(const Costs& one, const Costs& other);

/**
 * Costs of a feature that an object of a scene does not use, measured before it is switched on,
 * while it is on, and after it is switched off again.
 */
struct FeatureCosts
{
  std::string Class;
  std::string Feature;
  /// Value of Feature::Own before the feature was switched on, while it was on, and after it was
  /// switched off again.
  double OwnOff = 0.0;
  double OwnOn = 0.0;
  double OwnAfter = 0.0;
  /// Costs after the feature was switched off again, minus the costs before it was switched on.
  Costs Left;
  /// Costs while the feature was on, minus the costs before it was switched on.
  Costs Added;
  /// Median time in seconds of the object's counterpart, in which no feature is ever switched on.
  double Seconds = 0.0;
  /// Noise of the times, in seconds: the interquartile range of the time differences between object
  /// and counterpart, before any feature was switched on or after this feature was switched off,
  /// whichever is larger.
  double Noise = 0.0;
  /// Number of pairs of runs that determine the time in Left (Pairs) and in Added (PairsOn).
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
  /// Number of pairs of runs in each state. If 0, times are not measured.
  int Pairs = 5;
  /// Time limit for each state in seconds. At least two pairs of runs are always measured.
  double Limit = 10.0;
  /// If not empty, only the features of this class are measured.
  std::string OnlyClass;
};

/**
 * Builds a scene, draws its panels, and measures every feature that is off in some filter, mapper
 * or render pass: it is switched on, then off again, in the first such object. Returns one entry
 * for each class and feature.
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
