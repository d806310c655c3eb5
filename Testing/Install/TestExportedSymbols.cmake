# SPDX-License-Identifier: BSD-3-Clause
cmake_minimum_required(VERSION 3.16)
# No library shows more than public classes and those shared within the project: each defined symbol is of a
# class with a public header, or one of SHARED_CLASSES in namespace interlume. LIBRARIES are the files. Both
# lists have | between the items.
string(REPLACE "|" ";" LIBRARIES "${LIBRARIES}")
string(REPLACE "|" ";" SHARED_CLASSES "${SHARED_CLASSES}")
file(GLOB headers "${SOURCE_DIR}/Filters/*/vtk*.h" "${SOURCE_DIR}/Rendering/*/vtk*.h")
set(classes)
foreach (class IN LISTS SHARED_CLASSES)
  list(APPEND classes "interlume::${class}")
endforeach ()
foreach (header IN LISTS headers)
  get_filename_component(class "${header}" NAME_WE)
  list(APPEND classes "${class}")
endforeach ()
list(LENGTH LIBRARIES number)
set(all 0)
foreach (library IN LISTS LIBRARIES)
  execute_process(COMMAND "${NM}" --dynamic --defined-only --demangle --format=posix "${library}"
    OUTPUT_VARIABLE symbols RESULT_VARIABLE status)
  string(REPLACE ";" "," symbols "${symbols}")
  string(REGEX MATCHALL "[^\n]+" symbols "${symbols}")
  list(LENGTH symbols count)
  if (NOT status EQUAL 0 OR count EQUAL 0)
    message(FATAL_ERROR "${NM} found no symbols in ${library}")
  endif ()
  foreach (symbol IN LISTS symbols)
    string(REGEX REPLACE
      "^((typeinfo|typeinfo name|vtable|VTT|guard variable) for |(non-)?virtual thunk to )?(vtk[A-Za-z0-9]+|interlume::[A-Za-z0-9]+).*"
      "\\4" class "${symbol}")
    if (NOT class IN_LIST classes)
      message(FATAL_ERROR "${library} shows what is no public class: ${symbol}")
    endif ()
  endforeach ()
  math(EXPR all "${all} + ${count}")
endforeach ()
message(STATUS "${all} symbols in ${number} libraries")
