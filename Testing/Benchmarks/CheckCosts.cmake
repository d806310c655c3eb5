# SPDX-License-Identifier: BSD-3-Clause
# cmake -D PAGE=index.html -P CheckCosts.cmake
# Checks the costs section of the report page. The scene interval-linear must have no cost for
# origin arrays or any other disabled feature, and the page must have a claim about this.
cmake_minimum_required(VERSION 3.16)
file(READ "${PAGE}" page)
string(REGEX MATCH "<h2 id=\"costs\">Cost of unused features</h2>.*<h2 id=\"stability\">" section "${page}")
if (NOT section)
  message(FATAL_ERROR "${PAGE} has no section 'Cost of unused features'")
endif ()
# A row contains the number of scenes, then of passes, buffers, bytes, words of shaders, arrays and
# reports.
set(cell "<td class=\"number\">")
string(REPEAT "${cell}0</td>" 6 nothing)
if (NOT section MATCHES
    "<tr><td>all scenes</td><td>vtkIntervalVolume</td><td>GenerateOriginArrays</td>${cell}1</td>${nothing}")
  message(FATAL_ERROR "${PAGE}: no table row of GenerateOriginArrays with 1 scene and zero costs")
endif ()
set(claim "<td><a href=\"#costs\">costs</a></td><td>a feature that is off")
if (NOT page MATCHES
    "${claim} has no pass, buffer, byte, word of a shader or array</td><td>features that scenes do not use [1-9]")
  message(FATAL_ERROR "${PAGE}: no claim that disabled features add no pass, buffer, byte, shader word or array, or it does not hold")
endif ()
if (NOT page MATCHES "${claim} takes no time, ms, but for noise</td>")
  message(FATAL_ERROR "${PAGE}: no claim that disabled features take no time")
endif ()
