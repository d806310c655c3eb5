// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/Scene.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace gallery
{
namespace
{
std::vector<Scene>& Registry()
{
  static std::vector<Scene> scenes;
  return scenes;
}

/// Returns the chapter and the number of the figure within the chapter. As strings, "3.10" would
/// sort before "3.3".
std::pair<int, int> FigureNumber(const Scene& scene)
{
  const std::string::size_type dot = scene.Figure.find('.');
  const std::string number = dot == std::string::npos ? "" : scene.Figure.substr(dot + 1);
  return { std::atoi(scene.Figure.c_str()), std::atoi(number.c_str()) };
}
}

const std::vector<Scene>& AllScenes()
{
  return Registry();
}

const Scene* FindScene(const std::string& id)
{
  const std::vector<Scene>& scenes = Registry();
  const auto found = std::find_if(
    scenes.begin(), scenes.end(), [&id](const Scene& scene) { return scene.Id == id; });
  return found == scenes.end() ? nullptr : &*found;
}

SceneRegistration::SceneRegistration(const Scene& scene)
{
  std::vector<Scene>& scenes = Registry();
  const auto position = std::upper_bound(scenes.begin(), scenes.end(), scene,
    [](const Scene& a, const Scene& b)
    { return std::make_pair(FigureNumber(a), a.Id) < std::make_pair(FigureNumber(b), b.Id); });
  scenes.insert(position, scene);
}
}
