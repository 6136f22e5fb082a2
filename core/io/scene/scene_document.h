#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "brume/scene.h"

namespace brume {

// The Gaussians of a scene that came from `medium.file`, as they were loaded: while they are
// unchanged, saving refers to the file again instead of writing them into the scene.
struct MediumFile {
  std::filesystem::path file;
  Medium loaded;            // of the scene, which shares its columns while nothing is edited
  GaussianId first_id = 0;  // the file's are this one and all after it

  [[nodiscard]] bool contains(GaussianId id) const {
    return id >= first_id && loaded.index_of(id).has_value();
  }
};

// Unknown keys of a scene file, by object: the text of a JSON object, "" for none. An object that a
// scene has once goes by its path in the file ("camera.keys"; "" is the top level), one of several
// by its id and the path within it ("keys"; "" is the object itself).
class UnknownKeys {
 public:
  void add(const std::string& path, std::string text);
  // Gives the object an id if it has none.
  void add(ObjectId& id, const std::string& path, std::string text);
  void add_of_gaussian(GaussianId id, std::string text);

  [[nodiscard]] const std::string& of(const std::string& path) const;
  [[nodiscard]] const std::string& of(ObjectId id, const std::string& path) const;
  [[nodiscard]] const std::string& of_gaussian(GaussianId id) const;

  bool operator==(const UnknownKeys&) const = default;

 private:
  std::map<std::string, std::string> of_scene_;
  std::map<std::pair<ObjectId, std::string>, std::string> of_objects_;
  std::map<GaussianId, std::string> of_gaussians_;
};

// The content of a scene file besides its scene. No edit of the scene changes it: objects are found
// by their ids, wherever they move, and again after undo.
struct SceneExtras {
  UnknownKeys unknown_keys;
  std::shared_ptr<const MediumFile> medium_file;  // nullptr: none
};

// The content of a scene file. A scene alone is a document without extras.
struct SceneDocument {
  SceneDocument() = default;
  SceneDocument(Scene s, SceneExtras e = {}) : scene(std::move(s)), extras(std::move(e)) {}

  Scene scene;
  SceneExtras extras;
};

}  // namespace brume
