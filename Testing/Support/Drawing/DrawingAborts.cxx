// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Drawing/DrawingAborts.h"

#include "Support/Drawing/ShadowPicture.h"
#include "Support/Checks/ReferenceCheck.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"

#include <chrono>
#include <thread>

namespace reference
{

namespace
{

/// What VTK leaves between two questions whether to go on, and a little more.
constexpr std::chrono::milliseconds BetweenQuestions(250);

void Stop(vtkObject* window, unsigned long, void* isAsked, void*)
{
  *static_cast<bool*>(isAsked) = true;
  static_cast<vtkRenderWindow*>(window)->SetAbortRender(1);
}

}

void CheckDrawingAborts(vtkRenderWindow* window, Check& check)
{
  vtkRenderer* renderer = window->GetRenderers()->GetFirstRenderer();
  vtkCamera* camera = renderer->GetActiveCamera();
  const RgbaPicture whole = ReadWindow(window);
  camera->Azimuth(20.0);
  const RgbaPicture other = ReadWindow(window);
  camera->Azimuth(-20.0);

  bool isAsked = false;
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback(&Stop);
  stop->SetClientData(&isAsked);
  const unsigned long tag = window->AddObserver(vtkCommand::AbortCheckEvent, stop);
  std::this_thread::sleep_for(BetweenQuestions);
  const RgbaPicture stopped = ReadWindow(window);
  window->RemoveObserver(tag);
  window->SetAbortRender(0);
  check.That(isAsked, "the window is asked while it draws");
  check.That(ComparePictures(stopped, whole).Max > 0.0, "what is stopped is not whole");
  check.Near(ComparePictures(ReadWindow(window), whole).Max, 0.0, 0.0, "no trace is left", 1.0);
  camera->Azimuth(20.0);
  check.Near(
    ComparePictures(ReadWindow(window), other).Max, 0.0, 0.0, "from another view neither", 1.0);
  camera->Azimuth(-20.0);
}

}
