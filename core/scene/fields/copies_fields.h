#pragma once

#include "brume/copies.h"
#include "core/scene/fields/field.h"

namespace brume {

template <>
inline constexpr auto fields<Scatter> =
    std::tuple{field(&Scatter::density, domain::not_negative,
                     {.name = "density",
                      .label = "Density",
                      .unit = "1/u^2",
                      .says = "Copies per area of the surface that they are scattered over",
                      .step = 0.01,
                      .is_logarithmic = true,
                      .is_required = true}),
               field(&Scatter::seed, domain::integer,
                     {.name = "seed",
                      .label = "Seed",
                      .unit = "",
                      .says = "Another seed gives other copies",
                      .step = 1.0}),
               field(&Scatter::scale, domain::length,
                     {.name = "scale",
                      .label = "Scale",
                      .unit = "",
                      .says = "The least and the greatest scale of a copy",
                      .step = 0.01,
                      .is_logarithmic = true}),
               field(&Scatter::max_turn, domain::turn,
                     {.name = "turn",
                      .label = "Turn",
                      .unit = "degrees",
                      .says = "How far a copy is turned about the normal at most, either way",
                      .step = 1.0})};

}  // namespace brume
