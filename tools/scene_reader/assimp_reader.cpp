#include "tools/scene_reader/assimp_reader.h"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <map>
#include <span>

#include "brume/error.h"
#include "brume/limits.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/import/node_keys.h"
#include "core/io/import/node_transform.h"
#include "core/io/import/scene_readers.h"
#include "core/io/mesh/mesh_readers.h"
#include "core/io/mesh/obj_corner.h"
#include "core/io/text_scanner.h"
#include "core/io/unicode_text.h"
#include "core/math/basis.h"
#include "core/number_domain.h"
#include "core/scene/mesh.h"
#include "tools/scene_reader/assimp_deformation.h"
#include "tools/scene_reader/assimp_lights.h"
#include "tools/scene_reader/assimp_materials.h"
#include "tools/scene_reader/limited_files.h"
#include "tools/scene_reader/obj_repair.h"

namespace brume {
namespace fs = std::filesystem;
namespace {

constexpr double max_texcoord = 1e6;

glm::dvec3 to_dvec3(const aiVector3D& v) {
  return {v.x, v.y, v.z};
}

// The unit of an FBX [m]; the file has it in centimeters.
double unit_of(const aiScene& scene) {
  float unit = 0;
  const bool is_known =
      scene.mMetaData && scene.mMetaData->Get("UnitScaleFactor", unit) && unit > 0;
  return is_known ? 0.01 * static_cast<double>(unit) : 1.0;
}

// The transform to y up and meters from an FBX's axes and unit; assimp
// leaves that to us, if it left the transform of the root alone.
glm::dmat4 scene_transform(const aiScene& scene) {
  const glm::dmat4 result = glm::scale(glm::dmat4(1.0), glm::dvec3(unit_of(scene)));
  if (scene.mMetaData == nullptr) return result;
  if (!scene.mRootNode->mTransformation.IsIdentity()) return result;
  glm::dmat4 axes(0.0);
  axes[3][3] = 1.0;
  int row = 0;
  for (const char* key : {"CoordAxis", "UpAxis", "FrontAxis"}) {
    int axis = 0;
    int sign = 1;
    if (!scene.mMetaData->Get(key, axis) || axis < 0 || axis > 2) return result;
    scene.mMetaData->Get((std::string(key) + "Sign").c_str(), sign);
    axes[axis][row++] = sign < 0 ? -1.0 : 1.0;
  }
  return std::abs(glm::determinant(axes)) == 1.0 ? result * axes : result;
}

class Reader {
 public:
  Reader(const aiScene& from, const fs::path& file) : from_(from), file_(file) {}

  RawScene read() {
    channels_ = add_materials(from_, file_, scene_);
    add_nodes();
    std::size_t node = scene_.nodes.size();  // of the first camera
    for (unsigned i = 0; i < from_.mNumCameras; ++i) add_camera(*from_.mCameras[i], node++);
    for (unsigned i = 0; i < from_.mNumLights; ++i) add_light(*from_.mLights[i], node++);
    if (from_.mNumAnimations > 1) {
      warn("", "found " + std::to_string(from_.mNumAnimations) +
                   " animations; all but the first are left out");
    }
    return std::move(scene_);
  }

 private:
  void warn(const std::string& place, const std::string& message) {
    const std::string warning = InputError(file_, place, message).what();
    if (std::ranges::count(scene_.warnings, warning) == 0) scene_.warnings.push_back(warning);
  }

