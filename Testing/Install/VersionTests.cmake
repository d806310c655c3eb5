# SPDX-License-Identifier: BSD-3-Clause
# find_version_tests(ROOT OUTPUT): lists the lines under ROOT that depend on the version of VTK, or include a
# header that only some versions have, each as "file: line". The following files may depend on it, each for
# one purpose:
set(interlume_version_files
  # loading OpenGL
  Rendering/Scene/Loader/OpenGLFunctions.h
  # storage of the cells of an unstructured grid
  Filters/Common/GridCells.h
  # VTK classes that the benchmarks compare with
  Utilities/Benchmarks/Flow/VelocityInterpolation.cxx
  Utilities/Benchmarks/Shadows/GpuShadows.h
  # arithmetic of small vectors
  Utilities/Gallery/VectorArithmetic.h
  # detection of VTK's Python package
  Utilities/cmake/InterlumePython.cmake)

function (find_version_tests root output)
  set(found)
  set(in_sources "VTK_(MAJOR_|MINOR_|BUILD_)?VERSION(_NUMBER|_CHECK)?[^A-Z_]|__has_include|vtk_gl(ew|ad)\\.h|vtkVectorOperators\\.h|GLEW_|GLAD_")
  set(in_cmake "VTK_(MAJOR_|MINOR_|BUILD_)?VERSION")
  foreach (folder IN ITEMS Filters Rendering Plugin Python Testing Examples Utilities)
    file(GLOB_RECURSE sources RELATIVE "${root}"
      "${root}/${folder}/*.h" "${root}/${folder}/*.hxx" "${root}/${folder}/*.txx" "${root}/${folder}/*.cxx")
    file(GLOB_RECURSE scripts RELATIVE "${root}"
      "${root}/${folder}/CMakeLists.txt" "${root}/${folder}/*.cmake")
    list(REMOVE_ITEM sources ${interlume_version_files})
    list(REMOVE_ITEM scripts ${interlume_version_files})
    # Skip this test, which contains the patterns.
    list(FILTER scripts EXCLUDE REGEX "^Testing/Install/")
    foreach (kind IN ITEMS sources scripts)
      set(pattern "${in_sources}")
      if (kind STREQUAL "scripts")
        set(pattern "${in_cmake}")
      endif ()
      foreach (name IN LISTS ${kind})
        file(STRINGS "${root}/${name}" lines REGEX "${pattern}")
        foreach (line IN LISTS lines)
          list(APPEND found "${name}: ${line}")
        endforeach ()
      endforeach ()
    endforeach ()
  endforeach ()
  set(${output} "${found}" PARENT_SCOPE)
endfunction ()
