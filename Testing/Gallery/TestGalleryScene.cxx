// SPDX-License-Identifier: BSD-3-Clause
// Draws one scene of the gallery and compares it with its baseline, first by VTK's image
// difference, then pixel by pixel. Arguments: the scene's id, then arguments of vtkTesting: -T
// directory for results, -V baseline. The image is saved in the directory for results as
// `<id>.png`. After an intended change, inspect it and copy it over the baseline. `<id>.json`
// contains the counters, which TestGalleryCounters checks.

#include "Gallery/GalleryImage.h"
#include "Gallery/Scene.h"
#include "Gallery/SceneReport.h"
#include "Gallery/Stage.h"
#include "Support/Drawing/PixelDifference.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPNGWriter.h"
#include "vtkTesting.h"
#include "vtkTrivialProducer.h"

#include <nlohmann/json.hpp>
#include <vtksys/SystemTools.hxx>

#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <string>

namespace
{
constexpr int WIDTH = 480;
constexpr int HEIGHT = 300;

/// Threshold of VTK's image difference, as in VTK's own tests.
constexpr double VTK_THRESHOLD = 10.0;

bool IsWithinPixelBounds(vtkImageData* image, const std::string& baseline)
{
  if (!std::ifstream(baseline))
  {
    std::cerr << "There is no baseline " << baseline << "\n";
    return false;
  }
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(baseline.c_str());
  reader->Update();
  const interlume::PixelBounds bounds;
  const interlume::PixelDifference difference =
    interlume::ComparePixels(image, reader->GetOutput(), bounds.Step);
  std::cout << "difference from the baseline: " << difference << "\n";
  return interlume::IsWithin(difference, bounds);
}

/// Compares an image with the baseline, then with the alternatives `<id>_1.png` and so on, as VTK's
/// tests do. A scene has an alternative for each combination of VTK and Mesa whose noise differs
/// visibly. In VTK 9.1, a whole number of tiles of vtkSSAOPass noise spans the window, but not in
/// newer versions. The edges of textured lines depend on Mesa's choice of mipmap levels.
bool IsWithinPixelBoundsOfAny(vtkImageData* image, const std::string& baseline)
{
  bool isWithin = IsWithinPixelBounds(image, baseline);
  const std::string stem = baseline.substr(0, baseline.rfind('.'));
  std::string next = stem + "_1.png";
  for (int i = 2; !isWithin && std::ifstream(next); ++i)
  {
    isWithin = IsWithinPixelBounds(image, next);
    next = stem + "_" + std::to_string(i) + ".png";
  }
  return isWithin;
}

bool Matches(const gallery::Scene& scene, vtkTesting* testing)
{
  const gallery::DisplayKeepAlive display;
  gallery::SceneReport report;
  vtkSmartPointer<vtkImageData> image = gallery::RenderScene(scene, { WIDTH, HEIGHT }, report);
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(image);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName((std::string(testing->GetTempDirectory()) + "/" + scene.Id + ".png").c_str());
  writer->Write();
  std::ofstream(std::string(testing->GetTempDirectory()) + "/" + scene.Id + ".json")
    << gallery::ToJson(report).dump(2) << "\n";
  const bool close = testing->RegressionTest(producer, VTK_THRESHOLD) == vtkTesting::PASSED;
  const bool same = IsWithinPixelBoundsOfAny(image, testing->GetValidImageFileName());
  return close && same;
}
}

int main(int argc, char* argv[])
{
  const gallery::Scene* scene = argc > 1 ? gallery::FindScene(argv[1]) : nullptr;
  if (!scene)
  {
    std::cerr << "The first argument must be the id of a scene.\n";
    return EXIT_FAILURE;
  }
  // Newer versions of VTK have other comparison methods. They interpret the threshold differently,
  // so that an empty image would pass. This selects the method of VTK 9.1.
  vtksys::SystemTools::PutEnv("VTK_TESTING_IMAGE_COMPARE_METHOD=LEGACY_VALID");
  vtkNew<vtkTesting> testing;
  testing->AddArguments(argc, argv);
  try
  {
    return Matches(*scene, testing) ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << "\n";
    return EXIT_FAILURE;
  }
}
