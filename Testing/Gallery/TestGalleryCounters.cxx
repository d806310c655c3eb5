// SPDX-License-Identifier: BSD-3-Clause
// Reads the counters of scenes, and checks that a scene has no cost for features that are off: no
// triangle, no pass and no buffer. Arguments: the directory with gallery.json and index.html, which
// `interlume-gallery --json` wrote and whose page is checked too, and JSON files of single scenes.

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <set>
#include <string>

namespace
{
/// Numbers of textures and passes that a panel needs in VTK 9.
constexpr int WINDOW_BUFFERS = 4;
constexpr int OCCLUSION_BUFFERS = 5;
constexpr int OCCLUSION_PASSES = 2;

/// Scenes that turn off ambient occlusion, since its noise would show on their smooth surfaces.
const std::set<std::string> WITHOUT_OCCLUSION = { "flow-disk", "flow-obstacle",
  "flow-volume-boundary", "hurricane-inflow", "implicit-stream", "inflow-dual", "inflow-post",
  "interval-linear", "interval-two-attributes", "streamline-zoom", "time-boundaries", "time-clip",
  "time-slices", "time-surfaces" };

class Checker
{
public:
  explicit Checker(const std::string& folder)
    : Page(ReadText(folder + "/index.html"))
    , Folder(folder)
  {
  }

  static std::string ReadText(const std::string& path)
  {
    std::ifstream file(path);
    return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
  }

