#include "core/io/scene/json_reader.h"

#include <algorithm>
#include <cmath>

#include "core/io/text_scanner.h"

namespace brume {
namespace {

std::string found(const Json& value, const std::string& allowed) {
  return "found " + quoted_json(value) + "; allowed: " + allowed;
}

}  // namespace

std::string JsonPath::joined(bool with_indices) const {
  if (parent == nullptr) return {};
  std::string text = parent->joined(with_indices);
  if (!key.empty() || !is_element) {
    if (!text.empty()) text += '.';
    text += quoted_text(key);
  }
  if (is_element) text += '[' + (with_indices ? std::to_string(index) : "") + ']';
  return text;
}

void JsonContext::fail(const JsonPath& path, const std::string& message) const {
  throw InputError(file_, path.text(), message);
}

void JsonContext::warn(const JsonPath& path, const std::string& message) {
  add_warning(path.kind() + message, path.kind(), message);
}

void JsonContext::warn_of_left_out(const JsonPath& path, const InputError& error) {
  // The error may be in what the path refers to.
  const std::string place = path.text() + ": ";
  const std::string file = InputError(file_, "", "").what();
  std::string message = error.what();
  if (message.starts_with(file)) message.erase(0, file.size());
  if (message.starts_with(place)) message.erase(0, place.size());
  add_warning(path.kind(), path.text(), message + "; it is left out");
}

void JsonContext::add_warning(const std::string& key, const std::string& place,
                              const std::string& message) {
  if (warnings_ == nullptr || !warned_.insert(key).second) return;
  if (warned_.size() > max_warnings) return;
  warnings_->push_back(InputError(file_, place, message).what());
}

void JsonContext::finish_warnings() {
  if (warned_.size() <= max_warnings) return;
  const std::size_t more = warned_.size() - max_warnings;
  warnings_->push_back(
      InputError(file_, "", "and " + std::to_string(more) + " more warnings like these").what());
}

JsonObject::JsonObject(JsonContext& context, const Json& value, const JsonPath& path)
    : context_(context), value_(value), path_(path) {
  if (!value.is_object()) context.fail(path, found(value, "an object"));
}

const Json* JsonObject::find(std::string_view key) {
  asked_.push_back(key);
  return peek(key);
}

const Json* JsonObject::peek(std::string_view key) const {
  const auto found = value_.find(key);
  return found == value_.end() ? nullptr : &*found;
}

const Json& JsonObject::required(std::string_view key) {
  const Json* value = find(key);
  if (value == nullptr) fail(key, "missing");
  return *value;
}

std::optional<JsonObject> JsonObject::find_object(std::string_view key) {
  const Json* value = find(key);
  if (value == nullptr) return std::nullopt;
  return std::optional<JsonObject>(std::in_place, context_, *value, path_of(key));
}

JsonObject JsonObject::object(std::string_view key) {
  return {context_, required(key), path_of(key)};
}

double JsonObject::number(std::string_view key, const NumberDomain& domain,
                          std::optional<double> fallback) {
  const Json* value = fallback ? find(key) : &required(key);
  if (value == nullptr) return *fallback;
  if (!value->is_number() || !domain.contains(value->get<double>())) {
    fail(key, found(*value, domain.allowed));
  }
  return value->get<double>();
}

std::int64_t JsonObject::integer(std::string_view key, std::int64_t min_value,
                                 std::int64_t max_value, std::int64_t fallback) {
  const Json* value = find(key);
  if (value == nullptr) return fallback;
  const std::string allowed =
      "an integer from " + std::to_string(min_value) + " to " + std::to_string(max_value);
  if (value->is_number_float()) {  // 800.0, as some programs write it
    const double number = value->get<double>();
    if (number != std::floor(number) || std::abs(number) > 9e15) fail(key, found(*value, allowed));
  } else if (!value->is_number_integer() ||
             (value->is_number_unsigned() && value->get<std::uint64_t>() > INT64_MAX)) {
    fail(key, found(*value, allowed));
  }
  const std::int64_t number = value->get<std::int64_t>();
  if (number < min_value || number > max_value) fail(key, found(*value, allowed));
  return number;
}

glm::dvec2 JsonObject::pair(std::string_view key, const NumberDomain& domain,
                            std::optional<glm::dvec2> fallback) {
  const Json* value = fallback ? find(key) : &required(key);
  if (value == nullptr) return *fallback;
  const std::vector<double> v = read_numbers(context_, *value, path_of(key), 2, domain);
  return {v[0], v[1]};
}

glm::dvec3 JsonObject::vector(std::string_view key, const NumberDomain& domain,
                              std::optional<glm::dvec3> fallback) {
  const Json* value = fallback ? find(key) : &required(key);
  if (value == nullptr) return *fallback;
  const std::vector<double> v = read_numbers(context_, *value, path_of(key), 3, domain);
  return {v[0], v[1], v[2]};
}

bool JsonObject::boolean(std::string_view key, bool fallback) {
  const Json* value = find(key);
  if (value == nullptr) return fallback;
  if (!value->is_boolean()) fail(key, found(*value, "true or false"));
  return value->get<bool>();
}

std::string JsonObject::text(std::string_view key, std::optional<std::string> fallback) {
  const Json* value = fallback ? find(key) : &required(key);
  if (value == nullptr) return *fallback;
  if (!value->is_string()) fail(key, found(*value, "a string"));
  return value->get<std::string>();
}

std::string JsonObject::name(std::optional<std::string> fallback) {
  const std::size_t shortest = fallback && fallback->empty() ? 0 : 1;
  std::string name = text("name", std::move(fallback));
  const auto is_control = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
  if (name.size() < shortest || name.size() > limits::name_length ||
      std::ranges::any_of(name, is_control)) {
    fail("name", "found " + quoted_text(name) + "; allowed: a name of " + std::to_string(shortest) +
                     " to " + std::to_string(limits::name_length) +
                     " bytes without control characters");
  }
  return name;
}

std::size_t JsonObject::choice(std::string_view key, const std::vector<std::string>& allowed,
                               std::optional<std::size_t> fallback) {
  const Json* value = fallback ? find(key) : &required(key);
  if (value == nullptr) return *fallback;
  if (value->is_string()) {
    const auto found =
        std::find(allowed.begin(), allowed.end(), value->get_ref<const std::string&>());
    if (found != allowed.end()) return static_cast<std::size_t>(found - allowed.begin());
  }
  std::string names;
  for (const std::string& name : allowed) names += (names.empty() ? "\"" : ", \"") + name + "\"";
  fail(key, found(*value, names));
}

const Json::array_t& JsonObject::array(std::string_view key, std::size_t longest) {
  static const Json::array_t none;
  const Json* value = find(key);
  if (value == nullptr) return none;
  if (!value->is_array()) fail(key, found(*value, "an array"));
  if (value->size() > longest) {
    fail(key, "found " + std::to_string(value->size()) + " elements; allowed: at most " +
                  std::to_string(longest));
  }
  return value->get_ref<const Json::array_t&>();
}

std::string JsonObject::unknown_keys() {
  std::string rest;
  for (const auto& [key, value] : value_.items()) {
    if (std::find(asked_.begin(), asked_.end(), key) != asked_.end()) continue;
    rest += rest.empty() ? '{' : ',';
    rest += Json(key).dump();
    rest += ':';
    rest += value.dump();
    context_.warn(path_of(key), "unknown key; it is kept when the scene is saved");
  }
  if (!rest.empty()) rest += '}';
  return rest;
}

std::vector<double> read_numbers(const JsonContext& context, const Json& value,
                                 const JsonPath& path, std::size_t count,
                                 const NumberDomain& domain) {
  if (!value.is_array() || value.size() != count) {
    context.fail(path, found(value, "an array of " + std::to_string(count) + " numbers"));
  }
  std::vector<double> numbers;
  for (std::size_t i = 0; i < count; ++i) {
    if (!value[i].is_number() || !domain.contains(value[i].get<double>())) {
      context.fail(path.element(i), found(value[i], domain.allowed));
    }
    numbers.push_back(value[i].get<double>());
  }
  return numbers;
}

glm::dquat read_unit_quaternion(const JsonContext& context, const Json& value,
                                const JsonPath& path) {
  const std::vector<double> q = read_numbers(context, value, path, 4, domain::coordinate);
  const glm::dquat rotate(q[0], q[1], q[2], q[3]);
  const double length = glm::length(rotate);
  if (!(std::abs(length - 1.0) <= 1e-3)) {
    context.fail(path, "found a quaternion of length " + quoted_text(length) +
                           "; allowed: length 1, within 1e-3");
  }
  // A quaternion that is unit up to rounding stays as it is, so that a saved scene is the same
  // scene.
  return std::abs(length - 1.0) <= 1e-12 ? rotate : rotate / length;
}

void add_unknown_keys(Json& object, const std::string& unknown_keys) {
  if (unknown_keys.empty()) return;
  const Json keys = Json::parse(unknown_keys);
  for (const auto& [key, value] : keys.items()) {
    if (!object.contains(key)) object[key] = value;
  }
}

std::string quoted_json(const Json& value) {
  if (value.is_object()) return "an object";
  if (value.is_array()) return "an array of " + std::to_string(value.size()) + " elements";
  return quoted_text(value.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace brume
