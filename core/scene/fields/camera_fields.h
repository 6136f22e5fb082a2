#pragma once

#include "brume/camera.h"
#include "core/scene/fields/field.h"

namespace brume {

template <>
inline constexpr auto fields<Camera> = std::tuple{
    field(&Camera::eye, &CameraKeys::eye, domain::coordinate,
          {.name = "eye",
           .label = "Position",
           .unit = "u",
           .says = "Position of the eye",
           .step = 0.01,
           .is_keyed_jointly = true}),
    field(&Camera::target, &CameraKeys::target, domain::coordinate,
          {.name = "target",
           .label = "Looks at",
           .unit = "u",
           .says = "The point that the camera looks at, any but the eye",
           .step = 0.01,
           .is_keyed_jointly = true}),
    field(&Camera::up, domain::coordinate,
          {.name = "up",
           .label = "Up",
           .unit = "",
           .says = "The direction that is up in the picture, of any length but 0",
           .step = 0.01}),
    field(&Camera::vertical_fov, &CameraKeys::vertical_fov, domain::field_of_view,
          {.name = "vertical_fov",
           .label = "Field of view",
           .unit = "degrees",
           .says = "Full angle of view from the bottom to the top of the picture",
           .step = 0.1,
           .is_keyed_jointly = true}),
    field(&Camera::height, &CameraKeys::height, domain::length,
          {.name = "height",
           .label = "Height",
           .unit = "u",
           .says = "Of an orthographic camera, in place of vertical_fov: height of what it sees, "
                   "from edge to edge; it sees from the plane of `eye` on, and has no lens that "
                   "blurs",
           .step = 0.01,
           .is_logarithmic = true,
           .absent = "a perspective camera",
           .is_always_saved = false,
           .is_keyed_jointly = true,
           .replaces = {"vertical_fov", "aperture"}}),
    field(
        &Camera::aperture, &CameraKeys::aperture, domain::not_negative,
        {.name = "aperture",
         .label = "Aperture",
         .unit = "u",
         .says = "Radius of the lens: the larger, the more is blurred before and behind the plane "
                 "in focus; 0 is a pinhole, which has everything in focus",
         .step = 0.005,
         .is_always_saved = false,
         .is_track_optional = true}),
    field(&Camera::focus_distance, &CameraKeys::focus_distance, domain::length,
          {.name = "focus_distance",
           .label = "Focus distance",
           .unit = "u",
           .says = "Distance along the view axis of the plane in focus",
           .step = 0.01,
           .is_logarithmic = true,
           .absent = "that of the target",
           .is_always_saved = false}),
    field(&Camera::roll, &CameraKeys::roll, domain::degrees,
          {.name = "roll",
           .label = "Roll",
           .unit = "degrees",
           .says = "Turns the camera about the way it looks, after `up`: positive leans its top to "
                   "its own right, so the picture turns to the left",
           .step = 0.1,
           .is_always_saved = false,
           .is_track_optional = true})};

}  // namespace brume
