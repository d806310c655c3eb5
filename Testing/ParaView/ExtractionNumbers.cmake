# SPDX-License-Identifier: BSD-3-Clause
# In the build of the VTK modules: the numbers and pictures for ParaView to repeat, and the defaults of
# its XML.
find_package(VTK 9.1 REQUIRED
  COMPONENTS CommonCore CommonDataModel ImagingCore IOImage IOLegacy IOXML IOXMLParser
    RenderingCore RenderingOpenGL2 RenderingVolume)
find_package(nlohmann_json REQUIRED)

add_executable(ExtractionNumbers
  Extractions/ExtractionMeasures.cxx Extractions/ExtractionNumbers.cxx
  Extractions/FlowExtraction.cxx Extractions/FlowNumbers.cxx Extractions/PieceWriter.cxx
  Extractions/TimeVaryingExtraction.cxx Extractions/TimeVaryingNumbers.cxx)
target_include_directories(ExtractionNumbers PRIVATE "${PROJECT_SOURCE_DIR}/Testing")
target_link_libraries(ExtractionNumbers PRIVATE
  InterlumeSupport Interlume::InterlumeFlow Interlume::InterlumeIntervals
  Interlume::InterlumeSources VTK::ImagingCore VTK::IOLegacy VTK::IOXML nlohmann_json::nlohmann_json)
set(extractions_folder "${CMAKE_BINARY_DIR}/Testing/Extractions")
file(MAKE_DIRECTORY "${extractions_folder}")
add_test(NAME TestExtractionNumbers COMMAND ExtractionNumbers "${extractions_folder}")

# picture_program(NAME): one that writes pictures, run as the test Test<NAME>
function (picture_program name)
  add_executable(${name} Extractions/${name}.cxx Extractions/FlowExtraction.cxx
    Extractions/PictureStage.cxx Extractions/TimeVaryingExtraction.cxx)
  target_include_directories(${name} PRIVATE "${PROJECT_SOURCE_DIR}/Testing")
  target_link_libraries(${name} PRIVATE
    InterlumeSupport Interlume::InterlumeFlow Interlume::InterlumeIntervals
    Interlume::InterlumeFlowTexture Interlume::InterlumeLight
    Interlume::InterlumeSources Interlume::InterlumeTetrahedra VTK::IOImage VTK::RenderingCore
    VTK::RenderingOpenGL2 VTK::RenderingVolume nlohmann_json::nlohmann_json)
  vtk_module_autoinit(TARGETS ${name}
    MODULES VTK::RenderingCore VTK::RenderingOpenGL2 VTK::RenderingVolume)
  add_test(NAME Test${name} COMMAND ${name} "${extractions_folder}")
  set_tests_properties(Test${name} PROPERTIES
    LABELS image
    FAIL_REGULAR_EXPRESSION "ERROR: ;Warning: ;ERR\\|;WARN\\|")
endfunction ()
picture_program(InflowTexturePictures)
picture_program(RepresentationPictures)
picture_program(ShadowedSlicePictures)

add_executable(TestPluginXMLDefaults TestPluginXMLDefaults.cxx)
target_link_libraries(TestPluginXMLDefaults PRIVATE
  Interlume::InterlumeFlow Interlume::InterlumeFlowTexture Interlume::InterlumeIntervals
  Interlume::InterlumeLight Interlume::InterlumeSources Interlume::InterlumeTetrahedra VTK::IOXMLParser)
if (INTERLUME_ENABLE_TETGEN)
  target_link_libraries(TestPluginXMLDefaults PRIVATE Interlume::InterlumeMeshing)
  target_compile_definitions(TestPluginXMLDefaults PRIVATE INTERLUME_ENABLE_TETGEN)
endif ()
add_test(NAME TestPluginXMLDefaults COMMAND TestPluginXMLDefaults "${PROJECT_SOURCE_DIR}/Plugin")

set_tests_properties(TestExtractionNumbers TestPluginXMLDefaults PROPERTIES
  LABELS "value;quick"
  FAIL_REGULAR_EXPRESSION "ERROR: ;Warning: ")
