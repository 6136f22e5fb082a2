#include "render/layers/cryptomatte.h"

#include <gtest/gtest.h>

#include <bit>
#include <nlohmann/json.hpp>

namespace brume {
namespace {

// The values are those of the reference implementation, published with it and in tests of other
// programs.
TEST(Cryptomatte, HashIsMurmurHash3) {
  EXPECT_EQ(murmur_hash3(""), 0u);
  EXPECT_EQ(murmur_hash3("hello"), 0x248bfa47u);
  EXPECT_EQ(murmur_hash3("hello, world"), 0x149bbb7fu);
  EXPECT_EQ(murmur_hash3("The quick brown fox jumps over the lazy dog"), 0x2e4ff723u);
}

// The manifest in the specification, the key of Arnold's layer, and an object that Gaffer tests
// with: its id, and as a float.
TEST(Cryptomatte, HashesAreThoseOfOtherPrograms) {
  EXPECT_EQ(cryptomatte_hash("bunny"), 0x13851a76u);
  EXPECT_EQ(murmur_hash3("crypto_object") >> 4, 0xf834d0au);
  const std::uint32_t torso =
      cryptomatte_hash("/GAFFERBOT/C_torso_GRP/C_head_GRP/C_head_CPT/C_head001_REN");
  EXPECT_EQ(torso, 4226998693u);
  EXPECT_FLOAT_EQ(std::bit_cast<float>(torso), -2.5222249091461295e+36f);
}

TEST(Cryptomatte, HashesAreNormalFloats) {
  for (int i = 0; i < 20'000; ++i) {
    const float id = std::bit_cast<float>(cryptomatte_hash("object " + std::to_string(i)));
    ASSERT_TRUE(std::isnormal(id)) << i;
  }
}

TEST(Cryptomatte, RanksByCoverage) {
  CoverageFilm film(2, {"floor", "bunny", "lamp"});
  film.add(0, 0, 0.25f);
  film.add(0, 1, 0.25f);
  film.add(0, 2, 0.125f);
  film.add(0, 1, 0.25f);
  EXPECT_EQ(film.coverage(0, 1), 0.5f);
  EXPECT_EQ(film.coverage(1, 1), 0.0f);
  ImageLayers image{2, 1, {}, {}};
  film.write("CryptoObject", image);
  ASSERT_EQ(image.channels.size(), 12u);
  const auto at = [&](const char* channel, std::size_t pixel) {
    return image.channels.at(std::string("CryptoObject") + channel)[pixel];
  };
  const auto id = [](const char* name) { return std::bit_cast<float>(cryptomatte_hash(name)); };
  EXPECT_EQ(at("00.R", 0), id("bunny"));
  EXPECT_EQ(at("00.G", 0), 0.5f);
  EXPECT_EQ(at("00.B", 0), id("floor"));
  EXPECT_EQ(at("00.A", 0), 0.25f);
  EXPECT_EQ(at("01.R", 0), id("lamp"));
  EXPECT_EQ(at("01.G", 0), 0.125f);
  EXPECT_EQ(at("01.B", 0), 0.0f);
  EXPECT_EQ(at("00.R", 1), 0.0f);
  EXPECT_EQ(at("00.G", 1), 0.0f);
}

TEST(Cryptomatte, MetadataNamesTheLayerAndItsManifest) {
  const CoverageFilm film(1, {"bunny", "a \"quoted\" name"});
  ImageLayers image{1, 1, {}, {}};
  film.write("crypto_object", image);
  const std::string key = "cryptomatte/f834d0a/";
  EXPECT_EQ(image.metadata.at(key + "name"), "crypto_object");
  EXPECT_EQ(image.metadata.at(key + "hash"), "MurmurHash3_32");
  EXPECT_EQ(image.metadata.at(key + "conversion"), "uint32_to_float32");
  const auto manifest = nlohmann::json::parse(image.metadata.at(key + "manifest"));
  EXPECT_EQ(manifest.size(), 2u);
  EXPECT_EQ(manifest.at("bunny"), "13851a76");
  EXPECT_EQ(manifest.count("a \"quoted\" name"), 1u);
}

}  // namespace
}  // namespace brume
