# SPDX-License-Identifier: BSD-3-Clause
# cmake -D PAGE=index.html -D SUITES=13 -P CheckReport.cmake
# Fails unless the report's page begins with one table of claims, and has one folded table for each suite.
file(READ "${PAGE}" page)
string(FIND "${page}" "claims are met in every case" claims)
string(FIND "${page}" "<div class=\"plots\">" plots)
if (claims LESS 0 OR claims GREATER plots)
  message(FATAL_ERROR "${PAGE} does not begin with claims")
endif ()
string(REGEX MATCHALL "<details>" folded "${page}")
list(LENGTH folded folded)
string(REGEX MATCHALL "<summary>[0-9]+ rows</summary>\n<div class=\"wide\"><table>" tables "${page}")
list(LENGTH tables tables)
string(REGEX MATCHALL "<table>" all "${page}")
list(LENGTH all all)
math(EXPR unfolded "${all} - ${folded}")
if (NOT tables EQUAL SUITES OR NOT unfolded EQUAL 1)
  message(FATAL_ERROR "${PAGE} has ${tables} folded tables of rows for ${SUITES} suites, and ${unfolded} others")
endif ()
