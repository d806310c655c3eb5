# SPDX-License-Identifier: BSD-3-Clause
# Python's side of the modules: finds what VTK wraps classes with, and wraps ours with it. To be included
# where VTK, or ParaView, has been found.
#   INTERLUME_PYTHON             whether the modules are wrapped; where not, a status line has said why
#   INTERLUME_PYTHON_DESTINATION where the package goes, relative to the prefix, unless it is given
#   interlume_python_libraries   the folder of VTK's libraries

# interlume_find_python(): looks for VTK's tools and for the Python that VTK's own modules are made for.
# A macro, since find_package's targets have the scope of the folder that asks for them.
macro (interlume_find_python)
  set(INTERLUME_PYTHON OFF)
  if (NOT INTERLUME_WRAP_PYTHON)
    set(interlume_python_obstacle "INTERLUME_WRAP_PYTHON is OFF")
  elseif (INTERLUME_SANITIZE)
    set(interlume_python_obstacle "Python cannot load a library with sanitizers")
  elseif (NOT BUILD_SHARED_LIBS)
    set(interlume_python_obstacle "modules of Python need shared libraries")
  elseif (NOT VTK_WRAP_PYTHON)
    set(interlume_python_obstacle "this VTK is not wrapped")
  else ()
    # The interpreter beside VTK, which may not be the first one on the path.
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
    interlume_find_python_obstacle(interlume_python_obstacle)
  endif ()
  if (interlume_python_obstacle)
    message(STATUS "Without Python: ${interlume_python_obstacle}")
  else ()
    set(INTERLUME_PYTHON ON)
    if (NOT DEFINED INTERLUME_PYTHON_DESTINATION)
      interlume_python_destination(INTERLUME_PYTHON_DESTINATION)
    endif ()
    message(STATUS "With Python ${Python3_VERSION}: ${Python3_EXECUTABLE}")
  endif ()
endmacro ()

# Sets VARIABLE to what is missing; empty where nothing is.
function (interlume_find_python_obstacle variable)
  set(obstacle "")
  if (NOT Python3_FOUND)
    set(obstacle "Python's interpreter or its headers are missing (on Debian: python3-dev)")
  elseif (NOT TARGET VTK::WrapPython OR NOT TARGET VTK::WrapHierarchy
          OR NOT TARGET VTK::WrappingPythonCore OR NOT TARGET VTK::Python)
    set(obstacle "VTK's wrapping tools are missing (on Debian: python3-vtk9)")
  else ()
    interlume_python_path(path)
    execute_process(
      COMMAND "${CMAKE_COMMAND}" -E env "PYTHONPATH=${path}" "LD_LIBRARY_PATH=${interlume_python_libraries}"
        "${Python3_EXECUTABLE}" -c
        "from vtkmodules.vtkCommonCore import vtkVersion; print(vtkVersion.GetVTKVersion(), end='')"
      OUTPUT_VARIABLE version
      ERROR_QUIET)
    if (NOT version MATCHES "^${VTK_MAJOR_VERSION}\\.${VTK_MINOR_VERSION}\\.")
      set(obstacle
        "${Python3_EXECUTABLE} has no vtkmodules of VTK ${VTK_VERSION}; Python3_EXECUTABLE may name another")
    endif ()
  endif ()
  set(${variable} "${obstacle}" PARENT_SCOPE)
endfunction ()

# Sets VARIABLE to the PYTHONPATH where vtkmodules and what FOLDERS have are found.
function (interlume_python_path variable)
  set(folders ${ARGN} "${VTK_PREFIX_PATH}/${VTK_PYTHONPATH}")
  if (NOT "$ENV{PYTHONPATH}" STREQUAL "")
    list(APPEND folders "$ENV{PYTHONPATH}")
  endif ()
  string(REPLACE ";" ":" path "${folders}")
  set(${variable} "${path}" PARENT_SCOPE)
endfunction ()

# Sets VARIABLE to where Python looks for packages below the prefix, relative to that: the interpreter
# is asked, since Debian's has folders of its own, and another prefix has the usual one.
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
