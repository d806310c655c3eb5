# SPDX-License-Identifier: BSD-3-Clause
# The ParaView plugin: the same modules, built against ParaView's VTK, and the server-manager XML of
# Plugin/.
find_package(ParaView 5.11 REQUIRED)
paraview_plugin_scan(
  PLUGIN_FILES      "${PROJECT_SOURCE_DIR}/Plugin/paraview.plugin"
  PROVIDES_PLUGINS  plugins
  REQUIRES_MODULES  required_modules
  ENABLE_BY_DEFAULT ON)
foreach (module IN LISTS required_modules)
  if (NOT TARGET "${module}")
    message(FATAL_ERROR "This ParaView does not have the module ${module}.")
  endif ()
endforeach ()
include(InterlumePython)
interlume_find_python()
paraview_plugin_build(
  RUNTIME_DESTINATION  "${CMAKE_INSTALL_BINDIR}"
  LIBRARY_DESTINATION  "${CMAKE_INSTALL_LIBDIR}"
  LIBRARY_SUBDIRECTORY "${PARAVIEW_PLUGIN_SUBDIR}"
  PLUGINS_COMPONENT    plugin
  PLUGINS              ${plugins})

# A Python package for the plugin. ParaView cannot load the package for VTK's Python. Both packages
# may be installed.
if (INTERLUME_PYTHON)
  set(modules ${interlume_modules})
  set(tetgen_modules)
  set(interlume_library_destination "${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/Interlume")
  set(INTERLUME_PYTHON_DESTINATION "${interlume_library_destination}/python")
  set(interlume_python_component plugin)
  add_subdirectory("${PROJECT_SOURCE_DIR}/Python" Python)
endif ()
if (BUILD_TESTING)
  add_subdirectory("${PROJECT_SOURCE_DIR}/Testing/ParaView" Testing/ParaView)
endif ()
