# SPDX-License-Identifier: BSD-3-Clause
# The icons of the client and, where Qt 5 has its XML patterns, its help: ParaView makes a page for
# each filter of its XML; the guide and pictures are added. Sets help_arguments for
# paraview_add_plugin and, where there is help, help_folder.
set(help_arguments UI_RESOURCES "${CMAKE_CURRENT_LIST_DIR}/../Icons/icons.qrc")
# ParaView 6.1, of Qt 6, takes the same tool but does not look for it; 5.13 of Qt 6 makes no help.
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
set(guide_pictures "${PROJECT_SOURCE_DIR}/Documentation/pictures/guide")
file(GLOB guide_picture_files CONFIGURE_DEPENDS "${guide_pictures}/*.png")
add_custom_command(
  OUTPUT  "${help_stamp}"
  COMMAND "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_LIST_DIR}/make_help.py"
          "${help_folder}" "${guide}" "${guide_pictures}"
  COMMAND "${CMAKE_COMMAND}" -E touch "${help_stamp}"
  DEPENDS Interlume_doc "${help_folder}/Interlume_doc.xslt" "${guide}" ${guide_picture_files}
          "${CMAKE_CURRENT_LIST_DIR}/make_help.py"
  COMMENT "Adding the guide to the help")
list(APPEND help_arguments XML_DOCUMENTATION ON DOCUMENTATION_DEPENDENCIES "${help_stamp}")
