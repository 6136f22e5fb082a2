#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "brume/error.h"
#include "core/io/image/exr_picture.h"
#include "core/io/image/image_file.h"
#include "render/output/compare.h"
#include "tools/brume/command.h"
#include "tools/brume/request_arguments.h"

namespace brume {
namespace {

// JSON has no infinity.
nlohmann::ordered_json finite_or_null(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

class CompareCommand final : public Command {
 public:
  explicit CompareCommand(CLI::App& app) {
    app.add_option("A", a_, "the image to check, .exr")->type_name("FILE")->required();
    app.add_option("B", b_, "the reference, .exr")->type_name("FILE")->required();
    app.add_option("--layer", layer_,
                   "compare this layer, such as airlight or Z, instead of the beauty");
    app.add_option("--max-rel-rmse", max_rel_rmse_, "exit with 1 if rel_rmse is above this")
        ->check(finite_in(0.0, 1e12));
  }

  ExitCode run() override {
    const ImageLayers a = read(a_);
    const ImageLayers b = read(b_);
    if (a.width != b.width || a.height != b.height) {
      throw InputError(a_, "", "found " + size_text(a) + " pixels; " + b_ + " has " + size_text(b));
    }
    std::vector<ChannelPair> pairs;
    const std::vector<std::string> names = channels_of(b, b_);
    if (channels_of(a, a_) != names) throw InputError(a_, "", "has different channels from " + b_);
    pairs.reserve(names.size());
    for (const std::string& name : names) {
      pairs.push_back({a.channels.at(name), b.channels.at(name)});
    }
    const Comparison result = compare(pairs);

    nlohmann::ordered_json line;
    line["rel_rmse"] = result.incomparable > 0 ? nullptr : finite_or_null(result.rel_rmse);
    line["max_error"] = result.incomparable > 0 ? nullptr : finite_or_null(result.max_error);
    line["bias"] = result.incomparable > 0 ? nullptr : finite_or_null(result.bias);
    if (result.incomparable > 0) line["incomparable"] = result.incomparable;
    print_result(line.dump() + "\n");
    if (result.incomparable > 0) {
      print_note("check failed: " + std::to_string(result.incomparable) +
                 " values are NaN or infinite in one image");
      return check_failed;
    }
    return max_rel_rmse_ && !(result.rel_rmse <= *max_rel_rmse_) ? check_failed : done;
  }

 private:
  // The layer, as it is stored; without one the picture, in linear Rec. 709.
  [[nodiscard]] ImageLayers read(const std::string& file) const {
    if (!layer_.empty()) return read_exr(file);
    std::vector<std::string> warnings;
    ExrPicture picture = read_exr_picture(file, &warnings);
    print_warnings(warnings);
    picture.convert_to_rec709();
    ImageLayers image{picture.width, picture.height, {}, {}};
    for (int c = 0; c < 3; ++c) {
      std::vector<float>& channel = image.channels[std::string(1, "RGB"[c])];
      channel.reserve(picture.pixels.size());
      for (const glm::vec3& pixel : picture.pixels) channel.push_back(pixel[c]);
    }
    return image;
  }

  static std::string size_text(const ImageLayers& image) {
    return std::to_string(image.width) + " x " + std::to_string(image.height);
  }

  [[nodiscard]] std::vector<std::string> channels_of(const ImageLayers& image,
                                                     const std::string& file) const {
    std::vector<std::string> names = layer_channels(image, layer_);
    if (!names.empty()) return names;
    std::string all;
    for (const auto& [name, values] : image.channels) all += " " + name;
    throw InputError(file, "", "there is no layer " + layer_ + "; its channels:" + all);
  }

  std::string a_;
  std::string b_;
  std::string layer_;
  std::optional<double> max_rel_rmse_;
};

}  // namespace

std::unique_ptr<Command> make_compare_command(CLI::App& app) {
  return std::make_unique<CompareCommand>(app);
}

}  // namespace brume