  void add_nodes() {
    struct Visit {
      const aiNode* node;
      std::optional<std::size_t> parent;
    };
    std::vector<Visit> open{{from_.mRootNode, std::nullopt}};
    std::vector<MovingNode> moving;
    while (!open.empty()) {
      const auto [node, parent] = open.back();
      open.pop_back();
      const std::size_t index = nodes_.size();
      if (index >= max_imported_nodes) {
        throw InputError(file_, "",
                         "found more than " + std::to_string(max_imported_nodes) +
                             " nodes; allowed: " + std::to_string(max_imported_nodes));
      }
      const std::string name = node->mName.C_Str();
      nodes_.push_back(node);
      scene_.nodes.push_back({imported_name(name, "node " + std::to_string(index)), parent});
      names_.try_emplace(name, index);
      MovingNode& added = moving.emplace_back();
      added.parent = parent;
      added.at_rest = to_dmat4(node->mTransformation);
      if (!parent) added.at_rest = scene_transform(from_) * added.at_rest;
      for (unsigned i = node->mNumChildren; i > 0; --i) {
        open.push_back({node->mChildren[i - 1], index});
      }
    }
    add_tracks(from_, names_, moving);
    // Cameras and lights are within the node of their name, and look along -z.
    const auto add_within = [&](const aiString& name, const glm::dmat4& at_rest) {
      const auto found = names_.find(name.C_Str());
      MovingNode& added = moving.emplace_back();
      if (found != names_.end()) added.parent = found->second;
      added.at_rest = at_rest;
    };
    for (unsigned i = 0; i < from_.mNumCameras; ++i) {
      add_within(from_.mCameras[i]->mName, axes_of(*from_.mCameras[i]));
    }
    for (unsigned i = 0; i < from_.mNumLights; ++i) {
      add_within(from_.mLights[i]->mName, axes_of(*from_.mLights[i]));
    }
    motion_.emplace(file_, moving);
    for (std::size_t i = 0; i < moving.size(); ++i) {
      const std::optional<std::size_t> parent = moving[i].parent;
      to_world_.push_back(motion_->moves(i) ? motion_->to_world(i, 0.0)
                                            : (parent ? to_world_[*parent] : glm::dmat4(1.0)) *
                                                  moving[i].at_rest);
    }
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      for (unsigned k = 0; k < nodes_[i]->mNumMeshes; ++k) {
        add_part(*from_.mMeshes[nodes_[i]->mMeshes[k]], i);
      }
    }
  }

  static glm::dmat4 axes_of(const aiCamera& camera) {
    const glm::dvec3 back = -to_dvec3(camera.mLookAt);
    const glm::dvec3 up = to_dvec3(camera.mUp);
    return {glm::dvec4(glm::cross(up, back), 0.0), glm::dvec4(up, 0.0), glm::dvec4(back, 0.0),
            glm::dvec4(to_dvec3(camera.mPosition), 1.0)};
  }
  static glm::dmat4 axes_of(const aiLight& light) {
    const glm::dvec3 direction = to_dvec3(light.mDirection);
    const double length = glm::length(direction);
    const glm::dvec3 back = length > 0.0 ? -direction / length : glm::dvec3(0.0, 1.0, 0.0);
    const auto [u, v] = make_basis(back);
    return {glm::dvec4(u, 0.0), glm::dvec4(v, 0.0), glm::dvec4(back, 0.0),
            glm::dvec4(to_dvec3(light.mPosition), 1.0)};
  }

