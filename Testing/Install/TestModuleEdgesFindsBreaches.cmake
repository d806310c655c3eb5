# SPDX-License-Identifier: BSD-3-Clause
# Creates a small tree with allowed includes and one violation of each kind, and expects exactly the
# violations.
cmake_minimum_required(VERSION 3.16)
include("${CMAKE_CURRENT_LIST_DIR}/ModuleEdges.cmake")
file(REMOVE_RECURSE "${WORK_DIR}")
file(WRITE "${WORK_DIR}/Filters/Isotables/vtkTable.h" "#include \"vtkSMPTools.h\"\n")
file(WRITE "${WORK_DIR}/Filters/Intervals/vtkCut.h"
  "#include \"vtkTable.h\"\n#include \"vtkUnstructuredGridAlgorithm.h\"\n")
file(WRITE "${WORK_DIR}/Filters/Flow/vtkStreamVolume.h" "#include \"vtkCut.h\"\n")
file(WRITE "${WORK_DIR}/Filters/Meshing/vtkMesh.h" "#include \"vtkPolyData.h\"\n")
file(WRITE "${WORK_DIR}/Filters/Sources/vtkField.h" "#include \"vtkImageAlgorithm.h\"\n")
file(WRITE "${WORK_DIR}/Rendering/Scene/vtkDepth.h" "#include \"vtkRenderer.h\"\n")
file(WRITE "${WORK_DIR}/Rendering/Light/vtkSweep.h" "#include \"vtkDepth.h\"\n")
file(WRITE "${WORK_DIR}/Rendering/Tetrahedra/vtkOrder.h" "#include \"vtkDepth.h\"\n")
file(WRITE "${WORK_DIR}/Rendering/Light/Plan/Slabs.h" "#include \"vtkSweep.h\"\n")
file(WRITE "${WORK_DIR}/Rendering/FlowTexture/vtkStripes.h"
  "#include \"vtkDepth.h\"\n#include \"vtkSweep.h\"\n")
file(WRITE "${WORK_DIR}/Filters/Common/Vectors.h" "#include <cmath>\n")
file(WRITE "${WORK_DIR}/Rendering/Light/vtkUse.cxx" "#include \"Common/Vectors.h\"\n")
file(WRITE "${WORK_DIR}/Plugin/vtkPanel.cxx" "#include \"vtkPVView.h\"\n")
file(WRITE "${WORK_DIR}/Testing/Support/Meshes/Mesh.h" "#include \"Support/Images/Image.h\"\n")
file(WRITE "${WORK_DIR}/Testing/Support/Images/Image.h" "#include \"vtkStripes.h\"\n")
file(WRITE "${WORK_DIR}/Testing/Light/Stage.h" "#include \"Support/Meshes/Mesh.h\"\n#include \"Gallery/Look.h\"\n")
file(WRITE "${WORK_DIR}/Utilities/Gallery/Look.h" "#include \"Support/Images/Image.h\"\n")
find_breaches("${WORK_DIR}" breaches)
if (breaches)
  message(FATAL_ERROR "allowed includes were reported: ${breaches}")
endif ()

set(expected
  "Filters/Common/V.h: #include \"vtkCut.h\""
  "Filters/Isotables/vtkA.cxx: #include \"vtkPolyDataAlgorithm.h\""
  "Filters/Isotables/vtkB.cxx: #include \"vtkInformation.h\""
  "Filters/Isotables/vtkC.cxx: #include \"vtkUnstructuredGrid.h\""
  "Filters/Isotables/vtkD.cxx: #include \"vtkCut.h\""
  "Filters/Isotables/vtkE.cxx: #include \"vtkStreamVolume.h\""
  "Filters/Intervals/vtkF.cxx: #include \"vtkStreamVolume.h\""
  "Filters/Intervals/vtkK.cxx: #include \"vtkMesh.h\""
  "Filters/Intervals/vtkM.cxx: #include \"vtkField.h\""
  "Filters/Meshing/vtkL.cxx: #include \"vtkCut.h\""
  "Filters/Sources/vtkG.cxx: #include \"vtkTable.h\""
  "Rendering/FlowTexture/vtkS.cxx: #include \"Plan/Slabs.h\""
  "Rendering/FlowTexture/vtkT.cxx: #include \"vtkOrder.h\""
  "Rendering/Light/vtkU.cxx: #include \"vtkStripes.h\""
  "Rendering/Light/vtkH.cxx: #include <vtkCut.h>"
  "Rendering/Light/vtkN.cxx: #include \"vtkOrder.h\""
  "Rendering/Scene/vtkO.cxx: #include \"vtkOrder.h\""
  "Rendering/Scene/vtkP.cxx: #include \"vtkSweep.h\""
  "Rendering/Tetrahedra/vtkQ.cxx: #include \"vtkSweep.h\""
  "Testing/Flow/I.cxx: #include \"vtkSMProxy.h\""
  "Testing/Support/Meshes/W.cxx: #include \"Light/Stage.h\""
  "Testing/Support/Images/X.cxx: #include \"Support/Meshes/Mesh.h\""
  "Testing/Support/Images/Y.cxx: #include \"Gallery/Look.h\""
  "Utilities/Gallery/V.cxx: #include \"Support/Meshes/Mesh.h\""
  "Utilities/Gallery/Z.cxx: #include \"Light/Stage.h\""
  "Filters/Flow/vtkR.cxx: #include \"Support/Images/Image.h\""
  "Plugin/vtkW.cxx: #include \"Gallery/Look.h\""
  "Examples/J.cxx: #  include \"pqCoreInit.h\"")
foreach (breach IN LISTS expected)
  string(REGEX MATCH "^([^:]*): (.*)$" whole "${breach}")
  file(WRITE "${WORK_DIR}/${CMAKE_MATCH_1}" "${CMAKE_MATCH_2}\n")
endforeach ()
find_breaches("${WORK_DIR}" breaches)
list(SORT breaches)
list(SORT expected)
if (NOT breaches STREQUAL expected)
  message(FATAL_ERROR "found\n${breaches}\nexpected\n${expected}")
endif ()
