# SPDX-License-Identifier: BSD-3-Clause
# interlume_export_public(MODULE...): makes only two kinds of classes visible: those of the
# installed headers, and those of private headers that have the export macro because other modules
# use them. Other classes and their template instantiations are hidden. The linker hides them, not
# the compiler, so that tests can link the objects of private classes.
function (interlume_export_public)
  if (NOT UNIX OR APPLE OR NOT BUILD_SHARED_LIBS)
    return()
  endif ()
  foreach (module IN LISTS ARGN)
    string(REPLACE "Interlume::" "" library "${module}")
    get_target_property(folder ${library} SOURCE_DIR)
    file(GLOB headers RELATIVE "${folder}" CONFIGURE_DEPENDS "${folder}/vtk*.h")
    list(TRANSFORM headers REPLACE "\\.h$" "")
    set(classes ${headers})
    file(GLOB headers CONFIGURE_DEPENDS "${folder}/[A-Z]*.h" "${folder}/*/*.h")
    foreach (header IN LISTS headers)
      file(STRINGS "${header}" marked REGEX "INTERLUME[A-Z]+_EXPORT")
      if (marked)
        get_filename_component(class "${header}" NAME_WE)
        list(APPEND classes "interlume::${class}")
      endif ()
    endforeach ()
    set(patterns)
    foreach (class IN LISTS classes)
      # Each blank is written as ?, which matches any character, because a quoted pattern cannot
      # contain wildcards.
      string(APPEND patterns "      ${class}::*;\n")
      foreach (kind IN ITEMS typeinfo?for typeinfo?name?for vtable?for VTT?for)
        string(APPEND patterns "      ${kind}?${class};\n      ${kind}?${class}::*;\n")
      endforeach ()
      foreach (kind IN ITEMS guard?variable?for non-virtual?thunk?to virtual?thunk?to)
        string(APPEND patterns "      ${kind}?${class}::*;\n")
      endforeach ()
    endforeach ()
    set(script "${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/${library}.exports")
    file(GENERATE OUTPUT "${script}" CONTENT
      "{\n  global:\n    *_AutoInit_*;\n    extern \"C++\"\n    {\n${patterns}    };\n  local:\n    *;\n};\n")
    target_link_options(${library} PRIVATE "LINKER:--version-script=${script}")
    set_property(TARGET ${library} APPEND PROPERTY LINK_DEPENDS "${script}")
  endforeach ()
endfunction ()
