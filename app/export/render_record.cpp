#include "app/export/render_record.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <cmath>
#include <limits>

#include "app/document/paths.h"
#include "brume/error.h"
#include "brume/limits.h"
#include "brume/request_options.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/scene/scene_file.h"
#include "core/number_domain.h"

namespace brume {
namespace {

constexpr const char* record_format = "brume-render";
constexpr std::size_t max_record = std::size_t{16} << 20;  // of a million complete frames: 8 MB
constexpr double max_number = std::numeric_limits<double>::max();

QJsonArray film_numbers(const Film& film) {
  QJsonArray numbers{film.width, film.height};
  if (const auto& region = film.region) {
    for (const int k : {region->x, region->y, region->full_width, region->full_height}) {
      numbers.append(k);
    }
  }
  return numbers;
}

// The options of a request that have a text, but those of the machine.
QJsonObject option_texts(const RenderRequest& request) {
  QJsonObject texts;
  for (const RequestOption& option : request_options()) {
    if (!option.get || std::string_view(option.name) == "threads") continue;
    const std::string text = option.get(request);
    if (!text.empty()) texts[option.name] = QString::fromStdString(text);
  }
  return texts;
}

QJsonObject look_object(const FrameExportRequest& request) {
  const DisplayLook& look = request.info.look;
  QJsonObject object{{"exposure", look.exposure}};
  const auto choice = look.view ? look.view->choice() : request.kept_view.value_or(ColorChoice{});
  if (choice.config.empty()) return object;
  object["config"] = QString::fromStdString(choice.config);
  object["display"] = QString::fromStdString(choice.display);
  object["view"] = QString::fromStdString(choice.view);
  return object;
}

class RecordReader {
 public:
  explicit RecordReader(const std::filesystem::path& file) : file_(file) {}

  RenderRecord read() {
    const std::string bytes = read_first_bytes(file_, max_record);
    QJsonParseError error{};
    const QJsonDocument json = QJsonDocument::fromJson(QByteArray::fromStdString(bytes), &error);
    if (!json.isObject()) {
      refuse("", error.error == QJsonParseError::NoError ? "a JSON object is expected"
                                                         : error.errorString());
    }
    const QJsonObject root = json.object();
    if (root["format"] != QJsonValue(record_format)) refuse("format", "it is no render");
    if (root["version"] != QJsonValue(1)) refuse("version", "allowed: 1");
    RenderRecord record;
    record.place = number(root["place"], "place", -max_number, max_number);
    FrameExportRequest& request = record.request;
    request.title = root["title"].toString();
    request.file = to_path(root["file"].toString());
    request.info.scene = root["scene_name"].toString().toStdString();
    request.info.bits = root["bits"] == QJsonValue(16) ? 16 : 8;
    if (root.contains("priority")) {
      request.priority = whole_number(root["priority"], "priority", -1, 1);
    }
    read_look(root["look"].toObject(), request);
    if (root.contains("range")) read_range(root, request);
    if (root.contains("film")) request.request.film = film_of(root["film"].toArray());
    read_options(root["options"].toObject(), request.request);
    return record;
  }

 private:
  [[noreturn]] void refuse(const QString& place, const QString& why) const {
    throw InputError(file_, place.toStdString(), why.toStdString());
  }

  [[nodiscard]] double number(const QJsonValue& value, const char* place, double low,
                              double high) const {
    const double found = value.toDouble(std::nan(""));
    if (!(found >= low && found <= high)) refuse(place, "a number is missing or out of range");
    return found;
  }

  [[nodiscard]] int whole_number(const QJsonValue& value, const char* place, int low,
                                 int high) const {
    const double found = number(value, place, low, high);
    if (found != std::floor(found)) refuse(place, "a whole number is expected");
    return static_cast<int>(found);
  }

  void read_look(const QJsonObject& look, FrameExportRequest& request) const {
    request.info.look.exposure = number(look["exposure"], "look.exposure", -max_number, max_number);
    if (!look.contains("view")) return;
    request.kept_view = ColorChoice{look["config"].toString().toStdString(),
                                    look["display"].toString().toStdString(),
                                    look["view"].toString().toStdString()};
  }

  void read_range(const QJsonObject& root, FrameExportRequest& request) const {
    const QJsonArray range = root["range"].toArray();
    const int first = whole_number(range[0], "range[0]", 0, limits::frame);
    const int last = whole_number(range[1], "range[1]", first, limits::frame);
    const double rate =
        number(range[2], "range[2]", domain::frame_rate.min_value, domain::frame_rate.max_value);
    request.range = {first, last, rate};
    for (const QJsonValue& frame : root["complete"].toArray()) {
      request.complete.insert(whole_number(frame, "complete", first, last));
    }
  }

  [[nodiscard]] Film film_of(const QJsonArray& numbers) const {
    const auto size = [&](int k, int low) {
      return whole_number(numbers[k], "film", low, limits::film_side);
    };
    Film film{size(0, 1), size(1, 1)};
    if (numbers.size() == 2) return film;
    const FilmRegion region{size(2, 0), size(3, 0), size(4, 1), size(5, 1)};
    if (region.x + film.width > region.full_width || region.y + film.height > region.full_height) {
      refuse("film", "the region is not inside of the picture");
    }
    film.region = region;
    return film;
  }

  void read_options(const QJsonObject& texts, RenderRequest& request) const {
    qsizetype known = 0;
    for (const RequestOption& option : request_options()) {
      if (!texts.contains(option.name)) continue;
      ++known;
      const std::string text = texts[option.name].toString().toStdString();
      const std::string why = option.set(request, text, Film{});
      if (!why.empty()) refuse(QString("options.") + option.name, QString::fromStdString(why));
    }
    if (known != texts.size()) refuse("options", "there is one of a newer version");
  }

  const std::filesystem::path& file_;
};

}  // namespace

QByteArray record_text(const FrameExportRequest& request, double place) {
  QJsonObject root{{"format", record_format},
                   {"version", 1},
                   {"place", place},
                   {"title", request.title},
                   {"file", to_qstring(request.file)},
                   {"scene_name", QString::fromStdString(request.info.scene)},
                   {"bits", request.info.bits},
                   {"look", look_object(request)},
                   {"options", option_texts(request.request)}};
  if (request.request.film) root["film"] = film_numbers(*request.request.film);
  if (request.priority != 0) root["priority"] = request.priority;
  if (const auto& range = request.range) {
    root["range"] = QJsonArray{range->first, range->last, range->frames_per_second};
    QJsonArray complete;
    for (const int frame : request.complete) complete.append(frame);
    root["complete"] = complete;
  }
  return QJsonDocument(root).toJson(QJsonDocument::Compact);
}

RenderRecord read_record(const std::filesystem::path& record, const std::filesystem::path& scene) {
  RenderRecord kept = RecordReader(record).read();
  kept.request.kept_scene = scene;
  return kept;
}

Scene scene_to_keep(const FrameExportRequest& request) {
  Scene scene = *request.scene;
  scene.output.file.clear();  // the record has the file
  scene.output.layers = request.request.layers;
  if (request.request.camera) {
    scene.camera = *request.request.camera;
    scene.camera_keys = {};
  }
  return scene;
}

void load_kept_scene(FrameExportRequest& request) {
  auto scene = std::make_shared<const Scene>(load_document(request.kept_scene).scene);
  request.request.layers = scene->output.layers;
  request.scene = std::move(scene);
  if (request.kept_view) {
    request.info.look.view = std::make_shared<const ColorView>(*request.kept_view);
  }
}

}  // namespace brume