  void CheckScene(const nlohmann::json& scene)
  {
    this->Scene = scene.at("id").get<std::string>();
    const auto features = scene.at("features").get<std::set<std::string>>();
    const auto has = [&features](const char* name) { return features.count(name) > 0; };
    const nlohmann::json& extraction = scene.at("extraction");
    const int panels = scene.at("panels");

    const bool isExtracted = scene.at("filters") > 0;
    this->Expect((scene.at("tetrahedra") > 0) == isExtracted,
      "there are tetrahedra if a filter extracts some");
    this->Expect(extraction.at("cells_visited") <= extraction.at("cells"),
      "the visited cells are among the cells");
    this->Expect((extraction.at("cells_with_output") > 0) == (isExtracted && !has("flow")),
      "some cells have output");
    this->Expect((has("boundaries") || has("stream-surfaces") || has("time-surfaces")) ==
        (scene.at("boundary_triangles") > 0),
      "there are boundary triangles only if boundaries are on");
    this->CheckFlow(scene, has("flow"));
    this->Expect(has("boundaries") ==
        (this->Scene == "interval-boundary" || this->Scene == "interval-constant" ||
          this->Scene == "time-boundaries"),
      "boundaries are on in interval-boundary, interval-constant and time-boundaries only");
    this->Expect(has("time-boundaries") ==
        (this->Scene == "time-isosurfaces" || this->Scene == "time-end-volumes" ||
          this->Scene == "time-priority"),
      "boundaries of tetrahedra are on in the three scenes about them only");
    this->Expect(has("criteria") == (scene.at("criteria") > 0),
      "there are criteria only if the feature is on");
    const int slabs = scene.at("slabs");
    this->Expect(has("time") == (slabs > 0 && scene.at("simplices") > 0),
      "there are slabs and 4-simplices only for time-varying data");
    this->Expect(!isExtracted || has("flow") ||
        extraction.at("passes") == (has("time") ? slabs : (has("criteria") ? 2 : 1)),
      "one pass per slab, and a second pass only with criteria");
    this->Expect(has("time-slices") == (this->Scene == "time-slices"),
      "time slices are on in time-slices only");
    // Boundaries have no extent in time.
    this->HasTime = has("time") && !has("time-boundaries");
    int volumePasses = 0;
    int volumeBuffers = 0;
    this->Expect(has("volumes") == !scene.at("volumes").empty(), "volumes match the features");
    for (const nlohmann::json& volume : scene.at("volumes"))
    {
      this->CheckVolume(volume);
      volumePasses += volume.at("passes").get<int>();
      volumeBuffers += volume.at("buffers").get<int>();
    }
    int shadowedLights = 0;
    int unshadowedVolumes = 0;
    this->Expect(has("slices") == !scene.at("sliced_volumes").empty(), "slices match the features");
    for (const nlohmann::json& volume : scene.at("sliced_volumes"))
    {
      this->CheckSlicedVolume(volume);
      shadowedLights += volume.at("shadowed_lights").get<int>();
      unshadowedVolumes += volume.at("shadowed_lights") == 0 ? 1 : 0;
      volumePasses += volume.at("eye_passes").get<int>() + volume.at("light_passes").get<int>() +
        volume.at("occlusion_passes").get<int>();
      volumeBuffers +=
        volume.at("image_buffers").get<int>() + volume.at("light_buffers").get<int>();
    }
    this->Expect(has("shadows") == (shadowedLights > 0), "shadows match the features");
    this->Expect(has("inflow-textures") == !scene.at("inflow_volumes").empty(),
      "inflow textures match the features");
    for (const nlohmann::json& volume : scene.at("inflow_volumes"))
    {
      this->CheckInflowVolume(volume);
      volumePasses += volume.at("passes").get<int>();
      // Each volume has its own image buffer.
      ++volumeBuffers;
    }
    const int surfacePanels = scene.at("surface_panels");
    const int occlusionPanels = scene.at("occlusion_panels");
    // Unshaded drawings and surfaces with shadows may also lack ambient occlusion.
    const bool isOcclusionOptional =
      has("slices") || has("scene-shadows") || this->Scene == "penumbra-analysis";
    const bool isOcclusionOff = WITHOUT_OCCLUSION.count(this->Scene) > 0;
    this->Expect(isOcclusionOptional ? occlusionPanels <= surfacePanels
                                     : occlusionPanels == (isOcclusionOff ? 0 : surfacePanels),
      "panels with surfaces have ambient occlusion, except some with slices and smooth surfaces");
    this->Expect(
      has("ambient-occlusion") == (occlusionPanels > 0), "ambient occlusion matches the features");
    // Surfaces are drawn once more for the shadow map of the single shadow light, except in panels
    // without shadows. With volumes, they are also drawn once for the depth buffer of the camera,
    // and the volumes need one more buffer.
    const bool isMixed = has("scene-shadows");
    const int mixedExtras = isMixed ? (has("slices") ? 3 : 1) : 0;
    this->Expect(isMixed
        ? scene.at("passes") >= surfacePanels * 2 - unshadowedVolumes + volumePasses
        : scene.at("passes") == surfacePanels + occlusionPanels * OCCLUSION_PASSES + volumePasses,
      "one pass for the surfaces of a panel, plus the passes of ambient occlusion and volumes");
    const int buffers = panels * WINDOW_BUFFERS + occlusionPanels * OCCLUSION_BUFFERS +
      volumeBuffers + panels * mixedExtras;
    this->Expect(isMixed ? scene.at("buffers") <= buffers : scene.at("buffers") == buffers,
      "no buffers except for the window, ambient occlusion, volumes and mixed shadows");
    this->Expect(scene.at("bytes") > 0, "the sizes of buffers are counted");
    this->Expect(scene.at("seconds") > 0.0, "the time is measured");
  }

  /// Checks that the page shows the scene whose counters were checked last.
  void CheckPage(const nlohmann::json& scene)
  {
    this->Expect(this->Page.find("src=\"" + this->Scene + ".png\"") != std::string::npos,
      "the page shows the image");
    this->Expect(
      std::ifstream(this->Folder + "/" + this->Scene + ".png").good(), "the image file exists");
    this->CheckFrames(scene);
  }

