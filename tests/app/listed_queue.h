#pragma once

#include <QTreeWidget>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "app/export/queue_list.h"
#include "app/export/render_queue.h"
#include "app/window/frame_output.h"
#include "render/request.h"
#include "tests/app/test_window.h"

namespace brume {

inline FrameExportRequest tiny_request(const std::filesystem::path& file = {}) {
  FrameExportRequest request;
  request.scene = std::make_shared<const Scene>(tiny_scene());
  request.file = file;
  request.request.scattering = Scattering::single;
  return request;
}

// One that is never done, as what follows it waits.
inline FrameExportRequest endless_request() {
  FrameExportRequest request = tiny_request();
  Scene big = small_scene();
  big.film = {2000, 1500};
  request.scene = std::make_shared<const Scene>(big);
  trace_paths(request.request, 100'000, Denoising::none);
  return request;
}

inline std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder,
                                                   const char* extension) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == extension) files.push_back(entry.path());
  }
  return files;
}

// Waits until a window has so many renders, the last of them done; whether it has.
inline bool wait_for_renders(TestWindow& window, std::size_t count) {
  const auto& renders = window->output().queue().items();
  return QTest::qWaitFor(
      [&] { return renders.size() == count && renders.back().state == RenderQueue::State::done; },
      patience);
}

// Renders a picture by F12; whether it gets done.
inline bool render_picture(TestWindow& window) {
  const std::size_t count = window->output().queue().items().size();
  window.key(Qt::Key_F12);
  return wait_for_renders(window, count + 1);
}

// A queue with its list, and what the mouse does in that.
struct ListedQueue {
  explicit ListedQueue(const std::filesystem::path& folder) : queue(folder), list(queue) {
    list.resize(600, 300);
    list.show();
  }
  void choose(int row) { tree()->setCurrentItem(tree()->topLevelItem(row)); }
  [[nodiscard]] QTreeWidget* tree() const { return list.findChild<QTreeWidget*>("render_queue"); }
  void click(int row, const char* button) {
    choose(row);
    brume::click(list, button);
  }
  bool wait_for(std::size_t row, RenderQueue::State state) {
    return QTest::qWaitFor([&] { return queue.items().at(row).state == state; }, patience);
  }

  RenderQueue queue;
  QueueList list;
};

}  // namespace brume
