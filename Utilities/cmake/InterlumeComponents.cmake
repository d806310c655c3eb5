# SPDX-License-Identifier: BSD-3-Clause
# interlume_component(MODULE NAME [USES COMPONENT...] [SOURCES NAME...])
# Adds the private sources in the directory NAME to the library MODULE, such as InterlumeFlow, as an
# object library. The component can include its own headers, the public headers of the module, and
# the headers of components that it uses, directly or indirectly. The components that it uses must
# be added before it, so dependencies are acyclic. A component without SOURCES consists of headers,
# which are compiled together to check that they include what they need. Call it after
# vtk_module_add_module and interlume_use_headers.
function (interlume_component module name)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "" "USES;SOURCES")
  set(visible ${name})
  foreach (used IN LISTS arg_USES)
    get_property(indirect TARGET ${module} PROPERTY INTERLUME_USED_BY_${used})
    if (NOT indirect)
      message(FATAL_ERROR "${module}: ${name} uses ${used}, which must be defined before it.")
    endif ()
    list(APPEND visible ${indirect})
  endforeach ()
  list(REMOVE_DUPLICATES visible)
  set_property(TARGET ${module} PROPERTY INTERLUME_USED_BY_${name} "${visible}")

  set(folder "${CMAKE_CURRENT_BINARY_DIR}/Components/${name}")
  interlume_link_headers("${folder}" ${visible})
  list(TRANSFORM arg_SOURCES REPLACE "(.+)" "${name}/\\1.cxx" OUTPUT_VARIABLE sources)
  if (NOT sources)
    set(sources "${CMAKE_CURRENT_BINARY_DIR}/Components/${name}Headers.cxx")
    file(GLOB headers RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}" CONFIGURE_DEPENDS "${name}/*.h")
    list(TRANSFORM headers REPLACE "(.+)" "#include \"\\1\"\n")
    list(JOIN headers "" includes)
    file(GENERATE OUTPUT "${sources}" CONTENT "${includes}")
  endif ()

  set(component ${module}${name})
  add_library(${component} OBJECT ${sources})
  # The include directories of the module without its own directory. All are SYSTEM, since the property does
  # not distinguish VTK's directories.
  set(own "${CMAKE_CURRENT_SOURCE_DIR}|${CMAKE_CURRENT_BINARY_DIR}|${PROJECT_SOURCE_DIR}/Filters")
  target_include_directories(${component}
    PRIVATE "${folder}" "${CMAKE_CURRENT_BINARY_DIR}" "${PROJECT_SOURCE_DIR}/Filters")
  target_include_directories(${component} SYSTEM
    PRIVATE "$<FILTER:$<TARGET_PROPERTY:${module},INCLUDE_DIRECTORIES>,EXCLUDE,^(${own})$>")
  target_compile_definitions(${component}
    PRIVATE "$<TARGET_PROPERTY:${module},COMPILE_DEFINITIONS>" ${module}_EXPORTS)
  target_compile_options(${component} PRIVATE "$<TARGET_PROPERTY:${module},COMPILE_OPTIONS>")
  set_target_properties(${component} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  if (TARGET ${module}ShaderTexts)
    add_dependencies(${component} ${module}ShaderTexts)
  endif ()
  target_sources(${module} PRIVATE $<TARGET_OBJECTS:${component}>)
  set_property(TARGET ${module} APPEND PROPERTY INTERLUME_COMPONENTS ${component})
endfunction ()

# Fills FOLDER with links to the directories of the module's components and to its public headers.
function (interlume_link_headers folder)
  file(GLOB headers RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}" CONFIGURE_DEPENDS "vtk*.h")
  file(REMOVE_RECURSE "${folder}")
  file(MAKE_DIRECTORY "${folder}")
  foreach (entry IN LISTS ARGN headers)
    file(CREATE_LINK "${CMAKE_CURRENT_SOURCE_DIR}/${entry}" "${folder}/${entry}" SYMBOLIC)
  endforeach ()
endfunction ()

# interlume_shaders(VARIABLE MODULE FILE...): sets VARIABLE to the generated sources of the shader
# texts, to be passed to vtk_module_add_module. A separate target generates their headers, since
# each component may include them.
function (interlume_shaders variable module)
  string(TOUPPER ${module} prefix)
  set(headers)
  set(sources)
  foreach (shader IN LISTS ARGN)
    get_filename_component(name "${shader}" NAME_WE)
    vtk_encode_string(INPUT "${shader}" NAME "${name}"
      HEADER_OUTPUT header SOURCE_OUTPUT source
      EXPORT_HEADER "${module}Module.h" EXPORT_SYMBOL "${prefix}_NO_EXPORT")
    list(APPEND headers "${header}")
    list(APPEND sources "${source}")
  endforeach ()
  add_custom_target(${module}ShaderTexts DEPENDS ${headers})
  set(${variable} ${sources} PARENT_SCOPE)
endfunction ()
