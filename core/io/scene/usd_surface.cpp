#include "core/io/scene/usd_surface.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <string>
#include <vector>

#include "brume/mesh_arrays.h"
#include "core/math/normals.h"
#include "core/scene/placement.h"

namespace brume {
namespace {

using Frames = std::span<const UsdFrame>;

std::string vectors(const std::vector<glm::vec3>& values) {
  return usd_list(values.size(), [&](std::size_t i) { return usd_value(glm::dvec3(values[i])); });
}

// Lists of a surface, which are long: made once where frames have the same ones.
// `is_as_first(surface)` says whether those of a frame are as the first's.
template <class IsAsFirst>
class SurfaceLists {
 public:
  SurfaceLists(UsdText& out, Frames frames, std::size_t i, IsAsFirst is_as_first)
      : out_(out), frames_(frames), i_(i), is_as_first_(is_as_first) {}

  template <class ListOf>
  void write(std::string_view declaration, ListOf list_of, std::string_view metadata = {}) {
    std::vector<std::string> values{list_of(surface(0))};
    for (std::size_t k = 1; k < frames_.size(); ++k) {
      if (!is_as_first_(surface(k))) {
        values.resize(k, values.front());
        values.push_back(list_of(surface(k)));
      }
    }
    if (values.size() == 1 && (frames_.size() > 1 || !frames_.front().frame)) {
      out_.constant(declaration, values.front(), metadata);
    } else {
      values.resize(frames_.size(), values.front());
      out_.animated(declaration, values, metadata);
    }
  }

 private:
  [[nodiscard]] const Surface& surface(std::size_t k) const {
    return frames_[k].scene.surfaces[i_];
  }

