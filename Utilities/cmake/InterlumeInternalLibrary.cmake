# SPDX-License-Identifier: BSD-3-Clause
# interlume_internal_library(MODULE): adds the static library MODULEPrivate, which consists of the
# objects of the module's library. Tests and benchmarks of private classes link it after the module
# itself, so that no class must be exported for them.
function (interlume_internal_library module)
  if (TARGET ${module}Private)
    return ()
  endif ()
  get_target_property(components ${module} INTERLUME_COMPONENTS)
  list(TRANSFORM components REPLACE "(.+)" "$<TARGET_OBJECTS:\\1>")
  add_library(${module}Private STATIC EXCLUDE_FROM_ALL $<TARGET_OBJECTS:${module}> ${components})
  get_target_property(folder ${module} SOURCE_DIR)
  target_include_directories(${module}Private INTERFACE "${folder}" "${PROJECT_SOURCE_DIR}/Filters")
  target_link_libraries(${module}Private INTERFACE ${module} $<TARGET_PROPERTY:${module},LINK_LIBRARIES>
    glm::glm VTK::CommonSystem "$<$<TARGET_EXISTS:VTK::glad>:VTK::glad>" "$<$<TARGET_EXISTS:VTK::glew>:VTK::glew;VTK::opengl>")
  set_target_properties(${module}Private PROPERTIES LINKER_LANGUAGE CXX)
endfunction ()
