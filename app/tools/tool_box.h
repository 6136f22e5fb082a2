#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <vector>

#include "app/tools/tool.h"

namespace brume {

class ViewGrid;

// All tools, and which of them has the left mouse button. The table in tool_box.cpp is where a tool
// gets its name, which is also that of its icon and, as tool.<name>, of its key.
class ToolBox : public QObject {
  Q_OBJECT
 public:
  ToolBox(Document& document, ViewGrid& views, QObject* parent);
  ~ToolBox() override;

  struct Entry {
    QString name;   // "paintbrush"
    QString title;  // "Paintbrush"
    std::unique_ptr<Tool> tool;
  };
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }
  [[nodiscard]] std::size_t active() const { return active_; }
  [[nodiscard]] Tool& tool() const { return *entries_[active_].tool; }
  void activate(std::size_t index);

 Q_SIGNALS:
  void activated(std::size_t index);

 private:
  ViewGrid& views_;
  std::vector<Entry> entries_;
  std::size_t active_ = 0;
};

}  // namespace brume