  UsdText& out_;
  Frames frames_;
  std::size_t i_;
  IsAsFirst is_as_first_;
};

// Normals of the corners of triangles, also where a vertex has none, which USD does not know.
std::string corner_normals(const MeshArrays& mesh) {
  std::vector<glm::vec3> normals;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 flat = area_normal(mesh.points, t);
    const double length = glm::length(flat);
    for (int k = 0; k < 3; ++k) {
      const bool is_flat = mesh.normals[t[k]] == glm::vec3(0.0f) && length > 0.0;
      normals.push_back(is_flat ? glm::vec3(flat / length) : mesh.normals[t[k]]);
    }
  }
  return vectors(normals);
}

// Colors of vertices multiply base color and opacity.
void write_mesh(UsdText& out, Frames frames, std::size_t i) {
  const auto arrays_of = [](const Surface& surface) -> const MeshArrays& {
    return to_arrays(*surface.mesh);
  };
  const Surface& surface = frames.front().scene.surfaces[i];
  const MeshArrays& arrays = arrays_of(surface);
  out.constant("int[] faceVertexCounts",
               usd_list(arrays.triangles.size(), [](std::size_t) { return std::string("3"); }));
  out.constant("int[] faceVertexIndices", usd_list(arrays.triangles.size(), [&](std::size_t k) {
                 const glm::uvec3& t = arrays.triangles[k];
                 return std::to_string(t.x) + ", " + std::to_string(t.y) + ", " +
                        std::to_string(t.z);
               }));
  SurfaceLists lists(out, frames, i, [&](const Surface& other) {
    const MeshArrays& found = arrays_of(other);
    return other.mesh == surface.mesh ||
           (found.points == arrays.points && found.normals == arrays.normals);
  });
  lists.write("point3f[] points",
              [&](const Surface& shown) { return vectors(arrays_of(shown).points); });
  const bool have_normals = std::ranges::all_of(frames, [&](const UsdFrame& frame) {
    return std::ranges::count(arrays_of(frame.scene.surfaces[i]).normals, glm::vec3(0.0f)) == 0;
  });
  lists.write(
      "normal3f[] normals",
      [&](const Surface& shown) {
        const MeshArrays& mesh = arrays_of(shown);
        return have_normals ? vectors(mesh.normals) : corner_normals(mesh);
      },
      have_normals ? "interpolation = \"vertex\"" : "interpolation = \"faceVarying\"");
  const auto write_each = [&](const char* declaration, std::size_t count, auto value_of) {
    if (count == 0) return;
    out.constant(declaration, usd_list(count, value_of), "interpolation = \"vertex\"");
  };
  const auto write_texcoords = [&](const char* declaration, std::span<const glm::vec2> texcoords) {
    write_each(declaration, texcoords.size(), [&](std::size_t k) {
      const glm::dvec2 uv(texcoords[k]);
      return usd_tuple({uv.x, uv.y});
    });
  };
  write_texcoords("texCoord2f[] primvars:st", arrays.texcoords);
  write_texcoords("texCoord2f[] primvars:st1", arrays.second_texcoords);
  const MetallicRoughness& material = surface.material.metallic_roughness;
  write_each("color3f[] primvars:displayColor", arrays.colors.size(), [&](std::size_t k) {
    return usd_value(material.base_color * glm::dvec3(arrays.colors[k]));
  });
  if (usd_colors_have_opacity(surface)) {
    write_each("float[] primvars:displayOpacity", arrays.colors.size(), [&](std::size_t k) {
      return usd_value(usd_opacity(material) * static_cast<double>(arrays.colors[k].a));
    });
  }
  out.constant("uniform token subdivisionScheme", "\"none\"");
  out.constant("uniform bool doubleSided", usd_value(true));
}

std::string surface_name(const Surface& surface) {
  if (!surface.name.empty()) return surface.name;
  return surface.mesh_file.empty() ? "Surface" : surface.mesh_file.stem().string();
}

// The copies of a surface, of which a prim of USD is the prototype: relative to its own placement,
// which that prim has.
void write_copies(UsdText& out, Frames frames, std::size_t i, const std::string& path) {
  const Surface& first = frames.front().scene.surfaces[i];
  const auto has_copies = [i](const UsdFrame& frame) {
    return frame.scene.surfaces[i].placed_copies != nullptr;
  };
  if (std::ranges::none_of(frames, has_copies)) return;
  const CopyPlacements none;
  const auto copies_of = [&](const Surface& surface) -> const CopyPlacements& {
    return surface.placed_copies ? *surface.placed_copies : none;
  };
  const auto turn = [](const Surface& surface, const CopyPlacement& copy) {
    return copy.rotate * glm::conjugate(surface.rotate);
  };
  out.open("PointInstancer", surface_name(first) + " copies");
  out.constant("rel prototypes", "<" + path + ">");
  SurfaceLists lists(out, frames, i, [&](const Surface& surface) {
    return Placement(surface) == Placement(first) && copies_of(surface) == copies_of(first);
  });
  const auto write = [&](const char* declaration, auto value_of) {
    lists.write(declaration, [&](const Surface& surface) {
      const CopyPlacements& copies = copies_of(surface);
      return usd_list(copies.size(), [&](std::size_t k) { return value_of(surface, copies[k]); });
    });
  };
  write("int[] protoIndices",
        [](const Surface&, const CopyPlacement&) { return std::string("0"); });
  write("point3f[] positions", [&](const Surface& surface, const CopyPlacement& copy) {
    const glm::dvec3 shift = copy.scale / surface.scale * surface.translate;
    return usd_value(copy.translate - turn(surface, copy) * shift);
  });
  write("quath[] orientations", [&](const Surface& surface, const CopyPlacement& copy) {
    const glm::dquat q = turn(surface, copy);
    return usd_tuple({q.w, q.x, q.y, q.z});
  });
  write("float3[] scales", [](const Surface& surface, const CopyPlacement& copy) {
    return usd_value(glm::dvec3(copy.scale / surface.scale));
  });
  out.close();
}

}  // namespace

void write_usd_surface(UsdText& out, Frames frames, std::size_t i, UsdTextures& textures) {
  const auto surface = [&](std::size_t k) -> const Surface& { return frames[k].scene.surfaces[i]; };
  const Surface& first = surface(0);
  const std::string path = out.open("Mesh", surface_name(first), "\"MaterialBindingAPI\"");
  out.transform([&](std::size_t k) {
    const Placement placement(surface(k));
    return glm::translate(glm::dmat4(1.0), placement.translate) * glm::mat4_cast(placement.rotate) *
           glm::scale(glm::dmat4(1.0), glm::dvec3(placement.scale));
  });
  write_mesh(out, frames, i);
  write_usd_material(out, frames, i, path, textures);
  out.close();
  write_copies(out, frames, i, path);
}

}  // namespace brume
