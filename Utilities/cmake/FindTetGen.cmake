# SPDX-License-Identifier: BSD-3-Clause
# Finds TetGen, built as a library: the header tetgen.h and the library tet.
#   TetGen_FOUND
#   TetGen_VERSION   the version in the first lines of the header
#   TetGen::TetGen   the target to link to
# On Debian it is the package libtet1.5-dev, or libtet-dev in later releases.
find_path(TetGen_INCLUDE_DIR tetgen.h PATH_SUFFIXES tetgen tetgen1.5)
find_library(TetGen_LIBRARY NAMES tet tetgen)
mark_as_advanced(TetGen_INCLUDE_DIR TetGen_LIBRARY)
if (TetGen_INCLUDE_DIR)
  file(STRINGS "${TetGen_INCLUDE_DIR}/tetgen.h" TetGen_VERSION REGEX "^// Version [0-9.]+" LIMIT_COUNT 1)
  string(REGEX REPLACE "^// Version ([0-9.]+).*" "\\1" TetGen_VERSION "${TetGen_VERSION}")
endif ()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(TetGen
  REQUIRED_VARS TetGen_LIBRARY TetGen_INCLUDE_DIR
  VERSION_VAR TetGen_VERSION
  REASON_FAILURE_MESSAGE
    "TetGen's header tetgen.h or its library tet is missing (on Debian: libtet1.5-dev or libtet-dev). Install it, or set INTERLUME_ENABLE_TETGEN to OFF")

if (TetGen_FOUND AND NOT TARGET TetGen::TetGen)
  add_library(TetGen::TetGen UNKNOWN IMPORTED)
  set_target_properties(TetGen::TetGen PROPERTIES
    IMPORTED_LOCATION "${TetGen_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${TetGen_INCLUDE_DIR}"
    INTERFACE_COMPILE_DEFINITIONS TETLIBRARY)
endif ()
