#pragma once

#include <cstddef>

#include "app/document/scene_part.h"

namespace brume {

class Document;

// The Gaussians that a part of a scene stands for, as gaussian_count() of a scene counts them.
std::size_t gaussian_count(const ScenePart& part);

// Whether a scene may get `added` Gaussians for `removed` ones: limits::gaussians holds for all of
// it. If not, the document says why.
bool has_room(Document& document, std::size_t added, std::size_t removed);

}  // namespace brume
