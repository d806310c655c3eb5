# SPDX-License-Identifier: BSD-3-Clause
# Used in the build of the VTK modules: writes the numbers and images for ParaView to reproduce, and checks
# the defaults in the plugin's XML.
if (NOT INTERLUME_PYTHON)
  return()
endif ()
interlume_python_path(path "${CMAKE_BINARY_DIR}/${INTERLUME_PYTHON_DESTINATION}" "${CMAKE_CURRENT_SOURCE_DIR}")
set(extractions_folder "${CMAKE_BINARY_DIR}/Testing/Extractions")
file(MAKE_DIRECTORY "${extractions_folder}")

# extraction_test(NAME LABELS SCRIPT FOLDER)
function (extraction_test name labels script folder)
  add_test(NAME ${name}
    COMMAND "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_SOURCE_DIR}/${script}" "${folder}")
  set_tests_properties(${name} PROPERTIES
    LABELS "${labels}"
    ENVIRONMENT "PYTHONPATH=${path};PYTHONDONTWRITEBYTECODE=1;INTERLUME_DATA=${PROJECT_SOURCE_DIR}/Data"
    FAIL_REGULAR_EXPRESSION "ERROR: ;Warning: ;ERR\\|;Traceback")
endfunction ()
extraction_test(TestExtractionNumbers "value;quick" Extractions/write_numbers.py "${extractions_folder}")
extraction_test(TestInflowTexturePictures image
  Extractions/write_inflow_textures.py "${extractions_folder}")
extraction_test(TestRepresentationPictures image
  Extractions/write_representation.py "${extractions_folder}")
extraction_test(TestShadowedSlicePictures image
  Extractions/write_shadowed_slices.py "${extractions_folder}")
extraction_test(TestPluginXMLDefaults "value;quick" TestPluginXMLDefaults.py "${PROJECT_SOURCE_DIR}/Plugin")
# TestExtractionNumbers may print warnings, since one of the flows of write_numbers.py has no
# critical point. The image tests may not.
set_tests_properties(TestInflowTexturePictures TestRepresentationPictures TestShadowedSlicePictures PROPERTIES
  TIMEOUT 300
  FAIL_REGULAR_EXPRESSION "ERROR: ;Warning: ;ERR\\|;WARN\\|;Traceback")
