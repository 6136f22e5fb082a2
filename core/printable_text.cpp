#include "core/printable_text.h"

#include <cstddef>
#include <cstdio>

namespace brume {
namespace {

struct Character {
  char32_t code = 0;
  std::size_t bytes = 0;  // 0: not UTF-8
};

// The first character of a text that is not empty.
Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t bytes = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || text.size() < bytes) return {};
  char32_t code = lead & (0xffu >> (bytes + 1));
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return {};
    code = code << 6 | (byte(i) & 0x3f);
  }
  const bool is_overlong = code < (bytes == 4 ? 0x10000u : bytes == 3 ? 0x800u : 0x80u);
  const bool is_surrogate = code >= 0xd800 && code <= 0xdfff;
  return is_overlong || is_surrogate || code > 0x10ffff ? Character{} : Character{code, bytes};
}

bool in(char32_t code, char32_t first, char32_t last) {
  return code >= first && code <= last;
}

bool is_printable(char32_t code) {
  if (code < 0x20 || in(code, 0x7f, 0x9f)) return false;
  // Marks of direction, embeddings, overrides and isolates; separators of lines and paragraphs.
  if (code == 0x61c || in(code, 0x200e, 0x200f) || in(code, 0x2028, 0x202e)) return false;
  return !in(code, 0x2066, 0x2069) && code != 0xfeff;
}

void append_escaped(std::string& out, const char* format, unsigned number) {
  char escape[8];
  std::snprintf(escape, sizeof escape, format, number);
  out += escape;
}

std::string escaped(std::string_view text, bool keep_lines) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const Character c = first_character(text);
    if (c.bytes == 0) {
      append_escaped(out, "\\x%02x", static_cast<unsigned char>(text[0]));
    } else if (is_printable(c.code) || (keep_lines && c.code == '\n')) {
      out += text.substr(0, c.bytes);
    } else {
      append_escaped(out, "\\u%04x", static_cast<unsigned>(c.code));  // none is above ffff
    }
    text.remove_prefix(c.bytes == 0 ? 1 : c.bytes);
  }
  return out;
}

}  // namespace

std::string printable(std::string_view text) {
  return escaped(text, false);
}

std::string printable_lines(std::string_view text) {
  return escaped(text, true);
}

}  // namespace brume
