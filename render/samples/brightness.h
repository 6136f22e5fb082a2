#pragma once

#include <optional>

#include "core/scene/camera_rays.h"
#include "render/frame_renderer.h"
#include "render/util/job.h"

namespace brume {

// The brightness of the pixels of a frame.
Brightness brightness_of(const Frame& frame, const CameraRays::PixelRectangle& pixels);

// That of a small picture of the whole film, the same for all its regions. nullopt if stopped.
std::optional<Brightness> find_brightness(FrameRenderer& renderer, const Scene& scene,
                                          const Camera& camera, const Film& film,
                                          const Settings& settings, const Job& job);

// Settings that name it where frames depend on it; unchanged if they do already.
std::optional<Settings> with_brightness(FrameRenderer& renderer, const Scene& scene,
                                        const Camera& camera, const Film& film, Settings settings,
                                        const Job& job);

// The whole of a film, shrunk to about so many pixels if it has more.
Film small_film(const Film& film, double pixels);

}  // namespace brume
