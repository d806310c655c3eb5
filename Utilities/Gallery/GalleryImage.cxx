// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/GalleryImage.h"

#include "vtkNew.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>

namespace gallery
{
namespace
{
constexpr int CHANNELS = 3;

unsigned char* Pixel(vtkImageData* image, int x, int y)
{
  return static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
}
}

vtkSmartPointer<vtkRenderWindow> MakeWindow(int width, int height)
{
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->OffScreenRenderingOn();
  window->SetMultiSamples(0);
  window->SetSize(width, height);
  return window;
}

DisplayKeepAlive::DisplayKeepAlive()
  : Window(MakeWindow(8, 8))
{
  this->Window->Render();
}

vtkSmartPointer<vtkImageData> GrabImage(vtkRenderWindow* window)
{
  window->Render();
  vtkNew<vtkWindowToImageFilter> grabber;
  grabber->SetInput(window);
  grabber->SetInputBufferTypeToRGB();
  grabber->ReadFrontBufferOff();
  grabber->ShouldRerenderOff();
  grabber->Update();
  return grabber->GetOutput();
}

void Paste(vtkImageData* whole, vtkImageData* part, int left, int bottom)
{
  const int width = part->GetDimensions()[0];
  const int height = part->GetDimensions()[1];
  for (int y = 0; y < height; ++y)
  {
    std::copy_n(Pixel(part, 0, y), CHANNELS * width, Pixel(whole, left, bottom + y));
  }
}

vtkSmartPointer<vtkImageData> DownsampleRgbImage(vtkImageData* large, int factor)
{
  auto small = vtkSmartPointer<vtkImageData>::New();
  small->SetDimensions(large->GetDimensions()[0] / factor, large->GetDimensions()[1] / factor, 1);
  small->AllocateScalars(VTK_UNSIGNED_CHAR, CHANNELS);
  const int width = small->GetDimensions()[0];
  const int height = small->GetDimensions()[1];
  const int samples = factor * factor;
  for (int y = 0; y < height; ++y)
  {
    unsigned char* target = Pixel(small, 0, y);
    for (int x = 0; x < width; ++x)
    {
      int sums[CHANNELS] = { 0, 0, 0 };
      for (int sample = 0; sample < samples; ++sample)
      {
        const unsigned char* source =
          Pixel(large, x * factor + sample % factor, y * factor + sample / factor);
        for (int channel = 0; channel < CHANNELS; ++channel)
        {
          sums[channel] += source[channel];
        }
      }
      for (const int sum : sums)
      {
        *target++ = static_cast<unsigned char>((sum + samples / 2) / samples);
      }
    }
  }
  return small;
}
}
