#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace brume {

// Views of OpenColorIO's configurations.

// The configuration of ACES 1.0 that is built in.
inline constexpr const char* aces_config = "aces";

// Whether a configuration is a file, or else built in: aces_config, or ocio://NAME of OpenColorIO,
// from its version 2.2 on.
bool is_config_file(const std::string& config);

// The choice of a view in a configuration.
struct ColorChoice {
  std::string config;   // see is_config_file
  std::string display;  // empty: the configuration's first
  std::string view;     // empty: the display's first

  bool operator==(const ColorChoice&) const = default;
};

struct ColorDisplay {
  std::string name;
  std::vector<std::string> views;
};
// The displays of a configuration. Throws InputError.
std::vector<ColorDisplay> color_displays(const std::string& config);

// The configuration that the environment variable OCIO names, else aces_config.
std::string default_color_config();

// Linear Rec. 709 to the values of a display, as a view of a configuration has them; a view of data
// converts nothing. Where a configuration says neither what ACES2065-1 is in it (the role
// aces_interchange) nor has linear Rec. 709 under one of its usual names, its scene-linear space
// (the role scene_linear, else rendering or reference) is taken for that.
class ColorView {
 public:
  // Throws InputError that names the configuration, and what it has in place of a display or view
  // that it has not. What is wrong elsewhere in a configuration is a warning.
  explicit ColorView(const ColorChoice& choice);
  ~ColorView();

  [[nodiscard]] const ColorChoice& choice() const { return choice_; }  // none of it is empty
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }
  // That it is made from: the configuration and its LUTs; none if it is built in.
  [[nodiscard]] const std::vector<std::filesystem::path>& files() const { return files_; }
  // In place; R, G, B per pixel. Thread-safe.
  void apply(std::span<float> rgb) const;

 private:
  struct Processor;

  ColorChoice choice_;
  std::vector<std::string> warnings_;
  std::vector<std::filesystem::path> files_;
  std::unique_ptr<const Processor> processor_;
};

}  // namespace brume
