// SPDX-License-Identifier: BSD-3-Clause
#ifndef SceneCosts_h
#define SceneCosts_h

#include <string>
#include <vector>

namespace gallery
{
struct Scene;

/**
 * What a filter's execution or the drawing of a panel takes. Buffers, bytes and words of drawings
 * are those that OpenGL has; arrays and bytes of filters those of their outputs.
 */
struct Costs
{
  /// Passes that mappers and passes report; of filters, executions.
  double Passes = 0.0;
  double Buffers = 0.0;
  double Bytes = 0.0;
  double Words = 0.0;
  double Arrays = 0.0;
  /// Processor time of all threads, so that what else the machine does is not in it.
  double Seconds = 0.0;
};
/// Returns what \a one is more than \a other.
Costs Subtract(const Costs& one, const Costs& other);

/**
 * A feature that an object of a scene does not use: what it costs there, and what it would.
 */
struct FeatureCosts
{
  std::string Class;
  std::string Feature;
  /// The sum of the report's own numbers of the feature, before it was ever on, while it was, and
  /// after.
  double OwnOff = 0.0;
  double OwnOn = 0.0;
  double OwnAfter = 0.0;
  /// What is left of it once it was on, over what there was before it was ever on.
  Costs Left;
  /// What it adds while it is on.
  Costs Added;
  /// The median seconds of an object that never had it on.
  double Seconds = 0.0;
  /// What seconds differ by without reason: the distance of the quartiles of the pairs'
  /// differences.
  double Noise = 0.0;
  /// Pairs of runs that Left is the median of, and that Added is.
  int Pairs = 0;
  int PairsOn = 0;

  /// Whether no more seconds are left than noise.
  bool IsWithinNoise() const;
};

/// How scenes are measured.
struct CostSettings
{
  /// Pixels of a panel.
  int Width = 320;
  int Height = 200;
  /// Pairs of runs of each state; 0 for no times.
  int Pairs = 5;
  /// Seconds after which a state has no more pairs, but two.
  double Limit = 10.0;
  /// Only features of this class, where it is given.
  std::string OnlyClass;
};

/**
 * Builds a scene, draws its panels, and switches every feature that is off on and off again in each
 * object that could have it. Of objects of one class the first without the feature counts. Returns
 * each class of filters and mappers that the scene has, once for each feature that is off.
 *
 * For times the scene is built twice. Where an object has a feature in the one, the same object of
 * the other never has any, and both take turns: before the first feature, which says what they
 * differ by without any, while a feature is on, and after. Panels are drawn in a new window for
 * each state, after one drawing in another.
 */
std::vector<FeatureCosts> MeasureSceneCosts(const Scene& scene, const CostSettings& settings);
}

#endif
