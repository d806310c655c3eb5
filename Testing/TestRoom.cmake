# SPDX-License-Identifier: BSD-3-Clause
# interlume_test_room(ROOM
#   [TESTS FILE...]            tests of values; label value and quick
#   [SLOW FILE...]             tests of values that take ten seconds and more; label value
#   [DRAWN FILE...]            tests that draw and so need a display; label value
#   [QUICK_DRAWN FILE...]      the same, with the label quick as well
#   [SOURCES FILE...]          what tests of this room share
#   [PRIVATE_PARTS MODULE...]  modules, as InterlumeFlow, whose private parts are tested, in a program
#                              that links them statically; tests of public classes are in a program
#                              without this, and so test the libraries that are installed
#   [LIBRARIES TARGET...])
# Makes the program Interlume<ROOM>Tests and a CTest test of each file, named as the file, which has to
# hold a function of that name. The room's folder may have folders; names of files are there once.
# An error or warning that a test expects is caught by an observer; any other message of VTK's logger
# fails the test.
set(interlume_test_components
  CommonSystem FiltersCore FiltersGeneral FiltersSources ImagingCore IOXML RenderingCore
  RenderingOpenGL2 RenderingVolume RenderingVolumeOpenGL2 TestingCore)

# A macro, since find_package's targets have the scope of the folder that asks for them.
macro (interlume_test_room room)
  find_package(VTK 9.1 REQUIRED COMPONENTS ${interlume_test_components})
  interlume_add_test_room(${room} ${ARGN})
endmacro ()

function (interlume_add_test_room room)
  cmake_parse_arguments(PARSE_ARGV 1 arg ""
    "" "TESTS;SLOW;DRAWN;QUICK_DRAWN;SOURCES;PRIVATE_PARTS;LIBRARIES")
  set(program Interlume${room}Tests)
  set(files ${arg_TESTS} ${arg_SLOW} ${arg_DRAWN} ${arg_QUICK_DRAWN})
  set(drawn ${arg_DRAWN} ${arg_QUICK_DRAWN})
  set(names)
  foreach (file IN LISTS files)
    get_filename_component(name "${file}" NAME)
    list(APPEND names ${name})
  endforeach ()
  set(DISABLE_FLOATING_POINT_EXCEPTIONS ON)
  include("${VTK_DIR}/vtkTestingDriver.cmake")
  # The driver alone: it names functions by the files it is given, folders and all.
  create_test_sourcelist(sources ${program}.cxx ${names} EXTRA_INCLUDE vtkTestDriver.h)
  list(GET sources 0 driver)
  add_executable(${program} ${driver} ${files} ${arg_SOURCES})
  # The headers of Filters/Common, which need no library.
  target_include_directories(${program} PRIVATE "${PROJECT_SOURCE_DIR}/Filters")
  if (arg_PRIVATE_PARTS)
    list(TRANSFORM arg_PRIVATE_PARTS APPEND Private)
    list(APPEND arg_PRIVATE_PARTS InterlumeInternalSupport)
  endif ()
  target_link_libraries(${program} PRIVATE
    ${arg_LIBRARIES} ${arg_PRIVATE_PARTS} InterlumeTestSupport VTK::CommonSystem
    VTK::FiltersCore VTK::FiltersGeneral VTK::FiltersSources VTK::ImagingCore VTK::IOXML VTK::TestingCore)
  if (drawn)
    # OpenGL: one of the loaders, see OpenGLFunctions.h.
    target_link_libraries(${program} PRIVATE
      InterlumePictureSupport Interlume::InterlumeScene VTK::RenderingCore
      VTK::RenderingOpenGL2 VTK::RenderingVolume VTK::RenderingVolumeOpenGL2
      "$<$<TARGET_EXISTS:VTK::glad>:VTK::glad>"
      "$<$<TARGET_EXISTS:VTK::glew>:VTK::glew;VTK::opengl>")
    vtk_module_autoinit(TARGETS ${program}
      MODULES VTK::RenderingCore VTK::RenderingOpenGL2 VTK::RenderingVolumeOpenGL2)
  endif ()

  set(seconds 300)
  if (INTERLUME_SANITIZE)
    set(seconds 1800)
  endif ()
  # Which interlume_stability_tests of this folder need.
  set(interlume_room_program ${program} PARENT_SCOPE)
  foreach (file IN LISTS files)
    get_filename_component(test "${file}" NAME_WE)
    add_test(NAME ${test} COMMAND ${program} ${test})
    set(labels value)
    if (NOT file IN_LIST arg_DRAWN AND NOT file IN_LIST arg_SLOW)
      list(APPEND labels quick)
    endif ()
    set_tests_properties(${test} PROPERTIES
      LABELS "${labels}"
      FAIL_REGULAR_EXPRESSION " ERR\\|; WARN\\|;FATL\\|"
      TIMEOUT ${seconds})
    # What OpenGL's driver keeps cannot be told from a leak, since it is unloaded before leaks are
    # looked for.
    if (INTERLUME_SANITIZE AND file IN_LIST drawn)
      set_property(TEST ${test} APPEND PROPERTY
        ENVIRONMENT "ASAN_OPTIONS=detect_leaks=0:detect_odr_violation=0")
    endif ()
  endforeach ()
endfunction ()

# interlume_stability_tests(TEST...): these, of the room before, report their cases for the catalogue
# of stability, whose list of tests is what StabilityCatalogue::Gather reads.
function (interlume_stability_tests)
  set_tests_properties(${ARGN} PROPERTIES LABELS "value;stability" FIXTURES_SETUP stability_cases)
  set_property(TEST ${ARGN} APPEND PROPERTY
    ENVIRONMENT "INTERLUME_STABILITY_DIR=${CMAKE_BINARY_DIR}/Testing/Stability")
  foreach (test IN LISTS ARGN)
    set_property(GLOBAL APPEND_STRING PROPERTY INTERLUME_STABILITY_TESTS
      "${test}\t$<TARGET_FILE:${interlume_room_program}>\n")
  endforeach ()
endfunction ()

# Writes that list, when all tests are known.
function (interlume_write_stability_tests)
  get_property(tests GLOBAL PROPERTY INTERLUME_STABILITY_TESTS)
  file(GENERATE OUTPUT "${CMAKE_BINARY_DIR}/Testing/Stability/tests.txt" CONTENT "${tests}")
endfunction ()
