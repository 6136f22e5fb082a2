#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "brume/files.h"
#include "core/io/scene/scene_document.h"

namespace brume {

// The scene file, version 1 (JSON, extension .brume).

// Loads a scene with all referenced files and validates it. Throws InputError naming file, JSON
// path, the value found and the allowed ones. Warnings (one line each: unknown keys, keys without
// effect) are appended to `warnings` if given.
SceneDocument load_document(const std::filesystem::path& file,
                            std::vector<std::string>* warnings = nullptr);

// Writes a document, or a scene, losslessly; references become relative to the new file if
// possible. Atomic. Throws InputError.
void save_document(const SceneDocument& document, const std::filesystem::path& file);

// Whether a saved document refers to its medium_file: as long as its Gaussians are unchanged.
bool refers_to_medium_file(const SceneDocument& document);

// The text that save_document() writes to a file in `directory`.
std::string document_to_json(const SceneDocument& document, const std::filesystem::path& directory);

}  // namespace brume
