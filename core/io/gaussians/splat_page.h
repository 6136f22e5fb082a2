#pragma once

#include <string>

#include "brume/camera.h"

namespace brume {

// One page that shows splats in a browser, without a server or a network: the viewer of
// resources/web with them inside. `ply`: of splats whose y points down; the camera is where it
// begins. Throws InputError if the viewer is not installed.
std::string splat_page(const std::string& title, const std::string& ply, const Camera& camera,
                       const Film& film);

}  // namespace brume
