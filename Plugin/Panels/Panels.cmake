# SPDX-License-Identifier: BSD-3-Clause
# The widgets of the properties panel, where ParaView has its client.
set(CMAKE_AUTOMOC ON)
paraview_plugin_add_property_widget(
  KIND       WIDGET
  TYPE       interlume_intervals
  CLASS_NAME pqIntervalsPropertyWidget
  INTERFACES panel_interfaces
  SOURCES    panel_sources)
list(APPEND panel_sources
  "${CMAKE_CURRENT_SOURCE_DIR}/Panels/pqIntervalsPropertyWidget.cxx"
  "${CMAKE_CURRENT_SOURCE_DIR}/Panels/pqIntervalsPropertyWidget.h")
