// SPDX-License-Identifier: BSD-3-Clause
// Extreme media and lights of the multiple scattering solver.
#include "Support/Checks/LargestError.h"
#include "Support/Pages/StabilityCase.h"
#include "Scattering/Solver/ScatteringCases.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace
{

using namespace reference;
using namespace interlume;

const float NotANumber = std::numeric_limits<float>::quiet_NaN();
constexpr int Size = 16;

class SolverTable
{
public:
  SolverTable(int argc, char* argv[])
    : Catalogue("TestScatteringExtremes", argc, argv)
  {
    this->Catalogue.SetClass("vtkShadowedSliceMapper");
  }

  /// Checks in both modes that values are finite and not negative, and that the outgoing energy
  /// equals the incoming energy. The result is NaN if no light enters the medium.
  void Energy(const std::string& name, const std::string& extreme, const ScatteringMedium& medium,
    const std::vector<ScatteringLight>& lights)
  {
    double worst = 0.0;
    for (const ScatteringMode mode : { ScatteringMode::Forward, ScatteringMode::Full })
    {
      const Solved solved = Solve(medium, lights, mode);
      const double taken = solved.Report.Taken;
      reference::KeepLargest(
        worst, taken > 0.0 ? std::abs(solved.GetSum() / taken - 1.0) : std::nan(""));
      worst = IsValid(solved) && taken > 0.0 ? worst : std::nan("");
    }
    this->Catalogue.Measure(
      name, extreme, "outgoing energy over incoming energy, minus 1, of both modes", worst, 1e-4);
  }

  void Measure(const std::string& name, const std::string& extreme, const std::string& expected,
    double measured, double bound)
  {
    this->Catalogue.Measure(name, extreme, expected, measured, bound);
  }
  void Check(const std::string& name, const std::string& extreme, const std::string& expected,
    const std::string& seen, bool passed)
  {
    this->Catalogue.Check(name, extreme, expected, seen, passed);
  }

  static bool IsValid(const Solved& solved)
  {
    const auto isValid = [](const glm::vec3& value)
    {
      return value.x >= 0.0f && value.y >= 0.0f && value.z >= 0.0f &&
        value.x + value.y + value.z < 1e6f;
    };
    bool all = !solved.Error && !solved.Field.Fluence.empty() &&
      std::all_of(solved.Field.Fluence.begin(), solved.Field.Fluence.end(), isValid);
    for (const std::vector<glm::vec3>& forward : solved.Field.Forward)
    {
      all = all && std::all_of(forward.begin(), forward.end(), isValid);
    }
    return all;
  }

  int GetExitCode() { return this->Catalogue.GetExitCode(); }

private:
  StabilityCatalogue Catalogue;
};

/// Returns the largest difference between the fluences of two fields, relative to the largest
/// fluence of the second field.
double Difference(const ScatteredLight& a, const ScatteredLight& b)
{
  double largest = 0.0;
  double difference = 0.0;
  for (std::size_t i = 0; i < a.Fluence.size(); ++i)
  {
    reference::KeepLargest(largest, static_cast<double>(b.Fluence[i].x));
    difference =
      std::max(difference, static_cast<double>(std::abs(a.Fluence[i].x - b.Fluence[i].x)));
  }
  return largest > 0.0 ? difference / largest : std::nan("");
}

const glm::dvec3 Oblique(1.0, -2.0, 2.0);

void TestMedia(SolverTable& table)
{
  for (const double depth : { 1e-6, 1e-2, 1e2, 1e4 })
  {
    std::ostringstream name;
    name << "depth-" << depth;
    const ScatteringMedium medium = MakeCloud(Size, depth, glm::vec3(1.0f, 0.99f, 0.5f), 0.8);
    table.Energy(
      name.str(), "a cloud of that optical depth", medium, { MakeLight(medium, Oblique) });
  }
  for (const double g : { -0.99, 0.99 })
  {
    const ScatteringMedium medium = MakeCloud(Size, 20.0, glm::vec3(1.0f), g);
    table.Energy(g < 0.0 ? "backwards" : "forwards",
      "a phase function with the mean cosine " + std::to_string(g), medium,
      { MakeLight(medium, Oblique) });
  }
  const ScatteringMedium white = MakeCloud(Size, 20.0, glm::vec3(1.0f), 0.0);
  table.Energy("albedo-1", "no absorption", white, { MakeLight(white, Oblique) });
  const ScatteringMedium black = MakeCloud(Size, 20.0, glm::vec3(0.0f), 0.8);
  const Solved dark = Solve(black, { MakeLight(black, Oblique) }, ScatteringMode::Full);
  table.Measure("albedo-0", "full absorption", "fraction of the light that is not absorbed",
    1.0 - dark.Report.Absorbed / dark.Report.Taken, 1e-6);
  ScatteringMedium one = MakeMedium(glm::ivec3(1), 3.0, glm::vec3(0.9f), 0.5);
  table.Energy("one-cell", "a grid of one cell", one, { MakeLight(one, Oblique) });
  ScatteringMedium mirrors = MakeMedium(glm::ivec3(6), 3.0, glm::vec3(0.9f), 0.0);
  mirrors.Mirrors = glm::bvec3(true);
  ScatteringLight even;
  even.Direct.assign(mirrors.GetNumberOfCells(), glm::vec3(1.0f));
  const Solved closed = Solve(mirrors, { even }, ScatteringMode::Full);
  table.Measure("mirrors", "mirrors on all sides and uniform light",
    "fluence minus albedo / (1 - albedo)", closed.Field.Fluence[0].x - 9.0, 0.01);
}

/// Compares each channel with a solution in which all channels have that channel's albedo and
/// light. Returns the largest difference, relative to the largest fluence.
double CompareChannels(const ScatteringMedium& medium, const glm::vec3& color)
{
  const auto solve = [](const ScatteringMedium& own, const glm::vec3& light)
  {
    std::vector<ScatteringLight> lights;
    for (const double side : { -1.0, 1.0 })
    {
      lights.push_back(MakeLight(own, side * Oblique));
      lights.back().Fill(own, light);
    }
    ScatteringSettings settings;
    settings.Tolerance = 1e-8;
    return Solve(own, lights, ScatteringMode::Full, settings).Field;
  };
  const ScatteredLight together = solve(medium, color);
  double worst = 0.0;
  for (int channel = 0; channel < 3; ++channel)
  {
    ScatteringMedium single = medium;
    for (glm::vec3& albedo : single.Albedo)
    {
      albedo = glm::vec3(albedo[channel]);
    }
    const ScatteredLight alone = solve(single, glm::vec3(color[channel]));
    double largest = 0.0;
    double difference = 0.0;
    for (std::size_t i = 0; i < alone.Fluence.size(); ++i)
    {
      const double expected = alone.Fluence[i].x;
      reference::KeepLargest(largest, expected);
      reference::KeepLargest(difference, std::abs(together.Fluence[i][channel] - expected));
    }
    reference::KeepLargest(worst, largest > 0.0 ? difference / largest : std::nan(""));
  }
  return worst;
}

void TestChannels(SolverTable& table)
{
  const std::string expected = "largest difference from a solution with equal channels";
  for (const double depth : { 1e1, 1e3, 1e5 })
  {
    std::ostringstream name;
    name << "channels-" << depth;
    table.Measure(name.str(), "the same light and albedo in all channels", expected,
      CompareChannels(MakeMedium(glm::ivec3(6), depth, glm::vec3(1.0f), 0.0), glm::vec3(1.0f)),
      1e-5);
  }
  // The source terms of all channels are equal, but the absorption differs.
  table.Measure("channels-source", "the same product of light and albedo in all channels", expected,
    CompareChannels(MakeMedium(glm::ivec3(6), 60.0, glm::vec3(1.0f, 0.5f, 0.25f), 0.0),
      glm::vec3(0.25f, 0.5f, 1.0f)),
    1e-5);
}

void TestCells(SolverTable& table)
{
  const ScatteringMedium clean = MakeCloud(Size, 20.0, glm::vec3(0.9f), 0.8);
  const ScatteringLight light = MakeLight(clean, Oblique);
  ScatteringMedium empty = clean;
  ScatteringMedium bad = clean;
  for (std::size_t i = 0; i < clean.GetNumberOfCells(); i += 37)
  {
    empty.Extinction[i] = 0.0f;
    bad.Extinction[i] = i % 2 ? NotANumber : std::numeric_limits<float>::infinity();
  }
  const Solved expected = Solve(empty, { light }, ScatteringMode::Full);
  const Solved found = Solve(bad, { light }, ScatteringMode::Full);
  table.Measure("nan-cells", "extinction NaN or infinite in some cells",
    "largest difference from empty cells", Difference(found.Field, expected.Field), 0.0);
  const std::size_t count = (clean.GetNumberOfCells() + 36) / 37;
  table.Measure("nan-cells-counted", "extinction NaN or infinite in some cells",
    "number of such cells minus the reported number",
    static_cast<double>(count) - static_cast<double>(found.Report.BadCells), 0.0);
  ScatteringMedium nothing = clean;
  nothing.Extinction.assign(nothing.GetNumberOfCells(), 0.0f);
  const Solved none = Solve(nothing, { light }, ScatteringMode::Full);
  table.Measure("nothing", "no medium", "sum of the energy",
    none.GetSum() + (SolverTable::IsValid(none) ? 0.0 : std::nan("")), 0.0);

  ScatteringMedium wall = MakeMedium(glm::ivec3(Size), 20.0, glm::vec3(1.0f), 0.5);
  wall.Blocked.assign(wall.GetNumberOfCells(), 0);
  glm::ivec3 cell(0, 0, Size / 2);
  for (cell.y = 0; cell.y < Size; ++cell.y)
  {
    for (cell.x = 0; cell.x < Size; ++cell.x)
    {
      wall.Blocked[wall.GetIndex(cell)] = 1;
    }
  }
  const Solved walled = Solve(wall, { MakeLight(wall, { 0.0, 0.0, 1.0 }) }, ScatteringMode::Full);
  float behind = 0.0f;
  for (std::size_t i = wall.GetIndex({ 0, 0, Size / 2 }); i < walled.Field.Fluence.size(); ++i)
  {
    behind = std::max(behind, walled.Field.Fluence[i].x);
  }
  const float before = walled.Field.Fluence[wall.GetIndex({ Size / 2, Size / 2, 2 })].x;
  table.Measure("wall", "a wall of blocked cells across the grid",
    "light behind the wall over light in front of it",
    before > 0.0f ? behind / before : std::nan(""), 0.0);
  table.Energy("wall-energy", "a wall of blocked cells across the grid", wall,
    { MakeLight(wall, { 0.0, 0.0, 1.0 }) });
}

void TestLights(SolverTable& table)
{
  const ScatteringMedium medium = MakeCloud(Size, 20.0, glm::vec3(1.0f, 0.9f, 0.8f), 0.8);
  table.Energy("light-inside", "a light inside the medium", medium,
    { MakeScatteringPointLight(medium, { 0.5, 0.5, 0.5 }) });
  table.Energy("light-in-middle-of-cell", "a light at the center of a cell", medium,
    { MakeScatteringPointLight(medium, glm::dvec3(7.5 / Size)) });
  table.Energy("light-far", "a light 1e9 away", medium,
    { MakeScatteringPointLight(medium, { 1e9, 0.5, 0.5 }) });
  table.Energy("opposite-lights", "two opposite lights", medium,
    { MakeLight(medium, { 0.0, 0.0, 1.0 }), MakeLight(medium, { 0.0, 0.0, -1.0 }) });
  ScatteringLight dark = MakeLight(medium, Oblique);
  for (glm::vec3& direct : dark.Direct)
  {
    direct = glm::vec3(0.0f);
  }
  const Solved black = Solve(medium, { dark }, ScatteringMode::Full);
  table.Measure("black-light", "a black light", "sum of the energy",
    black.GetSum() + (SolverTable::IsValid(black) ? 0.0 : std::nan("")), 0.0);
  const Solved none = Solve(medium, {}, ScatteringMode::Full);
  table.Measure("no-light", "no light", "sum of the energy",
    none.GetSum() + (SolverTable::IsValid(none) ? 0.0 : std::nan("")), 0.0);
  ScatteringLight bad = MakeLight(medium, Oblique);
  bad.Direct[100].y = NotANumber;
  table.Energy("nan-light", "a light that is NaN in one cell", medium, { bad });

  ScatteredLight field;
  ScatteringReport report;
  bad.Direct.pop_back();
  std::string error =
    ScatteringSolver::Solve(medium, { bad }, ScatteringMode::Full, {}, field, report).GetMessage();
  table.Check("cells-missing", "a light that lacks one cell", "an error that names both numbers",
    error, error.find("4095") != std::string::npos && error.find("4096") != std::string::npos);
  ScatteringLight nullDirection = MakeLight(medium, Oblique);
  nullDirection.Direction = glm::dvec3(0.0);
  error =
    ScatteringSolver::Solve(medium, { nullDirection }, ScatteringMode::Full, {}, field, report)
      .GetMessage();
  table.Check("no-direction", "a light whose direction has zero length",
    "an error that names the direction", error, error.find("not of length 1") != std::string::npos);
  ScatteringMedium flat = medium;
  flat.Cells.y = 0;
  error = ScatteringSolver::Solve(flat, {}, ScatteringMode::Full, {}, field, report).GetMessage();
  table.Check("no-cells", "a grid without cells", "an error that names the axis", error,
    error.find("0 cells along axis 1") != std::string::npos);
}

}

int TestScatteringExtremes(int argc, char* argv[])
{
  SolverTable table(argc, argv);
  TestMedia(table);
  TestChannels(table);
  TestCells(table);
  TestLights(table);
  return table.GetExitCode();
}
