#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <span>
#include <string>

#include "core/io/scene/usd_file.h"
#include "core/io/scene/usd_text.h"

namespace brume {

// A file as a stage in `folder` names it.
std::string named_from(const std::filesystem::path& folder, const std::filesystem::path& file);

// The images of a stage: files where they are, and those within another file as PNGs beside the
// stage, NAME_texture_1.png and so on.
class UsdTextures {
 public:
  UsdTextures(const std::filesystem::path& stage, AddOutput add_output);

  // The asset of a texture that has content, which it writes if that is not a file of its own.
  // Throws InputError.
  std::string asset(const TextureReference& texture);
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
  std::string stem_;
  AddOutput add_output_;  // may be none
  std::map<const Texture*, std::filesystem::path> written_;
};

// The opacity of a material where it has no texture and vertices no colors. USD has no color of
// what crosses a pane.
double usd_opacity(const MetallicRoughness& material);
// Whether colors of vertices change the opacity, and no texture has it.
bool usd_colors_have_opacity(const Surface& surface);

// Binds the prim at `path`, which is open, to a UsdPreviewSurface with the material of surface i.
// Measured materials are grey; lobes of Phong become such of GGX as have their width. A texture of
// base color is multiplied by the mean color of the vertices: USD cannot multiply by each.
void write_usd_material(UsdText& out, std::span<const UsdFrame> frames, std::size_t i,
                        const std::string& path, UsdTextures& textures);

}  // namespace brume
