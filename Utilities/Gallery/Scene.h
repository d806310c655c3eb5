// SPDX-License-Identifier: BSD-3-Clause
#ifndef Scene_h
#define Scene_h

#include <string>
#include <vector>

namespace gallery
{
class Stage;

/**
 * An image of the gallery: its name, texts, data, and a function that builds its pipeline.
 *
 * A file in Scenes/ defines the build function of a scene, or of several scenes with common data,
 * and a `const SceneRegistration` for each. The file must be listed in CMakeLists.txt, and nowhere
 * else. The gallery program and the regression test with the same id render the same scene.
 */
struct Scene
{
  /// Unique name on the command line, such as `interval-linear`.
  std::string Id;
  /// Number of the corresponding figure in C. Zhang's dissertation, such as `3.3`.
  std::string Figure;
  /// Title in one line.
  std::string Title;
  /// Two or three sentences for the gallery page: what the image shows, and which details to look
  /// at.
  std::string Caption;
  /// Files in Data/ that the scene reads. Each has a row in the data manifest. Empty for analytic
  /// data.
  std::vector<std::string> Data;
  /// Builds the scene on an empty stage.
  void (*Build)(Stage& stage);
};

/**
 * Returns all registered scenes, ordered by figure number.
 */
const std::vector<Scene>& AllScenes();

/**
 * Returns the scene with this id, or nullptr.
 */
const Scene* FindScene(const std::string& id);

/**
 * Registers a scene before main() starts.
 */
class SceneRegistration
{
public:
  explicit SceneRegistration(const Scene& scene);
};
}

#endif