  /// Checks that consecutive frames of an animation differ, and that the page plays them.
  void CheckFrames(const nlohmann::json& scene)
  {
    const int frames = scene.at("frames");
    this->Expect(
      (frames > 0) == (this->Scene == "inflow-post"), "only inflow-post has an animation");
    std::string before;
    for (int i = 0; i < frames; ++i)
    {
      const std::string number = std::to_string(i);
      const std::string name =
        this->Scene + "/" + std::string(3 - number.size(), '0') + number + ".png";
      const std::string bytes = ReadText(this->Folder + "/" + name);
      this->Expect(!bytes.empty() && bytes != before, "there is a new frame " + number);
      this->Expect(this->Page.find('"' + name + '"') != std::string::npos,
        "frame " + number + " is on the page");
      before = bytes;
    }
    const std::string movie = this->Scene + ".ogv";
    const bool hasMovie = scene.at("movie");
    this->Expect(hasMovie == (ReadText(this->Folder + "/" + movie).substr(0, 4) == "OggS"),
      "a movie exists if the report contains one");
    this->Expect(hasMovie == (this->Page.find("href=\"" + movie) != std::string::npos),
      "the page links the movie");
  }

  void CheckFlow(const nlohmann::json& scene, bool hasFlow)
  {
    this->Expect(
      (scene.at("flow_cells") > 0) == hasFlow, "there are flow cells only in flow scenes");
    this->Expect(scene.at("flow_cells_left_out") < scene.at("flow_cells") || !hasFlow,
      "some flow cells are not skipped");
    const int filters = scene.at("filters");
    const int inflowPasses = scene.at("inflow_passes");
    const int timePasses = scene.at("time_passes");
    this->Expect(
      inflowPasses <= filters && timePasses <= filters, "each extraction runs at most once");
    this->Expect(
      (inflowPasses + timePasses > 0) == hasFlow, "there are extractions only in flow scenes");
    this->Expect((inflowPasses > 0) == (hasFlow && scene.at("intervals") > 0),
      "there are inflow passes only with intervals");
  }

  void CheckVolume(const nlohmann::json& volume)
  {
    const std::string features = " " + volume.at("features").get<std::string>() + " ";
    const auto has = [&features](const std::string& name)
    { return features.find(" " + name + " ") != std::string::npos; };
    const std::string sort = volume.at("sort");
    const std::string blend = volume.at("blend");

    this->Expect(!has("delta-t") || this->HasTime,
      "shaders have code for time extents only in time-varying scenes");
    this->Expect(has("surface") == (volume.at("boundary_triangles") > 0),
      "shaders have code for boundary triangles only if there are some");
    const std::set<std::string> parallel{ "constant-plate", "coupled-charge", "flow-system",
      "projected-hypercube", "wave-in-time" };
    this->Expect(has("perspective") != (parallel.count(this->Scene) > 0),
      "the projection is perspective, except in a few scenes");
    this->Expect(volume.at("pixel_stride") == 1, "every pixel is computed");
    this->Expect(volume.at("tetrahedra_drawn") > 0, "some tetrahedra are drawn");
    this->Expect(
      volume.at("tetrahedra_drawn") <= volume.at("tetrahedra"), "no tetrahedron is drawn twice");
    this->Expect(
      volume.at("adjacency") == (sort == "mpvonc"), "adjacency is computed for MPVONC only");
    this->Expect(volume.at("sorted") == (sort != "none"),
      "tetrahedra are sorted unless the sort mode is none");
    this->Expect(
      (volume.at("layers") > 0) == (blend == "priority"), "there are layers for priority only");
    this->Expect(volume.at("passes") == (blend == "priority" ? volume.at("layers").get<int>() : 1),
      "one pass, or one pass per layer");
    if (sort == "none")
    {
      this->Expect(volume.at("cycles") == 0 && volume.at("gaps") == 0,
        "cycles and gaps are not searched without sorting");
    }
    if (this->Scene == "interval-cycle" || this->Scene == "interval-intersection")
    {
      this->Expect(sort == "none", "one color or overlapping meshes need no sorting");
    }
    if (this->Scene == "interval-priority" || this->Scene == "time-priority")
    {
      this->Expect(blend == "priority" && sort == "none", "priority blending without sorting");
    }
    if (this->Scene == "wave-in-time" || this->Scene == "time-delta" ||
      this->Scene == "time-vortex" || this->Scene == "time-vortex-three" ||
      this->Scene == "time-cylinder")
    {
      this->Expect(has("delta-t") && blend == "additive" && sort == "none",
        "additive blending of time colors without sorting, weighted by time extent");
    }
    if (this->Scene == "time-boundaries" || this->Scene == "time-mug")
    {
      this->Expect(has("delta-t") && blend == "optical-depth" && sort == "none",
        "optical depth blending of overlapping tetrahedra without sorting, weighted by time "
        "extent");
    }
    if (this->Scene == "time-isosurfaces" || this->Scene == "time-end-volumes")
    {
      this->Expect(sort == "none", "one color needs no sorting");
    }
    if (this->Scene == "constant-plate")
    {
      this->Expect(blend == "optical-depth" && sort == "none", "overlapping cells need no sorting");
    }
    if (this->Scene == "interval-constant")
    {
      this->Expect(
        blend == "composite" && sort == "mpvonc", "one mesh is composited in visibility order");
    }
  }

