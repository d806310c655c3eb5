# SPDX-License-Identifier: BSD-3-Clause
# interlume_export_public(MODULE...): of each module's library, only the public classes are visible to
# others: those of the headers that are installed. Private parts, and what the compiler makes of
# templates for them, stay inside. A module may share private classes with the others of the project: those of
# namespace interlume that its property INTERLUME_SHARED_CLASSES lists. By the linker and not by the compiler, so that tests can have the
# private parts' objects.
function (interlume_export_public)
  if (NOT UNIX OR APPLE OR NOT BUILD_SHARED_LIBS)
    return()
  endif ()
  foreach (module IN LISTS ARGN)
    string(REPLACE "Interlume::" "" library "${module}")
    get_target_property(folder ${library} SOURCE_DIR)
    file(GLOB headers RELATIVE "${folder}" CONFIGURE_DEPENDS "${folder}/vtk*.h")
    set(patterns)
    foreach (header IN LISTS headers)
      get_filename_component(class "${header}" NAME_WE)
      # A blank is the sign ? here: a pattern in quotes could have no star.
      string(APPEND patterns "      ${class}::*;\n")
      foreach (kind IN ITEMS typeinfo?for typeinfo?name?for vtable?for VTT?for)
        string(APPEND patterns "      ${kind}?${class};\n      ${kind}?${class}::*;\n")
      endforeach ()
      foreach (kind IN ITEMS guard?variable?for non-virtual?thunk?to virtual?thunk?to)
        string(APPEND patterns "      ${kind}?${class}::*;\n")
      endforeach ()
    endforeach ()
    get_target_property(shared ${library} INTERLUME_SHARED_CLASSES)
    if (NOT shared)
      set(shared)
    endif ()
    foreach (class IN LISTS shared)
      string(APPEND patterns "      interlume::${class}::*;\n")
    endforeach ()
    set(script "${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/${library}.exports")
    file(GENERATE OUTPUT "${script}" CONTENT
      "{\n  global:\n    *_AutoInit_*;\n    extern \"C++\"\n    {\n${patterns}    };\n  local:\n    *;\n};\n")
    target_link_options(${library} PRIVATE "LINKER:--version-script=${script}")
    set_property(TARGET ${library} APPEND PROPERTY LINK_DEPENDS "${script}")
  endforeach ()
endfunction ()
