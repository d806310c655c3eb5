// SPDX-License-Identifier: BSD-3-Clause
// Measures what scenes of the gallery pay for features that they do not use, and what these would
// add: see gallery::MeasureSceneCosts. Prints two tables, and writes every number as JSON.
#include "Benchmarks/Measures/BenchTiming.h"
#include "Gallery/Costs/SceneCosts.h"
#include "Gallery/Picture.h"
#include "Gallery/Scene.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{
using gallery::Costs;
using gallery::FeatureCosts;
using gallery::SceneCosts;

nlohmann::json ToJson(const Costs& costs)
{
  return { { "passes", costs.Passes }, { "buffers", costs.Buffers }, { "bytes", costs.Bytes },
    { "words", costs.Words }, { "arrays", costs.Arrays }, { "seconds", costs.Seconds } };
}

nlohmann::json ToJson(const SceneCosts& scene)
{
  nlohmann::json json = { { "scene", scene.Scene }, { "executed", nlohmann::json::object() },
    { "features", nlohmann::json::array() } };
  for (const auto& [name, costs] : scene.Executed)
  {
    json["executed"][name] = { { "executions", costs.Executions }, { "arrays", costs.Arrays },
      { "bytes", costs.Bytes }, { "seconds", costs.Seconds } };
  }
  for (const FeatureCosts& feature : scene.Features)
  {
    json["features"].push_back({ { "class", feature.Class }, { "feature", feature.Feature },
      { "own", { feature.OwnOff, feature.OwnOn, feature.OwnAfter } },
      { "left", ToJson(feature.Left) }, { "added", ToJson(feature.Added) },
      { "seconds", feature.Seconds }, { "spread", feature.Spread } });
  }
  return json;
}

/// The same feature in all scenes that do not use it.
using Group = std::vector<const FeatureCosts*>;

double MedianOf(const Group& group, const std::function<double(const FeatureCosts&)>& get)
{
  std::vector<double> values;
  for (const FeatureCosts* feature : group)
  {
    values.push_back(get(*feature));
  }
  return Median(values);
}

double LargestOf(const Group& group, const std::function<double(const FeatureCosts&)>& get)
{
  double most = 0.0;
  for (const FeatureCosts* feature : group)
  {
    most = std::max(most, std::abs(get(*feature)));
  }
  return most;
}

/// The largest of all that counts, of what is left and of the report's own numbers.
double GetMostLeft(const FeatureCosts& feature)
{
  const Costs& left = feature.Left;
  return std::max({ std::abs(left.Passes), std::abs(left.Buffers), std::abs(left.Bytes),
    std::abs(left.Words), std::abs(left.Arrays), feature.OwnOff, feature.OwnAfter });
}

void PrintFeatures(const std::vector<SceneCosts>& scenes)
{
  std::map<std::string, Group> groups;
  for (const SceneCosts& scene : scenes)
  {
    for (const FeatureCosts& feature : scene.Features)
    {
      groups[feature.Class + " " + feature.Feature].push_back(&feature);
    }
  }
  std::printf(
    "| feature that is off | scenes | most of passes, buffers, bytes, words, arrays | ms, "
    "median | spread, ms | scenes within twice the spread | on: passes | buffers | KiB | "
    "words | arrays | ms |\n"
    "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const auto& [name, group] : groups)
  {
    const auto within = std::count_if(group.begin(), group.end(),
      [](const FeatureCosts* feature)
      { return std::abs(feature->Left.Seconds) <= 2.0 * feature->Spread; });
    const auto added = [&group = group](double Costs::*number)
    { return MedianOf(group, [=](const FeatureCosts& of) { return of.Added.*number; }); };
    std::printf(
      "| %s | %zu | %.0f | %.2f | %.2f | %ld | %.0f | %.0f | %.0f | %.0f | %.0f | %.2f |\n",
      name.c_str(), group.size(), LargestOf(group, &GetMostLeft),
      1e3 * MedianOf(group, [](const FeatureCosts& of) { return of.Left.Seconds; }),
      1e3 * MedianOf(group, [](const FeatureCosts& of) { return of.Spread; }),
      static_cast<long>(within), added(&Costs::Passes), added(&Costs::Buffers),
      added(&Costs::Bytes) / 1024.0, added(&Costs::Words), added(&Costs::Arrays),
      1e3 * added(&Costs::Seconds));
  }
}

/// Classes of Interlume that scenes execute; in all others they have no execution, array or byte.
void PrintClasses(const std::vector<SceneCosts>& scenes)
{
  std::map<std::string, std::vector<gallery::ExecutionCosts>> classes;
  for (const SceneCosts& scene : scenes)
  {
    for (const auto& [name, costs] : scene.Executed)
    {
      classes[name].push_back(costs);
    }
  }
  std::printf("\n| class | scenes that execute it | scenes that do not | arrays | KiB | ms |\n"
              "| --- | --- | --- | --- | --- | --- |\n");
  for (const auto& [name, all] : classes)
  {
    std::vector<double> arrays;
    std::vector<double> bytes;
    std::vector<double> seconds;
    for (const gallery::ExecutionCosts& costs : all)
    {
      arrays.push_back(costs.Arrays);
      bytes.push_back(static_cast<double>(costs.Bytes));
      seconds.push_back(costs.Seconds);
    }
    std::printf("| %s | %zu | %zu | %.0f | %.0f | %.2f |\n", name.c_str(), all.size(),
      scenes.size() - all.size(), Median(arrays), Median(bytes) / 1024.0, 1e3 * Median(seconds));
  }
}
}

int main(int argc, char* argv[])
{
  std::vector<std::string> names;
  std::string json;
  int width = 320;
  int height = 200;
  int runs = 5;
  CLI::App app(
    "Measures what scenes of the gallery pay for features that they do not use, and what "
    "these would add.");
  app.add_option("SCENE", names, "Scenes; default all of the gallery");
  app.add_option("--json", json, "Write all numbers to this file");
  app.add_option("--width", width, "Pixels of a panel")->check(CLI::Range(16, 8192));
  app.add_option("--height", height, "Pixels of a panel")->check(CLI::Range(16, 8192));
  app.add_option("--runs", runs, "Runs of each state, of which the median counts")
    ->check(CLI::Range(1, 1000));
  CLI11_PARSE(app, argc, argv);
  try
  {
    const gallery::DisplayHold display;
    std::vector<SceneCosts> scenes;
    nlohmann::json all = nlohmann::json::array();
    for (const gallery::Scene& scene : gallery::AllScenes())
    {
      if (names.empty() || std::find(names.begin(), names.end(), scene.Id) != names.end())
      {
        std::cerr << scene.Id << std::endl;
        scenes.push_back(gallery::MeasureSceneCosts(scene, width, height, runs));
        all.push_back(ToJson(scenes.back()));
      }
    }
    if (scenes.empty())
    {
      throw std::invalid_argument("no such scene; interlume-gallery --list shows them");
    }
    PrintFeatures(scenes);
    PrintClasses(scenes);
    if (!json.empty())
    {
      std::ofstream file(json);
      file << nlohmann::json{ { "width", width }, { "height", height }, { "runs", runs },
        { "scenes", all } }
                .dump(2)
           << "\n";
      if (!file)
      {
        throw std::runtime_error("cannot write " + json);
      }
    }
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << "interlume-bench-costs: " << error.what() << "\n";
    return 1;
  }
}
