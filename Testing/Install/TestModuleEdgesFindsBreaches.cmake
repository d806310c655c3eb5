# Makes a small tree with one breach of each kind beside lines that are allowed, and expects just
# the breaches.
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
file(WRITE "${WORK_DIR}/Rendering/FlowTexture/vtkStripes.h" "#include \"vtkDepth.h\"\n")
file(WRITE "${WORK_DIR}/Plugin/vtkPanel.cxx" "#include \"vtkPVView.h\"\n")
file(WRITE "${WORK_DIR}/Testing/Reference/Answer.h" "#include \"Pictures/Picture.h\"\n")
file(WRITE "${WORK_DIR}/Utilities/Pictures/Picture.h" "#include \"vtkStripes.h\"\n")
find_breaches("${WORK_DIR}" breaches)
if (breaches)
  message(FATAL_ERROR "allowed includes were taken for breaches: ${breaches}")
endif ()

set(expected
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
  "Rendering/FlowTexture/vtkS.cxx: #include \"vtkSweep.h\""
  "Rendering/FlowTexture/vtkT.cxx: #include \"vtkOrder.h\""
  "Rendering/Light/vtkU.cxx: #include \"vtkStripes.h\""
  "Rendering/Light/vtkH.cxx: #include <vtkCut.h>"
  "Rendering/Light/vtkN.cxx: #include \"vtkOrder.h\""
  "Rendering/Scene/vtkO.cxx: #include \"vtkOrder.h\""
  "Rendering/Scene/vtkP.cxx: #include \"vtkSweep.h\""
  "Rendering/Tetrahedra/vtkQ.cxx: #include \"vtkSweep.h\""
  "Testing/Flow/I.cxx: #include \"vtkSMProxy.h\""
  "Utilities/Gallery/V.cxx: #include \"Reference/Answer.h\""
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
