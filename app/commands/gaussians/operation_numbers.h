#pragma once

#include "core/authoring/fog_shapes.h"
#include "core/scene/fields/field.h"

namespace brume {

// The numbers of operations that can be adjusted (app/document/last_operation.h), described as the
// values of a scene are, for forms. An emitter has those of its own.

// More homogeneous density.
struct EvenFog {
  double density = 0.0;  // [1/u]
};

// The change that simplifying may make.
struct SimplifyNumbers {
  double max_error = 1.0;  // [%]
  bool ellipsoids = true;
};

// The place and the size of imported surfaces or Gaussians are: first scaled about the origin, then
// moved.
struct ImportPlacement {
  double scale = 1.0;
  glm::dvec3 position{0.0};
};

namespace domain {

inline constexpr NumberDomain flatness{1.0, 20.0, "a number from 1 to 20"};
inline constexpr NumberDomain pattern{0.0, 1e9, "an integer from 0 to 1e9"};
inline constexpr NumberDomain column_count{1.0, 10'000.0, "an integer from 1 to 10,000"};
inline constexpr NumberDomain percent{0.01, 100.0, "a number from 0.01 to 100"};

}  // namespace domain

template <>
inline constexpr auto fields<EvenFog> =
    std::tuple{field(&EvenFog::density, domain::density,
                     {.name = "density",
                      .label = "Density",
                      .unit = "1/u",
                      .says = "By how much the homogeneous density rises",
                      .step = 0.01,
                      .is_logarithmic = true})};

template <>
inline constexpr auto fields<SimplifyNumbers> = std::tuple{
    field(
        &SimplifyNumbers::max_error, domain::percent,
        {.name = "error",
         .label = "Max error",
         .unit = "%",
         .says = "Gaussians that overlap are merged while lines through the fog keep their optical "
                 "depth up to this, relative RMS",
         .step = 0.02,
         .is_logarithmic = true}),
    field(&SimplifyNumbers::ellipsoids, domain::boolean,
          {.name = "ellipsoids",
           .label = "Ellipsoids",
           .unit = "",
           .says = "What is merged may be ellipsoids: fewer are left along strands and layers of "
                   "fog. Else it is balls",
           .step = 1.0})};

template <>
inline constexpr auto fields<ImportPlacement> =
    std::tuple{field(&ImportPlacement::scale, domain::length,
                     {.name = "scale",
                      .label = "Scale",
                      .unit = "",
                      .says = "The size of what is imported, over that in its file",
                      .step = 0.01,
                      .is_logarithmic = true}),
               field(&ImportPlacement::position, domain::coordinate,
                     {.name = "position",
                      .label = "Position",
                      .unit = "u",
                      .says = "Where the origin of the file is",
                      .step = 0.01})};

template <>
inline constexpr auto fields<FogShape> = std::tuple{
    field(&FogShape::center, domain::coordinate,
          {.name = "center",
           .label = "Centre",
           .unit = "u",
           .says = "Of height fog the middle of its footprint, on the ground",
           .step = 0.01}),
    field(&FogShape::size, domain::length,
          {.name = "size",
           .label = "Size",
           .unit = "u",
           .says = "Edges or diameters; of height fog y is the height over which its density falls "
                   "to 1/e, of a layer its thickness",
           .step = 0.01,
           .is_logarithmic = true}),
    field(&FogShape::density, domain::density,
          {.name = "density",
           .label = "Density",
           .unit = "1/u",
           .says = "Scattering coefficient within the shape; of height fog at the ground",
           .step = 0.01,
           .is_logarithmic = true}),
    field(&FogShape::spacing, domain::length,
          {.name = "spacing",
           .label = "Spacing",
           .unit = "u",
           .says = "Distance between Gaussians along y; their radius is 0.8 of it",
           .step = 0.01,
           .is_logarithmic = true}),
    field(&FogShape::flatness, domain::flatness,
          {.name = "flatness",
           .label = "Flatness",
           .unit = "",
           .says = "So many times as wide as high are the Gaussians, and as far apart: fewer for "
                   "layers",
           .step = 0.01,
           .is_logarithmic = true}),
    field(&FogShape::jitter, domain::unit,
          {.name = "jitter",
           .label = "Jitter",
           .unit = "",
           .says = "0: an even lattice; 1: random within its cells, so that the fog is patchy",
           .step = 0.01}),
    field(&FogShape::seed, domain::pattern,
          {.name = "seed",
           .label = "Seed",
           .unit = "",
           .says = "Another number makes another pattern",
           .step = 1.0})};

template <>
inline constexpr auto fields<FogColumn> =
    std::tuple{field(&FogColumn::foot, domain::coordinate,
                     {.name = "foot",
                      .label = "Foot",
                      .unit = "u",
                      .says = "Where it rises from",
                      .step = 0.01}),
               field(&FogColumn::height, domain::length,
                     {.name = "height",
                      .label = "Height",
                      .unit = "u",
                      .says = "How high it rises",
                      .step = 0.01,
                      .is_logarithmic = true}),
               field(&FogColumn::width, domain::length,
                     {.name = "width",
                      .label = "Width",
                      .unit = "u",
                      .says = "How wide it is at the foot",
                      .step = 0.01,
                      .is_logarithmic = true}),
               field(&FogColumn::spread, domain::unit,
                     {.name = "spread",
                      .label = "Spread",
                      .unit = "",
                      .says = "By how much its radius grows, relative to the height risen",
                      .step = 0.01}),
               field(&FogColumn::lean, domain::coordinate,
                     {.name = "lean",
                      .label = "Lean",
                      .unit = "u",
                      .says = "How far the wind moves its top",
                      .step = 0.01}),
               field(&FogColumn::density, domain::density,
                     {.name = "density",
                      .label = "Density",
                      .unit = "1/u",
                      .says = "Scattering coefficient at the foot",
                      .step = 0.01,
                      .is_logarithmic = true}),
               field(&FogColumn::count, domain::column_count,
                     {.name = "count",
                      .label = "Gaussians",
                      .unit = "",
                      .says = "How many Gaussians it is made of",
                      .step = 0.02,
                      .is_logarithmic = true}),
               field(&FogColumn::turbulence, domain::unit,
                     {.name = "turbulence",
                      .label = "Turbulence",
                      .unit = "",
                      .says = "How far Gaussians are off its axis, relative to its radius",
                      .step = 0.01}),
               field(&FogColumn::seed, domain::pattern,
                     {.name = "seed",
                      .label = "Seed",
                      .unit = "",
                      .says = "Another number makes another pattern",
                      .step = 1.0})};

}  // namespace brume
