#pragma once

#include <cstddef>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <initializer_list>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace brume {

// Values as USD's text has them.
std::string usd_value(double value);
std::string usd_value(bool value);
std::string usd_tuple(std::initializer_list<double> values);
std::string usd_value(const glm::dvec3& value);
std::string usd_value(const glm::dvec4& value);
std::string usd_value(const glm::dmat4& transform);  // of column vectors, as GLM's; USD's are rows
std::string usd_string(std::string_view text);       // quoted
std::string usd_asset(std::string_view path);

// A list of value_of(i), the texts of as many values as there are.
template <class ValueOf>
std::string usd_list(std::size_t count, ValueOf value_of) {
  std::string text = "[";
  for (std::size_t i = 0; i < count; ++i) text += (i == 0 ? "" : ", ") + value_of(i);
  return text + "]";
}

// The text of a stage, prim by prim.
class UsdText {
 public:
  // The time codes of all values that follow; of values without one there is nothing else.
  explicit UsdText(std::vector<std::optional<int>> frames) : frames_(std::move(frames)) {}

  // A prim within the one that is open. `name`: any text; the prim's own is made an identifier that
  // no sibling has. Returns its path.
  std::string open(std::string_view type, std::string_view name, std::string_view apis = {});
  void close();

  // Without a value. `declaration`: type and name.
  void declare(std::string_view declaration) { line(declaration); }
  // Writes a constant. `metadata`: of the attribute, lines of "name = value"; empty: none.
  void constant(std::string_view declaration, const std::string& value,
                std::string_view metadata = {});
  // Per frame; time samples if they differ, and of one frame with a time code: stages of a frame
  // each, which others put together, must not say that a value stays.
  void animated(std::string_view declaration, std::span<const std::string> values,
                std::string_view metadata = {});
  // animated() of value_of(k) for each frame k.
  template <class ValueOf>
  void each_frame(std::string_view declaration, ValueOf value_of) {
    std::vector<std::string> values;
    for (std::size_t k = 0; k < frames_.size(); ++k) values.push_back(usd_value(value_of(k)));
    animated(declaration, values);
  }
  // The prim's place in the world, per frame.
  template <class TransformOf>
  void transform(TransformOf transform_of) {
    each_frame("matrix4d xformOp:transform", transform_of);
    constant("uniform token[] xformOpOrder", "[\"xformOp:transform\"]");
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  struct Prim {
    std::string path;
    std::set<std::string> children;
  };

  void line(std::string_view text);
  void close_metadata(std::string_view metadata);

  std::vector<std::optional<int>> frames_;
  std::string text_;
  std::vector<Prim> open_{{}};  // the last is the innermost; the first is the stage
};

}  // namespace brume
