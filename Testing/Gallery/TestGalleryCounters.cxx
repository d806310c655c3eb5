// SPDX-License-Identifier: BSD-3-Clause
// Reads what `interlume-gallery --json` and its page say, and checks that a scene paid only for
// what it used: a feature that is off leaves no triangle, no pass and no buffer. Argument: the
// folder with gallery.json and index.html.

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <set>
#include <string>

namespace
{
/// Textures and passes of a panel, as TestGalleryCounters expects them of VTK 9.
constexpr int WINDOW_BUFFERS = 4;
constexpr int OCCLUSION_BUFFERS = 5;
constexpr int OCCLUSION_PASSES = 2;

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
    this->Expect((scene.at("tetrahedra") > 0) == isExtracted, "tetrahedra were made");
    this->Expect(extraction.at("cells_visited") <= extraction.at("cells"),
      "no more cells visited than there are");
    this->Expect((extraction.at("cells_with_output") > 0) == (isExtracted && !has("flow")),
      "cells gave output");
    this->Expect((has("boundaries") || has("stream-surfaces") || has("time-surfaces")) ==
        (scene.at("boundary_triangles") > 0),
      "boundary triangles exactly where boundaries are on");
    this->CheckFlow(scene, has("flow"));
    this->Expect(has("boundaries") ==
        (this->Scene == "interval-boundary" || this->Scene == "interval-constant" ||
          this->Scene == "time-boundaries"),
      "boundaries on in interval-boundary, interval-constant and time-boundaries only");
    this->Expect(has("time-boundaries") ==
        (this->Scene == "time-isosurfaces" || this->Scene == "time-end-volumes" ||
          this->Scene == "time-priority"),
      "boundaries of tetrahedra in the three scenes that show them only");
    this->Expect(has("criteria") == (scene.at("criteria") > 0), "criteria as asked for");
    const int slabs = scene.at("slabs");
    this->Expect(has("time") == (slabs > 0 && scene.at("simplices") > 0),
      "slabs and 4-simplices exactly where there is time");
    this->Expect(!isExtracted || has("flow") ||
        extraction.at("passes") == (has("time") ? slabs : (has("criteria") ? 2 : 1)),
      "a pass for each slab, and a second one exactly where there is a criterion");
    this->Expect(
      has("time-slices") == (this->Scene == "time-slices"), "slices in time in time-slices only");
    // Boundaries have no extent in time.
    this->HasTime = has("time") && !has("time-boundaries");
    int volumePasses = 0;
    int volumeBuffers = 0;
    this->Expect(has("volumes") == !scene.at("volumes").empty(), "volumes as the features say");
    for (const nlohmann::json& volume : scene.at("volumes"))
    {
      this->CheckVolume(volume);
      volumePasses += volume.at("passes").get<int>();
      volumeBuffers += volume.at("buffers").get<int>();
    }
    int shadowedLights = 0;
    this->Expect(
      has("slices") == !scene.at("sliced_volumes").empty(), "slices as the features say");
    for (const nlohmann::json& volume : scene.at("sliced_volumes"))
    {
      this->CheckSlicedVolume(volume);
      shadowedLights += volume.at("shadowed_lights").get<int>();
      volumePasses += volume.at("eye_passes").get<int>() + volume.at("light_passes").get<int>() +
        volume.at("occlusion_passes").get<int>();
      volumeBuffers +=
        volume.at("image_buffers").get<int>() + volume.at("light_buffers").get<int>();
    }
    this->Expect(has("shadows") == (shadowedLights > 0), "shadows as the features say");
    this->Expect(has("inflow-textures") == !scene.at("inflow_volumes").empty(),
      "inflow textures as the features say");
    for (const nlohmann::json& volume : scene.at("inflow_volumes"))
    {
      this->CheckInflowVolume(volume);
      volumePasses += volume.at("passes").get<int>();
      // Each draws into an image of its own.
      ++volumeBuffers;
    }
    const int surfacePanels = scene.at("surface_panels");
    const int occlusionPanels = scene.at("occlusion_panels");
    // Flat drawings and shadows of surfaces have none either.
    const bool mayLackOcclusion =
      has("slices") || has("scene-shadows") || this->Scene == "penumbra-analysis";
    this->Expect(
      mayLackOcclusion ? occlusionPanels <= surfacePanels : occlusionPanels == surfacePanels,
      "ambient occlusion where there are surfaces, but for some beside slices");
    this->Expect(
      has("ambient-occlusion") == (occlusionPanels > 0), "ambient occlusion as the features say");
    // Surfaces are drawn once more for the depth map of the one light that casts shadows, and once
    // for the eye's depth where volumes need it, which leave their light in a buffer more.
    const bool isMixed = has("scene-shadows");
    const int mixedExtras = isMixed ? (has("slices") ? 3 : 1) : 0;
    this->Expect(isMixed
        ? scene.at("passes") >= surfacePanels * 2 + volumePasses
        : scene.at("passes") == surfacePanels + occlusionPanels * OCCLUSION_PASSES + volumePasses,
      "one pass for the surfaces of a panel, those of ambient occlusion and of the volumes");
    const int buffers = panels * WINDOW_BUFFERS + occlusionPanels * OCCLUSION_BUFFERS +
      volumeBuffers + panels * mixedExtras;
    this->Expect(isMixed ? scene.at("buffers") <= buffers : scene.at("buffers") == buffers,
      "no buffer beyond the window, ambient occlusion, the volumes and mixed shadows");
    this->Expect(scene.at("bytes") > 0, "bytes of buffers counted");
    this->Expect(scene.at("seconds") > 0.0, "time taken");
    this->Expect(this->Page.find("src=\"" + this->Scene + ".png\"") != std::string::npos,
      "the page shows the picture");
    this->Expect(
      std::ifstream(this->Folder + "/" + this->Scene + ".png").good(), "the picture is there");
    this->CheckFrames(scene);
  }

  /// Files of an animation, which differ from one to the next, and the page that plays them.
  void CheckFrames(const nlohmann::json& scene)
  {
    const int frames = scene.at("frames");
    this->Expect(
      (frames > 0) == (this->Scene == "inflow-post"), "an animation in inflow-post only");
    std::string before;
    for (int i = 0; i < frames; ++i)
    {
      const std::string number = std::to_string(i);
      const std::string name =
        this->Scene + "/" + std::string(3 - number.size(), '0') + number + ".png";
      const std::string bytes = ReadText(this->Folder + "/" + name);
      this->Expect(!bytes.empty() && bytes != before, "frame " + number);
      this->Expect(
        this->Page.find('"' + name + '"') != std::string::npos, "frame " + number + " on the page");
      before = bytes;
    }
    const std::string movie = this->Scene + ".ogv";
    const bool hasMovie = scene.at("movie");
    this->Expect(hasMovie == (ReadText(this->Folder + "/" + movie).substr(0, 4) == "OggS"),
      "a movie where the report says so");
    this->Expect(
      hasMovie == (this->Page.find("href=\"" + movie) != std::string::npos), "a movie on the page");
  }

  void CheckFlow(const nlohmann::json& scene, bool hasFlow)
  {
    this->Expect((scene.at("flow_cells") > 0) == hasFlow, "cells of a flow where there is one");
    this->Expect(scene.at("flow_cells_left_out") < scene.at("flow_cells") || !hasFlow,
      "cells of the flow to extract from");
    const int filters = scene.at("filters");
    const int inflowPasses = scene.at("inflow_passes");
    const int timePasses = scene.at("time_passes");
    this->Expect(inflowPasses <= filters && timePasses <= filters, "each extraction made once");
    this->Expect((inflowPasses + timePasses > 0) == hasFlow, "extractions where there is flow");
    this->Expect((inflowPasses > 0) == (hasFlow && scene.at("intervals") > 0),
      "extracted by inflow exactly where there are intervals");
  }

  void CheckVolume(const nlohmann::json& volume)
  {
    const std::string features = " " + volume.at("features").get<std::string>() + " ";
    const auto has = [&features](const std::string& name)
    { return features.find(" " + name + " ") != std::string::npos; };
    const std::string sort = volume.at("sort");
    const std::string blend = volume.at("blend");

    this->Expect(!has("delta-t") || this->HasTime, "no code for an extent in time without time");
    this->Expect(has("surface") == (volume.at("boundary_triangles") > 0),
      "code for boundary triangles exactly where there are some");
    this->Expect(has("perspective") == (this->Scene != "constant-plate"),
      "a picture in perspective, but for that of equal cells");
    this->Expect(volume.at("pixel_stride") == 1, "every pixel computed");
    this->Expect(volume.at("tetrahedra_drawn") > 0, "tetrahedra drawn");
    this->Expect(volume.at("tetrahedra_drawn") <= volume.at("tetrahedra"), "none drawn twice");
    this->Expect(volume.at("adjacency") == (sort == "mpvonc"), "adjacency for MPVONC only");
    this->Expect(volume.at("sorted") == (sort != "none"), "sorted as the sort mode says");
    this->Expect((volume.at("layers") > 0) == (blend == "priority"), "layers for priority only");
    this->Expect(volume.at("passes") == (blend == "priority" ? volume.at("layers").get<int>() : 1),
      "one pass, or one for each layer");
    if (sort == "none")
    {
      this->Expect(volume.at("cycles") == 0 && volume.at("gaps") == 0, "no order looked for");
    }
    if (this->Scene == "interval-cycle" || this->Scene == "interval-intersection")
    {
      this->Expect(sort == "none", "one colour or overlapping meshes need no order");
    }
    if (this->Scene == "interval-priority" || this->Scene == "time-priority")
    {
      this->Expect(blend == "priority" && sort == "none", "priority without an order");
    }
    if (this->Scene == "wave-in-time" || this->Scene == "time-delta" ||
      this->Scene == "time-vortex" || this->Scene == "time-vortex-three" ||
      this->Scene == "time-cylinder")
    {
      this->Expect(has("delta-t") && blend == "additive" && sort == "none",
        "colours of time added up without an order, by the extent in time");
    }
    if (this->Scene == "time-boundaries" || this->Scene == "time-mug")
    {
      this->Expect(has("delta-t") && blend == "optical-depth" && sort == "none",
        "overlapping tetrahedra without an order, by the extent in time");
    }
    if (this->Scene == "time-isosurfaces" || this->Scene == "time-end-volumes")
    {
      this->Expect(sort == "none", "one colour needs no order");
    }
    if (this->Scene == "constant-plate")
    {
      this->Expect(blend == "optical-depth" && sort == "none", "overlapping cells need no order");
    }
    if (this->Scene == "interval-constant")
    {
      this->Expect(blend == "composite" && sort == "mpvonc", "one mesh in order of visibility");
    }
  }

  void CheckSlicedVolume(const nlohmann::json& volume)
  {
    const std::string features = " " + volume.at("features").get<std::string>() + " ";
    const bool hasShadows = volume.at("shadowed_lights") > 0;
    this->Expect(volume.at("slices_drawn") > 0, "slices drawn");
    this->Expect(volume.at("slices_drawn") <= volume.at("slices"), "no slice drawn in vain");
    this->Expect(volume.at("blocks_drawn") > 0, "blocks drawn");
    this->Expect(volume.at("blocks_drawn") <= volume.at("blocks"), "no block drawn twice");
    this->Expect(volume.at("light_buffers") == volume.at("shadowed_lights"),
      "a buffer for each light that casts shadows");
    this->Expect((volume.at("light_passes") > 0) == hasShadows, "light passes for shadows only");
    this->Expect((volume.at("light_buffer_bytes") > 0) == hasShadows, "light buffers take bytes");
    this->Expect((features.find(" shadow") != std::string::npos) == hasShadows,
      "code for shadows exactly where a light casts them");
  }

  void CheckInflowVolume(const nlohmann::json& volume)
  {
    const std::string features = " " + volume.at("features").get<std::string>() + " ";
    this->Expect(volume.at("passes") == 1, "one pass for an inflow volume");
    this->Expect(volume.at("image_buffer_bytes") > 0, "its image takes bytes");
    this->Expect(volume.at("textures") > 0, "its textures");
    this->Expect((features.find(" detail") != std::string::npos) <= (this->Scene == "inflow-dual"),
      "code for a second texture in inflow-dual only");
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
  if (argc != 2)
  {
    std::cerr << "the argument is the folder of the gallery\n";
    return EXIT_FAILURE;
  }
  const std::string folder = argv[1];
  try
  {
    Checker checker(folder);
    const nlohmann::json gallery =
      nlohmann::json::parse(Checker::ReadText(folder + "/gallery.json"));
    checker.Expect(gallery.at("scenes").size() >= 12, "at least twelve scenes");
    for (const nlohmann::json& scene : gallery.at("scenes"))
    {
      checker.CheckScene(scene);
    }
    return checker.HasPassed() ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << "\n";
    return EXIT_FAILURE;
  }
}
