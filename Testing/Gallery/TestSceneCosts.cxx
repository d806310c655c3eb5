// SPDX-License-Identifier: BSD-3-Clause
// A feature that is off costs nothing, before it is first turned on and after it is turned off
// again: no pass, buffer, byte, shader token or array. Each counter is known to work, because some
// feature increases it. Arguments: scenes, each optionally followed by = and the only class whose
// features are measured.
#include "Gallery/Costs/SceneCosts.h"
#include "Gallery/GalleryImage.h"
#include "Gallery/Scene.h"

#include <cstdlib>
#include <exception>
#include <iostream>
#include <map>
#include <string>

namespace
{
constexpr int WIDTH = 160;
constexpr int HEIGHT = 100;

class Checker
{
public:
  void Check(const std::string& scene, const gallery::FeatureCosts& feature)
  {
    const std::string name = scene + ": " + feature.Class + " " + feature.Feature;
    std::cout << name << ": own " << feature.OwnOff << ", " << feature.OwnOn << ", "
              << feature.OwnAfter << "; adds passes " << feature.Added.Passes << ", buffers "
              << feature.Added.Buffers << ", bytes " << feature.Added.Bytes << ", words "
              << feature.Added.Words << ", arrays " << feature.Added.Arrays << "; leaves "
              << feature.Left.Passes << ", " << feature.Left.Buffers << ", " << feature.Left.Bytes
              << ", " << feature.Left.Words << ", " << feature.Left.Arrays << std::endl;
    this->Expect(feature.OwnOff == 0.0, name + " has no own cost while it is off");
    this->Expect(feature.OwnAfter == 0.0, name + " has no own cost when it is off again");
    const gallery::Costs& left = feature.Left;
    this->Expect(left.Passes == 0.0, name + " leaves no pass behind");
    this->Expect(left.Buffers == 0.0, name + " leaves no buffer behind");
    this->Expect(left.Bytes == 0.0, name + " leaves no byte behind");
    this->Expect(left.Words == 0.0, name + " leaves no shader token behind");
    this->Expect(left.Arrays == 0.0, name + " leaves no array behind");
    const gallery::Costs& added = feature.Added;
    this->Adds["own"] += feature.OwnOn > 0.0 ? 1 : 0;
    this->Adds["passes"] += added.Passes > 0.0 ? 1 : 0;
    this->Adds["buffers"] += added.Buffers > 0.0 ? 1 : 0;
    this->Adds["bytes"] += added.Bytes > 0.0 ? 1 : 0;
    this->Adds["words"] += added.Words > 0.0 ? 1 : 0;
    this->Adds["arrays"] += added.Arrays > 0.0 ? 1 : 0;
    ++this->Features;
  }

  void CheckAll()
  {
    for (const char* counter : { "own", "passes", "buffers", "bytes", "words", "arrays" })
    {
      this->Expect(
        this->Adds[counter] > 0, std::string("some feature increases the counter ") + counter);
    }
    this->Expect(this->Features > 10, "more than ten features are measured");
  }

  bool HasPassed() const { return this->Passed; }

private:
  void Expect(bool holds, const std::string& what)
  {
    if (!holds)
    {
      std::cerr << "expected: " << what << "\n";
      this->Passed = false;
    }
  }

  std::map<std::string, int> Adds;
  int Features = 0;
  bool Passed = true;
};
}

int main(int argc, char* argv[])
{
  try
  {
    const gallery::DisplayKeepAlive display;
    Checker checker;
    for (int i = 1; i < argc; ++i)
    {
      const std::string argument = argv[i];
      const std::size_t end = argument.find('=');
      const gallery::Scene* scene = gallery::FindScene(argument.substr(0, end));
      if (!scene)
      {
        std::cerr << "There is no scene " << argv[i] << "\n";
        return EXIT_FAILURE;
      }
      gallery::CostSettings settings;
      settings.Width = WIDTH;
      settings.Height = HEIGHT;
      settings.Pairs = 0;
      settings.OnlyClass = end == std::string::npos ? "" : argument.substr(end + 1);
      for (const gallery::FeatureCosts& feature : gallery::MeasureSceneCosts(*scene, settings))
      {
        checker.Check(scene->Id, feature);
      }
    }
    checker.CheckAll();
    return checker.HasPassed() ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << "\n";
    return EXIT_FAILURE;
  }
}
