# SPDX-License-Identifier: BSD-3-Clause
# Used in the build of the plugin: runs scripts with pvbatch, serially and with four MPI ranks.
set(INTERLUME_EXTRACTION_DATA_DIR "" CACHE PATH
  "Directory with the results of TestExtractionNumbers and the image tests from a build of the VTK modules")
if (NOT INTERLUME_EXTRACTION_DATA_DIR)
  message(FATAL_ERROR
    "The plugin's tests need INTERLUME_EXTRACTION_DATA_DIR, a directory with test results from a build of the VTK "
    "modules. Set it, or set BUILD_TESTING to OFF. Utilities/test does both builds.")
endif ()
find_program(PVBATCH pvbatch HINTS "${ParaView_PREFIX_PATH}/bin" REQUIRED)
find_program(PVPYTHON pvpython HINTS "${ParaView_PREFIX_PATH}/bin" REQUIRED)
find_program(PVSERVER pvserver HINTS "${ParaView_PREFIX_PATH}/bin" REQUIRED)
find_program(PARAVIEW_CLIENT paraview HINTS "${ParaView_PREFIX_PATH}/bin" REQUIRED)
find_program(XVFB Xvfb REQUIRED)
find_program(OPENBOX openbox REQUIRED)
find_package(MPI REQUIRED COMPONENTS C)
find_path(INTERLUME_PARAVIEW_PYTHON paraview/servermanager.py REQUIRED
  HINTS
    "${ParaView_PREFIX_PATH}/lib/python3/dist-packages"
    "${ParaView_PREFIX_PATH}/lib/python${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}/site-packages")
get_filename_component(paraview_libraries "${ParaView_DIR}/../.." ABSOLUTE)

include("${CMAKE_CURRENT_LIST_DIR}/../MPIEnvironment.cmake")
set(plugin_environment
  "INTERLUME_PLUGIN=$<TARGET_FILE:Interlume>"
  "INTERLUME_EXTRACTION_DATA_DIR=${INTERLUME_EXTRACTION_DATA_DIR}"
  "INTERLUME_CLIENT=${PARAVIEW_CLIENT}"
  "INTERLUME_DATA=${PROJECT_SOURCE_DIR}/Data"
  "PYTHONPATH=${INTERLUME_PARAVIEW_PYTHON}:${CMAKE_CURRENT_SOURCE_DIR}"
  "PYTHONDONTWRITEBYTECODE=1"
  "LD_LIBRARY_PATH=${paraview_libraries}"
  ${interlume_mpi_environment})
set(server_file "${CMAKE_CURRENT_BINARY_DIR}/server.npz")

# ParaView 6.1 warns of active textures after rendering two views, even without the plugin. The
# pattern ignores the two messages: "There are still active textures", "Leaked for texture object".
set(plugin_failures "ERR\\|;WARN\\| +[^TL ];ERROR: ;Warning: ;Traceback")

# plugin_test(NAME LABELS COMMAND...)
function (plugin_test name labels)
  add_test(NAME ${name} COMMAND ${ARGN})
  set_tests_properties(${name} PROPERTIES
    LABELS "${labels}"
    TIMEOUT 300
    ENVIRONMENT "${plugin_environment}"
    FAIL_REGULAR_EXPRESSION "${plugin_failures}")
endfunction ()

set(script "${CMAKE_CURRENT_SOURCE_DIR}")
set(batch "${PVBATCH}" --force-offscreen-rendering)
set(ranks "${MPIEXEC_EXECUTABLE}" ${MPIEXEC_NUMPROC_FLAG} 4)

# plugin_pieces_test(ONE PIECES KIND): compares the results of the script PIECES in one and in four processes.
function (plugin_pieces_test one pieces kind)
  set(file "${CMAKE_CURRENT_BINARY_DIR}/${pieces}.npz")
  plugin_test(${one} "paraview;${kind}" ${batch} "${script}/${pieces}.py" write "${file}")
  plugin_test(${pieces} "paraview;mpi;${kind}"
    ${ranks} ${batch} "${script}/${pieces}.py" compare "${file}")
  set_tests_properties(${one} PROPERTIES FIXTURES_SETUP ${pieces})
  set_tests_properties(${pieces} PROPERTIES FIXTURES_REQUIRED ${pieces} RUN_SERIAL ON)
