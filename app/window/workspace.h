#pragma once

#include <QString>
#include <functional>

namespace brume {

class Document;
class MessageBar;
class SceneFiles;
class Timeline;
class ToolBox;
class ViewGrid;

// The parts of the window work on these, which outlive them.
struct Workspace {
  Document& document;
  SceneFiles& files;
  Timeline& timeline;
  ViewGrid& views;
  ToolBox& tools;
  MessageBar& messages;
  std::function<void(const QString&)> show_status;  // for some seconds
};

}  // namespace brume