  void add_part(const aiMesh& mesh, std::size_t node) {
    if (mesh.mPrimitiveTypes != aiPrimitiveType_TRIANGLE &&
        !(mesh.mPrimitiveTypes & aiPrimitiveType_TRIANGLE)) {
      return;
    }
    if (scene_.parts.size() >= limits::surfaces) {
      throw InputError(file_, "",
                       "found more than " + std::to_string(limits::surfaces) +
                           " meshes of nodes; allowed: " + std::to_string(limits::surfaces));
    }
    RawPart part{node, mesh.mMaterialIndex, {}};
    MeshArrays& arrays = part.mesh;
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      arrays.points.emplace_back(to_dvec3(mesh.mVertices[i]));
      if (mesh.HasNormals()) arrays.normals.emplace_back(to_dvec3(mesh.mNormals[i]));
      if (mesh.HasVertexColors(0)) {
        const aiColor4D& color = mesh.mColors[0][i];
        arrays.colors.push_back(linear_color({color.r, color.g, color.b, color.a}));
      }
    }
    const TexcoordChannels& channels = channels_[mesh.mMaterialIndex];
    arrays.texcoords = texcoords(mesh, channels.empty() ? 0 : channels[0]);
    if (channels.size() > 1 && !arrays.texcoords.empty()) {
      arrays.second_texcoords = texcoords(mesh, channels[1]);
    }
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
      const aiFace& face = mesh.mFaces[i];
      if (face.mNumIndices != 3) continue;
      const glm::uvec3 t(face.mIndices[0], face.mIndices[1], face.mIndices[2]);
      if (t.x != t.y && t.y != t.z && t.z != t.x) arrays.triangles.push_back(t);
    }
    if (arrays.triangles.empty()) return;
    const std::string place = "node " + quoted_text(scene_.nodes[node].name);
    set_shape(mesh, node, place, part);
    include(arrays, part.keys);
    scene_.parts.push_back(std::move(part));
  }

  // Places a mesh, which is as in the file: by its bones, or by its node.
  void set_shape(const aiMesh& mesh, std::size_t node, const std::string& place, RawPart& part) {
    Deformation deformation;
    DeformationMotion motion;
    motion.track = read_morph(from_, mesh, *nodes_[node], deformation);
    if (mesh.mNumAnimMeshes > 0 && !motion.track) {
      warn(place, "its morph targets, which are not animated, are left out");
    }
    if (mesh.HasBones()) {
      motion.joints = read_bones(mesh, names_, node, deformation);
    } else {
      motion.joints = {{std::nullopt, transform_of(node, place, part)}};
    }
    if (!mesh.HasBones() && !motion.track) {
      if (part.mesh.normals.empty()) add_flat_normals(part.mesh);
      apply_transform(motion.joints.front().to_node, file_, place, part.mesh);
      return;
    }
    deformation.rest = std::move(part.mesh);
    part.mesh = deformed(deformation, pose_at(motion, *motion_, 0.0));
    apply_transform(glm::dmat4(1.0), file_, place, part.mesh);
    try {
      part.deformation = moving_deformation(std::move(deformation), motion, *motion_);
    } catch (const InputError& error) {
      scene_.warnings.push_back(std::string(error.what()) + "; it stays as it is at 0 s");
    }
  }

  // The transform of a node to the world, or to the placements of which the part gets the keys.
  glm::dmat4 transform_of(std::size_t node, const std::string& place, RawPart& part) {
    if (!motion_->moves(node)) return to_world_[node];
    NodeKeys found = placement_keys(*motion_, node);
    if (found.is_stretched) {
      warn(place, "its animation stretches it along one axis: it keeps its proportions");
    }
    part.keys = std::move(found.keys);
    return found.to_placed;
  }

  static std::vector<glm::vec2> texcoords(const aiMesh& mesh, unsigned channel) {
    std::vector<glm::vec2> result;
    if (channel >= AI_MAX_NUMBER_OF_TEXTURECOORDS || !mesh.HasTextureCoords(channel)) return result;
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      const aiVector3D& uv = mesh.mTextureCoords[channel][i];
      const bool is_valid = std::abs(uv.x) <= max_texcoord && std::abs(uv.y) <= max_texcoord;
      result.push_back(is_valid ? glm::vec2(uv.x, uv.y) : glm::vec2(0.0f));
    }
    return result;
  }

  void include(const MeshArrays& arrays, const PlacementKeys& keys) {
    const auto add = [this](const glm::dvec3& point) {
      low_ = glm::min(low_, point);
      high_ = glm::max(high_, point);
    };
    for (const Key<glm::dvec3>& key : keys.translate) add(key.value);
    for (const glm::vec3& point : arrays.points) {
      if (keys.empty()) add(glm::dvec3(point));
    }
  }

  void add_camera(const aiCamera& camera, std::size_t node) {
    const double half_width = std::tan(0.5 * static_cast<double>(camera.mHorizontalFOV));
    const double aspect = camera.mAspect > 0 ? static_cast<double>(camera.mAspect) : 1.0;
    const double fov = glm::degrees(2.0 * std::atan(half_width / aspect));
    if (!domain::field_of_view.contains(fov) || scene_.cameras.size() >= limits::cameras) return;
    NamedCamera& added = scene_.cameras.emplace_back();
    added.name = imported_name(camera.mName.C_Str(), "Camera");
    added.camera = camera_of_node(to_world_[node], center(), fov);
    if (motion_->moves(node)) add_keys(*motion_, node, center(), added);
  }

  void add_light(const aiLight& from, std::size_t node) {
    if (scene_.lights.size() >= limits::lights) return;
    const LightUnits units = light_units(from_, unit_of(from_));
    std::optional<Light> light = light_of(from, units, to_world_[node], center());
    if (!light) {
      warn("", "area and volume lights are left out: how large they are is not known");
      return;
    }
    const bool decays = std::holds_alternative<light::Directional>(light->kind) ||
                        units.are_watts || decay_exponent(from) == 2;
    if (!decays) {
      warn("",
           "found lights that do not decay by the square of the distance: they do here, and "
           "are as bright as there in the middle of the meshes");
    }
    light->name = imported_name(from.mName.C_Str(), "");
    if (motion_->moves(node)) add_keys(*motion_, node, *light);
    scene_.lights.push_back(std::move(*light));
  }

  // The middle of the meshes.
  [[nodiscard]] glm::dvec3 center() const {
    return scene_.parts.empty() ? glm::dvec3(0.0) : 0.5 * (low_ + high_);
  }

  const aiScene& from_;
  const fs::path& file_;
  RawScene scene_;
  std::vector<TexcoordChannels> channels_;  // by material
  std::vector<const aiNode*> nodes_;
  std::map<std::string, std::size_t> names_;  // of nodes
  std::optional<NodeMotion> motion_;          // of nodes, then of cameras and lights
  std::vector<glm::dmat4> to_world_;          // at 0 s, of the same
  glm::dvec3 low_{limits::coordinate};
  glm::dvec3 high_{-limits::coordinate};
};

