#include "app/assets/asset_files.h"

#include <algorithm>
#include <exception>
#include <utility>

namespace brume {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t max_assets = 5'000;

std::optional<AssetKind> kind_if_readable(const fs::path& file) {
  try {
    return asset_kind(file);
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace

std::vector<Asset> find_assets(const fs::path& folder, const std::stop_token& stop) {
  std::vector<Asset> assets;
  std::error_code error;
  fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied,
                                         error);
  while (!error && entry != fs::recursive_directory_iterator() && assets.size() < max_assets &&
         !stop.stop_requested()) {
    std::error_code no_file;
    if (entry->is_regular_file(no_file)) {
      if (const auto kind = kind_if_readable(entry->path())) {
        assets.push_back({entry->path(), *kind});
      }
    }
    entry.increment(error);
  }
  std::ranges::sort(assets, {}, [](const Asset& asset) {
    return std::pair(asset_name(asset.file).toCaseFolded(), asset.file);
  });
  return assets;
}

}  // namespace brume
