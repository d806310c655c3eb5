// SPDX-License-Identifier: BSD-3-Clause
// Adds the directory of the Python package, next to the plugin library, to Python's search path.
// Programmable filters and the Python shell can then import the package without further setup.
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
// Returns the path of the library that contains an address, or an empty string.
std::string GetLibraryPath(const void* address)
{
#ifdef _WIN32
  return vtkResourceFileLocator::GetLibraryPathForSymbolWin32(address);
#else
  Dl_info library;
  return dladdr(address, &library) != 0 && library.dli_fname ? library.dli_fname : "";
#endif
}

// Adds the path when the plugin is loaded, whether or not Python is already initialized.
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
