#include "core/authoring/mirror.h"

namespace brume {

std::vector<Gaussian> mirror_images(const Gaussian& gaussian, const MirrorPlanes& planes) {
  std::vector<Gaussian> images{gaussian};
  for (int axis = 0; axis < 3; ++axis) {
    if (!planes.axes[static_cast<std::size_t>(axis)]) continue;
    const std::size_t originals = images.size();
    for (std::size_t k = 0; k < originals; ++k) {
      Gaussian image = images[k];
      image.center[axis] = 2.0 * planes.center[axis] - image.center[axis];
      images.push_back(image);
    }
  }
  return images;
}

}  // namespace brume
