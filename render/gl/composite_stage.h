#pragma once

#include <memory>

#include "render/gl/film_airlight.h"
#include "render/prepare/frame_stages.h"

namespace brume::gl {

// Compositing of medium, surfaces and environment on the device.
class CompositeStage {
 public:
  // Fills the `beauty` texture from the others.
  void run(Programs& programs, const FrameContext& work, FilmTextures& textures);

 private:
  std::shared_ptr<const RadianceMap> map_;  // content of sky_
  Buffer sky_;
};

}  // namespace brume::gl
