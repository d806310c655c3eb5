# SPDX-License-Identifier: BSD-3-Clause
# Run by `cpack` after it has built the packages. To each package with libraries, CPack adds scripts
# that run ldconfig. This file removes them, since Debian requires a trigger instead, which these
# packages have.
foreach (package IN LISTS CPACK_PACKAGE_FILES)
  set(folder "${package}.parts")
  set(files "${folder}/DEBIAN")
  execute_process(COMMAND dpkg-deb --raw-extract "${package}" "${folder}" RESULT_VARIABLE status)
  if (status EQUAL 0 AND EXISTS "${files}/triggers")
    file(REMOVE "${files}/postinst" "${files}/postrm")
    execute_process(COMMAND dpkg-deb --root-owner-group --build "${folder}" "${package}"
      OUTPUT_QUIET RESULT_VARIABLE status)
  endif ()
  file(REMOVE_RECURSE "${folder}")
  if (NOT status EQUAL 0)
    message(FATAL_ERROR "dpkg-deb cannot read or write ${package}.")
  endif ()
endforeach ()
