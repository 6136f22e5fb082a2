#pragma once

#include "brume/surface.h"
#include "core/scene/fields/field.h"

namespace brume {

// Their keyframes are among those of the surface.
template <>
inline constexpr auto fields<Material> =
    std::tuple{field(&Material::reflectance, &SurfaceKeys::reflectance, domain::unit,
                     {.name = "reflectance",
                      .label = "Reflectance",
                      .unit = "RGB",
                      .says = "Diffuse albedo, of diffuse and phong materials",
                      .step = 0.005}),
               field(&Material::specular, &SurfaceKeys::specular, domain::unit,
                     {.name = "specular",
                      .label = "Specular",
                      .unit = "RGB",
                      .says = "Reflectance of the highlight of a phong material",
                      .step = 0.005}),
               field(&Material::exponent, &SurfaceKeys::exponent, domain::not_negative,
                     {.name = "exponent",
                      .label = "Exponent",
                      .unit = "",
                      .says = "Exponent of a phong material: the higher, the smaller the highlight",
                      .step = 0.01,
                      .is_logarithmic = true})};

// The fields of its type.
inline void visit_fields_of(const Material& material, auto&& visit) {
  const bool is_phong = material.type == Material::Type::phong;
  const bool is_diffuse = material.type == Material::Type::diffuse;
  const auto& [reflectance, specular, exponent] = fields<Material>;
  if (is_phong || is_diffuse) visit(reflectance);
  if (!is_phong) return;
  visit(specular);
  visit(exponent);
}

template <>
inline constexpr auto fields<MetallicRoughness> = std::tuple{
    field(&MetallicRoughness::base_color, domain::unit,
          {.name = "base_color",
           .label = "Base colour",
           .unit = "RGB",
           .says = "Reflectance of a metal at normal incidence, or of what lies below the surface "
                   "of another material",
           .step = 0.005}),
    field(&MetallicRoughness::metallic, domain::unit,
          {.name = "metallic",
           .label = "Metallic",
           .unit = "",
           .says = "From other materials, such as wood or plastic, to metal",
           .step = 0.01}),
    field(&MetallicRoughness::roughness, domain::unit,
          {.name = "roughness",
           .label = "Roughness",
           .unit = "",
           .says = "From a mirror to almost diffuse",
           .step = 0.01}),
    field(&MetallicRoughness::emissive, domain::intensity,
          {.name = "emissive",
           .label = "Emissive",
           .unit = "RGB",
           .says = "Radiance that the surface emits in W/(sr u^2), seen by the eye, and a light",
           .step = 0.01}),
    field(&MetallicRoughness::normal_scale, domain::normal_scale,
          {.name = "normal_scale",
           .label = "Normal scale",
           .unit = "",
           .says = "Multiplies the slopes of the normal map",
           .step = 0.01,
           .is_always_saved = false}),
    field(
        &MetallicRoughness::opacity, domain::unit,
        {.name = "opacity",
         .label = "Opacity",
         .unit = "",
         .says = "Share of the surface that is there, of `cutout` and `blend`; times the alpha of "
                 "the base colour texture",
         .step = 0.01,
         .is_always_saved = false}),
    field(&MetallicRoughness::alpha_cutoff, domain::unit,
          {.name = "alpha_cutoff",
           .label = "Alpha cutoff",
           .unit = "",
           .says = "Where less than this share is there, `cutout` has a hole",
           .step = 0.01,
           .is_always_saved = false}),
    field(&MetallicRoughness::transmission, domain::unit,
          {.name = "transmission",
           .label = "Transmission",
           .unit = "RGB",
           .says = "Share of light that crosses the surface as a thin pane, unbent",
           .step = 0.005,
           .is_always_saved = false})};

}  // namespace brume
