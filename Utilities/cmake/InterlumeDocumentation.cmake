# SPDX-License-Identifier: BSD-3-Clause
# Adds the target `documentation` if Doxygen is found. It writes pages of the public headers and of
# the guide to documentation/html in the build directory.
find_package(Doxygen QUIET)
if (NOT DOXYGEN_FOUND)
  return()
endif ()
set(DOXYGEN_PROJECT_BRIEF "Light in volumes, intervals in space and time, implicit flow")
set(DOXYGEN_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/documentation")
set(DOXYGEN_FILE_PATTERNS "vtk*.h" "*.md")
set(DOXYGEN_USE_MDFILE_AS_MAINPAGE "${PROJECT_SOURCE_DIR}/Documentation/guide/README.md")
set(DOXYGEN_JAVADOC_AUTOBRIEF YES)
set(DOXYGEN_EXTRACT_ALL YES)
set(DOXYGEN_HIDE_FRIEND_COMPOUNDS YES)
set(DOXYGEN_HAVE_DOT NO)
set(DOXYGEN_WARN_IF_UNDOCUMENTED NO)
set(DOXYGEN_QUIET YES)
set(DOXYGEN_MACRO_EXPANSION YES)
set(DOXYGEN_EXPAND_ONLY_PREDEF YES)
set(DOXYGEN_PREDEFINED
  "vtkTypeMacro(a,b)=" "vtkGetMacro(a,b)=b Get##a()" "vtkSetMacro(a,b)=void Set##a(b value)"
  "vtkSetClampMacro(a,b,c,d)=void Set##a(b value)" "vtkBooleanMacro(a,b)=void a##On(); void a##Off()"
  "vtkGetVector2Macro(a,b)=const b* Get##a()" "vtkGetVector3Macro(a,b)=const b* Get##a()"
  "vtkGetVector6Macro(a,b)=const b* Get##a()" "vtkSetVector3Macro(a,b)=void Set##a(b x, b y, b z)")
foreach (module IN ITEMS Flow FlowTexture Intervals Isotables Light Meshing Scene Sources Tetrahedra)
  string(TOUPPER "${module}" upper)
  list(APPEND DOXYGEN_PREDEFINED "INTERLUME${upper}_EXPORT=")
endforeach ()
# Private classes, in subdirectories of the modules, are excluded.
file(GLOB modules LIST_DIRECTORIES ON "${PROJECT_SOURCE_DIR}/Filters/*" "${PROJECT_SOURCE_DIR}/Rendering/*")
set(DOXYGEN_RECURSIVE NO)
doxygen_add_docs(documentation ${modules} "${PROJECT_SOURCE_DIR}/Documentation/guide"
  "${PROJECT_SOURCE_DIR}/Documentation"
  COMMENT "Writing the documentation of the public headers and the guide")
# The pages refer to images in the directory pictures next to the guide's directory, and next to
# measurements.md.
foreach (place IN ITEMS pictures html/pictures)
  add_custom_command(TARGET documentation POST_BUILD
    COMMAND "${CMAKE_COMMAND}" -E copy_directory
      "${PROJECT_SOURCE_DIR}/Documentation/pictures" "${DOXYGEN_OUTPUT_DIRECTORY}/${place}")
endforeach ()
