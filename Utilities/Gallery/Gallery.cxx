// SPDX-License-Identifier: BSD-3-Clause
// interlume-gallery: renders the images of the gallery and an HTML page that shows them.

#include "Gallery/FrameFiles.h"
#include "Gallery/IndexPage.h"
#include "Gallery/GalleryImage.h"
#include "Gallery/Scene.h"
#include "Gallery/Stage.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "vtksys/Process.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
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
  int Jobs = 1;
  bool HasPage = true;
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

void WriteJson(const std::vector<nlohmann::json>& reports, const std::string& path)
{
  std::ofstream file(path);
  file << nlohmann::json{ { "scenes", reports } }.dump(2) << "\n";
  if (!file)
  {
    throw std::runtime_error("Cannot write " + path + ".");
  }
}

/// Draws a scene in this process.
nlohmann::json DrawHere(const gallery::Scene& scene, const Options& options)
{
  gallery::SceneReport report;
  gallery::FrameFiles frames(options.Out, scene.Id);
  vtkSmartPointer<vtkImageData> image =
    gallery::RenderScene(scene, ParseSize(options.Size, options.Samples), report, options.Frames,
      [&frames](vtkImageData* frame) { frames.Add(frame); });
  report.HasMovie = frames.Finish();
  gallery::WritePng(image, options.Out + "/" + scene.Id + ".png");
  return ToJson(report);
}

/// Draws a scene in a process of its own, since VTK renders in one thread of a process.
nlohmann::json DrawInProcess(
  const gallery::Scene& scene, const Options& options, const std::string& program)
{
  const std::string json = options.Out + "/" + scene.Id + ".json";
  const std::vector<std::string> words = { program, "--no-page", "--scene", scene.Id, "--out",
    options.Out, "--size", options.Size, "--antialias", std::to_string(options.Samples), "--frames",
    std::to_string(options.Frames), "--json", json };
  std::vector<const char*> command;
  for (const std::string& word : words)
  {
    command.push_back(word.c_str());
  }
  command.push_back(nullptr);
  const std::unique_ptr<vtksysProcess, void (*)(vtksysProcess*)> process(
    vtksysProcess_New(), &vtksysProcess_Delete);
  vtksysProcess_SetCommand(process.get(), command.data());
  vtksysProcess_SetPipeShared(process.get(), vtksysProcess_Pipe_STDERR, 1);
  vtksysProcess_Execute(process.get());
  vtksysProcess_WaitForExit(process.get(), nullptr);
  if (vtksysProcess_GetState(process.get()) != vtksysProcess_State_Exited ||
    vtksysProcess_GetExitValue(process.get()) != 0)
  {
    throw std::runtime_error("The process that draws " + scene.Id + " failed.");
  }
  const nlohmann::json report = nlohmann::json::parse(std::ifstream(json)).at("scenes").at(0);
  vtksys::SystemTools::RemoveFile(json);
  return report;
}

/// Draws scenes, several at a time if there are several jobs, and returns their reports.
std::vector<nlohmann::json> DrawAll(const std::vector<const gallery::Scene*>& scenes,
  const Options& options, const std::string& program)
{
  const bool isParallel = options.Jobs > 1 && scenes.size() > 1;
  std::vector<nlohmann::json> reports(scenes.size());
  std::mutex mutex;
  std::size_t begun = 0;
  std::size_t finished = 0;
  std::exception_ptr error;
  const auto work = [&]()
  {
    std::unique_lock<std::mutex> lock(mutex);
    while (begun < scenes.size() && !error)
    {
      const std::size_t i = begun++;
      lock.unlock();
      nlohmann::json report;
      std::exception_ptr failure;
      try
      {
        report =
          isParallel ? DrawInProcess(*scenes[i], options, program) : DrawHere(*scenes[i], options);
      }
      catch (...)
      {
        failure = std::current_exception();
      }
      lock.lock();
      error = error ? error : failure;
      if (!failure)
      {
        std::printf("[%zu/%zu] %-26s %.1f s\n", ++finished, scenes.size(), scenes[i]->Id.c_str(),
          report.at("seconds").get<double>() + report.at("frame_seconds").get<double>());
        std::fflush(stdout);
      }
      reports[i] = std::move(report);
    }
  };
  std::vector<std::thread> threads;
  for (int job = 1; isParallel && job < options.Jobs; ++job)
  {
    threads.emplace_back(work);
  }
  work();
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  if (error)
  {
    std::rethrow_exception(error);
  }
  return reports;
}

void Draw(const Options& options, const std::string& program)
{
  ParseSize(options.Size, options.Samples); // reports a wrong size once
  const std::vector<const gallery::Scene*> scenes = ChosenScenes(options.Scenes);
  const gallery::DisplayKeepAlive display;
  if (!vtksys::SystemTools::MakeDirectory(options.Out))
  {
    throw std::runtime_error("Cannot create the directory " + options.Out + ".");
  }
  const std::vector<nlohmann::json> reports = DrawAll(scenes, options, program);
  if (!options.Json.empty())
  {
    WriteJson(reports, options.Json);
  }
  if (options.HasPage)
  {
    gallery::WriteIndexPage(options.Out, reports);
    std::cout << vtksys::SystemTools::CollapseFullPath(options.Out + "/index.html") << "\n";
  }
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
  app
    .add_option("--jobs", options.Jobs,
      "Number of scenes that are rendered at a time, each in its own process. Times in the reports "
      "are comparable for 1 only.")
    ->check(CLI::Range(1, 256))
    ->capture_default_str();
  app.add_flag("!--no-page", options.HasPage, "Do not write index.html");
  CLI11_PARSE(app, argc, argv);
  try
  {
    if (options.List)
    {
      PrintList();
    }
    else
    {
      Draw(options, argv[0]);
    }
  }
  catch (const std::exception& error)
  {
    std::cerr << "interlume-gallery: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
