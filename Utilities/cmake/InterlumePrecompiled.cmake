# SPDX-License-Identifier: BSD-3-Clause
# interlume_precompile(): where INTERLUME_PRECOMPILE_HEADERS is on, the headers that most files include are
# read once for the libraries of all modules and of their wrappers, and once for each other target that has
# so many files that it wins by it. To be called when all targets are known. Clang's tools take no precompiled
# headers of GCC: they need the compilation database of a build without, as of the preset debug.
set(interlume_precompiled_headers
  <algorithm> <array> <cmath> <cstdint> <functional> <iostream> <limits> <map> <memory> <numeric> <sstream>
  <string> <unordered_map> <vector>
  <vtkAlgorithm.h> <vtkDataArray.h> <vtkDoubleArray.h> <vtkFloatArray.h> <vtkIdTypeArray.h> <vtkImageData.h>
  <vtkMath.h> <vtkNew.h> <vtkObjectFactory.h> <vtkPointData.h> <vtkPolyData.h> <vtkSmartPointer.h>
  <vtkUnstructuredGrid.h>)
set(interlume_large_targets
  InterlumeBenchmarks InterlumeFlowTests InterlumeGalleryScenes InterlumeIntervalsTests InterlumeLightTests
  InterlumePictureSupport InterlumeRepresentations InterlumeTestSupport InterlumeTetrahedraTests)

function (interlume_precompile)
  if (NOT INTERLUME_PRECOMPILE_HEADERS)
    return ()
  endif ()
  foreach (target IN LISTS interlume_large_targets)
    if (TARGET ${target})
      target_precompile_headers(${target} PRIVATE ${interlume_precompiled_headers})
    endif ()
  endforeach ()
  # Libraries of modules have the same options, which those who share precompiled headers must have; but for
  # Isotables, which knows VTK's core alone.
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
  endforeach ()
endfunction ()
