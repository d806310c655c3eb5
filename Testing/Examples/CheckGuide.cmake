# SPDX-License-Identifier: BSD-3-Clause
# cmake -D PAGE=page.md -D CXX=program.cxx -D PYTHON=script.py -P CheckGuide.cmake
# Checks that the C++ and Python code on the page occurs in the program and the script, except for indentation
# and additional code between the parts.
file(READ "${PAGE}" page)

# Checks the code block of one language.
function (check language source)
  file(READ "${source}" text)
  string(REGEX REPLACE "\n +" "\n" text "${text}")
  string(FIND "${page}" "```${language}\n" begin)
  if (begin LESS 0)
    message(FATAL_ERROR "${PAGE} has no code block of ${language}")
  endif ()
  string(SUBSTRING "${page}" ${begin} -1 block)
  string(REGEX REPLACE "^```[a-z]+\n" "" block "${block}")
  string(FIND "${block}" "```" end)
  string(SUBSTRING "${block}" 0 ${end} block)
  string(REGEX REPLACE "\n +" "\n" block "${block}")
  # Blank lines separate parts, such as imports.
  string(REPLACE "\n\n" "@" parts "${block}")
  string(REPLACE ";" "\\;" parts "${parts}")
  string(REPLACE "@" ";" parts "${parts}")
  foreach (part IN LISTS parts)
    string(FIND "${text}" "${part}" position)
    if (position LESS 0)
      message(FATAL_ERROR "${source} does not contain this code of ${PAGE}:\n${part}")
    endif ()
  endforeach ()
endfunction ()

check(cpp "${CXX}")
check(python "${PYTHON}")
