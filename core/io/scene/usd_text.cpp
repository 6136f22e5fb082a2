#include "core/io/scene/usd_text.h"

#include <algorithm>
#include <cassert>

#include "core/number_domain.h"

namespace brume {
namespace {

constexpr std::size_t indent = 4;

bool is_ascii_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

// Letters, digits and underscores, no digit first.
std::string identifier(std::string_view text) {
  std::string name;
  for (const char c : text) name += is_ascii_letter(c) || (c >= '0' && c <= '9') ? c : '_';
  if (name.empty() || !is_ascii_letter(name.front())) name.insert(0, 1, '_');
  return name;
}

}  // namespace

std::string usd_value(double value) {
  return quoted_text(value);
}

std::string usd_value(bool value) {
  return value ? "true" : "false";
}

std::string usd_tuple(std::initializer_list<double> values) {
  std::string text = "(";
  for (const double value : values) {
    if (text.size() > 1) text += ", ";
    text += usd_value(value);
  }
  text += ")";
  return text;
}

std::string usd_value(const glm::dvec3& value) {
  return usd_tuple({value.x, value.y, value.z});
}

std::string usd_value(const glm::dvec4& value) {
  return usd_tuple({value.x, value.y, value.z, value.w});
}

std::string usd_value(const glm::dmat4& transform) {
  std::string text;
  for (int column = 0; column < 4; ++column) {
    text += column == 0 ? "( (" : ", (";
    for (int row = 0; row < 4; ++row) {
      text += (row == 0 ? "" : ", ") + usd_value(transform[column][row]);
    }
    text += ")";
  }
  return text + " )";
}

std::string usd_string(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c == '\n' ? ' ' : c;
  }
  return quoted + "\"";
}

// Between three signs each, a path may have one of its own.
std::string usd_asset(std::string_view path) {
  const bool has_sign = path.find('@') != std::string_view::npos;
  const std::string sign = has_sign ? "@@@" : "@";
  return sign + std::string(path) + sign;
}

std::string UsdText::open(std::string_view type, std::string_view name, std::string_view apis) {
  std::set<std::string>& siblings = open_.back().children;
  const std::string wanted = identifier(name);
  std::string free_name = wanted;
  for (int k = 2; siblings.contains(free_name); ++k) free_name = wanted + "_" + std::to_string(k);
  siblings.insert(free_name);
  text_ += '\n';
  line("def " + std::string(type) + " \"" + free_name + "\"");
  if (free_name != name || !apis.empty()) {
    line("(");
    if (free_name != name) line("    displayName = " + usd_string(name));
    if (!apis.empty()) line("    prepend apiSchemas = [" + std::string(apis) + "]");
    line(")");
  }
  line("{");
  open_.push_back({open_.back().path + "/" + free_name, {}});
  return open_.back().path;
}

void UsdText::close() {
  assert(open_.size() > 1);
  open_.pop_back();
  line("}");
}

void UsdText::constant(std::string_view declaration, const std::string& value,
                       std::string_view metadata) {
  line(std::string(declaration) + " = " + value + (metadata.empty() ? "" : " ("));
  close_metadata(metadata);
}

void UsdText::close_metadata(std::string_view metadata) {
  if (metadata.empty()) return;
  for (std::size_t start = 0; start < metadata.size();) {
    const std::size_t end = std::min(metadata.find('\n', start), metadata.size());
    line("    " + std::string(metadata.substr(start, end - start)));
    start = end + 1;
  }
  line(")");
}

void UsdText::animated(std::string_view declaration, std::span<const std::string> values,
                       std::string_view metadata) {
  assert(values.size() == frames_.size());
  const bool may_stay = values.size() > 1 || !frames_.front();
  if (may_stay && std::ranges::adjacent_find(values, std::ranges::not_equal_to{}) == values.end()) {
    constant(declaration, values.front(), metadata);
    return;
  }
  // Metadata are of the declaration, which has no value of its own.
  if (!metadata.empty()) {
    line(std::string(declaration) + " (");
    close_metadata(metadata);
  }
  line(std::string(declaration) + ".timeSamples = {");
  for (std::size_t k = 0; k < values.size(); ++k) {
    line("    " + std::to_string(frames_[k].value()) + ": " + values[k] + ",");
  }
  line("}");
}

void UsdText::line(std::string_view text) {
  text_.append(indent * (open_.size() - 1), ' ');
  text_ += text;
  text_ += '\n';
}

}  // namespace brume
