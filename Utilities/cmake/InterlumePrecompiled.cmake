# SPDX-License-Identifier: BSD-3-Clause
# interlume_precompile(): if INTERLUME_PRECOMPILE_HEADERS is on, precompiles frequently included
# headers: once for the libraries of all modules and their wrappers, and once for each other target
# with enough files to benefit. Call it after all targets are defined. Clang tools cannot read GCC's
# precompiled headers. They need the compilation database of a build without precompiled headers,
# such as the preset debug.
set(interlume_precompiled_headers
  <algorithm> <array> <cmath> <cstdint> <functional> <iostream> <limits> <map> <memory> <numeric> <sstream>
  <string> <unordered_map> <vector>
  <vtkAlgorithm.h> <vtkDataArray.h> <vtkDoubleArray.h> <vtkFloatArray.h> <vtkIdTypeArray.h> <vtkImageData.h>
  <vtkMath.h> <vtkNew.h> <vtkObjectFactory.h> <vtkPointData.h> <vtkPolyData.h> <vtkSmartPointer.h>
  <vtkUnstructuredGrid.h>)
set(interlume_large_targets
  InterlumeBenchmarks InterlumeFlowTests InterlumeGalleryFlow InterlumeGalleryIntervals InterlumeGalleryLight
  InterlumeIntervalsTests InterlumeLightTests InterlumeImageSupport InterlumeRepresentations InterlumeTestSupport InterlumeTetrahedraTests)

function (interlume_precompile)
  if (NOT INTERLUME_PRECOMPILE_HEADERS)
    return ()
  endif ()
  foreach (target IN LISTS interlume_large_targets)
    if (TARGET ${target})
      target_precompile_headers(${target} PRIVATE ${interlume_precompiled_headers})
    endif ()
  endforeach ()
  # Targets that share precompiled headers must have the same options, as the libraries of modules
  # do. Common and Isotables are excluded, since they depend only on VTK's core.
  file(GENERATE OUTPUT "${CMAKE_BINARY_DIR}/InterlumePrecompiled.cxx" CONTENT "")
  add_library(InterlumePrecompiled OBJECT "${CMAKE_BINARY_DIR}/InterlumePrecompiled.cxx")
  target_link_libraries(InterlumePrecompiled PRIVATE VTK::CommonDataModel VTK::CommonExecutionModel)
  set_target_properties(InterlumePrecompiled PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_precompile_headers(InterlumePrecompiled PRIVATE ${interlume_precompiled_headers})
  list(FILTER interlume_modules EXCLUDE REGEX "Common|Isotables")
  foreach (module IN LISTS interlume_modules)
    string(REPLACE "Interlume::" "" module "${module}")
    get_property(components TARGET ${module} PROPERTY INTERLUME_COMPONENTS)
    foreach (target IN ITEMS ${module} ${components} ${module}CS ${module}Python)
      if (TARGET ${target})
        target_precompile_headers(${target} REUSE_FROM InterlumePrecompiled)
      endif ()
    endforeach ()
    # VTK_DEPRECATION is empty in wrappers, but not in the precompiled header.
    foreach (target IN ITEMS ${module}CS ${module}Python)
      if (TARGET ${target})
        target_compile_options(${target} PRIVATE -Wno-deprecated-declarations)
      endif ()
    endforeach ()
  endforeach ()
endfunction ()
