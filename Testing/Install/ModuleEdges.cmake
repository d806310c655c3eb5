# SPDX-License-Identifier: BSD-3-Clause
# find_breaches(ROOT OUTPUT): lists the includes under ROOT that violate the dependencies between modules in
# Documentation/architecture.md, each as "file: line".
#   - only Plugin/ includes headers of ParaView
#   - programs below Utilities/ include no tests, but may include the directories of Testing/Support that
#     they share with tests. These include nothing else of Testing/. No file of Testing/Support includes a
#     test or program
#   - no module includes tests or programs
#   - rendering modules include no module under Filters/. Tetrahedra, Light and FlowTexture may include Scene
#     but not each other, except that FlowTexture may include the public headers of Light
#   - Isotables includes no pipeline and no dataset. Intervals may include Isotables, and Flow may include
#     both. Sources and Meshing include only VTK, and no filter module includes them
#   - all modules may include Filters/Common, which includes no module

# Returns a regular expression for the names of a module's headers. If there are none, it matches nothing.
function (header_pattern output)
  set(names)
  foreach (folder IN LISTS ARGN)
    file(GLOB_RECURSE headers "${folder}/*.h")
    foreach (header IN LISTS headers)
      get_filename_component(name "${header}" NAME_WE)
      list(APPEND names "${name}")
    endforeach ()
  endforeach ()
  list(JOIN names "|" pattern)
  if (NOT pattern)
    set(pattern "no header")
  endif ()
  set(${output} "(${pattern})\\.h" PARENT_SCOPE)
endfunction ()

# Appends to `breaches` all lines in the sources of a directory that include a matching header.
function (forbid root folder pattern)
  file(GLOB_RECURSE sources
    "${root}/${folder}/*.h" "${root}/${folder}/*.hxx" "${root}/${folder}/*.txx" "${root}/${folder}/*.cxx")
  foreach (source IN LISTS sources)
    file(STRINGS "${source}" lines REGEX "^[ \t]*#[ \t]*include[ \t]*[<\"](.*/)?${pattern}[>\"]")
    foreach (line IN LISTS lines)
      file(RELATIVE_PATH name "${root}" "${source}")
      list(APPEND breaches "${name}: ${line}")
    endforeach ()
  endforeach ()
  set(breaches "${breaches}" PARENT_SCOPE)
endfunction ()

function (find_breaches root output)
  set(breaches)
  # VTK's own names, such as vtkSMPTools, must not match. ParaView's names have a capital and a
  # lower-case letter after vtkSM.
  set(paraview "(vtkPV[A-Z]|vtkSM[A-Z][a-z]|vtkSI[A-Z][a-z]|vtkClientServer|pq[A-Z])[A-Za-z0-9]*\\.h")
  foreach (folder IN ITEMS Filters Rendering Testing Examples Utilities)
    forbid("${root}" ${folder} "${paraview}")
  endforeach ()
  set(shared_support AnalyticFlows Arrays Inputs Pages Images Transport)
  file(GLOB test_folders "${root}/Testing/*")
  list(REMOVE_ITEM test_folders "${root}/Testing/Support")
  header_pattern(tests ${test_folders})
  file(GLOB test_support "${root}/Testing/Support/*")
  foreach (folder IN LISTS shared_support)
    list(REMOVE_ITEM test_support "${root}/Testing/Support/${folder}")
  endforeach ()
  header_pattern(test_support ${test_support})
  set(programs "(Benchmarks|Gallery)/([A-Za-z]+/)*[A-Za-z0-9]+\\.h")
  foreach (folder IN LISTS shared_support)
    forbid("${root}" Testing/Support/${folder} "${test_support}")
  endforeach ()
  forbid("${root}" Testing/Support "${programs}")
  forbid("${root}" Testing/Support "${tests}")
  forbid("${root}" Utilities "${test_support}")
  forbid("${root}" Utilities "${tests}")
  foreach (folder IN ITEMS Filters Rendering Plugin)
    forbid("${root}" ${folder} "Support/[A-Za-z]+/[A-Za-z0-9]+\\.h")
    forbid("${root}" ${folder} "${programs}")
  endforeach ()

  set(pipeline "vtk[A-Za-z0-9]*(Algorithm|Executive|Information|InformationVector|Pipeline)\\.h")
  set(datasets "vtk[A-Za-z0-9]*(DataSet|DataObject|Grid|ImageData|PolyData)\\.h")
  forbid("${root}" Filters/Isotables "${pipeline}")
  forbid("${root}" Filters/Isotables "${datasets}")

  header_pattern(filters "${root}/Filters/Isotables" "${root}/Filters/Intervals" "${root}/Filters/Flow"
    "${root}/Filters/Meshing" "${root}/Filters/Sources")
  header_pattern(rendering "${root}/Rendering")
  header_pattern(intervals "${root}/Filters/Intervals")
  header_pattern(flow "${root}/Filters/Flow")
  header_pattern(meshing "${root}/Filters/Meshing")
  header_pattern(sources_headers "${root}/Filters/Sources")
  header_pattern(not_sources "${root}/Filters/Isotables" "${root}/Filters/Intervals" "${root}/Filters/Flow")
  header_pattern(tetrahedra "${root}/Rendering/Tetrahedra")
  header_pattern(light "${root}/Rendering/Light")
  header_pattern(light_rooms "${root}/Rendering/Light/*")
  header_pattern(flow_texture "${root}/Rendering/FlowTexture")
  forbid("${root}" Rendering "${filters}")
  foreach (folder IN ITEMS Scene Light FlowTexture)
    forbid("${root}" Rendering/${folder} "${tetrahedra}")
  endforeach ()
  foreach (folder IN ITEMS Scene Tetrahedra)
    forbid("${root}" Rendering/${folder} "${light}")
  endforeach ()
  forbid("${root}" Rendering/FlowTexture "${light_rooms}")
  foreach (folder IN ITEMS Scene Tetrahedra Light)
    forbid("${root}" Rendering/${folder} "${flow_texture}")
  endforeach ()
  forbid("${root}" Filters/Common "${filters}")
  forbid("${root}" Filters/Common "${rendering}")
  forbid("${root}" Filters/Isotables "${intervals}")
  forbid("${root}" Filters/Isotables "${flow}")
  forbid("${root}" Filters/Intervals "${flow}")
  forbid("${root}" Filters/Sources "${not_sources}")
  forbid("${root}" Filters/Meshing "${not_sources}")
  foreach (folder IN ITEMS Isotables Intervals Flow Sources)
    forbid("${root}" Filters/${folder} "${meshing}")
  endforeach ()
  foreach (folder IN ITEMS Isotables Intervals Flow Meshing)
    forbid("${root}" Filters/${folder} "${sources_headers}")
  endforeach ()
  set(${output} "${breaches}" PARENT_SCOPE)
endfunction ()
