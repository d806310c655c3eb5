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

bool PropSelection::FindColor(vtkHardwareSelector* selector, float* color)
{
  switch (selector->GetCurrentPass())
  {
    case vtkHardwareSelector::ACTOR_PASS:
      std::copy_n(selector->GetPropColorValue(), 3, color);
      return true;
    case vtkHardwareSelector::PROCESS_PASS:
      vtkHardwareSelector::Convert(selector->GetProcessID() + 1, color);
      return true;
    case vtkHardwareSelector::COMPOSITE_INDEX_PASS:
      vtkHardwareSelector::Convert(1, color);
      return true;
    default:
      return false;
  }
}

void PropSelection::Show(
  vtkHardwareSelector* selector, vtkOpenGLRenderWindow* window, vtkTextureObject* image)
{
  std::array<float, 3> color{};
  selector->BeginRenderProp();
  if (image && FindColor(selector, color.data()))
  {
    this->Quad.DrawWithShader(window, image, InterlumePropSelectionFS,
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