  void CheckSlicedVolume(const nlohmann::json& volume)
  {
    const std::string features = " " + volume.at("features").get<std::string>() + " ";
    const bool hasShadows = volume.at("shadowed_lights") > 0;
    this->Expect(volume.at("slices_drawn") > 0, "some slices are drawn");
    this->Expect(
      volume.at("slices_drawn") <= volume.at("slices"), "no more slices are drawn than planned");
    this->Expect(volume.at("blocks_drawn") > 0, "some blocks are drawn");
    this->Expect(volume.at("blocks_drawn") <= volume.at("blocks"), "no block is drawn twice");
    this->Expect(
      volume.at("light_buffers") == volume.at("shadowed_lights"), "one buffer per shadow light");
    this->Expect(
      (volume.at("light_passes") > 0) == hasShadows, "there are light passes for shadows only");
    this->Expect((volume.at("light_buffer_bytes") > 0) == hasShadows,
      "there are light buffers for shadows only");
    this->Expect((features.find(" shadow") != std::string::npos) == hasShadows,
      "shaders have code for shadows only if a light casts them");
  }

  void CheckInflowVolume(const nlohmann::json& volume)
  {
    const std::string features = " " + volume.at("features").get<std::string>() + " ";
    this->Expect(volume.at("passes") == 1, "one pass per inflow volume");
    this->Expect(volume.at("image_buffer_bytes") > 0, "the image buffer has a size");
    this->Expect(volume.at("textures") > 0, "there are textures");
    this->Expect((features.find(" detail") != std::string::npos) <= (this->Scene == "inflow-dual"),
      "shaders have code for a second texture in inflow-dual only");
  }

  void Expect(bool holds, const std::string& what)
  {
    if (!holds)
    {
      std::cerr << this->Scene << ": expected: " << what << "\n";
      this->Passed = false;
    }
  }

  bool HasPassed() const { return this->Passed; }

private:
  std::string Page;
  std::string Folder;
  std::string Scene;
  bool HasTime = false;
  bool Passed = true;
};
}

int main(int argc, char* argv[])
{
  if (argc < 2)
  {
    std::cerr << "The first argument must be the directory of the gallery.\n";
    return EXIT_FAILURE;
  }
  const std::string folder = argv[1];
  try
  {
    Checker checker(folder);
    const nlohmann::json gallery =
      nlohmann::json::parse(Checker::ReadText(folder + "/gallery.json"));
    for (const nlohmann::json& scene : gallery.at("scenes"))
    {
      checker.CheckScene(scene);
      checker.CheckPage(scene);
    }
    checker.Expect(argc - 2 >= 12, "there are at least twelve scenes");
    for (int i = 2; i < argc; ++i)
    {
      checker.CheckScene(nlohmann::json::parse(Checker::ReadText(argv[i])));
    }
    return checker.HasPassed() ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << "\n";
    return EXIT_FAILURE;
  }
}
