#include "app/tools/brushes/brush_library.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>
#include <array>

#include "app/document/paths.h"
#include "app/document/private_files.h"
#include "brume/error.h"
#include "core/io/disk/atomic_file.h"
#include "core/io/disk/file_bytes.h"
#include "core/number_domain.h"

namespace brume {
namespace {

constexpr qsizetype max_brushes = 1000;
constexpr qsizetype max_name = 100;

struct LibraryKey {
  const char* name;
  double BrushPreset::*member;
  NumberDomain domain;
};
constexpr NumberDomain relative_size{1e-6, 100.0, "a number from 1e-6 to 100"};
constexpr NumberDomain relative_number{0.0, 100.0, "a number from 0 to 100"};
constexpr std::array library_keys = std::to_array<LibraryKey>({
    {"size", &BrushPreset::size, relative_size},
    {"depth", &BrushPreset::depth, {0.0, 1e6, "a number from 0 to 1e6"}},
    {"jitter", &BrushPreset::jitter, domain::unit},
    {"smoothing", &BrushPreset::smoothing, {0.0, 500.0, "a number of pixels from 0 to 500"}},
    {"stretch", &BrushPreset::stretch, domain::brush_stretch},
    {"spacing", &BrushPreset::spacing, domain::brush_spacing},
    {"scatter", &BrushPreset::scatter, domain::brush_scatter},
    {"falloff", &BrushPreset::falloff, domain::unit},
    {"flow", &BrushPreset::flow, domain::unit},
    {"rate", &BrushPreset::rate, {0.0, 1e4, "a number from 0 to 10000"}},
    {"speed", &BrushPreset::speed, relative_number},
    {"spread", &BrushPreset::spread, relative_number},
    {"wander", &BrushPreset::wander, relative_number},
});

const char* tool_key(bool sprays) {
  return sprays ? "airbrush" : "paintbrush";
}

// `root`: what else the file has.
std::string library_text(QJsonObject root, const QJsonArray& brushes) {
  root["format"] = "brume-brushes";
  root["version"] = 1;
  root["brushes"] = brushes;
  return QJsonDocument(root).toJson().toStdString();
}

// `object`: what else the file has of the brush.
QJsonObject brush_object(const BrushPreset& preset, QJsonObject object) {
  object["name"] = preset.name.left(max_name);
  object["tool"] = tool_key(preset.sprays);
  for (const LibraryKey& key : library_keys) {
    object[QLatin1String(key.name)] = preset.*key.member;
  }
  return object;
}

// Reads a library with its JSON kept, to change it.
struct LibraryFile {
  std::filesystem::path file;
  QJsonObject root;
  std::vector<BrushPreset> presets;

  [[noreturn]] void refuse(const QString& place, const QString& message) const {
    throw InputError(file, place.toStdString(), message.toStdString());
  }

  void parse(const QByteArray& bytes) {
    QJsonParseError error{};
    const QJsonDocument json = QJsonDocument::fromJson(bytes, &error);
    if (!json.isObject()) {
      refuse(QString("byte %1").arg(error.offset), error.error == QJsonParseError::NoError
                                                       ? "a JSON object is expected"
                                                       : error.errorString());
    }
    root = json.object();
    if (root["format"] != QJsonValue("brume-brushes")) {
      refuse("format", "allowed: \"brume-brushes\"");
    }
    if (root["version"] != QJsonValue(1)) refuse("version", "allowed: 1");
    if (!root["brushes"].isArray()) refuse("brushes", "a list is expected");
    const QJsonArray brushes = root["brushes"].toArray();
    if (brushes.size() > max_brushes) {
      refuse("brushes", QString("more than %1 brushes").arg(max_brushes));
    }
    for (qsizetype k = 0; k < brushes.size(); ++k) presets.push_back(parse_brush(brushes[k], k));
  }

  [[nodiscard]] BrushPreset parse_brush(const QJsonValue& value, qsizetype index) const {
    const QString place = QString("brushes[%1]").arg(index);
    if (!value.isObject()) refuse(place, "an object is expected");
    const QJsonObject object = value.toObject();
    BrushPreset preset;
    preset.name = object["name"].toString();
    if (preset.name.isEmpty() || preset.name.size() > max_name) {
      refuse(place + ".name", QString("allowed: a text of 1 to %1 characters").arg(max_name));
    }
    const QString tool = object["tool"].toString();
    preset.sprays = tool == tool_key(true);
    if (!preset.sprays && tool != tool_key(false)) {
      refuse(place + ".tool", R"(allowed: "paintbrush" or "airbrush")");
    }
    for (const LibraryKey& key : library_keys) {
      const QJsonValue number = object[QLatin1String(key.name)];
      if (number.isUndefined()) continue;
      const QString member_place = QString("%1.%2").arg(place, key.name);
      if (!number.isDouble()) refuse(member_place, QString("allowed: %1").arg(key.domain.allowed));
      if (!key.domain.contains(number.toDouble())) {
        refuse(member_place, QString::fromStdString(key.domain.refusal(number.toDouble())));
      }
      preset.*key.member = number.toDouble();
    }
    return preset;
  }

  [[nodiscard]] qsizetype find(const BrushPreset& preset) const {
    for (std::size_t k = 0; k < presets.size(); ++k) {
      if (presets[k].name == preset.name && presets[k].sprays == preset.sprays) {
        return static_cast<qsizetype>(k);
      }
    }
    return -1;
  }

  void write(const QJsonArray& brushes) {
    make_private_folder(file.parent_path());
    write_private(file, library_text(root, brushes));
  }
};

LibraryFile open_library(const std::filesystem::path& file) {
  LibraryFile library{file, {}, {}};
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return library;
  library.parse(QByteArray::fromStdString(read_bytes(file)));
  return library;
}

}  // namespace

std::filesystem::path BrushLibrary::default_file() {
  return to_path(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) +
                 "/brushes.json");
}

std::vector<BrushPreset> BrushLibrary::read() const {
  return open_library(file_).presets;
}

void BrushLibrary::add(const BrushPreset& preset) const {
  LibraryFile library = open_library(file_);
  QJsonArray brushes = library.root["brushes"].toArray();
  const qsizetype present = library.find(preset);
  const QJsonObject object =
      brush_object(preset, present < 0 ? QJsonObject() : brushes[present].toObject());
  if (present < 0) {
    brushes.append(object);
  } else {
    brushes[present] = object;
  }
  library.write(brushes);
}

void BrushLibrary::replace(const BrushPreset& preset) const {
  write_atomically(file_, library_text({}, {brush_object(preset, {})}));
}

void BrushLibrary::remove(const BrushPreset& preset) const {
  LibraryFile library = open_library(file_);
  const qsizetype present = library.find(preset);
  if (present < 0) return;
  QJsonArray brushes = library.root["brushes"].toArray();
  brushes.removeAt(present);
  library.write(brushes);
}

}  // namespace brume
