# SPDX-License-Identifier: BSD-3-Clause
cmake_minimum_required(VERSION 3.16)
include("${CMAKE_CURRENT_LIST_DIR}/VersionTests.cmake")
find_version_tests("${SOURCE_DIR}" found)
if (found)
  list(JOIN found "\n" text)
  message(FATAL_ERROR
    "code that depends on the version of VTK, outside the files that may:\n${text}")
endif ()
# Each of these files must still depend on the version of VTK.
foreach (name IN LISTS interlume_version_files)
  file(STRINGS "${SOURCE_DIR}/${name}" lines REGEX "VTK_VERSION|__has_include")
  if (NOT lines)
    message(FATAL_ERROR "${name} does not depend on the version of VTK. Remove it from interlume_version_files")
  endif ()
endforeach ()
