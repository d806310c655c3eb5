# SPDX-License-Identifier: BSD-3-Clause
# find_breaches(ROOT OUTPUT): lists the lines under ROOT that cross an edge between modules that
# Documentation/architecture.md does not have, each as "file: line".
#   - ParaView's headers only in Plugin/
#   - the programs below Utilities/ know no test
#   - a rendering module knows no module under Filters/; Scene <- Tetrahedra, Light, FlowTexture, which do
#     not know each other, but that FlowTexture knows what is public of Light
#   - Isotables knows no pipeline and no dataset; Isotables <- Intervals <- Flow; Sources and Meshing on VTK
#     alone, and no filter module uses them
#   - Filters/Common is for all modules, and knows none

# The names of a module's headers, as one regular expression; one that matches nothing if it has none.
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

# Appends to `breaches` the lines in the folder's sources that include a header of the pattern.
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
  # vtkSMPTools and its like are VTK's: after vtkSM, ParaView's have a capital and a small letter.
  set(paraview "(vtkPV[A-Z]|vtkSM[A-Z][a-z]|vtkSI[A-Z][a-z]|vtkClientServer|pq[A-Z])[A-Za-z0-9]*\\.h")
  foreach (folder IN ITEMS Filters Rendering Testing Examples Utilities)
    forbid("${root}" ${folder} "${paraview}")
  endforeach ()
  header_pattern(tests "${root}/Testing")
  forbid("${root}" Utilities "${tests}")

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
