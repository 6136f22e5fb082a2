#include "render/layers/frame_layers.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>

#include "render/layers/cryptomatte.h"
#include "render/layers/light_layers.h"
#include "render/layers/surface_layers.h"
#include "render/renderer.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

// Fog that emits, two lights, an environment, a wall.
Scene lit_scene() {
  Scene scene = on_film(cloud_scene(6, 1.0), {16, 12});
  scene.lights[0].name = "key";
  scene.lights.push_back(scene.lights[0]);
  scene.lights[1].position = {-2.0, 1.0, 1.0};
  scene.lights[1].intensity = {3.0, 1.0, 9.0};
  scene.lights[1].name = "Fill light";
  scene.environment = Environment{.file = {}, .map = constant_sky(0.5f), .intensity = 1.0};
  scene.optics.albedo = {0.9, 0.9, 0.8};
  scene.medium.append({{0.0, 0.3, 0.2}, 0.3, 1.0, {{}, {1.0, 2.0, 0.5}}});
  scene.surfaces.push_back(wall(-0.5, 0.7));
  scene.surfaces[0].name = "wall";
  return scene;
}

// `sliced`, of all orders on few nodes.
Settings quick(Scattering scattering) {
  Settings settings = sliced(24, scattering);
  settings.source_grid = {.nodes = 2000, .directions = 32};
  return settings;
}

struct Layered {
  Frame frame;
  ImageLayers image;
};
Layered layered(const Scene& scene, const Settings& settings, const OutputLayers& layers) {
  Renderer renderer;
  Layered result{renderer.render(scene, scene.camera, scene.film, settings).value(), {}};
  result.image = render_layers({scene, scene, nullptr, settings,
                                render_lit_by(renderer, {[&](double) { return scene; },
                                                         scene.time,
                                                         scene.camera,
                                                         scene.film,
                                                         {.samples = settings.samples}}),
                                result.frame},
                               layers)
                     .value();
  return result;
}

constexpr std::array channel_names{".R", ".G", ".B"};

// The sum of layers in a pixel and channel.
double sum_of(const ImageLayers& image, const std::vector<std::string>& layers, std::size_t pixel,
              std::size_t c) {
  double sum = 0.0;
  for (const std::string& layer : layers) {
    sum += static_cast<double>(image.channels.at(layer + channel_names[c])[pixel]);
  }
  return sum;
}

void expect_sum(const Layered& made, const std::vector<std::string>& layers) {
  for (std::size_t i = 0; i < made.frame.depth.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double picture = made.frame.beauty[4 * i + c];
      ASSERT_NEAR(sum_of(made.image, layers, i, c), picture, 1e-6 * std::max(picture, 1.0)) << i;
    }
  }
}

const std::vector<std::string> all_sources{
    "airlight.key",       "surface.key",          "airlight.Fill_light",
    "surface.Fill_light", "airlight.environment", "surface.environment",
    "background",         "airlight.emission",    "surface.emission"};

TEST(LightLayers, AddUpToThePicture) {
  OutputLayers layers;
  layers.lights = layers.environment = layers.emission = true;
  for (const Scattering scattering : {Scattering::single, Scattering::multiple}) {
    const Settings settings = quick(scattering);
    const Layered made = layered(lit_scene(), settings, layers);
    EXPECT_EQ(made.image.channels.size(), 3 * all_sources.size());
    expect_sum(made, all_sources);
    // To rounding the picture is that without layers, or, since each source of light is solved for
    // by itself, within the solver's tolerance.
    const Difference change =
        difference(made.frame.beauty, render_frame(lit_scene(), settings).beauty);
    EXPECT_LT(change.relative_rmse, scattering == Scattering::single ? 1e-6 : 2e-3);
    for (std::size_t i = 0; i < made.frame.depth.size(); ++i) {
      EXPECT_NEAR(sum_of(made.image,
                         {"airlight.key", "airlight.Fill_light", "airlight.environment",
                          "airlight.emission"},
                         i, 1),
                  made.frame.airlight[3 * i + 1], 1e-6);
    }
  }
}

