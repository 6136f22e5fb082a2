#pragma once

#include <QString>
#include <optional>

#include "app/import/asset_kind.h"
#include "brume/scene.h"

namespace brume {

class Document;
class ToolBox;

// What is chosen of a kind, ready to be saved: the selected Gaussians, the light or surface that
// was chosen last, the camera in use, the brush. Nullopt: nothing is. `name`: that it is called.
struct ChosenAsset {
  QString name;
  Scene scene;  // of all but brushes
};
std::optional<ChosenAsset> chosen_asset(const Document& document, const ToolBox& tools,
                                        AssetKind kind);

// Throws InputError.
void save_asset(const ChosenAsset& asset, const ToolBox& tools, AssetKind kind,
                const std::filesystem::path& file);

// Makes the brush of a file the one that is painted with. Throws InputError.
void use_brush(ToolBox& tools, const std::filesystem::path& file);

}  // namespace brume
