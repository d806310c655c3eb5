# SPDX-License-Identifier: BSD-3-Clause
# interlume_add_test_executable(NAME
#   [TESTS FILE...]            value tests; labels value and quick
#   [SLOW FILE...]             value tests that take ten seconds or more; label value
#   [DRAWN FILE...]            tests that render and need a display; label value
#   [QUICK_DRAWN FILE...]      the same with the additional label quick
#   [SOURCES FILE...]          sources shared by the tests
#   [PRIVATE_PARTS MODULE...]  modules (such as InterlumeFlow) whose private classes are tested. The
#                              program links them statically. Tests of public classes use a program
#                              without this option and thus test the installed libraries
#   [LIBRARIES TARGET...])
# Adds the program Interlume<NAME>Tests and a CTest test for each file. The test has the name of the file,
# and the file must define a function of that name. Files may be in subdirectories, but their names must be
# unique. Tests catch expected errors and warnings with observers; any other message of VTK's logger fails
# the test.
set(interlume_test_components
  CommonSystem FiltersCore FiltersGeneral FiltersSources ImagingCore IOXML RenderingCore
  RenderingOpenGL2 RenderingVolume RenderingVolumeOpenGL2 TestingCore)

# This is a macro because find_package defines targets in the scope of the calling directory.
macro (interlume_add_test_executable group)
  find_package(VTK 9.1 REQUIRED COMPONENTS ${interlume_test_components})
  interlume_add_test_program(${group} ${ARGN})
endmacro ()

function (interlume_add_test_program group)
  cmake_parse_arguments(PARSE_ARGV 1 arg ""
    "" "TESTS;SLOW;DRAWN;QUICK_DRAWN;SOURCES;PRIVATE_PARTS;LIBRARIES")
  set(program Interlume${group}Tests)
  set(files ${arg_TESTS} ${arg_SLOW} ${arg_DRAWN} ${arg_QUICK_DRAWN})
  set(drawn ${arg_DRAWN} ${arg_QUICK_DRAWN})
  set(names)
  foreach (file IN LISTS files)
    get_filename_component(name "${file}" NAME)
    list(APPEND names ${name})
  endforeach ()
  set(DISABLE_FLOATING_POINT_EXCEPTIONS ON)
  include("${VTK_DIR}/vtkTestingDriver.cmake")
  # Create only the driver here: it derives function names from file names, including directories.
  create_test_sourcelist(sources ${program}.cxx ${names} EXTRA_INCLUDE vtkTestDriver.h)
  list(GET sources 0 driver)
  add_executable(${program} ${driver} ${files} ${arg_SOURCES})
  # Compiling tests takes half as long as with -O3. The libraries that they test keep -O3.
  target_compile_options(${program} PRIVATE
    "$<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU,Clang>>:-O1>")
  # For the headers of Filters/Common, which need no library.
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
      InterlumeImageSupport Interlume::InterlumeScene VTK::RenderingCore
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
  # For calls of interlume_stability_tests in this directory.
  set(interlume_test_program ${program} PARENT_SCOPE)
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
    # Memory that an OpenGL driver keeps cannot be distinguished from a leak, because the driver is unloaded
    # before leak detection.
    if (INTERLUME_SANITIZE AND file IN_LIST drawn)
      set_property(TEST ${test} APPEND PROPERTY
        ENVIRONMENT "ASAN_OPTIONS=detect_leaks=0:detect_odr_violation=0")
    endif ()
  endforeach ()
endfunction ()

# interlume_stability_tests(TEST...): lets tests of the preceding interlume_add_test_executable report to the
# stability catalog. StabilityCatalogue::Gather reads the list of these tests.
function (interlume_stability_tests)
  set_tests_properties(${ARGN} PROPERTIES LABELS "value;stability" FIXTURES_SETUP stability_cases)
  set_property(TEST ${ARGN} APPEND PROPERTY
    ENVIRONMENT "INTERLUME_STABILITY_DIR=${CMAKE_BINARY_DIR}/Testing/Stability")
  foreach (test IN LISTS ARGN)
    set_property(GLOBAL APPEND_STRING PROPERTY INTERLUME_STABILITY_TESTS
      "${test}\t$<TARGET_FILE:${interlume_test_program}>\n")
  endforeach ()
endfunction ()

# Writes the list after all tests have been added.
function (interlume_write_stability_tests)
  get_property(tests GLOBAL PROPERTY INTERLUME_STABILITY_TESTS)
  file(GENERATE OUTPUT "${CMAKE_BINARY_DIR}/Testing/Stability/tests.txt" CONTENT "${tests}")
endfunction ()
