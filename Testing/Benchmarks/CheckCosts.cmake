# SPDX-License-Identifier: BSD-3-Clause
# cmake -D PAGE=index.html -P CheckCosts.cmake
# Fails unless the report's page says what the scene interval-linear pays: nothing for the origins that it does not
# keep, nothing for any feature, and claims it.
cmake_minimum_required(VERSION 3.16)
file(READ "${PAGE}" page)
string(REGEX MATCH "<h2 id=\"costs\">What scenes pay</h2>.*<h2 id=\"stability\">" section "${page}")
if (NOT section)
  message(FATAL_ERROR "${PAGE} has no section of what scenes pay")
endif ()
# The numbers of scenes, and of passes, buffers, bytes, words, arrays and of reports.
set(cell "<td class=\"number\">")
string(REPEAT "${cell}0</td>" 6 nothing)
if (NOT section MATCHES
    "<tr><td>all scenes</td><td>vtkIntervalVolume</td><td>KeepOrigins</td>${cell}1</td>${nothing}")
  message(FATAL_ERROR "${PAGE}: no line of KeepOrigins with 1 scene and nothing left")
endif ()
set(claim "<td><a href=\"#costs\">costs</a></td><td>a feature that is off")
if (NOT page MATCHES
    "${claim} has no pass, buffer, byte, word of a shader or array</td><td>features that scenes do not use [1-9]")
  message(FATAL_ERROR "${PAGE}: something is left, or no claim says that nothing is")
endif ()
if (NOT page MATCHES "${claim} takes no time, ms, but for noise</td>")
  message(FATAL_ERROR "${PAGE}: no claim of time")
endif ()
