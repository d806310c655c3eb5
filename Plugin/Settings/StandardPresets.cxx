// SPDX-License-Identifier: BSD-3-Clause
// Sets the colors with which ParaView first shows arrays of the plugin's filters. Settings of the
// user have precedence.
#include "vtkSMSettings.h"

namespace
{
// Streaks of line integral convolution are gray.
constexpr const char* Presets = R"({ "standard_presets": { "LIC": "Grayscale" } })";

// Adds the presets when the plugin is loaded, with the priority of ParaView's own presets.
const bool IsAdded = vtkSMSettings::GetInstance()->AddCollectionFromString(Presets, 0.0);
}
