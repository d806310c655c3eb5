# SPDX-License-Identifier: BSD-3-Clause
cmake_minimum_required(VERSION 3.16)
include("${CMAKE_CURRENT_LIST_DIR}/VersionTests.cmake")
find_version_tests("${SOURCE_DIR}" found)
if (found)
  list(JOIN found "\n" text)
  message(FATAL_ERROR
    "differences between VTK's versions outside the files that are there to know them:\n${text}")
endif ()
# Each of those files is still there, and still knows one.
foreach (name IN LISTS interlume_version_files)
  file(STRINGS "${SOURCE_DIR}/${name}" lines REGEX "VTK_VERSION|__has_include")
  if (NOT lines)
    message(FATAL_ERROR "${name} knows no difference between VTK's versions: take it off the list")
  endif ()
endforeach ()
