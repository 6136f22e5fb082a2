#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "brume/limits.h"
#include "render/transfer/radiance_transfer.h"

namespace brume {

// Disk cache of radiance transfer: one file per mesh and settings, 4 bytes per coefficient. Safe to
// delete. Version 1, little-endian: header, visibility and reflected light per side, hash.

// $XDG_CACHE_HOME/brume, else $HOME/.cache/brume; empty where neither is an absolute path.
std::filesystem::path cache_folder();

// radiance_transfer(), cached by mesh and settings in `folder`, which is created if missing; with
// an empty folder, or beyond limits::file_bytes, nothing is written. Damaged files are replaced;
// unreadable or unwritable ones are tolerated; both append a line to `warnings`, if given. nullopt
// if stopped.
std::optional<RadianceTransfer> cached_radiance_transfer(
    const std::shared_ptr<const TriangleMesh>& mesh, const TransferSettings& settings,
    const std::filesystem::path& folder, const Job& job = {},
    std::vector<std::string>* warnings = nullptr);

}  // namespace brume
