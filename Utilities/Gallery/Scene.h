// SPDX-License-Identifier: BSD-3-Clause
#ifndef Scene_h
#define Scene_h

#include <string>
#include <vector>

namespace gallery
{
class Stage;

/**
 * One picture of the gallery: what it is called, what it shows, and the pipeline that builds it.
 *
 * A file in Scenes/ defines the build functions of one scene or of several that share their data,
 * and a `const SceneRegistration` for each; nothing else has to be told of them but the list of
 * files in CMakeLists.txt. The gallery program and the regression test of the same id render the
 * same scene.
 */
struct Scene
{
  /// Unique name on the command line, such as `interval-linear`.
  std::string Id;
  /// Number of the figure of the source it answers, such as `3.3`.
  std::string Figure;
  /// One line.
  std::string Title;
  /// Two or three sentences for the page: what is seen, and what to look at.
  std::string Caption;
  /// The files of Data/ it reads; each has a row in the manifest. Empty for analytic data.
  std::vector<std::string> Data;
  /// Fills an empty stage.
  void (*Build)(Stage& stage);
};

/**
 * Every registered scene, ordered by figure number.
 */
const std::vector<Scene>& AllScenes();

/**
 * The scene of that id, or nullptr.
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