// Surfaces that shine do so in the layers of emission, once.
TEST(LightLayers, ShiningSurfacesAreEmission) {
  Scene scene = lit_scene();
  Material& material = scene.surfaces[0].material;
  material = metallic_roughness(glm::dvec3(1.0), 1.0, 1.0, {0.5, 0.25, 0.125});
  OutputLayers layers;
  layers.lights = layers.environment = layers.emission = layers.albedo = layers.materials = true;
  const Layered made = layered(scene, quick(Scattering::single), layers);
  expect_sum(made, all_sources);
  const auto& emitted = made.image.channels.at("surface.emission.R");
  const auto& lit = made.image.channels.at("surface.key.R");
  EXPECT_GT(*std::ranges::max_element(emitted), 0.25f);
  EXPECT_GT(*std::ranges::max_element(lit), 0.0f);
  // A white metal reflects all of what it gets straight on.
  EXPECT_EQ(*std::ranges::max_element(made.image.channels.at("albedo.R")), 1.0f);
}

// One light's layers are the frame of that light.
TEST(LightLayers, AreTheLightsAlone) {
  OutputLayers layers;
  layers.lights = true;
  const Layered made = layered(lit_scene(), quick(Scattering::single), layers);
  EXPECT_EQ(made.image.channels.size(), 12u);
  Scene alone = lit_scene();
  alone.lights.erase(alone.lights.begin());
  alone.environment.reset();
  alone.medium = alone.medium.changed(0.0, [](Gaussian gaussian) {
    gaussian.optics.emission = glm::dvec3(0.0);
    return gaussian;
  });
  const Frame frame = render_frame(alone, quick(Scattering::single));
  double error = 0.0;
  double size = 0.0;
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    const double picture = frame.beauty[4 * i + 2];
    const double sum = sum_of(made.image, {"airlight.Fill_light", "surface.Fill_light"}, i, 2);
    error += (sum - picture) * (sum - picture);
    size += picture * picture;
  }
  EXPECT_LT(std::sqrt(error / size), 5e-3);  // its slices are others
  EXPECT_GT(size, 0.0);
}

TEST(LightLayers, OrdersAddUpToThePicture) {
  OutputLayers layers;
  layers.direct = layers.multiple = true;
  const Settings settings = quick(Scattering::multiple);
  const Layered made = layered(lit_scene(), settings, layers);
  double background = 0.0;
  double multiple = 0.0;
  for (std::size_t i = 0; i < made.frame.depth.size(); ++i) {
    const double picture = made.frame.beauty[4 * i];
    const double sum = sum_of(
        made.image, {"airlight.direct", "surface.direct", "airlight.multiple", "surface.multiple"},
        i, 0);
    multiple += sum_of(made.image, {"airlight.multiple"}, i, 0);
    if (std::isfinite(made.frame.depth[i])) {
      EXPECT_NEAR(sum, picture, 1e-6 * std::max(picture, 1.0));
    } else {
      background += picture - sum;  // what is behind the fog has no order
    }
  }
  EXPECT_GT(multiple, 0.0);
  EXPECT_GT(background, 0.0);
}

