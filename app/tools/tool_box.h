#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <vector>

#include "app/view/tool.h"

namespace brume {

class View;

// All tools and the active one. A name in the table of tool_box.cpp is also the tool's icon and, as
// tool.<name>, its shortcut.
class ToolBox : public QObject {
  Q_OBJECT
 public:
  // `use`: makes all views work with a tool, or with none. `view`: the first one of the tools.
  ToolBox(Document& document, View& view, std::function<void(Tool*)> use, QObject* parent);
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
  void activate(const QString& name);

 Q_SIGNALS:
  void activated(std::size_t index);

 private:
  std::function<void(Tool*)> use_;
  std::vector<Entry> entries_;
  std::size_t active_ = 0;
};

}  // namespace brume
