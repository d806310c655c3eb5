# SPDX-License-Identifier: BSD-3-Clause
# Creates a small tree with allowed lines and one violation of each kind, and expects exactly the violations.
cmake_minimum_required(VERSION 3.16)
include("${CMAKE_CURRENT_LIST_DIR}/VersionTests.cmake")
file(REMOVE_RECURSE "${WORK_DIR}")
foreach (name IN LISTS interlume_version_files)
  file(WRITE "${WORK_DIR}/${name}" "#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)\n")
endforeach ()
file(WRITE "${WORK_DIR}/Filters/Flow/vtkField.h" "#include \"GridCells.h\"\n")
file(WRITE "${WORK_DIR}/Filters/Flow/CMakeLists.txt" "find_package(VTK 9.1 REQUIRED)\n")
find_version_tests("${WORK_DIR}" found)
if (found)
  message(FATAL_ERROR "allowed lines were reported: ${found}")
endif ()

set(expected
  "Examples/A.cxx: #if VTK_MAJOR_VERSION > 8"
  "Filters/Flow/vtkB.cxx: #if VTK_VERSION_NUMBER >= 90320240707ULL"
  "Plugin/Representations/vtkC.h: #if VTK_MINOR_VERSION == 1"
  "Rendering/Light/vtkD.cxx: #include \"vtk_glew.h\""
  "Rendering/Light/vtkE.cxx: #include \"vtk_glad.h\""
  "Rendering/Tetrahedra/vtkF.cxx:   return GLEW_VERSION_3_2"
  "Testing/Flow/CMakeLists.txt: if (VTK_VERSION VERSION_LESS 9.2)"
  "Testing/Flow/G.cxx: #if __has_include(\"vtkVectorOperators.h\")"
  "Utilities/Gallery/H.cxx: #include \"vtkVectorOperators.h\""
  "Utilities/cmake/I.cmake: if (VTK_VERSION VERSION_GREATER 9.3)")
foreach (breach IN LISTS expected)
  string(REGEX MATCH "^([^:]*): (.*)$" whole "${breach}")
  file(WRITE "${WORK_DIR}/${CMAKE_MATCH_1}" "${CMAKE_MATCH_2}\n")
endforeach ()
find_version_tests("${WORK_DIR}" found)
list(SORT found)
list(SORT expected)
if (NOT found STREQUAL expected)
  message(FATAL_ERROR "found\n${found}\nexpected\n${expected}")
endif ()
