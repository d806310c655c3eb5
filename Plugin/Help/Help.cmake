# SPDX-License-Identifier: BSD-3-Clause
# The icons of the client and, where ParaView is of Qt 5, its help: ParaView makes a page for each
# filter of its XML; the guide and pictures are added. With Qt 6 ParaView's own rule makes none. Sets
# help_arguments for paraview_add_plugin and, where there is help, help_folder.
set(help_arguments UI_RESOURCES "${CMAKE_CURRENT_LIST_DIR}/../Icons/icons.qrc")
if (DEFINED PARAVIEW_QT_MAJOR_VERSION AND PARAVIEW_QT_MAJOR_VERSION GREATER 5)
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
