# SPDX-License-Identifier: BSD-3-Clause
# cmake -D PAGE=page.md -D PROGRAM=Examples/Guide/page -P CheckGuide.cmake
# Checks that a page of the guide starts with its image, or that the README contains it, and that the first code block of
# each language is the whole file PROGRAM.cxx or PROGRAM.py, except for the license in the first line.
file(READ "${PAGE}" page)
get_filename_component(name "${PROGRAM}" NAME)

set(begin "^# [^\n]+\n\n!\\[[^]]+\\]\\(\\.\\./")
if (name STREQUAL readme)
  set(begin "!\\[[^]]+\\]\\(Documentation/")
endif ()
if (NOT page MATCHES "${begin}pictures/pages/${name}\\.png\\)\n")
  message(FATAL_ERROR "${PAGE} lacks the image pictures/pages/${name}.png at its place")
endif ()

function (check language source)
  file(READ "${source}" text)
  string(FIND "${text}" "\n" end)
  string(SUBSTRING "${text}" ${end} -1 text)
  string(FIND "${page}" "```${language}${text}```\n" position)
  if (position LESS 0)
    message(FATAL_ERROR "No code block of ${PAGE} is ${source} without its first line:\n```${language}${text}```")
  endif ()
endfunction ()

check(cpp "${PROGRAM}.cxx")
check(python "${PROGRAM}.py")
