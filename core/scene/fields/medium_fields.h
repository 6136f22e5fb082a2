#pragma once

#include "brume/scene.h"
#include "core/scene/fields/field.h"

namespace brume {

template <>
inline constexpr auto fields<MediumOptics> = std::tuple{
    field(&MediumOptics::albedo, &MediumKeys::albedo, domain::albedo,
          {.name = "albedo",
           .label = "Albedo",
           .unit = "RGB",
           .says = "Single-scattering albedo: the fraction of the attenuated light that "
                   "is scattered, the rest is absorbed",
           .step = 0.005,
           .is_always_saved = false}),
    field(&MediumOptics::anisotropy, &MediumKeys::anisotropy, domain::anisotropy,
          {.name = "anisotropy",
           .label = "Anisotropy",
           .unit = "",
           .says = "g of the Henyey-Greenstein phase function: 0 isotropic, positive "
                   "forward, negative backward",
           .step = 0.005,
           .is_always_saved = false}),
    field(&MediumOptics::extent, &MediumKeys::extent, domain::length,
          {.name = "extent",
           .label = "Homogeneous extent",
           .unit = "u",
           .says = "How far homogeneous fog reaches from the middle of the scene, of the "
                   "box around surfaces and Gaussians: it is in a ball of this radius",
           .step = 0.01,
           .is_logarithmic = true,
           .absent = "as far as the view, for light from far away the scene's diameter",
           .is_always_saved = false})};

template <>
inline constexpr auto fields<Noise> = std::tuple{
    field(&Noise::amplitude, &NoiseKeys::amplitude, domain::not_negative,
          {.name = "amplitude",
           .label = "Amplitude",
           .unit = "",
           .says = "Rms displacement of a ray over the radius of the Gaussian that it passes; 0 is "
                   "off",
           .step = 0.005}),
    field(&Noise::frequency, &NoiseKeys::frequency, domain::not_negative,
          {.name = "frequency",
           .label = "Frequency",
           .unit = "1/u",
           .says = "Cells per u",
           .step = 0.01,
           .is_logarithmic = true}),
    field(&Noise::velocity, &NoiseKeys::velocity, domain::coordinate,
          {.name = "velocity",
           .label = "Wind",
           .unit = "u/s",
           .says = "Velocity of the noise",
           .step = 0.01}),
    field(&Noise::seed, domain::integer,
          {.name = "seed",
           .label = "Seed",
           .unit = "",
           .says = "Another seed gives another noise",
           .step = 1.0})};

}  // namespace brume
