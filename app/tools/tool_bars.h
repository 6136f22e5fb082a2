#pragma once

#include <QFrame>
#include <QToolBar>

class QStackedWidget;
class QActionGroup;

namespace brume {

class ToolBox;

// Tool buttons; their actions have the shortcuts.
class ToolBar : public QToolBar {
  Q_OBJECT
 public:
  ToolBar(ToolBox& tools, QWidget* parent);
};

// The options of the active tool in one row above the picture.
class ToolOptions : public QFrame {
  Q_OBJECT
 public:
  ToolOptions(ToolBox& tools, QWidget* parent);
};

}  // namespace brume
