#pragma once

#include <stop_token>
#include <vector>

#include "app/import/asset_kind.h"

namespace brume {

// A drag of an asset carries its file under this type, UTF-8.
inline constexpr const char* asset_mime = "application/x-brume-asset";

struct Asset {
  std::filesystem::path file;
  AssetKind kind = AssetKind::surface;

  bool operator==(const Asset&) const = default;
};

// The assets in a folder and those in it, by name; of very many the first that are met. None if
// there is no such folder; files that cannot be read are left out.
std::vector<Asset> find_assets(const std::filesystem::path& folder, const std::stop_token& stop);

}  // namespace brume
