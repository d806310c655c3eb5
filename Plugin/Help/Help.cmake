# SPDX-License-Identifier: BSD-3-Clause
# Icons and help pages for the ParaView client. ParaView generates a help page per filter from the
# XML; make_help.py adds the guide and its figures. This requires xmlpatterns of Qt 5. Sets
# help_arguments for paraview_add_plugin and, if help is built, help_folder.
set(help_arguments UI_RESOURCES "${CMAKE_CURRENT_LIST_DIR}/../Icons/icons.qrc")
# ParaView 6.1 with Qt 6 uses the same tool but does not search for it. ParaView 5.13 with Qt 6
# builds no help.
find_program(qt_xmlpatterns_executable NAMES xmlpatterns-qt5 xmlpatterns PATHS /usr/lib/qt5/bin)
mark_as_advanced(qt_xmlpatterns_executable)
if (NOT qt_xmlpatterns_executable)
  list(APPEND help_arguments XML_DOCUMENTATION OFF)
  return ()
endif ()
find_package(Python3 QUIET REQUIRED COMPONENTS Interpreter)
set(help_folder "${CMAKE_CURRENT_BINARY_DIR}/paraview_help")
set(help_stamp "${CMAKE_CURRENT_BINARY_DIR}/help.stamp")
set(guide "${PROJECT_SOURCE_DIR}/Documentation/guide/paraview.md")
set(guide_images "${PROJECT_SOURCE_DIR}/Documentation/pictures/guide")
file(GLOB guide_image_files CONFIGURE_DEPENDS "${guide_images}/*.png")
add_custom_command(
  OUTPUT  "${help_stamp}"
  COMMAND "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_LIST_DIR}/make_help.py"
          "${help_folder}" "${guide}" "${guide_images}"
  COMMAND "${CMAKE_COMMAND}" -E touch "${help_stamp}"
  DEPENDS Interlume_doc "${help_folder}/Interlume_doc.xslt" "${guide}" ${guide_image_files}
          "${CMAKE_CURRENT_LIST_DIR}/make_help.py"
  COMMENT "Adding the guide to the help")
list(APPEND help_arguments XML_DOCUMENTATION ON DOCUMENTATION_DEPENDENCIES "${help_stamp}")
