# SPDX-License-Identifier: BSD-3-Clause
# cmake -D PAGE=page.md -D CXX=program.cxx -D PYTHON=script.py -P CheckGuide.cmake
# Fails unless the code on the page, in C++ and in Python, stands in the program and in the script, but for
# how far it is indented there, and between the imports and the picture.
file(READ "${PAGE}" page)

# Checks the one block of a language.
function (check language source)
  file(READ "${source}" text)
  string(REGEX REPLACE "\n +" "\n" text "${text}")
  string(FIND "${page}" "```${language}\n" begin)
  if (begin LESS 0)
    message(FATAL_ERROR "${PAGE} has no code of ${language}")
  endif ()
  string(SUBSTRING "${page}" ${begin} -1 block)
  string(REGEX REPLACE "^```[a-z]+\n" "" block "${block}")
  string(FIND "${block}" "```" end)
  string(SUBSTRING "${block}" 0 ${end} block)
  string(REGEX REPLACE "\n +" "\n" block "${block}")
  # Imports and what follows them are parts of their own.
  string(REPLACE "\n\n" "@" parts "${block}")
  string(REPLACE ";" "\\;" parts "${parts}")
  string(REPLACE "@" ";" parts "${parts}")
  foreach (part IN LISTS parts)
    string(FIND "${text}" "${part}" place)
    if (place LESS 0)
      message(FATAL_ERROR "${source} does not have this part of ${PAGE}:\n${part}")
    endif ()
  endforeach ()
endfunction ()

check(cpp "${CXX}")
check(python "${PYTHON}")
