# SPDX-License-Identifier: BSD-3-Clause
# Widgets of the properties panel. Included only if the ParaView client is built.
paraview_plugin_add_property_widget(
  KIND       WIDGET
  TYPE       interlume_intervals
  CLASS_NAME pqIntervalsPropertyWidget
  INTERFACES panel_interfaces
  SOURCES    panel_sources)
paraview_plugin_add_property_widget(
  KIND       WIDGET
  TYPE       interlume_report
  CLASS_NAME pqReportPropertyWidget
  INTERFACES report_interfaces
  SOURCES    report_sources)
paraview_plugin_add_property_widget(
  KIND       GROUP_WIDGET
  TYPE       interlume_area_light
  CLASS_NAME pqAreaLightPropertyWidget
  INTERFACES area_light_interfaces
  SOURCES    area_light_sources)
paraview_plugin_add_property_widget(
  KIND       WIDGET_DECORATOR
  TYPE       interlume_live
  CLASS_NAME pqLivePreviewDecorator
  INTERFACES live_interfaces
  SOURCES    live_sources)
paraview_plugin_add_auto_start(
  CLASS_NAME pqHyphenInSearch
  STARTUP    startup
  SHUTDOWN   shutdown
  INTERFACES search_interfaces
  SOURCES    search_sources)
paraview_plugin_add_auto_start(
  CLASS_NAME pqProgressiveViews
  STARTUP    startup
  SHUTDOWN   shutdown
  INTERFACES progressive_interfaces
  SOURCES    progressive_sources)
paraview_plugin_add_auto_start(
  CLASS_NAME pqLiveDisplaySliders
  STARTUP    startup
  SHUTDOWN   shutdown
  INTERFACES slider_interfaces
  SOURCES    slider_sources)
paraview_plugin_add_action_group(
  CLASS_NAME pqSourceCells
  GROUP_NAME "MenuBar/Edit"
  INTERFACES cells_interfaces
  SOURCES    cells_sources)
if (TARGET Qt5::Gui)
  find_package(Qt5X11Extras QUIET)
endif ()
list(APPEND panel_interfaces
  ${area_light_interfaces} ${cells_interfaces} ${live_interfaces} ${progressive_interfaces}
  ${report_interfaces} ${search_interfaces} ${slider_interfaces})
list(APPEND panel_sources
  ${area_light_sources}
  ${live_sources}
  ${progressive_sources}
  ${report_sources}
  ${search_sources}
  ${cells_sources}
  ${slider_sources}
  "${CMAKE_CURRENT_SOURCE_DIR}/Panels/PendingInput.cxx"
  "${CMAKE_CURRENT_SOURCE_DIR}/Panels/PendingInput.h"
  "${CMAKE_CURRENT_SOURCE_DIR}/Panels/pqAreaLightPropertyWidget.cxx"
  "${CMAKE_CURRENT_SOURCE_DIR}/Panels/pqAreaLightPropertyWidget.h"
  "${CMAKE_CURRENT_SOURCE_DIR}/Panels/pqHyphenInSearch.cxx"
  "${CMAKE_CURRENT_SOURCE_DIR}/Panels/pqHyphenInSearch.h"
  "${CMAKE_CURRENT_SOURCE_DIR}/Panels/pqIntervalsPropertyWidget.cxx"
  "${CMAKE_CURRENT_SOURCE_DIR}/Panels/pqIntervalsPropertyWidget.h"
  "${CMAKE_CURRENT_SOURCE_DIR}/Panels/pqLiveDisplaySliders.cxx"
  "${CMAKE_CURRENT_SOURCE_DIR}/Panels/pqLiveDisplaySliders.h"
  "${CMAKE_CURRENT_SOURCE_DIR}/Panels/pqLivePreviewDecorator.cxx"
  "${CMAKE_CURRENT_SOURCE_DIR}/Panels/pqLivePreviewDecorator.h"
  "${CMAKE_CURRENT_SOURCE_DIR}/Panels/pqProgressiveViews.cxx"
  "${CMAKE_CURRENT_SOURCE_DIR}/Panels/pqProgressiveViews.h"
  "${CMAKE_CURRENT_SOURCE_DIR}/Panels/pqReportPropertyWidget.cxx"
  "${CMAKE_CURRENT_SOURCE_DIR}/Panels/pqReportPropertyWidget.h"
  "${CMAKE_CURRENT_SOURCE_DIR}/Panels/pqSourceCells.cxx"
  "${CMAKE_CURRENT_SOURCE_DIR}/Panels/pqSourceCells.h")
# ParaView generates sources of the interfaces, which define the same macros.
set(interface_sources ${panel_sources})
list(FILTER interface_sources INCLUDE REGEX "Implementation[.]cxx$")
set_source_files_properties(${interface_sources} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
