#include "core/io/ies_file.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "brume/error.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/text_scanner.h"
#include "core/number_domain.h"

namespace brume {
namespace {

struct Column {
  double azimuth = 0.0;             // [degrees]
  std::vector<double> intensities;  // at each polar angle
};

class IesReader {
 public:
  explicit IesReader(const std::filesystem::path& file) : file_(file), text_(read_bytes(file)) {
    // Numbers are separated by either.
    std::ranges::replace(text_, ',', ' ');
  }

  PhotometricProfile read() {
    skip_keywords();
    number("number of lamps");
    number("lumens per lamp");
    number("candela multiplier");  // scales all intensities
    const std::size_t polar_count = count("number of vertical angles");
    const std::size_t azimuth_count = count("number of horizontal angles");
    if (const double type = number("photometric type"); type != 1.0) {
      fail("found the photometric type " + quoted_text(std::string_view(token_)) +
           "; allowed: 1, type C");
    }
    for (const char* name : {"units type", "width", "length", "height", "ballast factor",
                             "ballast-lamp factor", "input watts"}) {
      number(name);
    }
    const std::vector<double> polar_angles = angles(polar_count, "vertical", 180.0);
    const std::vector<double> azimuths = angles(azimuth_count, "horizontal", 360.0);
    check_azimuths(azimuths);
    std::vector<Column> columns = read_columns(azimuths, polar_count);
    complete(columns);

    std::vector<double> all_azimuths;
    std::vector<double> intensities;
    for (const Column& column : columns) {
      all_azimuths.push_back(column.azimuth);
      intensities.insert(intensities.end(), column.intensities.begin(), column.intensities.end());
    }
    return {polar_angles, std::move(all_azimuths), std::move(intensities)};
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw InputError(file_, scanner_.place(), message);
  }

  // Up to the numbers of the luminaire.
  void skip_keywords() {
    constexpr std::string_view tilt = "TILT=";
    std::string_view line;
    do {
      if (!scanner_.next_line()) {
        throw InputError(file_, "",
                         "found no line that begins with TILT=; allowed: an IES LM-63 file");
      }
      line = scanner_.rest_of_line();
    } while (!line.starts_with(tilt));
    std::string_view value = scanner_.next_token();
    value.remove_prefix(tilt.size());
    scanner_.next_line();
    if (value != "INCLUDE") return;  // NONE, or a file
    number("lamp to luminaire geometry");
    const std::size_t tilts = count("number of tilt angles");
    for (std::size_t i = 0; i < 2 * tilts; ++i) number("tilt");
  }

  double number(std::string_view name) {
    token_ = scanner_.token_ahead();
    const std::optional<double> value = parse_number(token_);
    if (!value || !std::isfinite(*value)) {
      const std::string found =
          token_.empty() ? std::string("the end of the file") : quoted_text(token_);
      fail("found " + found + " as " + std::string(name) + "; allowed: a finite number");
    }
    return *value;
  }

  std::size_t count(std::string_view name) {
    const double value = number(name);
    constexpr double most = limits::profile_angles;
    if (!(value >= 1.0 && value <= most) || value != std::floor(value)) {
      fail("found " + quoted_text(token_) + " as " + std::string(name) +
           "; allowed: a whole number from 1 to " + std::to_string(limits::profile_angles));
    }
    return static_cast<std::size_t>(value);
  }

  std::vector<double> angles(std::size_t count, std::string_view which, double greatest) {
    std::vector<double> found;
    for (std::size_t i = 0; i < count; ++i) {
      const double angle = number(std::string(which) + " angle");
      const bool ascends = found.empty() || angle > found.back();
      if (!(angle >= 0.0 && angle <= greatest && ascends)) {
        fail("found the " + std::string(which) + " angle " + quoted_text(token_) +
             "; allowed: ascending angles from 0 to " + std::to_string(static_cast<int>(greatest)) +
             " degrees");
      }
      found.push_back(angle);
    }
    return found;
  }

  void check_azimuths(const std::vector<double>& azimuths) const {
    if (azimuths.size() == 1) return;
    const double first = azimuths.front();
    const double last = azimuths.back();
    const bool starts_at_0 = first == 0.0 && (last == 90.0 || last >= 180.0);
    if (starts_at_0 || (first == 90.0 && last == 270.0)) return;
    fail("found horizontal angles from " + quoted_text(first) + " to " + quoted_text(last) +
         "; allowed: one alone, from 0 to 90, 180 or 360 degrees, or from 90 to 270");
  }

  std::vector<Column> read_columns(const std::vector<double>& azimuths, std::size_t polar_count) {
    std::vector<Column> columns;
    double greatest = 0.0;
    for (const double azimuth : azimuths) {
      Column& column = columns.emplace_back(Column{azimuth, {}});
      for (std::size_t i = 0; i < polar_count; ++i) {
        const double intensity = number("candela value");
        if (!(intensity >= 0.0 && intensity <= limits::intensity)) {
          fail("found the candela value " + quoted_text(token_) +
               "; allowed: a number from 0 to 1e20");
        }
        greatest = std::max(greatest, intensity);
        column.intensities.push_back(intensity);
      }
    }
    if (!(greatest > 0.0)) fail("found no candela value above 0; allowed: one at least");
    return columns;
  }

  // Adds what symmetry says, so that azimuths reach from 0 to 360.
  static void complete(std::vector<Column>& columns) {
    if (columns.size() == 1) {
      columns.front().azimuth = 0.0;
      columns.push_back({360.0, columns.front().intensities});
      return;
    }
    if (columns.front().azimuth == 90.0) {  // to 270
      mirror(columns, 270.0);
      for (Column& column : columns) {
        column.azimuth = std::fmod(column.azimuth, 360.0);
      }
      // 90 and 450 are the same; what was mirrored from 360 on comes first.
      columns.pop_back();
      std::ranges::sort(columns, {}, &Column::azimuth);
      if (columns.front().azimuth > 0.0) insert_seam(columns);
    }
    for (const double plane : {90.0, 180.0}) {
      if (columns.back().azimuth == plane) mirror(columns, plane);
    }
    if (columns.back().azimuth < 360.0) columns.push_back({360.0, columns.front().intensities});
  }

  // Appends the mirror image at an azimuth, that of the last column.
  static void mirror(std::vector<Column>& columns, double plane) {
    for (std::size_t i = columns.size() - 1; i-- > 0;) {
      columns.push_back({2.0 * plane - columns[i].azimuth, columns[i].intensities});
    }
  }

  // A column at azimuth 0, between the last and the first.
  static void insert_seam(std::vector<Column>& columns) {
    const Column& before = columns.back();
    const Column& after = columns.front();
    const double past = 360.0 - before.azimuth;
    const double share = past / (past + after.azimuth);
    Column seam{0.0, {}};
    for (std::size_t i = 0; i < after.intensities.size(); ++i) {
      seam.intensities.push_back(std::lerp(before.intensities[i], after.intensities[i], share));
    }
    columns.insert(columns.begin(), std::move(seam));
  }

  const std::filesystem::path& file_;
  std::string text_;
  TextScanner scanner_{text_};
  std::string_view token_;  // the last number
};

}  // namespace

std::shared_ptr<const PhotometricProfile> read_ies(const std::filesystem::path& file) {
  return std::make_shared<const PhotometricProfile>(IesReader(file).read());
}

}  // namespace brume
