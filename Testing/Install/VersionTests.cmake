# SPDX-License-Identifier: BSD-3-Clause
# find_version_tests(ROOT OUTPUT): lists the lines under ROOT that ask which VTK they are compiled with,
# or name a header that only some versions have, each as "file: line". Files that are there to know
# such differences, one for each concern, are left out:
set(interlume_version_files
  # how OpenGL is loaded
  Rendering/Scene/Loader/OpenGLFunctions.h
  # what an unstructured grid's cells are stored in
  Filters/Common/GridCells.h
  # peers that the benchmarks compare with
  Utilities/Benchmarks/Flow/VelocityInterpolation.cxx
  Utilities/Benchmarks/Shadows/GpuShadows.h
  # the arithmetic of small vectors
  Utilities/Gallery/VectorArithmetic.h
  # whether Python has the VTK that was found
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
    # The test itself, which names what it looks for.
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
