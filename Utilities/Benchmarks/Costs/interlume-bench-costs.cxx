// SPDX-License-Identifier: BSD-3-Clause
// Measures the cost of unused features in scenes of the gallery, and the cost of switching them on:
// see gallery::MeasureSceneCosts. Prints rows, see CostRows.h, and writes them as JSON.
// `interlume-bench report --costs` shows them as tables.
#include "Benchmarks/Costs/CostRows.h"
#include "Benchmarks/Results/BenchMachine.h"
#include "Benchmarks/Results/BenchResults.h"
#include "Gallery/Costs/SceneCosts.h"
#include "Gallery/GalleryImage.h"
#include "Gallery/Scene.h"
#include "Gallery/Stopwatch.h"

#include "vtkSMPTools.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <exception>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{
/// Converts seconds to milliseconds, rounded to microseconds.
double Milliseconds(double seconds)
{
  return std::round(1e6 * seconds) / 1e3;
}

void SetCounts(BenchRow& row, const std::string& prefix, const gallery::Costs& costs, double own)
{
  row.Counts[prefix + "passes"] = costs.Passes;
  row.Counts[prefix + "buffers"] = costs.Buffers;
  row.Counts[prefix + "bytes"] = costs.Bytes;
  row.Counts[prefix + "words"] = costs.Words;
  row.Counts[prefix + "arrays"] = costs.Arrays;
  row.Counts[prefix + "own"] = own;
}

BenchRow MakeRow(
  const BenchRows& rows, const std::string& scene, const gallery::FeatureCosts& feature)
{
  BenchRow row = rows.Make(scene, feature.Class, feature.Feature);
  SetCounts(row, "", feature.Left, std::max(feature.OwnOff, feature.OwnAfter));
  SetCounts(row, "on_", feature.Added, feature.OwnOn);
  if (feature.Pairs > 0)
  {
    row.Seconds = BenchSeconds{ feature.Seconds, feature.Pairs };
    row.Set(
      { { "ms", Milliseconds(feature.Left.Seconds) }, { "noise_ms", Milliseconds(feature.Noise) },
        { "within_noise", feature.IsWithinNoise() ? 1 : 0 },
        { "on_ms", Milliseconds(feature.Added.Seconds) }, { "on_runs", feature.PairsOn } });
  }
  return row;
}

/// Rows by scene, without summaries.
using SceneRows = std::map<std::string, std::vector<BenchRow>>;

/// Replaces the rows in \a scenes of each scene that \a file contains.
void Take(const BenchResults& file, SceneRows& scenes)
{
  SceneRows taken;
  for (const BenchRow& row : file.RowsOf(costs::Suite))
  {
    if (row.Case != costs::AllScenes)
    {
      taken[row.Case].push_back(row);
    }
  }
  for (const auto& [scene, rows] : taken)
  {
    scenes[scene] = rows;
  }
}

/// Sets the rows of \a results in the order of the gallery, with their summaries and claims.
void SetRows(BenchResults& results, const SceneRows& scenes)
{
  std::vector<BenchRow> rows;
  for (const gallery::Scene& scene : gallery::AllScenes())
  {
    const auto found = scenes.find(scene.Id);
    if (found != scenes.end())
    {
      rows.insert(rows.end(), found->second.begin(), found->second.end());
    }
  }
  results.SetClaims(costs::Suite, costs::CheckClaims(rows));
  const std::vector<BenchRow> summaries = costs::Summarize(rows);
  rows.insert(rows.end(), summaries.begin(), summaries.end());
  results.Rows = rows;
}

/// Combines the rows of several files, and their conditions with JoinConditions().
BenchResults ReadAll(const std::vector<std::string>& paths)
{
  SceneRows scenes;
  BenchResults results = BenchResults::Read(paths.front());
  std::vector<nlohmann::ordered_json> conditions;
  double took = 0.0;
  for (const std::string& path : paths)
  {
    const BenchResults file = BenchResults::Read(path);
    Take(file, scenes);
    conditions.push_back(file.Conditions);
    took += file.Suites.at(costs::Suite).at("took").get<double>();
  }
  results.Conditions = JoinConditions(conditions);
  results.Suites[costs::Suite]["took"] = took;
  SetRows(results, scenes);
  return results;
}

void Measure(const std::vector<std::string>& names, const gallery::CostSettings& settings,
  const std::string& json)
{
  BenchOptions options;
  options.Threads = vtkSMPTools::GetEstimatedNumberOfThreads();
  BenchResults results = BenchResults::MakeForThisMachine(options);
  std::ostringstream command;
  command << "interlume-bench-costs --width " << settings.Width << " --height " << settings.Height
          << " --pairs " << settings.Pairs << " --limit " << settings.Limit;
  for (const std::string& name : names)
  {
    command << ' ' << name;
  }
  results.Conditions["command"] = command.str();
  SceneRows scenes;
  const gallery::Stopwatch watch;
  for (const gallery::Scene& scene : gallery::AllScenes())
  {
    if (!names.empty() && std::find(names.begin(), names.end(), scene.Id) == names.end())
    {
      continue;
    }
    BenchRows rows(costs::Suite);
    for (const gallery::FeatureCosts& feature : gallery::MeasureSceneCosts(scene, settings))
    {
      rows.Add(MakeRow(rows, scene.Id, feature));
    }
    scenes[scene.Id] = rows.Get();
    // Write after each scene, so that an interrupted run leaves the rows of finished scenes.
    results.Suites[costs::Suite]["took"] = std::round(watch.Seconds());
    SetRows(results, scenes);
    if (!json.empty())
    {
      results.Write(json);
    }
  }
}
}

int main(int argc, char* argv[])
{
  std::vector<std::string> known;
  for (const gallery::Scene& scene : gallery::AllScenes())
  {
    known.push_back(scene.Id);
  }
  std::vector<std::string> names;
  std::string json;
  std::vector<std::string> from;
  gallery::CostSettings settings;
  CLI::App app("Measures the cost of unused features in scenes of the gallery, and the cost of "
               "enabling them.");
  auto* scenes = app.add_option("SCENE", names, "Scenes; default: all scenes of the gallery")
                   ->check(CLI::IsMember(known));
  auto* file = app.add_option("--json", json, "Write the rows to this file");
  app
    .add_option("--from", from,
      "Combine the rows of these files instead of measuring. If several files contain a scene, the "
      "last one is used")
    ->check(CLI::ExistingFile)
    ->excludes(scenes)
    ->needs(file);
  app.add_option("--width", settings.Width, "Width of a panel in pixels")
    ->check(CLI::Range(16, 8192))
    ->capture_default_str();
  app.add_option("--height", settings.Height, "Height of a panel in pixels")
    ->check(CLI::Range(16, 8192))
    ->capture_default_str();
  app
    .add_option("--pairs", settings.Pairs,
      "Pairs of runs of each state; their median is reported. 0 measures no times")
    ->check(CLI::Range(0, 1000))
    ->capture_default_str();
  app
    .add_option("--limit", settings.Limit,
      "Time in seconds after which a state gets no more pairs; at least two are run")
    ->check(CLI::NonNegativeNumber)
    ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try
  {
    if (!from.empty())
    {
      ReadAll(from).Write(json);
      return 0;
    }
    const gallery::DisplayKeepAlive display;
    Measure(names, settings, json);
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << "interlume-bench-costs: " << error.what() << "\n";
    return 1;
  }
}