endfunction ()

plugin_test(TestPluginData "paraview;value" ${batch} "${script}/TestPluginData.py")
plugin_test(TestPluginNumbers "paraview;value" ${batch} "${script}/TestPluginNumbers.py")
plugin_test(TestPluginProperties "paraview;value" ${batch} "${script}/TestPluginProperties.py")
plugin_test(TestPluginIntervals "paraview;value" ${batch} "${script}/TestPluginIntervals.py")
plugin_test(TestPluginIntervalsInTime "paraview;value"
  ${batch} "${script}/TestPluginIntervalsInTime.py" "${PROJECT_SOURCE_DIR}/Data/mug.ex2")
plugin_test(TestPluginTimeSteps "paraview;value"
  ${batch} "${script}/TestPluginTimeSteps.py" "${CMAKE_CURRENT_BINARY_DIR}/TimeSteps.pvsm")
plugin_test(TestPluginTimeSlabs "paraview;value"
  ${batch} "${script}/TestPluginTimeSlabs.py" "${CMAKE_CURRENT_BINARY_DIR}/TimeSlabs")
plugin_test(TestPluginIntervalsRandom "paraview;value"
  ${batch} "${script}/TestPluginIntervalsRandom.py")
plugin_test(TestPluginSources "paraview;value" ${batch} "${script}/TestPluginSources.py")
plugin_test(TestPluginMesher "paraview;value" ${batch} "${script}/TestPluginMesher.py")
plugin_test(TestPluginCellArrays "paraview;value"
  ${batch} "${script}/TestPluginCellArrays.py")
plugin_test(TestPluginComposite "paraview;value" ${batch} "${script}/TestPluginComposite.py")
plugin_test(TestPluginTimeVarying "paraview;value" ${batch} "${script}/TestPluginTimeVarying.py")
plugin_test(TestPluginFlow "paraview;value" ${batch} "${script}/TestPluginFlow.py")
plugin_test(TestPluginFlowDefaults "paraview;value" ${batch} "${script}/TestPluginFlowDefaults.py")
plugin_test(TestPluginChoices "paraview;value" ${batch} "${script}/TestPluginChoices.py")
plugin_test(TestPluginFlowProperties "paraview;value"
  ${batch} "${script}/TestPluginFlowProperties.py")
plugin_pieces_test(TestPluginOnePiece TestPluginPieces value)
plugin_pieces_test(TestPluginFlowOnePiece TestPluginFlowPieces value)
plugin_test(TestPluginImage "paraview;image"
  ${batch} "${script}/TestPluginImage.py" "${CMAKE_CURRENT_BINARY_DIR}/TestPluginImage.png")
plugin_test(TestPluginBlankView "paraview;image"
  ${batch} "${script}/TestPluginBlankView.py" "${CMAKE_CURRENT_BINARY_DIR}")
plugin_test(TestPluginBoundary "paraview;image"
  ${batch} "${script}/TestPluginBoundary.py" "${CMAKE_CURRENT_BINARY_DIR}")
plugin_test(TestPluginStreamSurface "paraview;image"
  ${batch} "${script}/TestPluginStreamSurface.py" "${CMAKE_CURRENT_BINARY_DIR}")
plugin_test(TestPluginBlocks "paraview;image" ${batch} "${script}/TestPluginBlocks.py")
plugin_test(TestPluginIntervalColors "paraview;image"
  ${batch} "${script}/TestPluginIntervalColors.py")
plugin_test(TestPluginPanel "paraview;image" ${batch} "${script}/TestPluginPanel.py")
plugin_test(TestPluginDisplayChanges "paraview;image"
  ${batch} "${script}/TestPluginDisplayChanges.py")
plugin_test(TestPluginRepresentation "paraview;image"
  ${batch} "${script}/TestPluginRepresentation.py" "${CMAKE_CURRENT_BINARY_DIR}" whole)
