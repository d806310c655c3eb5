# Warnings and sanitizers for every target of the project.
if (CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  add_compile_options(-Wall -Wextra)
endif ()

if (INTERLUME_SANITIZE)
  add_compile_options("-fsanitize=${INTERLUME_SANITIZE}" -fno-omit-frame-pointer -fno-sanitize-recover=undefined -g)
  add_link_options("-fsanitize=${INTERLUME_SANITIZE}")
endif ()
