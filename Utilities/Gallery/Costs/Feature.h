// SPDX-License-Identifier: BSD-3-Clause
#ifndef Feature_h
#define Feature_h

#include <functional>
#include <string>
#include <vector>

class vtkObject;

namespace gallery
{
/**
 * What an object can do besides, at a cost: an output, an array, a way to draw.
 */
struct Feature
{
  /// The class of the object, and the feature, as its setting is called.
  std::string Class;
  std::string Name;
  /// Whether the object does it in what it executed or drew last.
  std::function<bool(vtkObject* object)> IsOn;
  /// The sum of those numbers of the object's report and outputs that are of this feature alone,
  /// all of them numbers of what was made: 0 where it is off.
  std::function<double(vtkObject* object)> Own;
  /// Switches it on. Returns what switches it off again.
  std::function<std::function<void()>(vtkObject* object)> SwitchOn;
};

/// Returns the features of filters, and of what draws: mappers of volumes and the pass of mixed
/// scenes.
const std::vector<Feature>& AllFeatures();
}

#endif
