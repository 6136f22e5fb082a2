#pragma once

#include <memory>

#include "render/frame_stages.h"
#include "render/gl/film_airlight.h"

namespace brume::gl {

// Medium, surfaces and the environment behind them put together on the device.
class CompositeStage {
 public:
  // Fills `beauty` of the textures from the others.
  void run(Programs& programs, const FrameWork& work, FilmTextures& textures);

 private:
  std::shared_ptr<const RadianceMap> map_;  // what sky_ holds
  Buffer sky_;
};

}  // namespace brume::gl
