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
      // Its axes are mirrored and then turned round, which an ellipsoid does not show.
      glm::dquat& q = image.shape.rotation;
      if (!image.is_ball()) q = {q.w, -q.x, -q.y, -q.z};
      if (!image.is_ball()) q[axis] = -q[axis];
      images.push_back(image);
    }
  }
  return images;
}

}  // namespace brume
