# SPDX-License-Identifier: BSD-3-Clause
cmake_minimum_required(VERSION 3.16)
# Checks that libraries export only public classes and classes shared within the project. Each defined symbol
# must belong to a class with a public header, or to a class that a private header marks with an export macro.
# LIBRARIES are the files, separated by |.
string(REPLACE "|" ";" LIBRARIES "${LIBRARIES}")
file(GLOB headers "${SOURCE_DIR}/Filters/*/vtk*.h" "${SOURCE_DIR}/Rendering/*/vtk*.h")
set(classes)
foreach (header IN LISTS headers)
  get_filename_component(class "${header}" NAME_WE)
  list(APPEND classes "${class}")
endforeach ()
file(GLOB headers
  "${SOURCE_DIR}/Filters/Common/[A-Z]*.h" "${SOURCE_DIR}/Filters/*/*/*.h" "${SOURCE_DIR}/Rendering/*/*/*.h")
foreach (header IN LISTS headers)
  file(STRINGS "${header}" marked REGEX "INTERLUME[A-Z]+_EXPORT")
  if (marked)
    get_filename_component(class "${header}" NAME_WE)
    list(APPEND classes "interlume::${class}")
  endif ()
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
    # Names of lambdas in member templates start with the return type if they are compiled with Clang.
    string(REGEX REPLACE
      "^(void |(typeinfo|typeinfo name|vtable|VTT|guard variable) for |(non-)?virtual thunk to )?(vtk[A-Za-z0-9]+|interlume::[A-Za-z0-9]+).*"
      "\\4" class "${symbol}")
    if (NOT class IN_LIST classes)
      message(FATAL_ERROR "${library} exports a symbol that does not belong to a public class: ${symbol}")
    endif ()
  endforeach ()
  math(EXPR all "${all} + ${count}")
endforeach ()
message(STATUS "${all} symbols in ${number} libraries")
