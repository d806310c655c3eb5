# SPDX-License-Identifier: BSD-3-Clause
# The CMake package for `find_package(Interlume)`. Include this file before the modules are added:
# with its RPATH, installed libraries find each other.
include(CMakePackageConfigHelpers)
set(CMAKE_INSTALL_RPATH "$ORIGIN")
# Libraries with the same minor version are compatible.
set(interlume_soversion "${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")
set(interlume_library_destination "${CMAKE_INSTALL_LIBDIR}")
set(interlume_python_component python)
set(interlume_package_destination "${CMAKE_INSTALL_LIBDIR}/cmake/Interlume")

configure_package_config_file(
  "${CMAKE_CURRENT_LIST_DIR}/InterlumeConfig.cmake.in"
  "${CMAKE_BINARY_DIR}/InterlumeConfig.cmake"
  INSTALL_DESTINATION "${interlume_package_destination}")
write_basic_package_version_file(
  "${CMAKE_BINARY_DIR}/InterlumeConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(
  FILES
    "${CMAKE_BINARY_DIR}/InterlumeConfig.cmake"
    "${CMAKE_BINARY_DIR}/InterlumeConfigVersion.cmake"
  DESTINATION "${interlume_package_destination}"
  COMPONENT development)
