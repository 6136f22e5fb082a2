#include <algorithm>

#include "brume/error.h"
#include "brume/limits.h"
#include "core/io/scene/json_reader.h"
#include "core/io/text_scanner.h"

namespace brume {
namespace {

// Overhead of malloc per allocation.
constexpr std::size_t heap_overhead = 16;

// On the heap.
std::size_t bytes_of(const std::string& text) {
  const bool is_short = text.capacity() <= std::string().capacity();
  return is_short ? 0 : text.capacity() + heap_overhead;
}

std::size_t bytes_of(const Json& value) {
  if (value.is_string()) {
    return sizeof(std::string) + heap_overhead + bytes_of(value.get_ref<const std::string&>());
  }
  return value.is_structured() ? sizeof(Json::array_t) + heap_overhead : 0;
}

// Builds the document from the parser's events; unlike the library's own builder it refuses a key
// twice, deep nesting, absurd counts and values that take far more memory than their text, and
// knows where it is.
class Builder final : public nlohmann::json_sax<Json> {
 public:
  Builder(const std::filesystem::path& file, std::string_view text)
      : file_(file),
        text_(text),
        max_bytes_(limits::json_bytes + limits::json_bytes_per_byte * text.size()) {}

  Json root;

  bool null() override { return add(nullptr) != nullptr; }
  bool boolean(bool value) override { return add(value) != nullptr; }
  bool number_integer(number_integer_t value) override { return add(value) != nullptr; }
  bool number_unsigned(number_unsigned_t value) override { return add(value) != nullptr; }
  bool number_float(number_float_t value, const string_t&) override {
    return add(value) != nullptr;
  }
  bool string(string_t& value) override { return add(std::move(value)) != nullptr; }
  bool binary(binary_t&) override { return false; }  // not of JSON texts

  bool start_object(std::size_t) override { return open(Json::object()); }
  bool start_array(std::size_t) override { return open(Json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    Json& object = *stack_.back();
    if (object.contains(name)) fail("the key " + quoted_text(name) + " occurs twice in one object");
    if (object.size() >= limits::keys) {
      fail("found more than " + std::to_string(limits::keys) +
           " keys in one object; allowed: " + std::to_string(limits::keys));
    }
    spend(sizeof(Json::object_t::value_type) - sizeof(Json) + bytes_of(name));
    member_ = &object[name];
    keys_.back() = name;
    return true;
  }

  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::detail::exception& error) override {
    // `position` counts the character that was wrong, too.
    const std::string_view before = text_.substr(0, std::max<std::size_t>(position, 1) - 1);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t line_begin = before.rfind('\n') + 1;  // npos + 1 is 0
    std::string_view message = error.what();
    for (const std::string_view begin : {"syntax error", "number overflow"}) {
      const std::size_t found = message.find(begin);
      if (found != std::string_view::npos) message.remove_prefix(found);
    }
    throw InputError(file_,
                     "line " + std::to_string(line) + ", column " +
                         std::to_string(before.size() - line_begin + 1),
                     quoted_text(message, 160));
  }

 private:
  Json* add(Json value) {
    spend(sizeof(Json) + bytes_of(value));
    if (stack_.empty()) {
      root = std::move(value);
      return &root;
    }
    Json& parent = *stack_.back();
    if (parent.is_object()) {
      *member_ = std::move(value);
      return member_;
    }
    if (parent.size() >= limits::gaussians) {
      fail("found more than " + std::to_string(limits::gaussians) +
           " elements; allowed: " + std::to_string(limits::gaussians));
    }
    parent.push_back(std::move(value));
    return &parent.back();
  }

  bool open(Json value) {
    if (stack_.size() >= limits::json_depth) {
      fail("found nesting deeper than " + std::to_string(limits::json_depth) +
           "; allowed: " + std::to_string(limits::json_depth));
    }
    stack_.push_back(add(std::move(value)));
    keys_.emplace_back();
    return true;
  }

  void spend(std::size_t bytes) {
    bytes_ += bytes;
    if (bytes_ <= max_bytes_) return;
    fail("the values up to here take more than " + std::to_string(max_bytes_) +
         " bytes of memory; allowed: " + std::to_string(limits::json_bytes_per_byte) +
         " per byte of the text, plus " + std::to_string(limits::json_bytes));
  }

  bool close() {
    stack_.pop_back();
    keys_.pop_back();
    return true;
  }

  [[noreturn]] void fail(const std::string& message) const {
    std::string path;
    for (std::size_t i = 0; i < stack_.size(); ++i) {
      if (stack_[i]->is_array()) {
        if (i + 1 == stack_.size()) break;  // the array itself is meant
        (path += '[') += std::to_string(stack_[i]->size() - 1);
        path += ']';
      } else if (!keys_[i].empty()) {
        if (!path.empty()) path += '.';
        path += quoted_text(keys_[i]);
      }
    }
    throw InputError(file_, quoted_text(path, 160), message);
  }

  const std::filesystem::path& file_;
  std::string_view text_;
  std::size_t bytes_ = 0;  // that the values take
  std::size_t max_bytes_;
  std::vector<Json*> stack_;       // the open arrays and objects
  std::vector<std::string> keys_;  // the latest key of each
  Json* member_ = nullptr;
};

}  // namespace

Json parse_json(const std::filesystem::path& file, std::string_view text) {
  Builder builder(file, text);
  // The library treats a zero byte as the end of the text.
  if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos) {
    throw InputError(file, "byte " + std::to_string(zero),
                     "found a zero byte; allowed: UTF-8 text");
  }
  Json::sax_parse(text.begin(), text.end(), &builder);
  return std::move(builder.root);
}

}  // namespace brume
