#pragma once

#include <cstdint>

namespace brume {

// Identifies an object of a scene to whoever keeps something about it elsewhere, as the document of
// its file does (core/io/scene/scene_document.h). It stays the same through edits and undo, and a
// copy has it too. 0: nothing is kept.
using ObjectId = std::uint64_t;

}  // namespace brume
