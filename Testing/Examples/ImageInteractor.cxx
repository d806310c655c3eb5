// SPDX-License-Identifier: BSD-3-Clause
// An object factory that lets the programs of the guide run without a user. Every
// vtkRenderWindowInteractor writes the image of its window to the PNG file INTERLUME_IMAGE instead
// of starting the event loop. VTK loads the library from the directory VTK_AUTOLOAD_PATH, in C++
// and in Python, so that the programs run unchanged.
//
// INTERLUME_IMAGE_SCALE is the size of the image relative to the window, 1 by default.
// INTERLUME_IMAGE_SAMPLES is the number of samples per pixel and axis, 1 by default.

#include <vtkImageShrink3D.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkVersion.h>
#include <vtkWindowToImageFilter.h>

#include <cstdlib>

namespace
{
double GetNumber(const char* variable)
{
  const char* text = std::getenv(variable);
  return text ? std::atof(text) : 1.0;
}

class ImageInteractor : public vtkRenderWindowInteractor
{
public:
  static ImageInteractor* New();
  vtkTypeMacro(ImageInteractor, vtkRenderWindowInteractor);

  void Start() override
  {
    const int samples = static_cast<int>(GetNumber("INTERLUME_IMAGE_SAMPLES"));
    const double scale = samples * GetNumber("INTERLUME_IMAGE_SCALE");
    vtkRenderWindow* window = this->GetRenderWindow();
    const int* size = window->GetSize();
    window->OffScreenRenderingOn();
    window->SetMultiSamples(0);
    window->SetSize(static_cast<int>(scale * size[0]), static_cast<int>(scale * size[1]));
    window->Render();
    vtkNew<vtkWindowToImageFilter> image;
    image->SetInput(window);
    image->ReadFrontBufferOff();
    image->ShouldRerenderOff();
    vtkNew<vtkImageShrink3D> mean;
    mean->SetInputConnection(image->GetOutputPort());
    mean->SetShrinkFactors(samples, samples, 1);
    mean->MeanOn();
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputConnection(mean->GetOutputPort());
    writer->SetCompressionLevel(9);
    writer->SetFileName(std::getenv("INTERLUME_IMAGE"));
    writer->Write();
  }
};
vtkStandardNewMacro(ImageInteractor);
VTK_CREATE_CREATE_FUNCTION(ImageInteractor);

class ImageInteractorFactory : public vtkObjectFactory
{
public:
  static ImageInteractorFactory* New();
  vtkTypeMacro(ImageInteractorFactory, vtkObjectFactory);
  const char* GetVTKSourceVersion() override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() override { return "writes images instead of waiting for events"; }

protected:
  ImageInteractorFactory()
  {
    this->RegisterOverride("vtkRenderWindowInteractor", "ImageInteractor", this->GetDescription(),
      1, vtkObjectFactoryCreateImageInteractor);
  }
};
vtkStandardNewMacro(ImageInteractorFactory);
}

VTK_FACTORY_INTERFACE_IMPLEMENT(ImageInteractorFactory)
