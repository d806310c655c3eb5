# SPDX-License-Identifier: BSD-3-Clause
# Installs the build into an empty directory, and builds and runs a small project against it with
# find_package. Every installed header is compiled separately. VTK is found before Interlume and after it. The
# libraries of the build must not be used.
function (run what)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if (NOT status EQUAL 0)
    message(FATAL_ERROR "${what} failed with exit code ${status}:\n${output}")
  endif ()
  message(STATUS "${what}: done")
endfunction ()

set(prefix "${WORK_DIR}/prefix")
file(REMOVE_RECURSE "${WORK_DIR}")
run("installation" "${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${prefix}")

# All headers vtk*.h in the top directory of a module are public. Other installed headers must be generated.
set(public)
foreach (folder IN LISTS MODULE_DIRS)
  file(GLOB names RELATIVE "${folder}" "${folder}/vtk*.h")
  # Scene has no public headers; only rendering modules use it.
  if (NOT names AND NOT folder MATCHES "/Rendering/Scene$")
    message(FATAL_ERROR "${folder} has no public header")
  endif ()
  foreach (name IN LISTS names)
    if (NOT EXISTS "${prefix}/include/interlume/${name}")
      message(FATAL_ERROR "the public header ${name} of ${folder} is not installed")
    endif ()
  endforeach ()
  list(APPEND public ${names})
endforeach ()
file(GLOB_RECURSE installed RELATIVE "${prefix}/include/interlume" "${prefix}/include/*.h")
list(REMOVE_ITEM installed ${public})
list(FILTER installed EXCLUDE REGEX "^Interlume[A-Za-z]+Module\\.h$")
if (installed)
  message(FATAL_ERROR "private headers are installed: ${installed}")
endif ()

foreach (order IN ITEMS before after)
  set(build "${WORK_DIR}/build-${order}")
  string(COMPARE EQUAL "${order}" after vtk_after)
  run("configuration of the consumer, VTK ${order}" "${CMAKE_COMMAND}"
    -S "${CONSUMER_DIR}" -B "${build}" -G "${GENERATOR}"
    "-DCMAKE_MAKE_PROGRAM=${MAKE_PROGRAM}"
    "-DCMAKE_BUILD_TYPE=${BUILD_TYPE}"
    "-DCMAKE_C_COMPILER=${C_COMPILER}"
    "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
    "-DSANITIZE=${SANITIZE}"
    "-DVTK_AFTER=${vtk_after}"
    "-DHEADER_DIR=${prefix}/include/interlume"
    "-DVTK_DIR=${VTK_DIR}"
    "-DInterlume_DIR=${prefix}/${LIBRARY_DIR}/cmake/Interlume")
  run("build of the consumer, VTK ${order}" "${CMAKE_COMMAND}"
    --build "${build}" --target consumer)
  run("consumer, VTK ${order}" "${build}/consumer")
endforeach ()
run("separate compilation of each header" "${CMAKE_COMMAND}"
  --build "${WORK_DIR}/build-before" --target headers)

file(GLOB_RECURSE headers "${prefix}/include/*.h")
file(GLOB_RECURSE package_files "${prefix}/${LIBRARY_DIR}/cmake/*.cmake")
foreach (file IN LISTS headers package_files)
  file(STRINGS "${file}" lines REGEX "^[^#]*${BUILD_DIR}/")
  if (lines)
    message(FATAL_ERROR "${file} refers to the build directory: ${lines}")
  endif ()
endforeach ()
