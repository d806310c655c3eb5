# SPDX-License-Identifier: BSD-3-Clause
# Where the build of a wheel (pyproject.toml) differs: everything is in the folder of Python's package,
# VTK's libraries are in that of vtkmodules beside it, and libraries have no version in their names, since
# a wheel has no links.
set(interlume_library_destination interlume)
set(INTERLUME_PYTHON_DESTINATION .)
list(APPEND CMAKE_INSTALL_RPATH "$ORIGIN/../vtkmodules")
set(interlume_versions)
# VTK's wheels for this processor are compiled with the older strings of the C++ library:
# https://gitlab.kitware.com/vtk/vtk/-/issues/19919. A VTK that is no wheel may be used as well.
if (VTK_DIR MATCHES "vtk_sdk" AND CMAKE_SYSTEM_NAME STREQUAL "Linux" AND CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64")
  add_compile_definitions(_GLIBCXX_USE_CXX11_ABI=0)
endif ()
