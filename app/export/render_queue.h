#pragma once

#include <QObject>
#include <QString>
#include <map>
#include <optional>
#include <vector>

#include "app/export/frame_export.h"
#include "app/export/kept_renders.h"

namespace brume {

// Renders to files and pictures, one after the other in the background, each of the scene as it was
// when it was added. Leaves a part of the cores to the views. What it does not finish, a queue of a
// later session takes from the folder, stopped.
class RenderQueue : public QObject {
  Q_OBJECT
 public:
  explicit RenderQueue(const std::filesystem::path& folder, QObject* parent = nullptr);

  enum class State { waiting, rendering, done, cancelled, failed, stopped };
  struct Item {
    int id = 0;  // > 0
    FrameExportRequest request;
    State state = State::waiting;
    int percent = 0;
    QString message{};                // why it failed
    double milliseconds = 0.0;        // of its frames so far
    int rendered = 0;                 // how many they are
    std::map<int, QString> failed{};  // frames, and why
    QString kept{};                   // its name among the kept renders
    double place = 0.0;               // among them
    // False also of one whose files are damaged.
    [[nodiscard]] bool can_resume() const;
  };
  // The time that an item needs, where frames of it or of another one tell; for all that are
  // unfinished together.
  [[nodiscard]] std::optional<double> seconds_left(const Item& item) const;
  [[nodiscard]] std::optional<double> seconds_left() const;
  [[nodiscard]] const std::vector<Item>& items() const { return items_; }  // in order
  [[nodiscard]] const Item* find(int id) const;
  [[nodiscard]] int unfinished() const;  // how many wait or are rendered
  [[nodiscard]] int stopped() const;     // how many of an earlier session

  // False, and refused(), if one that has yet to be rendered writes the same file.
  [[nodiscard]] bool may_write(const FrameExportRequest& request);
  // Its id; 0 if it may not write.
  int add(FrameExportRequest request);
  void cancel(int id);  // what waits, at once
  void remove(int id);  // cancels it first
  // Renders that failed, were cancelled or stopped go on: ranges with the frames that are missing.
  void resume(int id);
  // Moves one that waits before the one that waits before it, or after the next.
  void move(int id, bool sooner);
  // Moves one that waits before any other; 0: behind all.
  void move_before(int id, int other);
  // The first of those that wait with the highest priority is rendered next.
  void set_priority(int id, int priority);

  // The exporter renders, and tells of single frames.
  [[nodiscard]] FrameExport& exporter() { return export_; }
  [[nodiscard]] const KeptRenders& kept() const { return kept_; }

 Q_SIGNALS:
  void changed();
  void refused(const QString& why);
  void progressed(int id, int percent);
  void rendered(int id, const brume::ExportedFrame& frame);

 private:
  [[nodiscard]] Item* item(int id);
  [[nodiscard]] Item* waiting_beside(int id, bool sooner);
  void take_left();
  void erase(int id);
  void update(const Item& item) { kept_.update(item.kept, item.request, item.place); }
  void start_next();
  void end(State state, const QString& message = {});

  std::vector<Item> items_;
  int last_id_ = 0;
  int running_ = 0;  // id; 0: none
  bool removes_running_ = false;
  KeptRenders kept_;
  FrameExport export_;
};

}  // namespace brume
