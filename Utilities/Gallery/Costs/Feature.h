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
 * An optional feature of an object that costs time or memory, such as an output, an array or a
 * rendering mode.
 */
struct Feature
{
  /// Class of the object, and name of the feature, which is usually the name of the setting that
  /// controls it.
  std::string Class;
  std::string Name;
  /// Returns true if the last execution or rendering of the object used the feature.
  std::function<bool(vtkObject* object)> IsOn;
  /// Returns the sum of those values in the object's report and outputs that must be 0 while the
  /// feature is off.
  std::function<double(vtkObject* object)> Own;
  /// Switches the feature on. Returns a function that restores the previous state.
  std::function<std::function<void()>(vtkObject* object)> SwitchOn;
};

/// Returns the features of filters, volume mappers and vtkShadowedScenePass.
const std::vector<Feature>& AllFeatures();
}

#endif
