#pragma once

#include "brume/lights.h"
#include "core/scene/fields/field.h"

namespace brume {

template <>
inline constexpr auto fields<Environment> =
    std::tuple{field(&Environment::intensity, &EnvironmentKeys::intensity, domain::not_negative,
                     {.name = "intensity",
                      .label = "Intensity",
                      .unit = "",
                      .says = "Scale of the radiance of map, sky and its sun",
                      .step = 0.01,
                      .is_logarithmic = true}),
               field(&Environment::rotation, &EnvironmentKeys::rotation, domain::degrees,
                     {.name = "rotation",
                      .label = "Rotation",
                      .unit = "degrees",
                      .says = "Rotation about +y, of the sky's sun too",
                      .step = 0.5})};

template <>
inline constexpr auto fields<Sky> = std::tuple{
    field(&Sky::elevation, &SkyKeys::elevation, domain::elevation,
          {.name = "elevation",
           .label = "Elevation",
           .unit = "degrees",
           .says = "Elevation of the sun above the horizon; below it twilight, then night",
           .step = 0.1,
           .is_required = true}),
    field(&Sky::azimuth, &SkyKeys::azimuth, domain::degrees,
          {.name = "azimuth",
           .label = "Azimuth",
           .unit = "degrees",
           .says = "Where the sun is: 0 is -z, 90 is +x",
           .step = 0.5}),
    field(&Sky::turbidity, &SkyKeys::turbidity, domain::turbidity,
          {.name = "turbidity",
           .label = "Turbidity",
           .unit = "",
           .says = "Optical depth of air and haze relative to that of air alone, at 550 nm: 2 is "
                   "clear, 6 hazy, 1 has no haze",
           .step = 0.02}),
    field(&Sky::ground_albedo, &SkyKeys::ground_albedo, domain::unit,
          {.name = "ground_albedo",
           .label = "Ground albedo",
           .unit = "RGB",
           .says = "Albedo of the ground, which is the lower half of the sky and lights the air "
                   "from below",
           .step = 0.005}),
    field(&Sky::sun, domain::boolean,
          {.name = "sun",
           .label = "Sun",
           .unit = "",
           .says = "`true`: the sun is a directional light of the scene; `false`: the sky is "
                   "without it",
           .step = 1.0})};

}  // namespace brume
