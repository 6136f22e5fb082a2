#pragma once

#include <cstddef>
#include <optional>

#include "brume/scene.h"
#include "core/io/image/image_file.h"
#include "render/frame_renderer.h"
#include "render/layers/light_layers.h"
#include "render/samples/exposure.h"
#include "render/util/job.h"

namespace brume {

// A frame that was rendered, and what its layers are made from.
struct LayeredFrame {
  const Scene& animated;  // for motion
  const Scene& scene;     // evaluate_at() a time
  const Camera* camera;   // null: the scene's; else the same at any time
  const Settings& settings;
  RenderLit render;
  Frame& frame;
};

// Renders as a renderer, which lives as long, did the frame: with the same samples.
RenderLit render_lit_by(FrameRenderer& renderer, const ExposedView& view);

// Whether a frame has more layers than it was rendered with.
bool has_more_layers(const OutputLayers& layers);
// The same of layers that are parts of the light.
bool has_light_layers(const OutputLayers& layers);

// Memory of those [bytes].
std::size_t layer_bytes(const Scene& scene, const Film& film, const OutputLayers& layers);

// The channels and metadata of all layers but airlight, transmittance and Z, see light_layers.h and
// surface_layers.h, and optical_depth.R/G/B: -log of the transmittance, at most 87; and
// depth.planar, the depth along the camera's axis of what Z is the distance of. The frame's
// picture may change with them. nullopt if stopped.
std::optional<ImageLayers> render_layers(const LayeredFrame& layered, const OutputLayers& layers,
                                         const Job& job = {});

}  // namespace brume