// Filtered pixels: what covers a part of one counts as a surface, whatever its centre shows.
TEST(LightLayers, PixelsShowSurfacesBesideTheBackground) {
  Scene scene = lit_scene();
  scene.medium = {};
  scene.film = {32, 24};
  scene.surfaces[0].rotate = glm::angleAxis(0.3, glm::dvec3(0.0, 0.0, 1.0));  // edges of any part
  Settings settings = quick(Scattering::single);
  settings.samples = matte_samples;
  OutputLayers layers;
  layers.lights = layers.environment = layers.objects = true;
  const Layered made = layered(scene, settings, layers);
  expect_sum(made, {"surface.key", "surface.Fill_light", "surface.environment", "background"});
  const auto& coverage = made.image.channels.at("CryptoObject00.G");
  int open_edges = 0;
  for (std::size_t i = 0; i < coverage.size(); ++i) {
    const double background = sum_of(made.image, {"background"}, i, 0);
    // One sample: where no other pixel beside shows the edge, it is not looked for.
    const double expected = 0.5 * (1.0 - static_cast<double>(coverage[i]));
    EXPECT_NEAR(background, expected, 0.51 / matte_samples) << i;
    if (coverage[i] < 0.1f || std::isfinite(made.frame.depth[i])) continue;
    ++open_edges;
    EXPECT_GT(sum_of(made.image, {"surface.environment"}, i, 0), 0.0);
  }
  EXPECT_GT(open_edges, 3);

  OutputLayers orders;
  orders.direct = true;
  const Layered once = layered(scene, settings, orders);
  for (std::size_t i = 0; i < coverage.size(); ++i) {
    const double sum = sum_of(once.image, {"surface.direct"}, i, 0) +
                       static_cast<double>(once.frame.background[3 * i]);
    EXPECT_NEAR(sum, once.frame.beauty[4 * i], 1e-6) << i;
    if (coverage[i] > 0.0f) continue;
    EXPECT_EQ(sum_of(once.image, {"surface.direct"}, i, 0), 0.0);
  }
}

TEST(LightLayers, NamesAreUniqueAndPlain) {
  std::vector<Light> lights(7);
  lights[0].name = "key";
  lights[1].name = "key";
  lights[2].name = "Fenêtre 1";
  lights[3].name = "direct";
  lights[5].on = false;
  lights[6].intensity = glm::dvec3(0.0);
  EXPECT_EQ(light_layer_names(lights), (std::vector<std::string>{"key", "key_2", "Fen__tre_1",
                                                                 "direct_2", "light_5", "", ""}));
}

// A pixel at z = 0, in scene units.
constexpr double pixel_size = 2.0 * 4.0 * 0.3639702343 / 32.0;

// Two walls, the left one nearer, whose right edge is in the middle of a column of pixels.
Scene two_walls() {
  Scene scene = on_film(cloud_scene(1, 0.1), {32, 32});
  scene.surfaces = {wall(0.0, 1.0, 0.25), wall(-1.0, 9.0, 0.5)};
  scene.surfaces[0].translate = {-1.0 + 0.5 * pixel_size, 0.0, 0.0};
  scene.surfaces[0].name = "left";
  scene.surfaces[0].id = 7;
  scene.surfaces[1].id = 8;
  return scene;
}

ImageLayers surface_layers(const Scene& scene, const Scene* next) {
  OutputLayers layers;
  layers.normal = layers.albedo = layers.position = layers.motion = true;
  layers.objects = layers.materials = true;
  ImageLayers image;
  add_surface_layers(scene, scene.camera, scene.film, layers, next,
                     next ? next->camera : scene.camera, {}, image);
  return image;
}

TEST(SurfaceLayers, AreWhatRaysHit) {
  const Scene scene = two_walls();
  const ImageLayers image = surface_layers(scene, nullptr);
  EXPECT_FALSE(image.channels.contains("forward.u"));
  const std::size_t left = 16 * 32 + 12;
  const std::size_t right = 16 * 32 + 26;
  EXPECT_NEAR(image.channels.at("albedo.R")[left], 0.25f, 1e-6f);
  EXPECT_NEAR(image.channels.at("albedo.G")[right], 0.5f, 1e-6f);
  EXPECT_NEAR(image.channels.at("normal.Z")[left], 1.0f, 1e-6f);
  EXPECT_NEAR(image.channels.at("normal.X")[left], 0.0f, 1e-6f);
  EXPECT_NEAR(image.channels.at("position.Z")[left], 0.0f, 1e-5f);
  EXPECT_NEAR(image.channels.at("position.Z")[right], -1.0f, 1e-5f);
  EXPECT_LT(image.channels.at("position.X")[left], 0.0f);
}

