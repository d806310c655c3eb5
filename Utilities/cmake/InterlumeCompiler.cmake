# SPDX-License-Identifier: BSD-3-Clause
# Warnings and sanitizers for every target of the project.
if (CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  add_compile_options(-Wall -Wextra)
endif ()
# GCC 14 warns in error of the bounds of a std::vector<bool> in VTK's vtkSMPThreadLocal wherever that is
# inlined. Earlier and later versions, which do not, look at the bounds of our own arrays.
if (CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 14
    AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 15)
  add_compile_options(-Wno-array-bounds -Wno-stringop-overflow)
endif ()

if (INTERLUME_SANITIZE)
  add_compile_options("-fsanitize=${INTERLUME_SANITIZE}" -fno-omit-frame-pointer -fno-sanitize-recover=undefined -g)
  add_link_options("-fsanitize=${INTERLUME_SANITIZE}")
endif ()
