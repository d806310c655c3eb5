// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Drawing/DrawingAborts.h"

#include "Support/Images/VolumeStage.h"
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

/// Longer than VTK's interval between two abort checks (five per second at most).
constexpr std::chrono::milliseconds AbortCheckInterval(250);

void Stop(vtkObject* window, unsigned long, void* isInvoked, void*)
{
  *static_cast<bool*>(isInvoked) = true;
  static_cast<vtkRenderWindow*>(window)->SetAbortRender(1);
}

}

void CheckDrawingAborts(vtkRenderWindow* window, Check& check)
{
  vtkRenderer* renderer = window->GetRenderers()->GetFirstRenderer();
  vtkCamera* camera = renderer->GetActiveCamera();
  const RgbaImage complete = ReadWindow(window);
  camera->Azimuth(20.0);
  const RgbaImage other = ReadWindow(window);
  camera->Azimuth(-20.0);

  bool isInvoked = false;
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback(&Stop);
  stop->SetClientData(&isInvoked);
  const unsigned long tag = window->AddObserver(vtkCommand::AbortCheckEvent, stop);
  std::this_thread::sleep_for(AbortCheckInterval);
  const RgbaImage stopped = ReadWindow(window);
  window->RemoveObserver(tag);
  window->SetAbortRender(0);
  check.That(isInvoked, "the window invokes AbortCheckEvent while it renders");
  check.That(CompareImages(stopped, complete).Max > 0.0, "the aborted frame is incomplete");
  check.Near(CompareImages(ReadWindow(window), complete).Max, 0.0, 0.0,
    "the next frame after an abort is complete", 1.0);
  camera->Azimuth(20.0);
  check.Near(CompareImages(ReadWindow(window), other).Max, 0.0, 0.0,
    "a frame from another view after an abort is complete", 1.0);
  camera->Azimuth(-20.0);
}

}
