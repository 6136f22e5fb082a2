#pragma once

#include <span>
#include <vector>

#include "render/cpu/tile_sampler.h"

namespace brume {

// Filters the pixels of a frame that have details, by `count` samples as pixel_samples() has them,
// and by up to 16 times as many where those differ by so much that the pixel would be off by more
// than 10% of the picture's rms. Surfaces and environment are seen by every sample. The fog in
// front of surfaces is not paid for as often: samples of a pixel that are about as far away share
// one ray, or take the fog of a pixel beside them that is. Only details of the fog itself take a
// ray per sample.
//
// `frame` is complete, of one sample a pixel. Returns the Gaussian x ray pairs evaluated from the
// eye; those from lights are added to the statistics.
std::uint64_t sample_film(const SampledView& view, std::vector<PixelDetail> details, int count,
                          const Job& job, Frame& frame);

// Sets the pixels that `sees_panes` names, of tiles so far from the region at most (see
// FilmWindow), to what one ray through their centers sees, of the first surface that is more than
// half opaque their depth. The rest as for sample_film().
std::uint64_t see_through_panes(const SampledView& view, std::span<const PixelDetail> sees_panes,
                                int distance, const Job& job, Frame& frame);

}  // namespace brume
