#pragma once

#include <QString>
#include <optional>

#include "app/import/asset_kind.h"

namespace brume {

class Document;
class ToolBox;

// The name of what is chosen of a kind: the selected Gaussians, the light or surface that was
// chosen last, the camera in use, the brush. Nullopt: nothing is.
std::optional<QString> chosen_name(const Document& document, const ToolBox& tools, AssetKind kind);

// Saves that, which must be chosen. Throws InputError.
void save_asset(const Document& document, const ToolBox& tools, AssetKind kind,
                const std::filesystem::path& file);

// Makes the brush of a file the one that is painted with. Throws InputError.
void use_brush(ToolBox& tools, const std::filesystem::path& file);

}  // namespace brume
