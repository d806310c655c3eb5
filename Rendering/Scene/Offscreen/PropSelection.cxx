// SPDX-License-Identifier: BSD-3-Clause
#include "Offscreen/PropSelection.h"

#include "InterlumePropSelectionFS.h"
#include "vtkHardwareSelector.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <array>

namespace interlume
{

void PropSelection::Show(
  vtkHardwareSelector* selector, vtkOpenGLRenderWindow* window, vtkTextureObject* picture)
{
  std::array<float, 3> color{ { 0.0f, 0.0f, 0.0f } };
  bool isShown = picture != nullptr;
  selector->BeginRenderProp();
  switch (selector->GetCurrentPass())
  {
    case vtkHardwareSelector::ACTOR_PASS:
      std::copy_n(selector->GetPropColorValue(), 3, color.begin());
      break;
    case vtkHardwareSelector::PROCESS_PASS:
      vtkHardwareSelector::Convert(selector->GetProcessID() + 1, color.data());
      break;
    case vtkHardwareSelector::COMPOSITE_INDEX_PASS:
      vtkHardwareSelector::Convert(1, color.data());
      break;
    default:
      isShown = false;
      break;
  }
  if (isShown)
  {
    this->Quad.DrawWith(window, picture, InterlumePropSelectionFS,
      [&color](vtkShaderProgram* program)
      { program->SetUniform3f("selectionColor", color.data()); });
  }
  selector->EndRenderProp();
}

void PropSelection::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Quad.ReleaseGraphicsResources(window);
}

}