TEST(SurfaceLayers, MotionIsWhereThePointComesToBe) {
  const Scene scene = two_walls();
  Scene next = scene;
  // One pixel to the right and two up, at the wall's distance.
  next.surfaces[0].translate += glm::dvec3(pixel_size, 2.0 * pixel_size, 0.0);
  const ImageLayers image = surface_layers(scene, &next);
  const std::size_t left = 16 * 32 + 12;
  const std::size_t right = 16 * 32 + 26;
  EXPECT_NEAR(image.channels.at("forward.u")[left], 1.0f, 1e-4f);
  EXPECT_NEAR(image.channels.at("forward.v")[left], 2.0f, 1e-4f);
  EXPECT_NEAR(image.channels.at("forward.u")[right], 0.0f, 1e-4f);
  Scene turned = scene;
  turned.surfaces.clear();
  next = turned;
  next.camera.target = next.camera.eye + glm::dvec3(std::sin(0.02), 0.0, -std::cos(0.02));
  const ImageLayers sky = surface_layers(turned, &next);
  EXPECT_NEAR(sky.channels.at("forward.u")[16 * 32 + 16], -0.02 / pixel_size * scene.camera.eye.z,
              0.02);
  EXPECT_NEAR(sky.channels.at("forward.v")[16 * 32 + 16], 0.0f, 0.02f);
}

TEST(SurfaceLayers, MattesCoverPixelsInPart) {
  const Scene scene = two_walls();
  const ImageLayers image = surface_layers(scene, nullptr);
  const float left_id = std::bit_cast<float>(cryptomatte_hash("left"));
  const auto coverage = [&](std::size_t pixel) {
    float sum = 0.0f;
    for (const auto& [id, share] : {std::pair("CryptoObject00.R", "CryptoObject00.G"),
                                    {"CryptoObject00.B", "CryptoObject00.A"}}) {
      if (image.channels.at(id)[pixel] == left_id) sum += image.channels.at(share)[pixel];
    }
    return sum;
  };
  EXPECT_EQ(coverage(16 * 32 + 12), 1.0f);
  EXPECT_EQ(coverage(16 * 32 + 26), 0.0f);
  // The wall ends in the middle of column 16.
  EXPECT_EQ(coverage(16 * 32 + 15), 1.0f);
  EXPECT_NEAR(coverage(16 * 32 + 16), 0.5f, 1.0f / matte_samples);
  EXPECT_EQ(coverage(16 * 32 + 17), 0.0f);
  // Two materials, since their reflectance differs.
  EXPECT_EQ(image.channels.at("CryptoMaterial00.R")[16 * 32 + 12],
            std::bit_cast<float>(cryptomatte_hash("diffuse 1")));
}

// A pane covers as much as it hides; other layers are of the first surface that hides more than
// half.
TEST(SurfaceLayers, PanesCoverInPart) {
  Scene scene = two_walls();
  Surface pane = scene.surfaces[0];
  pane.name = "pane";
  pane.id = 9;
  pane.translate.z += 0.5;
  pane.material = metallic_roughness(glm::dvec3(1.0), 1.0, 1.0);
  pane.material.metallic_roughness.alpha = AlphaMode::blend;
  const std::size_t pixel = 16 * 32 + 12;
  const float z = surface_layers(scene, nullptr).channels.at("position.Z")[pixel];
  scene.surfaces.push_back(pane);
  for (const double opacity : {0.25, 0.75}) {
    scene.surfaces.back().material.metallic_roughness.opacity = opacity;
    const ImageLayers image = surface_layers(scene, nullptr);
    for (const auto& [name, share] : {std::pair("pane", opacity), {"left", 1.0 - opacity}}) {
      const bool is_first = image.channels.at("CryptoObject00.R")[pixel] ==
                            std::bit_cast<float>(cryptomatte_hash(name));
      EXPECT_EQ(is_first, share > 0.5) << name;
      EXPECT_NEAR(image.channels.at(is_first ? "CryptoObject00.G" : "CryptoObject00.A")[pixel],
                  share, 1e-4);
    }
    EXPECT_NEAR(image.channels.at("position.Z")[pixel], opacity > 0.5 ? z + 0.5f : z, 1e-3f);
  }
}

