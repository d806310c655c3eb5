// SPDX-License-Identifier: BSD-3-Clause
#include "GuideImage.h"

#include <vtkCamera.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkWindowToImageFilter.h>

#include <cstdlib>
#include <iostream>

GuideImage::GuideImage(int argc, char* argv[])
{
  if (argc != 3)
  {
    std::cerr << "usage: " << argv[0] << " DATA IMAGE.png\n";
    std::exit(EXIT_FAILURE);
  }
  this->Folder = argv[1];
  this->File = argv[2];
  this->Renderer->SetBackground(0.925, 0.929, 0.933);
}

std::string GuideImage::GetPath(const std::string& name) const
{
  return this->Folder + "/" + name;
}

int GuideImage::Write(double x, double y, double z)
{
  vtkNew<vtkRenderWindow> window;
  window->OffScreenRenderingOn();
  window->SetMultiSamples(0);
  window->SetSize(600, 450);
  window->AddRenderer(this->Renderer);
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(x, y, z);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  this->Renderer->ResetCamera();
  camera->Zoom(1.25);
  window->Render();
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  image->ReadFrontBufferOff();
  image->ShouldRerenderOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(image->GetOutputPort());
  writer->SetFileName(this->File.c_str());
  writer->Write();
  return writer->GetErrorCode() ? EXIT_FAILURE : EXIT_SUCCESS;
}
