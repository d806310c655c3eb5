# SPDX-License-Identifier: BSD-3-Clause
# Settings of the build of a wheel (pyproject.toml): all files are in the directory of the Python
# package, VTK's libraries are in the directory of vtkmodules next to it, and library names have no
# version, since a wheel cannot contain links.
set(interlume_library_destination interlume)
set(INTERLUME_PYTHON_DESTINATION .)
list(APPEND CMAKE_INSTALL_RPATH "$ORIGIN/../vtkmodules")
set(interlume_versions)
# VTK's wheels for this platform use the old ABI of the C++ library's strings:
# https://gitlab.kitware.com/vtk/vtk/-/issues/19919. Other builds of VTK do not.
if (VTK_DIR MATCHES "vtk_sdk" AND CMAKE_SYSTEM_NAME STREQUAL "Linux" AND CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64")
  add_compile_definitions(_GLIBCXX_USE_CXX11_ABI=0)
endif ()
