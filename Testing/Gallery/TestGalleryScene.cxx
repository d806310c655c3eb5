// SPDX-License-Identifier: BSD-3-Clause
// Draws one scene of the gallery and compares it with its baseline, first by VTK's own image
// difference, then pixel by pixel. Arguments: the scene's id, then those of vtkTesting: -T folder
// for results, -V baseline. The picture is left in the folder for results as `<id>.png`: look at
// it, and copy it over the baseline where a change is meant.

#include "Gallery/Picture.h"
#include "Gallery/Scene.h"
#include "Gallery/Stage.h"
#include "Support/Drawing/PixelDifference.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPNGWriter.h"
#include "vtkTesting.h"
#include "vtkTrivialProducer.h"

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

/// Threshold of VTK's image difference, as its own tests have it.
constexpr double VTK_THRESHOLD = 10.0;

bool IsWithinPixelBounds(vtkImageData* picture, const std::string& baseline)
{
  if (!std::ifstream(baseline))
  {
    std::cerr << "no baseline " << baseline << "\n";
    return false;
  }
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(baseline.c_str());
  reader->Update();
  const interlume::PixelBounds bounds;
  const interlume::PixelDifference difference =
    interlume::ComparePixels(picture, reader->GetOutput(), bounds.Step);
  std::cout << "against the baseline: " << difference << "\n";
  return interlume::IsWithin(difference, bounds);
}

/// Against the baseline, then against its alternatives, named `<id>_1.png` and so on as in VTK's
/// own tests. A scene has one for each combination of VTK and Mesa whose grain shows: of
/// vtkSSAOPass, where VTK 9.1 rounds how often the noise goes across the window and newer versions
/// do not, and at the edges of lines that are a texture, by Mesa's choice of its levels.
bool IsWithinPixelBoundsOfAny(vtkImageData* picture, const std::string& baseline)
{
  bool isWithin = IsWithinPixelBounds(picture, baseline);
  const std::string stem = baseline.substr(0, baseline.rfind('.'));
  std::string next = stem + "_1.png";
  for (int i = 2; !isWithin && std::ifstream(next); ++i)
  {
    isWithin = IsWithinPixelBounds(picture, next);
    next = stem + "_" + std::to_string(i) + ".png";
  }
  return isWithin;
}

bool Matches(const gallery::Scene& scene, vtkTesting* testing)
{
  const gallery::DisplayHold display;
  gallery::SceneReport report;
  vtkSmartPointer<vtkImageData> picture = gallery::RenderScene(scene, WIDTH, HEIGHT, report);
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(picture);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(picture);
  writer->SetFileName((std::string(testing->GetTempDirectory()) + "/" + scene.Id + ".png").c_str());
  writer->Write();
  const bool close = testing->RegressionTest(producer, VTK_THRESHOLD) == vtkTesting::PASSED;
  const bool same = IsWithinPixelBoundsOfAny(picture, testing->GetValidImageFileName());
  return close && same;
}
}

int main(int argc, char* argv[])
{
  const gallery::Scene* scene = argc > 1 ? gallery::FindScene(argv[1]) : nullptr;
  if (!scene)
  {
    std::cerr << "the first argument is the id of a scene\n";
    return EXIT_FAILURE;
  }
  // Newer versions of VTK have other ways to compare, to which the threshold means something else:
  // an empty picture passes. This is the way of VTK 9.1.
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
