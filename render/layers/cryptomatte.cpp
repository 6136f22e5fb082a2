#include "render/layers/cryptomatte.h"

#include <algorithm>
#include <bit>
#include <nlohmann/json.hpp>

namespace brume {
namespace {

std::string hexadecimal(std::uint32_t hash) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  for (int shift = 28; shift >= 0; shift -= 4) text += digits[hash >> shift & 15];
  return text;
}

}  // namespace

std::uint32_t murmur_hash3(std::string_view text) {
  constexpr std::uint32_t c1 = 0xcc9e2d51;
  constexpr std::uint32_t c2 = 0x1b873593;
  std::uint32_t hash = 0;
  for (std::size_t i = 0; i < text.size(); i += 4) {
    std::uint32_t block = 0;
    const std::size_t bytes = std::min<std::size_t>(4, text.size() - i);
    for (std::size_t b = 0; b < bytes; ++b) {
      block |= std::uint32_t{static_cast<unsigned char>(text[i + b])} << (8 * b);
    }
    hash ^= std::rotl(block * c1, 15) * c2;
    if (bytes == 4) hash = std::rotl(hash, 13) * 5 + 0xe6546b64;
  }
  hash ^= static_cast<std::uint32_t>(text.size());
  hash = (hash ^ hash >> 16) * 0x85ebca6b;
  hash = (hash ^ hash >> 13) * 0xc2b2ae35;
  return hash ^ hash >> 16;
}

std::uint32_t cryptomatte_hash(std::string_view name) {
  const std::uint32_t hash = murmur_hash3(name);
  const std::uint32_t exponent = hash >> 23 & 255;
  // The specification flips the lowest bit of an exponent of only ones or zeros.
  return exponent == 0 || exponent == 255 ? hash ^ 1u << 23 : hash;
}

CoverageFilm::CoverageFilm(std::size_t pixels, std::vector<std::string> names)
    : pixels_(pixels), names_(std::move(names)) {}

void CoverageFilm::add(std::size_t pixel, std::uint32_t id, float weight) {
  if (!(weight > 0.0f)) return;
  for (Share& share : pixels_[pixel]) {
    if (share.weight == 0.0f) share.id = id;
    if (share.id != id) continue;
    share.weight += weight;
    return;
  }
}

void CoverageFilm::write(const std::string& layer, ImageLayers& image) const {
  std::vector<float> hashes;
  nlohmann::ordered_json manifest = nlohmann::ordered_json::object();
  for (const std::string& name : names_) {
    const std::uint32_t hash = cryptomatte_hash(name);
    hashes.push_back(std::bit_cast<float>(hash));
    manifest[name] = hexadecimal(hash);
  }
  std::array<float*, 2 * ranks> values{};
  for (std::size_t k = 0; k < values.size(); ++k) {
    const std::string name = layer + "0" + std::to_string(k / 4) + "." + "RGBA"[k % 4];
    std::vector<float>& channel = image.channels[name];
    channel.assign(pixels_.size(), 0.0f);
    values[k] = channel.data();
  }
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    Pixel shares = pixels_[i];
    std::ranges::sort(shares, [](const Share& a, const Share& b) {
      return a.weight != b.weight ? a.weight > b.weight : a.id < b.id;
    });
    for (std::size_t rank = 0; rank < ranks && shares[rank].weight > 0.0f; ++rank) {
      values[2 * rank][i] = hashes[shares[rank].id];
      values[2 * rank + 1][i] = std::min(shares[rank].weight, 1.0f);
    }
  }
  const std::string key = "cryptomatte/" + hexadecimal(murmur_hash3(layer)).substr(0, 7) + "/";
  image.metadata[key + "name"] = layer;
  image.metadata[key + "hash"] = "MurmurHash3_32";
  image.metadata[key + "conversion"] = "uint32_to_float32";
  image.metadata[key + "manifest"] =
      manifest.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace brume
