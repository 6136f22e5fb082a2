#include "tests/tools/malformed_scenes.h"

#include <utility>

namespace brume {
namespace {

// A scene whose parts can be replaced one at a time by something bad.
struct Parts {
  std::string head = R"("format": "brume-scene", "version": 1)";
  std::string camera = R"({"eye": [0, 0, 5], "target": [0, 0, 0]})";
  std::string film = R"({"width": 4, "height": 3})";
  std::string medium = R"({"gaussians": [{"center": [0, 0, 0], "radius": 1, "density": 1}]})";
  std::string lights = R"([{"type": "point", "position": [1, 1, 1]}])";
  std::string surfaces = R"([{"mesh": "good.obj"}])";
  std::string more = R"("x": 0)";

  [[nodiscard]] std::string text() const {
    std::string text = "{\n" + head;
    text += ",\n\"camera\": " + camera + ",\n\"film\": " + film + ",\n\"medium\": " + medium;
    text += ",\n\"lights\": " + lights + ",\n\"surfaces\": " + surfaces + ",\n" + more + "\n}\n";
    return text;
  }
};

std::string with(std::string Parts::*part, std::string value) {
  Parts parts;
  parts.*part = std::move(value);
  return parts.text();
}
std::string camera(const std::string& members) {
  return scene_with_camera(members);
}
std::string film(const std::string& members) {
  return with(&Parts::film, "{" + members + "}");
}
std::string medium(const std::string& members) {
  return with(&Parts::medium, "{" + members + "}");
}
std::string gaussian(const std::string& members) {
  return medium(R"("gaussians": [{"center": [0, 0, 0], "radius": 1, "density": 1}, {)" + members +
                "}]");
}
std::string spot(const std::string& members) {
  return with(&Parts::lights, R"([{"type": "spot", "position": [1, 1, 1], )" + members + "}]");
}
std::string surface(const std::string& members) {
  return scene_with_surface(members);
}
std::string mesh(const std::string& file) {
  return surface("\"mesh\": \"" + file + "\"");
}
std::string medium_file(const std::string& file) {
  return medium("\"file\": \"" + file + "\"");
}
std::string material(const std::string& members) {
  return surface(R"("mesh": "good.obj", "material": {)" + members + "}");
}
std::string environment(const std::string& members) {
  return with(&Parts::more, "\"environment\": {" + members + "}");
}
std::string more(const std::string& text) {
  return with(&Parts::more, text);
}
std::string repeated(const std::string& text, std::size_t count) {
  std::string all;
  all.reserve(text.size() * count);
  for (std::size_t i = 0; i < count; ++i) all += text;
  return all;
}

std::string elements(const std::string& element, std::size_t count) {
  std::string text = "[";
  text += repeated(element + ",", count - 1);
  return text + element + "]";
}

}  // namespace

std::string scene_with_camera(const std::string& members) {
  return with(&Parts::camera, "{" + members + "}");
}

std::string scene_with_surface(const std::string& members) {
  return with(&Parts::surfaces, R"([{"mesh": "good.obj"}, {)" + members + "}]");
}

std::string scene_with_light(const std::string& members) {
  return with(&Parts::lights, "[{" + members + "}]");
}

std::string scene_with_medium(const std::string& members) {
  return medium(members);
}

std::string scene_with_environment(const std::string& members) {
  return environment(R"("file": "sky.exr", )" + members);
}

std::string scene_with_sky(const std::string& members) {
  return environment("\"sky\": {" + members + "}");
}

std::string scene_with_emitter(const std::string& members) {
  return medium(R"("emitters": [{)" + members + "}]");
}

std::string scene_with_groups(const std::string& groups) {
  return medium("\"groups\": " + groups);
}

std::string scene_with_splines(const std::string& splines) {
  return medium("\"splines\": " + splines);
}

std::string good_scene() {
  return Parts{}.text();
}

std::vector<MalformedCase> malformed_cases() {
  const std::string good = good_scene();
  std::vector<MalformedCase> all;
  const auto add = [&all](const std::string& name, const std::string& text,
                          const std::string& place, const std::vector<std::string>& said = {}) {
    all.push_back({name, text, place, said});
  };
  // A Gaussian with a bad value in place of a good one, or without it.
  const auto add_gaussian = [&add](const std::string& key, const std::string& bad,
                                   const std::string& place, const std::vector<std::string>& said) {
    std::string members = bad.empty() ? "" : "\"" + key + "\": " + bad;
    for (const auto& [name, value] :
         {std::pair("center", "[0, 0, 0]"), {"radius", "1"}, {"density", "1"}}) {
      if (name == key) continue;
      members += std::string(members.empty() ? "\"" : ", \"") + name + "\": " + value;
    }
    add("a Gaussian of " + key + " " + bad, gaussian(members), "medium.gaussians[1]." + place,
        said);
  };
  // The text itself.
  add("empty", "", "line 1, column 1");
  add("only blanks", " \n\n ", "line 3");
  add("truncated", good.substr(0, good.size() / 2), "line 5, column");
  add("truncated in a string", good.substr(0, good.find("scene")), "line 2, column");
  add("text behind the end", good + "}", "column 1", {"syntax error"});
  add("a zero byte behind the end", good + std::string("\0junk", 5), "byte", {"zero byte"});
  add("no JSON", "brume-scene 1", "line 1, column 1");
  add("binary", std::string("\x7f\x45LF\x02\x01\x01\n\xff", 9), "line 1, column 1");
  add("UTF-16", std::string("\xff\xfe{\0}\0", 6), "byte 3");
  add("a string that is not UTF-8", more("\"x\": \"\xc3(\""), "line 8", {"UTF-8"});
  add("a comment", "// scene\n" + good, "line 1");
  add("a trailing comma", more(R"("x": [1,])"), "line 8, column 9");
  add("single quotes", more("'x': 1"), "line 8, column 1");
  add("NaN", gaussian(R"("center": [0, 0, 0], "radius": NaN)"), "line 5", {"literal"});
  add("Infinity", medium(R"("density": Infinity)"), "line 5", {"literal"});
  add("-Infinity", medium(R"("density": -Infinity)"), "line 5");
  add("a number beyond double", medium(R"("density": 1e999)"), "line 5", {"1e999"});
  add("a hexadecimal number", film(R"("width": 0x10)"), "line 4");
  add("a control character in a string", more("\"x\": \"a\nb\""), "line 8");
  add("a key twice", medium(R"("density": 1, "density": 2)"), "medium.density", {"twice"});
  add("an unknown key twice", more(R"("a": {"b": [0, {"c": 1, "c": 2}]})"), "a.b[1].c", {"twice"});
  add("nesting too deep", more("\"x\": " + repeated("[", 100) + repeated("]", 100)), "x[0][0]",
      {"nesting", "64"});
  add("nesting far too deep", more("\"x\": " + repeated("{\"a\":", 200'000)), "x.a.a", {"64"});
  add("too many keys", more([] {
        std::string keys = R"("x": {"k": 0)";
        for (int i = 0; i < 1100; ++i) (((keys += ",\"k") += std::to_string(i)) += "\": 0");
        return keys + "}";
      }()),
      "x.k1022", {"1024 keys"});

  // The head.
  add("an array", "[]", "scene.brume", {"found an array of 0 elements", "an object"});
  add("a number", "1", "scene.brume", {"found 1", "an object"});
  add("no format", with(&Parts::head, R"("version": 1)"), "format", {"missing"});
  add("another format", with(&Parts::head, R"("format": "usd", "version": 1)"), "format",
      {"\"usd\"", "brume-scene"});
  add("format of another type", with(&Parts::head, R"("format": 3, "version": 1)"), "format",
      {"found 3"});
  add("no version", with(&Parts::head, R"("format": "brume-scene")"), "version", {"missing"});
  add("a newer version", with(&Parts::head, R"("format": "brume-scene", "version": 2)"), "version",
      {"found 2", "newer"});
  add("version 0", with(&Parts::head, R"("format": "brume-scene", "version": 0)"), "version");
  add("version as text", with(&Parts::head, R"("format": "brume-scene", "version": "1")"),
      "version", {"found \"1\""});

  // Camera and film.
  add("camera of another type", with(&Parts::camera, "[]"), "camera", {"an object"});
  add("camera null", with(&Parts::camera, "null"), "camera", {"found null"});
  add("eye at the target", camera(R"("eye": [1, 2, 3], "target": [1, 2, 3])"), "camera.target",
      {"any other point"});
  add("up of length 0", camera(R"("up": [0, 0, 0])"), "camera.up", {"length 0"});
  add("width 0", film(R"("width": 0)"), "film.width", {"found 0", "1 to 16384"});
  add("negative height", film(R"("height": -3)"), "film.height", {"found -3"});
  add("width too great", film(R"("width": 16385)"), "film.width", {"16384"});
  add("width beyond 64 bits", film(R"("width": 18446744073709551617)"), "film.width");
  add("half a pixel", film(R"("width": 4.5)"), "film.width", {"found 4.5", "integer"});
  add("width as text", film(R"("width": "4")"), "film.width", {"found \"4\""});

  // The medium.
  add("medium of another type", with(&Parts::medium, "7"), "medium", {"found 7"});
  add("negative b0", medium(R"("density": -1e-9)"), "medium.density", {">= 0"});
  add("b0 true", medium(R"("density": true)"), "medium.density", {"found true"});
  add("gaussians as an object", medium(R"("gaussians": {})"), "medium.gaussians", {"an array"});
  add("a gaussian that is none", medium(R"("gaussians": [1])"), "medium.gaussians[0]");
  for (const char* key : {"center", "radius", "density"}) add_gaussian(key, "", key, {"missing"});
  add_gaussian("albedo", "[1, 0, 1]", "albedo[1]", {"found 0", "(0, 1]"});
  add_gaussian("albedo", "null", "albedo", {"found null"});
  add_gaussian("emission", "3", "emission", {"found 3"});
  add_gaussian("emission", "[1, -1, 0]", "emission[1]", {"found -1", ">= 0"});
  add_gaussian("radius", "0", "radius", {"found 0", "a number > 0"});
  add_gaussian("radius", "-0.5", "radius", {"found -0.5", "allowed: a number > 0"});
  add_gaussian("radius", "null", "radius", {"found null"});
  add_gaussian("density", "-1", "density", {"found -1", ">= 0"});
  add_gaussian("center", "[0, 0, 0, 0]", "center", {"4 elements"});
  add_gaussian("center", "[0, -1e300, 0]", "center[1]", {"found -1e+300"});
  add("too many gaussians", medium("\"gaussians\": [" + repeated("0,", 10'000'000) + "0]"),
      "medium.gaussians", {"10000000"});
  add("noise of another type", medium(R"("noise": 1)"), "medium.noise", {"an object"});

  // The medium's file.
  add("medium file missing", medium_file("none.ply"), "medium.file", {"none.ply", "no such file"});
  add("medium file a folder", medium_file("folder"), "medium.file", {"folder", "not a file"});
  add("medium file empty", medium_file("empty"), "medium.file", {"empty", "PLY"});
  add("medium file the scene itself", medium_file("scene.brume"), "medium.file", {"itself"});
  add("medium file a mesh", medium_file("mesh.ply"), "medium.file", {"mesh.ply", "radius"});
  add("medium file of a huge count", medium_file("huge.ply"), "medium.file", {"huge.ply"});
  add("medium file a number", medium(R"("file": 1)"), "medium.file", {"found 1", "a string"});
  add("medium file without a name", medium_file(""), "medium.file", {"a file name"});
  add("medium file with a zero byte", medium_file("a\\u0000b"), "medium.file", {"a file name"});
  add("medium file with a long name", medium_file(std::string(5000, 'a')), "medium.file");

  // Lights.
  add("lights as an object", with(&Parts::lights, "{}"), "lights", {"an array"});
  add("a light without type", scene_with_light(R"("position": [0, 0, 0])"), "lights[0].type",
      {"missing"});
  add("an unknown light", scene_with_light(R"("type": "laser", "position": [0, 0, 0])"),
      "lights[0].type", {"\"laser\"", "\"point\""});
  add("a spot that shines nowhere", spot(R"("direction": [0, 0, 0])"), "lights[0].direction",
      {"length 0", "allowed"});
  add("a spot whose inner angle is above the outer one",
      spot(R"("direction": [0, -1, 0], "inner_angle": 30.5, "outer_angle": 30)"),
      "lights[0].inner_angle", {"30.5", "at most outer_angle"});
  add("a directional light that shines nowhere",
      scene_with_light(R"("type": "directional", "irradiance": [1, 1, 1], "direction": [0, 0, 0])"),
      "lights[0].direction", {"length 0", "allowed"});
  add("a disk that faces nowhere",
      scene_with_light(
          R"("type": "disk", "position": [0, 0, 0], "direction": [0, 0, 0], "radius": 1,
           "radiance": [1, 1, 1])"),
      "lights[0].direction", {"length 0", "allowed"});
  add("too many lights",
      with(&Parts::lights, elements(R"({"type": "point", "position": [0, 0, 0]})", 1025)), "lights",
      {"1025", "1024"});

  // Surfaces.
  add("surfaces as a text", with(&Parts::surfaces, "\"x\""), "surfaces", {"an array"});
  add("no mesh", surface("\"scale\": 1"), "surfaces[1].mesh", {"missing"});
  add("mesh missing", mesh("none.obj"), "surfaces[1].mesh", {"none.obj", "no such file"});
  add("mesh a folder", mesh("folder"), "surfaces[1].mesh", {"folder", "not a file"});
  add("mesh in a file", mesh("good.obj/a.obj"), "surfaces[1].mesh", {"good.obj/a.obj"});
  add("mesh a circle of links", mesh("loop.obj"), "surfaces[1].mesh", {"loop.obj"});
  add("mesh the scene itself", mesh("../scene/scene.brume"), "surfaces[1].mesh", {"itself"});
  add("mesh a link to the scene", mesh("self.obj"), "surfaces[1].mesh", {"itself"});
  add("mesh a device", mesh("/dev/zero"), "surfaces[1].mesh", {"/dev/zero", "regular"});
  add("mesh of an unknown format", mesh("empty"), "surfaces[1].mesh", {"format", ".obj"});
  add("mesh of Gaussians", mesh("nan.ply"), "surfaces[1].mesh", {"nan.ply", "no faces"});
  add("scale 0", surface(R"("mesh": "good.obj", "scale": 0)"), "surfaces[1].scale", {"> 0"});
  add("negative scale", surface(R"("mesh": "good.obj", "scale": -1)"), "surfaces[1].scale");
  add("rotation of three", surface(R"("mesh": "good.obj", "rotate": [1, 0, 0])"),
      "surfaces[1].rotate", {"4 numbers"});
  add("rotation not unit", surface(R"("mesh": "good.obj", "rotate": [1, 1, 0, 0])"),
      "surfaces[1].rotate", {"length 1.41421356"});
  add("rotation 0", surface(R"("mesh": "good.obj", "rotate": [0, 0, 0, 0])"), "surfaces[1].rotate",
      {"length 0"});
  add("unknown transfer", surface(R"("mesh": "good.obj", "transfer": "all")"),
      "surfaces[1].transfer", {"interreflection"});
  add("too many surfaces", with(&Parts::surfaces, elements(R"({"mesh": "good.obj"})", 4097)),
      "surfaces", {"4097", "4096"});

  // Materials and the environment.
  add("unknown material", material(R"("type": "glass")"), "surfaces[1].material.type",
      {"\"glass\"", "\"diffuse\", \"phong\", \"measured\""});
  add("measured without file", material(R"("type": "measured")"), "surfaces[1].material.file",
      {"missing"});
  add("measured with another file", material(R"("type": "measured", "file": "good.obj")"),
      "surfaces[1].material.file", {"good.obj", "90 x 90 x 180"});
  add("measured truncated", material(R"("type": "measured", "file": "short.binary")"),
      "surfaces[1].material.file", {"short.binary", "bytes"});
  // Keys.
  add("keys of a value that are no array",
      camera(R"("keys": {"eye": {"time": 0, "value": [0, 0, 5]}})"), "camera.keys.eye",
      {"an object", "an array"});
  add("a key without time", medium(R"("keys": {"density": [{"value": 1}]})"),
      "medium.keys.density[0].time", {"missing"});
  add("a key without value", medium(R"("keys": {"density": [{"time": 1}]})"),
      "medium.keys.density[0].value", {"missing"});
  add("a negative density at a key",
      medium(R"("keys": {"density": [{"time": 0, "value": 1}, {"time": 1, "value": -1}]})"),
      "medium.keys.density[1].value", {"found -1", ">= 0"});
  add("keys in no order", medium(R"("noise": {"keys": {"amplitude":
             [{"time": 1, "value": 1}, {"time": 0.5, "value": 1}]}})"),
      "medium.noise.keys.amplitude[1].time", {"0.5 after 1", "increase"});
  add("a key at no time a clock has",
      camera(R"("keys": {"vertical_fov": [{"time": 1e300, "value": 40}]})"),
      "camera.keys.vertical_fov[0].time", {"1e9"});

  add("environment without file", environment("\"rotation\": 0"), "environment.file", {"missing"});
  add("environment of two kinds", environment(R"("file": "none.exr", "sky": {"elevation": 3})"),
      "environment.sky", {"file", "one of the two"});
  add("a sky without elevation", environment(R"("sky": {"turbidity": 3})"),
      "environment.sky.elevation", {"missing"});
  add("a sky that is none", environment(R"("sky": true)"), "environment.sky", {"object"});
  add("environment missing", environment(R"("file": "none.exr")"), "environment.file",
      {"none.exr", "no such file"});
  add("environment that is no image", environment(R"("file": "not.exr")"), "environment.file",
      {"not.exr", "OpenEXR"});
  add("environment with a magic number only", environment(R"("file": "magic.exr")"),
      "environment.file", {"magic.exr", "OpenEXR"});
  add("environment without colours", environment(R"("file": "depth.exr")"), "environment.file",
      {"depth.exr", "channels R G B"});
  return all;
}

}  // namespace brume
