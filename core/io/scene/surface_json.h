#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "brume/scene.h"
#include "core/io/scene/json_reader.h"
#include "core/io/scene/scene_budget.h"
#include "core/io/scene/scene_document.h"
#include "core/io/scene/scene_references.h"

namespace brume {

// Reads the surfaces of a scene file. Equal primitives share their mesh.
class SurfaceReader {
 public:
  // All of them outlive this.
  SurfaceReader(JsonContext& context, SceneReferences& references, SceneBudget& budget,
                UnknownKeys& unknown_keys)
      : context_(context), references_(references), budget_(budget), unknown_keys_(unknown_keys) {}

  Surface read(JsonObject& object);
  // After all: copies that are scattered over one another. `path`: of the surfaces.
  void reserve_scattered(const JsonPath& path, const std::vector<Surface>& surfaces);

 private:
  void read_mesh(JsonObject& object, Surface& surface);
  void read_copies(JsonObject& object, Surface& surface);
  Primitive read_primitive(JsonObject& object, Surface& surface);
  std::shared_ptr<const TriangleMesh> primitive_mesh(const Primitive& primitive);
  void read_imported(JsonObject& object, const JsonPath& path, Surface& surface);
  void check_node(const ImportedScene& scene, const JsonPath& path, const std::string& name);

  JsonContext& context_;
  SceneReferences& references_;
  SceneBudget& budget_;
  UnknownKeys& unknown_keys_;
  std::vector<std::pair<Primitive, std::shared_ptr<const TriangleMesh>>> primitive_meshes_;
};

}  // namespace brume
