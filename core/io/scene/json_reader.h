#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "brume/error.h"
#include "brume/limits.h"
#include "core/number_domain.h"

namespace brume {

using Json = nlohmann::ordered_json;  // keeps the order of keys

// Parses a JSON text strictly. Throws InputError naming line and column, or the JSON path where
// there is one: bad syntax, a key twice in one object, numbers beyond double; nesting, keys, array
// lengths or memory beyond limits.
Json parse_json(const std::filesystem::path& file, std::string_view text);

// The JSON path of a value as a chain to the root; formatted like medium.gaussians[17].radius on
// demand.
struct JsonPath {
  const JsonPath* parent = nullptr;
  std::string_view key;   // of an object; empty: an element of an element
  std::size_t index = 0;  // of an array that is there
  bool is_element = false;

  [[nodiscard]] JsonPath member(std::string_view name) const { return {this, name, 0, false}; }
  [[nodiscard]] JsonPath element(std::size_t i) const {
    return is_element || !parent ? JsonPath{this, {}, i, true} : JsonPath{parent, key, i, true};
  }
  [[nodiscard]] std::string text() const { return joined(true); }
  [[nodiscard]] std::string kind() const { return joined(false); }  // medium.gaussians[].radius

 private:
  [[nodiscard]] std::string joined(bool with_indices) const;
};

// Context of reading one file: its name for errors, and warnings.
class JsonContext {
 public:
  JsonContext(std::filesystem::path file, std::vector<std::string>* warnings)
      : file_(std::move(file)), warnings_(warnings) {}

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  [[noreturn]] void fail(const JsonPath& path, const std::string& message) const;
  void warn(const JsonPath& path, const std::string& message);  // once per message and kind of path
  // Reads what the file can do without. Where that throws InputError: false, and a warning that it
  // is left out, which names the first such place of each kind.
  template <class Read>
  bool try_read(const JsonPath& path, Read read) {
    try {
      read();
      return true;
    } catch (const InputError& error) {
      warn_of_left_out(path, error);
      return false;
    }
  }
  // Only the first warnings are kept; appends the number of the others.
  void finish_warnings();

 private:
  static constexpr std::size_t max_warnings = 20;

  void warn_of_left_out(const JsonPath& path, const InputError& error);
  void add_warning(const std::string& key, const std::string& place, const std::string& message);

  std::filesystem::path file_;
  std::vector<std::string>* warnings_;
  std::set<std::string> warned_;
};

// Reads the members of one JSON object, checking type and domain. Missing members get the fallback;
// without one they are required. Members never read are unknown.
class JsonObject {
 public:
  JsonObject(JsonContext& context, const Json& value, const JsonPath& path);
  JsonObject(const JsonObject&) = delete;  // paths of members lead to its own
  JsonObject& operator=(const JsonObject&) = delete;

  [[nodiscard]] const Json* find(std::string_view key);        // nullptr if missing
  [[nodiscard]] const Json* peek(std::string_view key) const;  // the same, and it stays unknown
  [[nodiscard]] const Json& required(std::string_view key);    // throws if missing

  double number(std::string_view key, const NumberDomain& domain, std::optional<double> fallback);
  std::int64_t integer(std::string_view key, std::int64_t min_value, std::int64_t max_value,
                       std::int64_t fallback);
  glm::dvec2 pair(std::string_view key, const NumberDomain& domain,
                  std::optional<glm::dvec2> fallback);
  glm::dvec3 vector(std::string_view key, const NumberDomain& domain,
                    std::optional<glm::dvec3> fallback);
  bool boolean(std::string_view key, bool fallback);
  std::string text(std::string_view key, std::optional<std::string> fallback);
  // The member `name`: what an object is called, up to limits::name_length bytes without control
  // characters; not empty, unless the fallback is.
  std::string name(std::optional<std::string> fallback);
  // Index of the text in `allowed`.
  std::size_t choice(std::string_view key, const std::vector<std::string>& allowed,
                     std::optional<std::size_t> fallback);
  // The elements of an array; empty if missing.
  const Json::array_t& array(std::string_view key, std::size_t longest);

  // A member that is an object itself; nullopt if missing, or else it throws.
  std::optional<JsonObject> find_object(std::string_view key);
  JsonObject object(std::string_view key);

  // Call after reading all members: the unknown ones as text of a JSON object ("" for none). Warns.
  std::string unknown_keys();

  [[nodiscard]] const JsonPath& path() const { return path_; }
  [[nodiscard]] JsonPath path_of(std::string_view key) const { return path_.member(key); }
  [[noreturn]] void fail(std::string_view key, const std::string& message) const {
    context_.fail(path_of(key), message);
  }

 private:
  JsonContext& context_;
  const Json& value_;
  JsonPath path_;
  std::vector<std::string_view> asked_;
};

// The numbers of an array of length `count` at `path`, checked.
std::vector<double> read_numbers(const JsonContext& context, const Json& value,
                                 const JsonPath& path, std::size_t count,
                                 const NumberDomain& domain);

// A quaternion w x y z of length 1, within 1e-3; exactly, but for rounding, afterwards.
glm::dquat read_unit_quaternion(const JsonContext& context, const Json& value,
                                const JsonPath& path);

// Adds unknown keys (text of an object, or "") to an object.
void add_unknown_keys(Json& object, const std::string& unknown_keys);

// A value as quoted in error messages.
std::string quoted_json(const Json& value);

}  // namespace brume
