#pragma once

#include <vector>

#include "render/cpu/film_airlight.h"
#include "render/samples/contrast.h"
#include "render/scattering/environment_light.h"
#include "render/shading/film_surfaces.h"

namespace brume {

// The view of a pixel's samples.
struct SampledView {
  const FilmTiles& tiles;
  const FilmSurfaces* surfaces = nullptr;         // null: none
  const SharedHighlights* highlights = nullptr;   // of the frame's pixels; with surfaces
  bool are_lit = false;                           // else they are black
  const EnvironmentLight* environment = nullptr;  // null: none
  // Null: no medium.
  const MediumIndex* medium = nullptr;
  const AirlightIntegrator* method = nullptr;
  double fog_tolerance = 0.01;  // see Settings::upsampling_tolerance
  double picture_rms = 0.0;     // see Brightness
};

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

}  // namespace brume
