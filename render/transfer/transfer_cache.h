#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/transfer/radiance_transfer.h"

namespace brume {

// Keeps radiance transfer on disk from one run to the next: a file for each mesh and settings, of 4
// bytes for each coefficient. Deleting them is always safe. Version 1, little-endian: a header, the
// visibility and the reflected light of each side, a hash of all that.

// $XDG_CACHE_HOME/brume, else $HOME/.cache/brume; empty where neither is an absolute path.
std::filesystem::path cache_folder();

// The name is a hash of the mesh's points, normals and triangles and of the settings. Material,
// scale and place do not matter to transfer.
std::filesystem::path transfer_file(const std::filesystem::path& folder, const TriangleMesh& mesh,
                                    const TransferSettings& settings);

// radiance_transfer(), read from the folder if it is there and else put there for the next time.
// The folder is made where it is missing; with none (""), nothing is kept, nor is what would take
// more than limits::file_bytes. A file that is damaged or not ours is replaced, and one that cannot
// be read or written is done without; both append one line to `warnings`, if given. Nothing if
// stopped.
std::optional<RadianceTransfer> cached_radiance_transfer(
    const std::shared_ptr<const TriangleMesh>& mesh, const TransferSettings& settings,
    const std::filesystem::path& folder, const Job& job = {},
    std::vector<std::string>* warnings = nullptr);

}  // namespace brume
