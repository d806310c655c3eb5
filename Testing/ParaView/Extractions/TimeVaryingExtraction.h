// SPDX-License-Identifier: BSD-3-Clause
#ifndef TimeVaryingExtraction_h
#define TimeVaryingExtraction_h

#include "vtkSmartPointer.h"

#include <nlohmann/json.hpp>

class vtkAlgorithm;
class vtkTimeVaryingIntervalVolume;

/**
 * A temporal source, as JSON says: `source` is `AnalyticField` or `TaperedCylinderWake`,
 * `source_properties` have the names and values that the properties of the source have in the
 * plugin's XML. Not yet updated.
 * @throw std::runtime_error for a property that is not one of those the tests set.
 */
vtkSmartPointer<vtkAlgorithm> MakeTemporalSource(const nlohmann::json& extraction);

/**
 * The filter over such a source; `properties` are the filter's.
 * @throw std::runtime_error for a property that is not one of those the tests set.
 */
vtkSmartPointer<vtkTimeVaryingIntervalVolume> MakeTimeVaryingVolume(
  const nlohmann::json& extraction);

#endif
