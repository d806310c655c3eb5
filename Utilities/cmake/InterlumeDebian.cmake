# SPDX-License-Identifier: BSD-3-Clause
# Debian packages, built by `cpack`, one for each component. The VTK modules have packages for the
# libraries, for development, and for Python. Because of its license, TetGen has separate packages.
# The plugin has packages for the plugin and for the program that runs TetGen. Use the presets
# `packages` and `paraview-packages`; Utilities/packages builds and tests the packages.
set(INTERLUME_PACKAGE_CONTACT "Interlume developers <developers@interlume.invalid>" CACHE STRING
  "Maintainer of the packages: name and e-mail address in angle brackets")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME interlume)
set(CPACK_PACKAGE_VENDOR Interlume)
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_PACKAGE_CONTACT "${INTERLUME_PACKAGE_CONTACT}")
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGING_INSTALL_PREFIX "${CMAKE_INSTALL_PREFIX}")
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")
set(CPACK_POST_BUILD_SCRIPTS "${CMAKE_CURRENT_LIST_DIR}/InterlumeDebianTriggers.cmake")
set(CPACK_COMPONENTS_ALL)

string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
find_program(INTERLUME_GZIP gzip)
set(about "${PROJECT_SOURCE_DIR}/Utilities/debian")

# interlume_debian_package(COMPONENT PACKAGE TITLE TEXT [SECTION NAME] [DEPENDS TEXT] [LIBRARIES])
# LIBRARIES: the package contains libraries for linking, and its name is not derived from the names
# of these libraries.
macro (interlume_debian_package component package title text)
  cmake_parse_arguments(arg "LIBRARIES" "SECTION;DEPENDS" "" ${ARGN})
  string(TOUPPER "${component}" upper)
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME "${package}")
  set(CPACK_COMPONENT_${upper}_DESCRIPTION "${title}\n${text}")
  foreach (field IN ITEMS SECTION DEPENDS)
    if (arg_${field})
      set(CPACK_DEBIAN_${upper}_PACKAGE_${field} "${arg_${field}}")
    endif ()
  endforeach ()
  set(folder "${CMAKE_BINARY_DIR}/debian/${package}")
  configure_file("${about}/changelog.in" "${folder}/changelog.Debian" @ONLY)
  execute_process(COMMAND "${INTERLUME_GZIP}" -9 -n -f "${folder}/changelog.Debian")
  install(FILES "${folder}/changelog.Debian.gz" "${about}/copyright"
    "${PROJECT_SOURCE_DIR}/Documentation/third-party.spdx.json"
    DESTINATION "share/doc/${package}" COMPONENT ${component})
  set(overrides "${package}: initial-upload-closes-no-bugs *\n")
  if (arg_LIBRARIES)
    string(APPEND overrides "${package}: package-name-doesnt-match-sonames *\n")
    file(WRITE "${folder}/triggers" "activate-noawait ldconfig\n")
    set(CPACK_DEBIAN_${upper}_PACKAGE_CONTROL_EXTRA "${folder}/triggers")
  endif ()
  file(WRITE "${folder}/overrides" "${overrides}")
  install(FILES "${folder}/overrides" RENAME "${package}"
    DESTINATION share/lintian/overrides COMPONENT ${component})
endmacro ()

if (INTERLUME_GZIP AND EXISTS /usr/bin/dpkg-deb)
  set(text "Interval volumes of any dataset from isotables, implicit flow fields, and volume\nrendering over time, with shadows, or with inflow textures.")
  set(tetgen_text "${text}\nTetGen's license is the AGPL.")
  set(this "(= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")
  if (INTERLUME_BUILD_PARAVIEW_PLUGIN)
    get_target_property(libraries VTK::CommonCore LOCATION)
    get_filename_component(libraries "${libraries}" DIRECTORY)
    set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${libraries}"
      "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}/${PARAVIEW_PLUGIN_SUBDIR}/Interlume")
    # Plugins work only with the minor version of ParaView for which they are built.
    math(EXPR next "${ParaView_VERSION_MINOR} + 1")
    interlume_debian_package(plugin paraview-interlume
      "filters and volume rendering of Interlume in ParaView" "${text}"
      DEPENDS "paraview (>= ${ParaView_VERSION_MAJOR}.${ParaView_VERSION_MINOR}), paraview (<< ${ParaView_VERSION_MAJOR}.${next}~)")
    set(CPACK_DEBIAN_PLUGIN_PACKAGE_RECOMMENDS python3-paraview)
    if (INTERLUME_ENABLE_TETGEN)
      set(CPACK_DEBIAN_PLUGIN_PACKAGE_SUGGESTS paraview-interlume-tetgen)
      interlume_debian_package(tetgen paraview-interlume-tetgen
        "tetrahedral meshes with TetGen for Interlume in ParaView" "${tetgen_text}"
        DEPENDS "paraview-interlume ${this}")
    endif ()
  else ()
    set(library "libinterlume${interlume_soversion}")
    set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
    interlume_debian_package(runtime ${library}
      "interval volumes and flow fields for VTK" "${text}"
      SECTION libs LIBRARIES)
    interlume_debian_package(development libinterlume-dev
      "interval volumes and flow fields for VTK: headers and CMake package" "${text}"
      SECTION libdevel DEPENDS "${library} ${this}, libvtk9-dev")
    set(python "")
    if (INTERLUME_PYTHON)
      # Modules are compiled for one minor version of Python.
      math(EXPR next "${Python3_VERSION_MINOR} + 1")
      set(python ", python3 (>= 3.${Python3_VERSION_MINOR}~), python3 (<< 3.${next})")
      interlume_debian_package(python python3-interlume
        "interval volumes and flow fields for VTK in Python" "${text}"
        SECTION python DEPENDS "${library} ${this}${python}, python3-vtk9")
    endif ()
    if (INTERLUME_ENABLE_TETGEN)
      interlume_debian_package(tetgen interlume-tetgen
        "tetrahedral meshes with TetGen for VTK" "${tetgen_text}"
        DEPENDS "${library} ${this}${python}" LIBRARIES)
      interlume_debian_package(tetgen_development interlume-tetgen-dev
        "tetrahedral meshes with TetGen for VTK: headers and CMake package" "${tetgen_text}"
        SECTION libdevel DEPENDS "interlume-tetgen ${this}, libinterlume-dev ${this}")
      if (INTERLUME_PYTHON)
        set(CPACK_DEBIAN_TETGEN_PACKAGE_RECOMMENDS "python3-interlume ${this}")
      endif ()
    endif ()
  endif ()
  include(CPack)
endif ()
