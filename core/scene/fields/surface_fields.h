#pragma once

#include "brume/surface.h"
#include "core/scene/fields/field.h"

namespace brume {

template <>
inline constexpr auto fields<Surface> = std::tuple{
    field(&Surface::visible, domain::boolean,
          {.name = "visible",
           .label = "Visible",
           .unit = "",
           .says = "`false` hides it: it is neither seen nor does it cast shadows or reflect light",
           .step = 1.0,
           .is_always_saved = false}),
    field(&Surface::locked, domain::boolean,
          {.name = "locked",
           .label = "Locked",
           .unit = "",
           .says = "`true`: the editor's view neither selects nor moves it",
           .step = 1.0,
           .is_always_saved = false}),
    field(&Surface::holdout, domain::boolean,
          {.name = "holdout",
           .label = "Holdout",
           .unit = "",
           .says =
               "`true`: the camera sees none of it, but what the picture is laid over, through "
               "the fog in front of it; it ends the fog, casts shadows and reflects light as ever",
           .step = 1.0,
           .is_always_saved = false})};

}  // namespace brume
