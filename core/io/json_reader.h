#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/number_domain.h"

namespace brume {

using Json = nlohmann::ordered_json;  // keeps the order of keys

// Parses a JSON text strictly. Throws InputError naming line and column, or the JSON path where
// there is one: bad syntax, a key twice in one object, numbers beyond double; nesting, keys, array
// lengths or memory beyond limits.
Json parse_json(const std::filesystem::path& file, std::string_view text);

// Where a value stands in the file, as a chain from the value up to the root; becomes text like
// medium.gaussians[17].radius only when somebody asks.
struct JsonPlace {
  const JsonPlace* parent = nullptr;
  std::string_view key;   // of an object, unless
  std::size_t index = 0;  // of an array
  bool is_element = false;

  [[nodiscard]] JsonPlace member(std::string_view name) const { return {this, name, 0, false}; }
  [[nodiscard]] JsonPlace element(std::size_t i) const { return {this, {}, i, true}; }
  [[nodiscard]] std::string text() const { return joined(true); }
  [[nodiscard]] std::string kind() const { return joined(false); }  // medium.gaussians[].radius

 private:
  [[nodiscard]] std::string joined(bool with_indices) const;
};

// What goes along with reading one file: its name for errors, and the warnings.
class JsonContext {
 public:
  JsonContext(std::filesystem::path file, std::vector<std::string>* warnings)
      : file_(std::move(file)), warnings_(warnings) {}

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  [[noreturn]] void fail(const JsonPlace& place, const std::string& message) const;
  void warn(const JsonPlace& place, const std::string& message);  // once for each kind of place
  // Of many warnings only the first are kept; after all this adds how many more there were.
  void finish_warnings();

 private:
  static constexpr std::size_t max_warnings = 20;

  std::filesystem::path file_;
  std::vector<std::string>* warnings_;
  std::set<std::string> warned_;
};

// Reads the members of one JSON object, each checked for type and domain; what nobody asked for
// is unknown. Members that are absent give the fallback; those without one are required.
class JsonObject {
 public:
  JsonObject(JsonContext& context, const Json& value, const JsonPlace& place);

  [[nodiscard]] const Json* find(std::string_view key);      // nullptr where absent
  [[nodiscard]] const Json& required(std::string_view key);  // throws where absent

  double number(std::string_view key, const NumberDomain& domain, std::optional<double> fallback);
  std::int64_t integer(std::string_view key, std::int64_t least, std::int64_t greatest,
                       std::int64_t fallback);
  glm::dvec3 vector(std::string_view key, const NumberDomain& domain,
                    std::optional<glm::dvec3> fallback);
  bool boolean(std::string_view key, bool fallback);
  std::string text(std::string_view key, std::optional<std::string> fallback);
  // The index of the text in `allowed`.
  std::size_t choice(std::string_view key, const std::vector<std::string>& allowed,
                     std::optional<std::size_t> fallback);
  // The elements of an array, none where it is absent.
  const Json::array_t& array(std::string_view key, std::size_t longest);

  // After all members were asked for: the rest as the text of an object, "" for none. Warns.
  std::string unknown();

  [[nodiscard]] JsonPlace place(std::string_view key) const { return place_.member(key); }
  [[noreturn]] void fail(std::string_view key, const std::string& message) const {
    context_.fail(place(key), message);
  }

 private:
  JsonContext& context_;
  const Json& value_;
  const JsonPlace& place_;
  std::vector<std::string_view> asked_;
};

// Numbers of an array of that length at `place`, each in the domain.
std::vector<double> read_numbers(const JsonContext& context, const Json& value,
                                 const JsonPlace& place, std::size_t count,
                                 const NumberDomain& domain);

// Adds the keys that came with an object and that this version does not know, the text of an object
// or "".
void add_unknown(Json& object, const std::string& unknown);

// A value as an error message shows it.
std::string shown_json(const Json& value);

}  // namespace brume
