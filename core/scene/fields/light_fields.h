#pragma once

#include <array>
#include <set>
#include <string_view>
#include <utility>

#include "brume/lights.h"
#include "core/scene/fields/field.h"

namespace brume {

// The names of kinds of light, in the order of Light::Kind.
struct LightKindInfo {
  const char* name;   // in files and in Python
  const char* label;  // in forms: "Directional"
  const char* title;  // of a light without a name: "Sun"
  const char* says;   // in one sentence
};
inline constexpr std::array light_kinds{
    LightKindInfo{"point", "Point", "Light", "Shines in all directions"},
    LightKindInfo{"spot", "Spot", "Spot", "Shines in a cone"},
    LightKindInfo{"directional", "Directional", "Sun", "The sun: far away, its rays are parallel"},
    LightKindInfo{"rectangle", "Rectangle", "Rectangle", "A surface that shines"},
    LightKindInfo{"disk", "Disc", "Disc light", "A surface that shines"},
    LightKindInfo{"sphere", "Sphere", "Sphere", "A surface that shines"}};
static_assert(light_kinds.size() == std::variant_size_v<Light::Kind>);

inline const LightKindInfo& kind_info(const Light& light) {
  return light_kinds[light.kind.index()];
}

// Calls visit(name, kind) for each kind of light, with its usual values.
void visit_light_kinds(auto&& visit) {
  [&]<std::size_t... k>(std::index_sequence<k...>) {
    (visit(light_kinds[k], std::variant_alternative_t<k, Light::Kind>()), ...);
  }
  (std::make_index_sequence<light_kinds.size()>());
}

// The kind of an index, with its usual values.
inline Light::Kind light_kind(std::size_t index) {
  Light::Kind found;
  std::size_t k = 0;
  visit_light_kinds([&](const auto&, const auto& kind) {
    if (k++ == index) found = kind;
  });
  return found;
}

// The member `profile` of a kind that has one, or else null.
auto* profile_member(auto& light) {
  using Profile = std::conditional_t<std::is_const_v<std::remove_reference_t<decltype(light)>>,
                                     const LightProfile, LightProfile>;
  return std::visit(
      [](auto& kind) -> Profile* {
        if constexpr (requires { kind.profile; }) {
          return &kind.profile;
        } else {
          return nullptr;
        }
      },
      light.kind);
}
// The profile of a light that has one, or else null.
auto* profile_of(auto& light) {
  auto* profile = profile_member(light);
  return profile && profile->content ? profile : nullptr;
}

// The picture in the beam of a spot that has one, or else null.
auto* texture_of(auto& light) {
  auto* spot = light.template as<light::Spot>();
  return spot && !spot->texture.file.empty() ? &spot->texture : nullptr;
}

// The value of a light of a kind.
template <class Kind, class T>
struct OfKind {
  T Kind::*value;
  constexpr auto& operator()(auto& light) const { return std::get<Kind>(light.kind).*value; }
};

namespace light_field {

inline constexpr auto position = field(&Light::position, &LightKeys::position, domain::coordinate,
                                       {.name = "position",
                                        .label = "Position",
                                        .unit = "u",
                                        .says = "Where it is, of a surface its centre",
                                        .step = 0.01,
                                        .is_required = true});

// The meaning of its strength depends on the kind.
constexpr auto strength(const FieldInfo& info) {
  return field(&Light::intensity, &LightKeys::intensity, domain::intensity, info);
}
inline constexpr auto intensity =
    strength({.name = "intensity",
              .label = "Intensity",
              .unit = "W/sr",
              .says = "Radiant intensity, RGB; of a spot on its axis, with a profile in its "
                      "brightest direction",
              .step = 0.01,
              .is_logarithmic = true});
inline constexpr auto irradiance =
    strength({.name = "irradiance",
              .label = "Irradiance",
              .unit = "W/u^2",
              .says = "Irradiance on a surface that faces it, without any medium, RGB",
              .step = 0.01,
              .is_logarithmic = true,
              .is_required = true});
inline constexpr auto radiance =
    strength({.name = "radiance",
              .label = "Radiance",
              .unit = "W/(sr u^2)",
              .says = "Radiance of every point of it in every direction, RGB",
              .step = 0.01,
              .is_logarithmic = true,
              .is_required = true});

template <class Kind, class T, class K>
constexpr auto of_kind(T Kind::*value, Keys<K> LightKeys::*keys, const NumberDomain& domain,
                       const FieldInfo& info) {
  return field_within<Light>(OfKind<Kind, T>{value}, keys, domain, info);
}

template <class Kind>
inline constexpr auto direction =
    of_kind(&Kind::direction, &LightKeys::direction, domain::coordinate,
            {.name = "direction",
             .label = "Direction",
             .unit = "",
             .says = "The way it shines, of a rectangle or disc the normal of the side that "
                     "shines; of any length but 0",
             .step = 0.01,
             .is_required = true});

template <class Kind>
inline constexpr auto radius = of_kind(&Kind::radius, &LightKeys::radius, domain::length,
                                       {.name = "radius",
                                        .label = "Radius",
                                        .unit = "u",
                                        .says = "Its radius",
                                        .step = 0.01,
                                        .is_logarithmic = true,
                                        .is_required = true});

template <class Kind>
inline constexpr auto two_sided = field_within<Light>(
    OfKind<Kind, bool>{&Kind::two_sided}, domain::boolean,
    {.name = "two_sided",
     .label = "Two-sided",
     .unit = "",
     .says = "Whether it shines to both sides; a sphere then also lights what is inside it",
     .step = 1.0});

template <class Kind>
inline constexpr auto visible = field_within<Light>(
    OfKind<Kind, bool>{&Kind::visible}, domain::boolean,
    {.name = "visible",
     .label = "Visible",
     .unit = "",
     .says = "Whether the eye sees it, also in mirrors and through panes, from the sides that it "
             "shines to; it still keeps no light out",
     .step = 1.0,
     .is_always_saved = false});

}  // namespace light_field

// The values that every light has.
template <>
inline constexpr auto fields<Light> =
    std::tuple{field(&Light::on, domain::boolean,
                     {.name = "on",
                      .label = "On",
                      .unit = "",
                      .says = "`false` turns it off and keeps its values",
                      .step = 1.0,
                      .is_always_saved = false}),
               field(&Light::locked, domain::boolean,
                     {.name = "locked",
                      .label = "Locked",
                      .unit = "",
                      .says = "`true`: the editor does not change it in the view",
                      .step = 1.0,
                      .is_always_saved = false})};

template <>
inline constexpr auto fields<light::Point> =
    std::tuple{light_field::position, light_field::intensity};

template <>
inline constexpr auto fields<light::Spot> = std::tuple{
    light_field::position, light_field::direction<light::Spot>, light_field::intensity,
    light_field::of_kind(&light::Spot::inner_angle, &LightKeys::inner_angle, domain::cone_angle,
                         {.name = "inner_angle",
                          .label = "Inner angle",
                          .unit = "degrees",
                          .says = "Angle from the axis within which its light is full, at most the "
                                  "outer one; equal angles make a hard edge",
                          .step = 0.25}),
    light_field::of_kind(&light::Spot::outer_angle, &LightKeys::outer_angle, domain::cone_angle,
                         {.name = "outer_angle",
                          .label = "Outer angle",
                          .unit = "degrees",
                          .says = "Angle from the axis beyond which it is dark, above 0",
                          .step = 0.25})};

template <>
inline constexpr auto fields<light::Directional> =
    std::tuple{light_field::direction<light::Directional>, light_field::irradiance,
               light_field::of_kind(&light::Directional::angular_diameter,
                                    &LightKeys::angular_diameter, domain::angular_diameter,
                                    {.name = "angular_diameter",
                                     .label = "Angular diameter",
                                     .unit = "degrees",
                                     .says = "Angle that its disc fills: the wider, the softer its "
                                             "shadows, at the cost of eight lights; the "
                                             "sun's is 0.53",
                                     .step = 0.01})};

template <>
inline constexpr auto fields<light::Rectangle> = std::tuple{
    light_field::position,
    light_field::direction<light::Rectangle>,
    light_field::radiance,
    light_field::of_kind(&light::Rectangle::width, &LightKeys::width, domain::length,
                         {.name = "width",
                          .label = "Width",
                          .unit = "u",
                          .says = "Its width",
                          .step = 0.01,
                          .is_logarithmic = true,
                          .is_required = true}),
    light_field::of_kind(&light::Rectangle::height, &LightKeys::height, domain::length,
                         {.name = "height",
                          .label = "Height",
                          .unit = "u",
                          .says = "Its height",
                          .step = 0.01,
                          .is_logarithmic = true,
                          .is_required = true}),
    light_field::of_kind(&light::Rectangle::up, &LightKeys::up, domain::coordinate,
                         {.name = "up",
                          .label = "Up",
                          .unit = "",
                          .says = "The direction of its height, as far as the normal leaves it",
                          .step = 0.01}),
    light_field::two_sided<light::Rectangle>,
    light_field::visible<light::Rectangle>};

template <>
inline constexpr auto fields<light::Disk> = std::tuple{light_field::position,
                                                       light_field::direction<light::Disk>,
                                                       light_field::radiance,
                                                       light_field::radius<light::Disk>,
                                                       light_field::two_sided<light::Disk>,
                                                       light_field::visible<light::Disk>};

template <>
inline constexpr auto fields<light::Sphere> =
    std::tuple{light_field::position, light_field::radiance, light_field::radius<light::Sphere>,
               light_field::two_sided<light::Sphere>, light_field::visible<light::Sphere>};

// The values of a light with a profile.
template <>
inline constexpr auto fields<LightProfile> = std::tuple{field_within<Light>(
    [](auto& light) -> auto& { return profile_member(light)->rotation; },
    &LightKeys::profile_rotation, domain::degrees,
    {.name = "profile_rotation",
     .label = "Profile rotation",
     .unit = "degrees",
     .says = "Rotation of the profile about its axis, counterclockwise as seen against it; at 0 "
             "its horizontal angle 0 is +x, its 90 is −z",
     .step = 0.5})};

// The values of a spot with a picture in its beam.
template <>
inline constexpr auto fields<LightTexture> = std::tuple{
    field_within<Light>(
        [](auto& light) -> auto& { return light.template as<light::Spot>()->texture.rotation; },
        &LightKeys::texture_rotation, domain::degrees,
        {.name = "texture_rotation",
         .label = "Texture rotation",
         .unit = "degrees",
         .says = "Rotation of the picture in its beam about the axis, counterclockwise as seen "
                 "from the light",
         .step = 0.5}),
    field_within<Light>(
        [](auto& light) -> auto& { return light.template as<light::Spot>()->texture.focus; },
        &LightKeys::texture_focus, domain::unit,
        {.name = "texture_focus",
         .label = "Texture focus",
         .unit = "",
         .says = "How sharp the picture in its beam is: 1 sharp, 0 blurred to the size of the cone",
         .step = 0.01})};

// The fields of a light: those of its kind, of its profile and texture, and of every light.
inline void visit_fields_of(const Light& light, auto&& visit) {
  std::visit([&]<class Kind>(const Kind&) { visit_fields<Kind>(visit); }, light.kind);
  if (profile_of(light)) visit_fields<LightProfile>(visit);
  if (texture_of(light)) visit_fields<LightTexture>(visit);
  visit_fields<Light>(visit);
}

// A light of the same kind with its usual values.
inline Light usual(const Light& light) {
  return {.kind = light_kind(light.kind.index())};
}

template <class F>
bool is_strength(const F& field) {
  if constexpr (std::is_same_v<decltype(field.get), glm::dvec3 Light::*>) {
    return field.get == &Light::intensity;
  }
  return false;
}

// The name of a light's intensity.
inline const FieldInfo& strength_info(const Light& light) {
  const FieldInfo* info = nullptr;
  visit_fields_of(light, [&info](const auto& field) {
    if (is_strength(field)) info = &field.info;
  });
  return *info;
}

// Calls visit(field, light) for each value that any light may have, with the first kind of light
// that has it.
void visit_light_fields(auto&& visit) {
  std::set<std::string_view> seen;
  Light light;
  const auto visit_new = [&](const auto& field) {
    if (seen.insert(field.info.name).second) visit(field, std::as_const(light));
  };
  visit_light_kinds([&]<class Kind>(const auto&, const Kind& kind) {
    light.kind = kind;
    visit_fields<Kind>(visit_new);
  });
  light.kind = light::Spot{};
  visit_fields<LightTexture>(visit_new);
  light.kind = {};
  visit_fields<LightProfile>(visit_new);
  visit_fields<Light>(visit_new);
}

// The value of a type that a light has under a name; null if its kind has none.
template <class T>
auto* find_value(auto& light, std::string_view name) {
  using Value =
      std::conditional_t<std::is_const_v<std::remove_reference_t<decltype(light)>>, const T, T>;
  Value* found = nullptr;
  visit_fields_of(light, [&]<class F>(const F& field) {
    if constexpr (std::is_same_v<typename F::Value, T>) {
      if (name == field.info.name) found = &field.of(light);
    }
  });
  return found;
}

}  // namespace brume