plugin_test(TestPluginShadowedSlices "paraview;image"
  ${batch} "${script}/TestPluginShadowedSlices.py" "${CMAKE_CURRENT_BINARY_DIR}" whole)
plugin_test(TestPluginInflowTextures "paraview;image"
  ${batch} "${script}/TestPluginInflowTextures.py" "${CMAKE_CURRENT_BINARY_DIR}")
plugin_test(TestPluginAreaLight "paraview;image"
  ${batch} "${script}/TestPluginAreaLight.py" "${CMAKE_CURRENT_BINARY_DIR}")
plugin_test(TestPluginSceneShadows "paraview;image"
  ${batch} "${script}/TestPluginSceneShadows.py" "${CMAKE_CURRENT_BINARY_DIR}")
plugin_test(TestPluginShadowedSlicesPieces "paraview;mpi;image"
  ${ranks} ${batch} "${script}/TestPluginShadowedSlices.py" "${CMAKE_CURRENT_BINARY_DIR}" distributed)
set_tests_properties(TestPluginShadowedSlicesPieces PROPERTIES RUN_SERIAL ON)
plugin_pieces_test(TestPluginOneOpacity TestPluginOpacity image)
plugin_pieces_test(TestPluginOnePieceShadows TestPluginPieceShadows image)
plugin_pieces_test(TestPluginOnePieceBlends TestPluginPieceBlends image)
plugin_test(TestPluginRepresentationPieces "paraview;mpi;image"
  ${ranks} ${batch} "${script}/TestPluginRepresentation.py" "${CMAKE_CURRENT_BINARY_DIR}" distributed)
set_tests_properties(TestPluginRepresentationPieces PROPERTIES RUN_SERIAL ON)

set(client "${PVPYTHON}" --force-offscreen-rendering)
# Selection requires a client.
plugin_test(TestPluginSelection "paraview;value" ${client} "${script}/TestPluginSelection.py")
plugin_test(TestPluginNoServer "paraview;image"
  ${batch} "${script}/TestPluginServer.py" write "${server_file}")
plugin_test(TestPluginServer "paraview;image"
  ${client} "${script}/TestPluginServer.py" compare "${server_file}" "${PVSERVER}")
set_tests_properties(TestPluginNoServer PROPERTIES FIXTURES_SETUP no_server)
plugin_test(TestPluginServerRanks "paraview;mpi;image"
  ${client} "${script}/TestPluginServer.py" ranks "${server_file}" ${ranks} "${PVSERVER}")
set_tests_properties(TestPluginServer TestPluginServerRanks PROPERTIES
  FIXTURES_REQUIRED no_server)
set_tests_properties(TestPluginServerRanks PROPERTIES RUN_SERIAL ON)
foreach (side IN ITEMS client server)
  plugin_test(TestPluginServerAlone-${side} "paraview;value"
    ${client} "${script}/TestPluginServer.py" alone ${side} "${PVSERVER}")
endforeach ()

# The driver must not be a program of ParaView, whose MPI would prevent mpiexec from starting.
plugin_test(TestPluginKilledRank "paraview;mpi;value" "${Python3_EXECUTABLE}"
  "${script}/TestPluginKilled.py" rank "${MPIEXEC_EXECUTABLE}" ${MPIEXEC_NUMPROC_FLAG} "${PVBATCH}")
plugin_test(TestPluginKilledClient "paraview;value" "${Python3_EXECUTABLE}"
  "${script}/TestPluginKilled.py" client "${PVSERVER}" "${PVPYTHON}")
set_tests_properties(TestPluginKilledRank PROPERTIES RUN_SERIAL ON)
# The test itself checks the server's messages about the client's exit.
set_tests_properties(TestPluginKilledClient PROPERTIES FAIL_REGULAR_EXPRESSION "Traceback")

