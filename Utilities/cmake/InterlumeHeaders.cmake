# SPDX-License-Identifier: BSD-3-Clause
# Headers that modules use privately: Filters/Common, and header-only libraries. Neither installed
# headers nor the exported targets refer to them. Any version in Debian 12 or later works. No
# version is requested, since Eigen 5 declares itself incompatible with 3.4.
find_package(Boost CONFIG REQUIRED)
find_package(Eigen3 CONFIG REQUIRED)
find_package(glm CONFIG REQUIRED)

# interlume_use_headers(MODULE [LIBRARY...]): lets MODULE include Filters/Common, GLM, and the
# libraries, given by their targets, such as Eigen3::Eigen.
function (interlume_use_headers module)
  vtk_module_include("${module}" PRIVATE "${PROJECT_SOURCE_DIR}/Filters")
  foreach (library IN ITEMS glm::glm ${ARGN})
    vtk_module_include("${module}"
      SYSTEM PRIVATE "$<TARGET_PROPERTY:${library},INTERFACE_INCLUDE_DIRECTORIES>")
  endforeach ()
  if ("Eigen3::Eigen" IN_LIST ARGN)
    # Excludes parts of Eigen with other licenses than MPL 2.
    vtk_module_definitions("${module}" PRIVATE EIGEN_MPL2_ONLY)
  endif ()
endfunction ()
