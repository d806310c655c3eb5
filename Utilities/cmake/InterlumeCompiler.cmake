# SPDX-License-Identifier: BSD-3-Clause
# Warnings and sanitizers for every target of the project.
if (CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  add_compile_options(-Wall -Wextra)
endif ()
# GCC 14 reports false violations of array bounds in a std::vector<bool> of VTK's vtkSMPThreadLocal
# wherever it is inlined. Other versions still check the project's code.
if (CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 14
    AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 15)
  add_compile_options(-Wno-array-bounds -Wno-stringop-overflow)
endif ()

if (INTERLUME_SANITIZE)
  add_compile_options("-fsanitize=${INTERLUME_SANITIZE}" -fno-omit-frame-pointer -fno-sanitize-recover=undefined -g)
  add_link_options("-fsanitize=${INTERLUME_SANITIZE}")
endif ()
