# SPDX-License-Identifier: BSD-3-Clause
# Finds VTK's wrapping tools and wraps the modules for Python. Include it after VTK or ParaView has
# been found.
#   INTERLUME_PYTHON             true if the modules are wrapped; otherwise a status message states the reason
#   INTERLUME_PYTHON_DESTINATION install directory of the package relative to the prefix; may be set before
#   interlume_python_libraries   directory of VTK's libraries

# interlume_find_python(): finds VTK's wrapping tools, and the Python version for which VTK's
# modules are built. This is a macro, since imported targets are visible only in the directory that
# calls find_package.
macro (interlume_find_python)
  set(INTERLUME_PYTHON OFF)
  if (NOT INTERLUME_WRAP_PYTHON)
    set(interlume_python_error "INTERLUME_WRAP_PYTHON is OFF")
  elseif (INTERLUME_SANITIZE)
    set(interlume_python_error "Python cannot load libraries with sanitizers")
  elseif (NOT BUILD_SHARED_LIBS)
    set(interlume_python_error "Python modules require BUILD_SHARED_LIBS")
  elseif (NOT VTK_WRAP_PYTHON)
    set(interlume_python_error "this VTK was built without Python wrapping")
  else ()
    # Prefer the interpreter in VTK's prefix, which may not be the first interpreter in PATH.
    if (NOT DEFINED Python3_ROOT_DIR AND NOT DEFINED Python3_EXECUTABLE)
      set(Python3_ROOT_DIR "${VTK_PREFIX_PATH}")
    endif ()
    set(Python3_FIND_STRATEGY LOCATION)
    find_package(Python3 QUIET COMPONENTS Interpreter Development.Module)
    if (NOT INTERLUME_BUILD_PARAVIEW_PLUGIN)
      find_package(VTK ${interlume_vtk_version} QUIET
        OPTIONAL_COMPONENTS Python WrappingPythonCore)
    endif ()
    get_target_property(interlume_python_libraries VTK::CommonCore LOCATION)
    get_filename_component(interlume_python_libraries "${interlume_python_libraries}" DIRECTORY)
    interlume_check_python(interlume_python_error)
  endif ()
  if (interlume_python_error)
    message(STATUS "Without Python: ${interlume_python_error}")
  else ()
    set(INTERLUME_PYTHON ON)
    if (NOT DEFINED INTERLUME_PYTHON_DESTINATION)
      interlume_python_destination(INTERLUME_PYTHON_DESTINATION)
    endif ()
    message(STATUS "With Python ${Python3_VERSION}: ${Python3_EXECUTABLE}")
  endif ()
endmacro ()

# Sets VARIABLE to an error message, or to an empty string if nothing is missing.
function (interlume_check_python variable)
  set(error "")
  if (NOT Python3_FOUND)
    set(error "the Python interpreter or its headers are missing (on Debian: python3-dev)")
  elseif (NOT TARGET VTK::WrapPython OR NOT TARGET VTK::WrapHierarchy
          OR NOT TARGET VTK::WrappingPythonCore OR NOT TARGET VTK::Python)
    set(error "VTK's wrapping tools are missing (on Debian: python3-vtk9)")
  else ()
    interlume_python_path(path)
    execute_process(
      COMMAND "${CMAKE_COMMAND}" -E env "PYTHONPATH=${path}" "LD_LIBRARY_PATH=${interlume_python_libraries}"
        "${Python3_EXECUTABLE}" -c
        "from vtkmodules.vtkCommonCore import vtkVersion; print(vtkVersion.GetVTKVersion(), end='')"
      OUTPUT_VARIABLE version
      ERROR_QUIET)
    if (NOT version MATCHES "^${VTK_MAJOR_VERSION}\\.${VTK_MINOR_VERSION}\\.")
      set(error
        "${Python3_EXECUTABLE} has no vtkmodules of VTK ${VTK_VERSION}; set Python3_EXECUTABLE to another interpreter")
    endif ()
  endif ()
  set(${variable} "${error}" PARENT_SCOPE)
endfunction ()

# Sets VARIABLE to the PYTHONPATH for vtkmodules and the given directories.
function (interlume_python_path variable)
  set(folders ${ARGN} "${VTK_PREFIX_PATH}/${VTK_PYTHONPATH}")
  if (NOT "$ENV{PYTHONPATH}" STREQUAL "")
    list(APPEND folders "$ENV{PYTHONPATH}")
  endif ()
  string(REPLACE ";" ":" path "${folders}")
  set(${variable} "${path}" PARENT_SCOPE)
endfunction ()

# Sets VARIABLE to the directory below the prefix where Python looks for packages, relative to the
# prefix. Queries the interpreter, since Debian's interpreter uses other directories than upstream.
# If no directory is below the prefix, uses lib/pythonX.Y/site-packages.
function (interlume_python_destination variable)
  execute_process(
    COMMAND "${Python3_EXECUTABLE}" -c [[
import os, site, sys
prefix = os.path.join(sys.argv[1], "")
folders = [f[len(prefix):] for f in site.getsitepackages() if f.startswith(prefix)]
usual = "lib/python%d.%d/site-packages" % sys.version_info[:2]
print(next((f for f in folders if f.startswith("lib")), usual), end="")
]] "${CMAKE_INSTALL_PREFIX}"
    OUTPUT_VARIABLE destination)
  set(${variable} "${destination}" PARENT_SCOPE)
endfunction ()
