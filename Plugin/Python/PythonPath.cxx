// SPDX-License-Identifier: BSD-3-Clause
// Python's package lies beside the plugin: a process that has loaded the plugin finds it there, so
// that programmable filters and the Python shell import it with nothing set before.
#include "vtkPythonInterpreter.h"
#include "vtksys/SystemTools.hxx"

#ifdef _WIN32
#include "vtkResourceFileLocator.h"
#else
#include <dlfcn.h>
#endif

#include <string>

namespace
{
// Returns the path of the library that holds an address, or nothing.
std::string GetLibraryPath(const void* address)
{
#ifdef _WIN32
  return vtkResourceFileLocator::GetLibraryPathForSymbolWin32(address);
#else
  Dl_info library;
  return dladdr(address, &library) != 0 && library.dli_fname ? library.dli_fname : "";
#endif
}

// The path is added when the plugin is loaded, be Python there already or later.
const bool IsAdded = []
{
  const std::string plugin = vtksys::SystemTools::CollapseFullPath(GetLibraryPath(&IsAdded));
  const std::string path = vtksys::SystemTools::GetFilenamePath(plugin) + "/python";
  const bool isThere = vtksys::SystemTools::FileExists(path + "/interlume/__init__.py");
  if (isThere)
  {
    vtkPythonInterpreter::PrependPythonPath(path.c_str());
  }
  return isThere;
}();
}
