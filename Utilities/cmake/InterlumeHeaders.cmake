# SPDX-License-Identifier: BSD-3-Clause
# Headers that modules use inside: those of Filters/Common, and libraries of headers alone. Nothing of them
# is in installed headers or in what the package exports. Any version of Debian 12 or later does, and none
# is asked for: Eigen 5 says that it is not compatible with 3.4.
find_package(Boost CONFIG REQUIRED)
find_package(Eigen3 CONFIG REQUIRED)
find_package(glm CONFIG REQUIRED)

# interlume_use_headers(MODULE [LIBRARY...]): Filters/Common with GLM, and the libraries' targets, such as
# Eigen3::Eigen.
function (interlume_use_headers module)
  vtk_module_include("${module}" PRIVATE "${PROJECT_SOURCE_DIR}/Filters")
  foreach (library IN ITEMS glm::glm ${ARGN})
    vtk_module_include("${module}"
      SYSTEM PRIVATE "$<TARGET_PROPERTY:${library},INTERFACE_INCLUDE_DIRECTORIES>")
  endforeach ()
  if ("Eigen3::Eigen" IN_LIST ARGN)
    # Of Eigen only what has its licence, MPL 2.
    vtk_module_definitions("${module}" PRIVATE EIGEN_MPL2_ONLY)
  endif ()
endfunction ()
