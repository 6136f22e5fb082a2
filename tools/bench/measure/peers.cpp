#include "tools/bench/measure/peers.h"

#include <nlohmann/json.hpp>

#include "brume/error.h"
#include "core/io/disk/file_bytes.h"

namespace brume {

std::vector<OtherRendererRow> read_other_renderers(const std::filesystem::path& file) {
  const std::string text = read_bytes(file);
  std::vector<OtherRendererRow> rows;
  try {
    const auto json = nlohmann::json::parse(text);
    for (const auto& entry : json.at("peers")) {
      OtherRendererRow& row = rows.emplace_back();
      entry.at("scene").get_to(row.scene);
      entry.at("size").at(0).get_to(row.film.width);
      entry.at("size").at(1).get_to(row.film.height);
      entry.at("program").get_to(row.program);
      entry.at("setting").get_to(row.setting);
      row.cpu_milliseconds = 1e3 * entry.at("cpu_seconds").get<double>();
      entry.at("rel_rmse").get_to(row.rel_rmse);
      if (!(row.cpu_milliseconds > 0.0) || !(row.rel_rmse >= 0.0)) {
        throw InputError(file, "peers[" + std::to_string(rows.size() - 1) + "]",
                         "cpu_seconds must be > 0 and rel_rmse >= 0");
      }
    }
  } catch (const nlohmann::json::exception& e) {
    throw InputError(file, "", std::string("is not an output of tools/compare-peers: ") + e.what());
  }
  return rows;
}

std::vector<OtherRendererRow> other_renderers_of(const std::vector<OtherRendererRow>& peers,
                                                 const std::string& scene, const Film& film) {
  std::vector<OtherRendererRow> result;
  for (const OtherRendererRow& row : peers) {
    if (row.scene == scene && row.film == film) result.push_back(row);
  }
  return result;
}

}  // namespace brume
