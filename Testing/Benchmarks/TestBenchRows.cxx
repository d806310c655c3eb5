// SPDX-License-Identifier: BSD-3-Clause
// Checks the file that interlume-bench wrote: all fields as documented, and a row of every kind.
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <set>
#include <string>

namespace
{
bool Success = true;

void Expect(bool condition, const std::string& what)
{
  if (!condition)
  {
    std::cerr << "ERROR: " << what << std::endl;
    Success = false;
  }
}

bool IsPositive(const nlohmann::json& row, const char* field)
{
  return row.at(field).is_number() && row.at(field).get<double>() > 0.0;
}

void CheckRow(const nlohmann::json& row)
{
  static const std::set<std::string> Fields = { "suite", "case", "method", "parameter", "error",
    "error_norm", "seconds", "runs", "peer", "peer_seconds", "peer_runs", "ratio", "counts" };
  const std::string text = row.dump();
  for (const auto& field : row.items())
  {
    Expect(Fields.count(field.key()) == 1, "unknown field " + field.key() + " in " + text);
  }
  for (const char* field : { "suite", "case", "method" })
  {
    Expect(row.contains(field) && row[field].is_string() && !row[field].get<std::string>().empty(),
      std::string("no ") + field + " in " + text);
  }
  Expect(row.contains("error") == row.contains("error_norm"),
    "error without error_norm, or the reverse, in " + text);
  if (row.contains("error"))
  {
    Expect(row["error"].is_number() && row["error"] >= 0.0,
      "error is negative or not a number in " + text);
    Expect(row["error_norm"].is_string(), "no error_norm in " + text);
  }
  if (row.contains("seconds"))
  {
    Expect(IsPositive(row, "seconds") && IsPositive(row, "runs"), "no time in " + text);
  }
  if (row.contains("peer"))
  {
    Expect(row.contains("seconds") && row.contains("peer_seconds") && row.contains("ratio") &&
        IsPositive(row, "peer_seconds") && IsPositive(row, "peer_runs") &&
        std::abs(row["ratio"].get<double>() * row["seconds"].get<double>() -
          row["peer_seconds"].get<double>()) < 1e-9,
      "ratio is not peer_seconds / seconds in " + text);
  }
  if (row.contains("counts"))
  {
    Expect(row["counts"].is_object() && !row["counts"].empty(), "empty counts in " + text);
    for (const auto& count : row["counts"].items())
    {
      Expect(count.value().is_number() || (count.key() == "device" && count.value().is_string()),
        "count " + count.key() + " is not a number in " + text);
    }
  }
}

void CheckMethods(const nlohmann::json& rows)
{
  const std::map<std::string, std::set<std::string>> expected = {
    { "interval",
      { "interval-volume clip2", "interval-volume clip2-tetrahedra", "threads-2 threads-1",
        "drag new-memory", "drag-tied new-memory", "memory", "inverted", "hexahedra clip2",
        "hexahedra-unstructured clip2", "tetrahedra-5 clip2", "tetrahedra-6 clip2", "clip2" } },
    { "contour",
      { "isotable-hexahedra contour3dlinear", "isotable-hexahedra contour3dlinear-merge",
        "isotable-image flyingedges" } },
    { "tetrahedra",
      { "opengl projectedtetrahedra", "software projectedtetrahedra", "projectedtetrahedra",
        "opengl, average color projectedtetrahedra",
        "software, average color projectedtetrahedra" } },
    { "interval4d",
      { "warm", "threads-2 threads-1", "cold warm", "later-slabs", "memory", "throughput",
        "slice interpolate", "interpolate", "sampled", "slice", "slice-again interpolate" } },
    // Rows for the baseline gpu-shadows need VTK 9.2.
    { "shadows",
      { "shadows shadows-off", "shadows-off gpu", "unlit no-lights", "spacing", "buffer" } },
    { "soft-shadows",
      { "sample-layers", "sample-layers, buffer", "accumulated-convolution",
        "accumulated-convolution, buffer", "hard", "default hard",
        "equal-time accumulated-convolution" } },
    { "mixed",
      { "shadow-maps", "scene-pass shadow-maps", "scene-pass, light moves shadow-maps",
        "scene-pass volume + 2 actors", "scene-pass, light moves volume + 2 actors" } },
    { "flow",
      { "RK4", "RK45", "samples", "new-mapping advection", "new-interval advection",
        "new-times advection", "automatic", "dormand-prince", "runge-kutta-4", "rosenbrock",
        "explicit", "implicit", "implicit-again", "implicit-refined" } },
    { "flow-speed",
      { "advection", "RK4", "RK45", "equal-error streamtracer-RK4", "equal-error streamtracer-RK45",
        "equal-error-again streamtracer-RK4", "threads-2 threads-1" } },
    { "flow-sharing", { "shared all streamlines" } },
    { "flow-texture",
      { "textures gpu", "textures gpu-rgba", "textures, unfiltered gpu",
        "textures, unfiltered gpu-rgba", "shadows no shadows", "shadows, light moving shadows",
        "paint filtered", "paint looked up once" } },
    { "filter-errors",
      { "isotable, image", "isotable, hexahedra", "flyingedges, image",
        "contour3dlinear, hexahedra", "vtkFlowCriticalPoints", "vtkVectorFieldTopology",
        "a plane for each layer", "five planes", "vtkStreamSurfaceParameters", "Hann", "box" } },
    { "growth", { "growth", "time exponent", "memory exponent" } },
  };
  std::map<std::string, std::set<std::string>> seen;
  for (const auto& row : rows)
  {
    const std::string baseline = row.contains("peer") ? " " + row["peer"].get<std::string>() : "";
    seen[row.at("suite")].insert(row.at("method").get<std::string>() + baseline);
  }
  for (const auto& suite : expected)
  {
    for (const std::string& method : suite.second)
    {
      Expect(seen[suite.first].count(method) == 1, "no row " + suite.first + " " + method);
    }
  }
}

/// Checks that the rows of each approximation have several methods, errors and times, and one
/// default.
void CheckQuestions(const nlohmann::json& rows)
{
  std::set<std::string> expected = { "contour-error", "critical-points", "vortex-axis",
    "stream-surface-resolution", "lic-step", "flow-texture-voxels" };
#ifdef INTERLUME_ENABLE_TETGEN
  expected.insert("mesher-bounds");
#endif
  std::map<std::string, int> methods;
  std::map<std::string, int> defaults;
  for (const auto& row : rows)
  {
    const std::string name = row.at("case");
    if (row.at("suite") != "filter-errors" && name != "flow-texture-voxels")
    {
      continue;
    }
    Expect(row.contains("error") && row.contains("seconds"), "no error or time in " + row.dump());
    Expect(row.at("error") < 10.0, "error of 10 or more in " + row.dump());
    ++methods[name];
    defaults[name] += row.contains("counts") && row["counts"].contains("default") ? 1 : 0;
  }
  for (const std::string& name : expected)
  {
    Expect(methods[name] > 1, "fewer than two methods in " + name);
    Expect(defaults[name] == 1, std::to_string(defaults[name]) + " defaults of " + name);
  }
  Expect(methods.size() == expected.size(), "unexpected question among the rows");
}
}

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::cerr << "usage: TestBenchRows FILE" << std::endl;
    return EXIT_FAILURE;
  }
  std::ifstream file(argv[1]);
  const auto results = nlohmann::json::parse(file);
  for (const char* field : { "cpu", "cores", "memory_gib", "system", "compiler", "build", "smp" })
  {
    Expect(results.at("machine").contains(field), std::string("machine without ") + field);
  }
  Expect(results.at("vtk").is_string(), "no vtk");
  const auto& conditions = results.at("conditions");
  Expect(conditions.at("size") == "tiny" && conditions.at("threads") > 0 &&
      conditions.at("date").get<std::string>().size() == 10,
    "unexpected conditions: " + conditions.dump());
  Expect(!results.at("rows").empty(), "no rows");
  for (const auto& row : results.at("rows"))
  {
    CheckRow(row);
    const std::string suite = row.value("suite", "");
    Expect(results.at("suites").contains(suite), "no entry in suites for " + suite);
  }
  CheckMethods(results.at("rows"));
  CheckQuestions(results.at("rows"));
  return Success ? EXIT_SUCCESS : EXIT_FAILURE;
}
