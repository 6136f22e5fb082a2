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
                      .says = "Scale of the map's radiance",
                      .step = 0.01,
                      .is_logarithmic = true}),
               field(&Environment::rotation, &EnvironmentKeys::rotation, domain::degrees,
                     {.name = "rotation",
                      .label = "Rotation",
                      .unit = "degrees",
                      .says = "Rotation about +y",
                      .step = 0.5})};

}  // namespace brume
