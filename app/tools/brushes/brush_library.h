#pragma once

#include <filesystem>
#include <vector>

#include "app/tools/brushes/brush_preset.h"

namespace brume {

// The user's own brushes, a JSON file:
//   { "format": "brume-brushes", "version": 1, "brushes": [ { "name": "...", "tool": "paintbrush",
//     "size": 0.06, "depth": 0.5, ... } ] }
// with the members of BrushPreset as keys; `tool` is paintbrush or airbrush. Keys that are not
// known are kept. All functions throw InputError; only replace() overwrites what cannot be read.
class BrushLibrary {
 public:
  explicit BrushLibrary(std::filesystem::path file) : file_(std::move(file)) {}

  // brushes.json in the folder of the user's application data.
  static std::filesystem::path default_file();

  [[nodiscard]] std::vector<BrushPreset> read() const;  // empty if there is no file
  // Replaces one of the same name and tool.
  void add(const BrushPreset& preset) const;
  void remove(const BrushPreset& preset) const;
  // Makes the file one of this brush alone, whatever it was, with the permissions of its folder.
  void replace(const BrushPreset& preset) const;

 private:
  std::filesystem::path file_;
};

}  // namespace brume
