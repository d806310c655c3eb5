// SPDX-License-Identifier: BSD-3-Clause
#include "ParaView/Extractions/PictureStage.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolumeProperty.h"
#include "vtkWindowToImageFilter.h"

#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>

using nlohmann::json;

std::array<double, 3> Triple(const json& numbers)
{
  return numbers.get<std::array<double, 3>>();
}

void SetUpProperty(vtkVolumeProperty* property, const json& picture)
{
  vtkNew<vtkColorTransferFunction> colors;
  for (const json& row : picture["colors"])
  {
    colors->AddRGBPoint(row[0], row[1], row[2], row[3]);
  }
  vtkNew<vtkPiecewiseFunction> opacities;
  for (const json& row : picture["opacities"])
  {
    opacities->AddPoint(row[0], row[1]);
  }
  property->SetColor(colors);
  property->SetScalarOpacity(opacities);
  property->SetScalarOpacityUnitDistance(picture["unit"]);
}

void SetUpLight(vtkLight* light, const json& values)
{
  light->SetLightTypeToSceneLight();
  light->SetPosition(Triple(values["position"]).data());
  light->SetFocalPoint(Triple(values["focus"]).data());
  light->SetColor(Triple(values["color"]).data());
  light->SetIntensity(values["intensity"]);
}

void SavePicture(const json& picture, vtkRenderer* renderer, const std::string& folder)
{
  renderer->SetBackground(Triple(picture["background"]).data());
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(Triple(picture["camera"]["position"]).data());
  camera->SetFocalPoint(Triple(picture["camera"]["focus"]).data());
  camera->SetViewUp(Triple(picture["camera"]["up"]).data());
  camera->SetViewAngle(picture["camera"]["angle"]);
  renderer->ResetCameraClippingRange();
  vtkNew<vtkRenderWindow> window;
  window->OffScreenRenderingOn();
  window->SetMultiSamples(0);
  window->SetSize(picture["size"][0], picture["size"][1]);
  window->AddRenderer(renderer);
  window->Render();
  vtkNew<vtkWindowToImageFilter> grabber;
  grabber->SetInput(window);
  grabber->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(grabber->GetOutputPort());
  writer->SetFileName((folder + "/" + picture["name"].get<std::string>() + ".png").c_str());
  writer->Write();
  if (writer->GetErrorCode())
  {
    throw std::runtime_error("cannot write to " + folder);
  }
}

int WritePictures(int argc, char* argv[], const std::string& listName,
  const std::vector<json>& pictures,
  const std::function<void(const json&, const std::string&)>& draw)
{
  if (argc != 2)
  {
    std::cerr << "usage: " << argv[0] << " FOLDER\n";
    return EXIT_FAILURE;
  }
  const std::string folder = argv[1];
  try
  {
    // A virtual X server starts anew when its last client leaves: this one stays.
    vtkNew<vtkRenderWindow> display;
    display->OffScreenRenderingOn();
    display->SetSize(8, 8);
    display->Render();
    for (const json& picture : pictures)
    {
      draw(picture, folder);
    }
    std::ofstream(folder + "/" + listName) << json(pictures).dump(2) << "\n";
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << "\n";
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
