#pragma once

#include <cstddef>

#include "app/document/scene_part.h"
#include "brume/limits.h"

namespace brume {

class Document;

// The Gaussians of a scene part, as counted by gaussian_count() of a scene.
std::size_t gaussian_count(const ScenePart& part);

// Whether `added` Gaussians may replace `removed` ones within limits::gaussians. If not, the
// document reports it.
bool has_room(Document& document, std::size_t added, std::size_t removed);

}  // namespace brume