// The MTL files that an OBJ names, each once, of those that could not be opened: for each of them
// assimp has tried NAME.mtl of NAME.obj, too.
std::vector<fs::path> missing_material_files(const fs::path& file,
                                             const std::vector<fs::path>& missed) {
  const fs::path substitute = file.lexically_normal().replace_extension(".mtl");
  const auto tried = std::ranges::count(missed, substitute);
  const bool is_named = 2 * tried > std::ssize(missed);
  std::vector<fs::path> result;
  for (const fs::path& path : missed) {
    if (path == substitute && !is_named) continue;
    if (std::ranges::count(result, path) == 0) result.push_back(path);
  }
  return result;
}

// Values that do no harm here, for which assimp would refuse the whole file.
void settle(aiScene& scene) {
  for (aiLight* light : std::span(scene.mLights, scene.mNumLights)) {
    light->mAngleInnerCone = std::min(light->mAngleInnerCone, light->mAngleOuterCone);
  }
  for (aiCamera* camera : std::span(scene.mCameras, scene.mNumCameras)) {
    camera->mClipPlaneNear = 0.1f;
    camera->mClipPlaneFar = 1000.0f;
  }
  for (aiAnimation* animation : std::span(scene.mAnimations, scene.mNumAnimations)) {
    animation->mDuration = std::numeric_limits<double>::max();
  }
}

}  // namespace

RawScene read_with_assimp(const fs::path& file) {
  Assimp::Importer importer;
  auto* files = new LimitedFiles(file);  // the importer's from here on
  importer.SetIOHandler(files);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, false);
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                              aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  // Vertices at one place are smooth up to 60 degrees, as those of meshes.
  importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, 60.0f);
  const auto read = [&]() -> const aiScene* {
    const aiScene* read_scene = importer.ReadFile(file.string(), 0);
    if (read_scene == nullptr) return nullptr;
    settle(const_cast<aiScene&>(*read_scene));  // the importer's, which has steps to go
    return importer.ApplyPostProcessing(aiProcess_ValidateDataStructure);
  };
  const aiScene* scene = read();
  ObjRepair repair;
  if (scene == nullptr && lower_case_extension(file) == ".obj") {
    std::string text = as_utf8(read_bytes(file));
    repair = repair_obj(text);
    if (repair.has_changed) {
      files->replace_scene(std::move(text));
      scene = read();
    }
  }
  if (scene != nullptr) {
    cut_polygons(const_cast<aiScene&>(*scene));
    scene = importer.ApplyPostProcessing(aiProcess_SortByPType | aiProcess_GenSmoothNormals |
                                         aiProcess_JoinIdenticalVertices |
                                         aiProcess_ValidateDataStructure);
  }
  if (scene == nullptr) {
    const bool is_obj = lower_case_extension(file) == ".obj";
    const std::string text = read_bytes(file);  // throws if there is a better reason
    if (is_obj) check_has_faces(file, count_obj(as_utf8(text)));
    // The importer's own words are about its code.
    throw InputError(
        file, "", std::string("cannot be read: it is damaged, or no ") + (is_obj ? "OBJ" : "FBX"));
  }
  RawScene result = Reader(*scene, file).read();
  if (repair.bad_faces > 0) {
    const std::string message = bad_obj_faces(repair.bad_faces);
    result.warnings.emplace_back(InputError(file, repair.first_line, message).what());
  }
  result.files = {file};
  for (const fs::path& opened : files->opened()) {
    if (opened != file.lexically_normal()) result.files.push_back(opened);
  }
  for (const fs::path& material_file : missing_material_files(file, files->missed())) {
    const std::string message = "the material file " + material_file.string() + " is missing";
    result.warnings.emplace_back(InputError(file, "", message).what());
  }
  return result;
}

}  // namespace brume