if (TARGET Interlume_qch)
  file(GLOB server_manager_xml "${PROJECT_SOURCE_DIR}/Plugin/*.xml")
  plugin_test(TestPluginHelp "paraview;value" "${Python3_EXECUTABLE}" "${script}/TestPluginHelp.py"
    "${PROJECT_BINARY_DIR}/Plugin/paraview_help/Interlume.qch" $<TARGET_FILE:Interlume>
    ${server_manager_xml})
endif ()

if (INTERLUME_PYTHON)
  plugin_test(TestPluginPython "paraview;value" ${batch} "${script}/TestPluginPython.py")
endif ()

# plugin_example(NAME DATA)
function (plugin_example name data)
  plugin_test(ParaViewExample_${name} "paraview;image" ${batch} "${script}/TestPluginExample.py"
    "${PROJECT_SOURCE_DIR}/Examples/ParaView/${name}.py" ${data}
    "${CMAKE_CURRENT_BINARY_DIR}/${name}.png")
  set_tests_properties(ParaViewExample_${name} PROPERTIES FIXTURES_SETUP examples)
endfunction ()
plugin_example(intervals_of_a_tooth tooth.vti)
plugin_example(mug_over_time mug.ex2)
plugin_example(shadows_of_a_bonsai bonsai.vti)
plugin_example(stream_volume_around_a_disk disk_out_ref.vtu)
# plugin_animation(NAME [DATA])
function (plugin_animation name)
  plugin_test(ParaViewAnimation_${name} "paraview;image" ${batch} "${script}/TestPluginAnimation.py"
    "${PROJECT_SOURCE_DIR}/Examples/ParaView/Animations/${name}.py" ${ARGN}
    "${CMAKE_CURRENT_BINARY_DIR}/animation-${name}")
endfunction ()
plugin_animation(intervals_of_a_tooth tooth.vti)
plugin_animation(mug_over_time mug.ex2)
plugin_animation(dye_around_a_sphere)
plugin_animation(time_surfaces_around_a_sphere)
plugin_animation(timelines_around_a_sphere)
plugin_test(TestPluginStates "paraview;image" ${batch} "${script}/TestPluginStates.py"
  "${PROJECT_SOURCE_DIR}/Examples/ParaView/States" "${CMAKE_CURRENT_BINARY_DIR}")
set_tests_properties(TestPluginStates PROPERTIES FIXTURES_REQUIRED examples)

# Tests of the client as a new user operates it, one per session of newcomer_uses.py. To write new baselines,
# run ctest -R TestNewcomer with INTERLUME_WRITE_BASELINES in the environment.
foreach (session IN ITEMS Open Scans Images Intervals Time Contours Flow Meshing)
  plugin_test(TestNewcomer${session} "paraview;image" "${Python3_EXECUTABLE}"
    "${script}/TestNewcomer.py" ${session} "${CMAKE_CURRENT_BINARY_DIR}/newcomer")
  set_tests_properties(TestNewcomer${session} PROPERTIES TIMEOUT 600)
endforeach ()
plugin_test(TestPluginClient "paraview;image" "${Python3_EXECUTABLE}"
  "${script}/TestPluginClient.py" "${CMAKE_CURRENT_BINARY_DIR}/client")
set_tests_properties(TestPluginClient TestPluginFlowDefaults TestPluginPanel PROPERTIES TIMEOUT 600)
add_custom_target(guide-pictures
  COMMAND "${CMAKE_COMMAND}" -E env ${plugin_environment} "${Python3_EXECUTABLE}"
          "${script}/newcomer_guide.py" "${PROJECT_SOURCE_DIR}/Documentation/pictures/guide"
  DEPENDS Interlume
  COMMENT "Rendering the images of the guide in the client"
  VERBATIM)
add_custom_target(paraview-states
  COMMAND "${CMAKE_COMMAND}" -E env ${plugin_environment} "${Python3_EXECUTABLE}"
          "${script}/paraview_states.py" "${PROJECT_SOURCE_DIR}/Examples/ParaView/States"
          "${PROJECT_SOURCE_DIR}/Documentation/pictures"
  DEPENDS Interlume
  COMMENT "Writing ParaView's state files and screenshots"
  VERBATIM)
