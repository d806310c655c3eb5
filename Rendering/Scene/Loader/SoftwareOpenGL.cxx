// SPDX-License-Identifier: BSD-3-Clause
#include "Loader/SoftwareOpenGL.h"

#include "Loader/OpenGLFunctions.h"

#include "vtkOpenGLRenderWindow.h"

#include <cstring>

namespace interlume
{

bool SoftwareOpenGL::IsUsed(vtkOpenGLRenderWindow* window)
{
  window->MakeCurrent();
  const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  if (!name)
  {
    return true;
  }
  for (const char* software :
    { "llvmpipe", "softpipe", "SWR", "Software", "SwiftShader", "Basic Render", "GDI Generic" })
  {
    if (std::strstr(name, software))
    {
      return true;
    }
  }
  return false;
}

}