TEST(SurfaceLayers, NamesOfSurfacesAreThoseOfTheOutliner) {
  std::vector<Surface> surfaces(5);
  surfaces[0].name = "floor";
  surfaces[1].primitive = Primitive{};
  surfaces[2].primitive = Primitive{};
  surfaces[3].mesh_file = "/meshes/bunny.obj";
  surfaces[4].name = "floor";
  EXPECT_EQ(object_mattes(surfaces).names,
            (std::vector<std::string>{"floor", "Box", "Box (2)", "bunny.obj", "floor (2)"}));
}

TEST(SurfaceLayers, PartsOfANodeHaveOneMatte) {
  std::vector<Surface> surfaces(4);
  for (Surface& surface : surfaces) surface.name = "lamp";
  surfaces[0].id = surfaces[2].id = 5;
  surfaces[1].id = 6;
  surfaces[3].id = 5;
  surfaces[3].name = "lamp/shade";
  const Mattes mattes = object_mattes(surfaces);
  EXPECT_EQ(mattes.names, (std::vector<std::string>{"lamp", "lamp (2)", "lamp/shade"}));
  EXPECT_EQ(mattes.of_surface, (std::vector<std::uint32_t>{0, 1, 0, 2}));
}

TEST(SurfaceLayers, MaterialsHaveTheNamesOfTheirFiles) {
  std::vector<Surface> surfaces(5);
  surfaces[0].material.name = surfaces[1].material.name = "brass";
  surfaces[2].material.reflectance = glm::dvec3(0.25);
  surfaces[3].material.name = "brass";
  surfaces[3].material.reflectance = glm::dvec3(0.25);
  surfaces[4].material.name = "glass";
  const Mattes mattes = material_mattes(surfaces);
  EXPECT_EQ(mattes.names, (std::vector<std::string>{"brass", "diffuse 2", "brass (2)", "glass"}));
  EXPECT_EQ(mattes.of_surface, (std::vector<std::uint32_t>{0, 0, 1, 2, 3}));
}

TEST(FrameLayers, PlanarDepthIsThatAlongTheAxis) {
  OutputLayers layers;
  layers.planar_depth = true;
  ASSERT_TRUE(has_more_layers(layers));
  Scene scene = two_walls();
  scene.film = film_region(scene.film, {0.0, 0.25}, {0.75, 1.0});
  const Layered made = layered(scene, quick(Scattering::single), layers);
  const std::vector<float>& depth = made.image.channels.at("depth.planar");
  ASSERT_EQ(depth.size(), made.frame.depth.size());
  // The walls face the camera.
  for (std::size_t i = 0; i < depth.size(); ++i) {
    const bool is_near = std::abs(depth[i] - 4.0f) < 1e-5f;
    EXPECT_TRUE(is_near || std::abs(depth[i] - 5.0f) < 1e-5f || std::isinf(depth[i])) << depth[i];
    EXPECT_LE(depth[i], made.frame.depth[i]);
  }
  EXPECT_GT(std::ranges::count_if(depth, [](float z) { return z < 4.5f; }), 100);
}

TEST(FrameLayers, OpticalDepthIsThatOfTheTransmittance) {
  OutputLayers layers;
  layers.optical_depth = true;
  ASSERT_TRUE(has_more_layers(layers));
  const Layered made = layered(lit_scene(), quick(Scattering::single), layers);
  EXPECT_EQ(made.image.channels.size(), 3u);
  for (std::size_t i = 0; i < made.frame.depth.size(); ++i) {
    EXPECT_NEAR(std::exp(-made.image.channels.at("optical_depth.B")[i]),
                made.frame.transmittance[3 * i + 2], 1e-6);
  }
  EXPECT_FALSE(has_more_layers({}));
  EXPECT_FALSE(has_more_layers({.airlight = false}));
}

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
