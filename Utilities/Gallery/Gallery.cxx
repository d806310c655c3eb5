// SPDX-License-Identifier: BSD-3-Clause
// interlume-gallery: renders the images of the gallery and an HTML page that shows them.

#include "Gallery/FrameFiles.h"
#include "Gallery/IndexPage.h"
#include "Gallery/GalleryImage.h"
#include "Gallery/Scene.h"
#include "Gallery/Stage.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{
struct Options
{
  bool List = false;
  std::vector<std::string> Scenes;
  std::string Out = "gallery";
  std::string Size = "1280x800";
  int Samples = 3;
  std::string Json;
  int Frames = 36;
};

void PrintList()
{
  for (const gallery::Scene& scene : gallery::AllScenes())
  {
    std::printf("%-26s %-6s %s\n", scene.Id.c_str(), scene.Figure.c_str(), scene.Title.c_str());
  }
}

gallery::ImageSize ParseSize(const std::string& text, int samples)
{
  // Many OpenGL implementations limit images to 16384 pixels in each direction.
  const int largest = 16384 / samples;
  gallery::ImageSize size = { 0, 0, samples };
  char rest = 0;
  if (std::sscanf(text.c_str(), "%dx%d%c", &size.Width, &size.Height, &rest) != 2 ||
    std::min(size.Width, size.Height) < 64 || std::max(size.Width, size.Height) > largest)
  {
    throw std::invalid_argument("With --antialias " + std::to_string(samples) +
      ", --size requires WIDTHxHEIGHT with both from 64 to " + std::to_string(largest) + ", not " +
      text + ".");
  }
  return size;
}

std::vector<const gallery::Scene*> ChosenScenes(const std::vector<std::string>& ids)
{
  std::vector<const gallery::Scene*> scenes;
  if (ids.empty())
  {
    for (const gallery::Scene& scene : gallery::AllScenes())
    {
      scenes.push_back(&scene);
    }
  }
  for (const std::string& id : ids)
  {
    const gallery::Scene* scene = gallery::FindScene(id);
    if (!scene)
    {
      throw std::invalid_argument("There is no scene " + id + ". --list prints all scenes.");
    }
    scenes.push_back(scene);
  }
  return scenes;
}

void WriteJson(const std::vector<gallery::SceneReport>& reports, const std::string& path)
{
  nlohmann::json scenes = nlohmann::json::array();
  for (const gallery::SceneReport& report : reports)
  {
    scenes.push_back(ToJson(report));
  }
  std::ofstream file(path);
  file << nlohmann::json{ { "scenes", scenes } }.dump(2) << "\n";
  if (!file)
  {
    throw std::runtime_error("Cannot write " + path + ".");
  }
}

void Draw(const Options& options)
{
  const gallery::ImageSize size = ParseSize(options.Size, options.Samples);
  const std::vector<const gallery::Scene*> scenes = ChosenScenes(options.Scenes);
  const gallery::DisplayKeepAlive display;
  if (!vtksys::SystemTools::MakeDirectory(options.Out))
  {
    throw std::runtime_error("Cannot create the directory " + options.Out + ".");
  }
  std::vector<gallery::SceneReport> reports;
  for (const gallery::Scene* scene : scenes)
  {
    gallery::SceneReport report;
    gallery::FrameFiles frames(options.Out, scene->Id);
    vtkSmartPointer<vtkImageData> image = gallery::RenderScene(
      *scene, size, report, options.Frames, [&frames](vtkImageData* frame) { frames.Add(frame); });
    report.HasMovie = frames.Finish();
    gallery::WritePng(image, options.Out + "/" + scene->Id + ".png");
    reports.push_back(report);
    std::printf("[%zu/%zu] %-26s %.1f s\n", reports.size(), scenes.size(), scene->Id.c_str(),
      report.BuildSeconds + report.RenderSeconds + report.FrameSeconds);
    std::fflush(stdout);
  }
  gallery::WriteIndexPage(options.Out, reports);
  if (!options.Json.empty())
  {
    WriteJson(reports, options.Json);
  }
  std::cout << vtksys::SystemTools::CollapseFullPath(options.Out + "/index.html") << "\n";
}
}

int main(int argc, char* argv[])
{
  Options options;
  CLI::App app(
    "Renders the gallery of Interlume: an image for each scene, and index.html that shows them.");
  app.add_flag("--list", options.List, "Print id, figure and title of every scene, and exit");
  app
    .add_option(
      "--scene", options.Scenes, "Render only this scene; repeat the option for more scenes")
    ->allow_extra_args(false);
  app.add_option("--out", options.Out, "Directory for the images and index.html")
    ->capture_default_str();
  app.add_option("--size", options.Size, "Width and height of an image in pixels")
    ->capture_default_str();
  app.add_option("--antialias", options.Samples, "Render N x N samples per pixel; 1 for none")
    ->check(CLI::Range(1, 8))
    ->capture_default_str();
  app.add_option("--json", options.Json, "Write times and counters of every scene to this file");
  app
    .add_option("--frames", options.Frames,
      "Number of frames of animated scenes, written next to the images and shown on the page; 0 "
      "for none")
    ->check(CLI::Range(0, 999))
    ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try
  {
    if (options.List)
    {
      PrintList();
    }
    else
    {
      Draw(options);
    }
  }
  catch (const std::exception& error)
  {
    std::cerr << "interlume-gallery: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
