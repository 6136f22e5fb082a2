#include "core/io/unicode_text.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace brume {
namespace {

void append_utf8(std::uint32_t character, std::string& text) {
  const auto add = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
  if (character < 0x80) return add(character);
  if (character < 0x800) {
    add(0xc0 | character >> 6);
  } else {
    if (character < 0x10000) {
      add(0xe0 | character >> 12);
    } else {
      add(0xf0 | character >> 18);
      add(0x80 | (character >> 12 & 0x3f));
    }
    add(0x80 | (character >> 6 & 0x3f));
  }
  add(0x80 | (character & 0x3f));
}

// Half of a pair becomes a replacement character.
std::string from_utf16(std::string_view bytes, bool is_big_endian) {
  const auto unit = [&](std::size_t i) {
    const auto first = static_cast<unsigned char>(bytes[2 * i]);
    const auto second = static_cast<unsigned char>(bytes[2 * i + 1]);
    return static_cast<std::uint32_t>(is_big_endian ? first << 8 | second : second << 8 | first);
  };
  std::string text;
  text.reserve(bytes.size() / 2);
  const std::size_t count = bytes.size() / 2;
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t character = unit(i);
    if (character >= 0xd800 && character < 0xe000) {
      const std::uint32_t low = i + 1 < count ? unit(i + 1) : 0;
      const bool is_pair = character < 0xdc00 && low >= 0xdc00 && low < 0xe000;
      character = is_pair ? 0x10000 + ((character & 0x3ff) << 10) + (low & 0x3ff) : 0xfffd;
      if (is_pair) ++i;
    }
    append_utf8(character, text);
  }
  return text;
}

}  // namespace

std::string as_utf8(std::string bytes) {
  if (bytes.starts_with("\xff\xfe")) return from_utf16(std::string_view(bytes).substr(2), false);
  if (bytes.starts_with("\xfe\xff")) return from_utf16(std::string_view(bytes).substr(2), true);
  if (bytes.starts_with("\xef\xbb\xbf")) bytes.erase(0, 3);
  return bytes;
}

}  // namespace brume
