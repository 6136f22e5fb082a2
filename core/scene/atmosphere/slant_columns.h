#pragma once

#include "core/scene/atmosphere/air.h"

namespace brume {

// The cosine of the zenith angle of the horizon that is seen from an altitude [km].
double cos_horizon(double altitude);

// All air from an altitude to the top of the atmosphere, in a direction above the horizon.
// Integrated: by 48 nodes within 1e-4 of it.
AirAmounts integrated_slant_columns(double altitude, double cos_zenith);

// The same from a table, within 0.3%; of directions below the horizon that of the horizon.
AirAmounts slant_columns(double altitude, double cos_zenith);

// The share of the sun's disc above the horizon seen from an altitude.
double visible_sun(double altitude, double cos_zenith);

}  // namespace brume
