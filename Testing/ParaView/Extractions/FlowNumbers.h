// SPDX-License-Identifier: BSD-3-Clause
#ifndef FlowNumbers_h
#define FlowNumbers_h

#include <nlohmann/json.hpp>

/**
 * Flow fields, mappings and volumes, as MakeFlowVolume takes them, with what came out: `points`,
 * the measures of the samples (numbers by status and id, sums of parameters, times and Inflow), and
 * `outputs`, the MeasureExtraction of the volume and its stream and time surfaces; where there is
 * an axis its number of `axis_points`, and `critical_points`, their number by type.
 */
nlohmann::json MeasureFlowVolumes();

#endif
