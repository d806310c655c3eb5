// SPDX-License-Identifier: BSD-3-Clause
#ifndef SceneCosts_h
#define SceneCosts_h

#include "Gallery/Costs/ExecutionWatch.h"

#include <map>
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
  /// What is left of it once it was on, over what there was before; Seconds are those by which the
  /// median of runs after it is longer than that of runs before.
  Costs Left;
  /// What it adds while it is on.
  Costs Added;
  /// The median seconds of runs before, and the spread of these: the third quartile less the first.
  double Seconds = 0.0;
  double Spread = 0.0;
};

struct SceneCosts
{
  std::string Scene;
  /// What each class executed while the scene was built. A class that is not here has made nothing.
  std::map<std::string, ExecutionCosts> Executed;
  /// Each class of filters and mappers that the scene has, once for each feature that is off.
  std::vector<FeatureCosts> Features;
};

/**
 * Builds a scene, draws its panels with \a width x \a height pixels, and switches every feature
 * that is off on and off again in each object that could have it: one run and \a runs more of each
 * state, of which the median is the time, each in a new window after one drawing in another. Of
 * objects of one class the first without the feature counts. Only features of \a onlyClass where it
 * is given.
 */
SceneCosts MeasureSceneCosts(
  const Scene& scene, int width, int height, int runs, const std::string& onlyClass = {});
}

#endif
