# SPDX-License-Identifier: BSD-3-Clause
# cmake -D PAGE=page.md -D PROGRAM=Examples/Guide/page -P CheckGuide.cmake
# Checks that the page starts with its image, and that its first code block of each language is the whole file
# PROGRAM.cxx or PROGRAM.py, except for the license in the first line.
file(READ "${PAGE}" page)
get_filename_component(name "${PROGRAM}" NAME)

string(REGEX MATCH "^# [^\n]+\n\n!\\[[^]]+\\]\\(\\.\\./pictures/pages/([a-z-]+)\\.png\\)\n" begin "${page}")
if (NOT CMAKE_MATCH_1 STREQUAL name)
  message(FATAL_ERROR "${PAGE} does not start with a title and the image ../pictures/pages/${name}.png")
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
