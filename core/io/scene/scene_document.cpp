#include "core/io/scene/scene_document.h"

namespace brume {
namespace {

const std::string& find(const auto& texts, const auto& key) {
  static const std::string no_text;
  const auto found = texts.find(key);
  return found == texts.end() ? no_text : found->second;
}

}  // namespace

void UnknownKeys::add(const std::string& path, std::string text) {
  if (!text.empty()) of_scene_[path] = std::move(text);
}

void UnknownKeys::add(ObjectId& id, const std::string& path, std::string text) {
  if (text.empty()) return;
  if (id == 0) id = of_objects_.empty() ? 1 : of_objects_.rbegin()->first.first + 1;
  of_objects_[{id, path}] = std::move(text);
}

void UnknownKeys::add_of_gaussian(GaussianId id, std::string text) {
  if (!text.empty()) of_gaussians_[id] = std::move(text);
}

const std::string& UnknownKeys::of(const std::string& path) const {
  return find(of_scene_, path);
}

const std::string& UnknownKeys::of(ObjectId id, const std::string& path) const {
  return find(of_objects_, std::pair(id, path));
}

const std::string& UnknownKeys::of_gaussian(GaussianId id) const {
  return find(of_gaussians_, id);
}

}  // namespace brume
