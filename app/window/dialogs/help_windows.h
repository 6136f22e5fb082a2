#pragma once

#include <QList>
#include <QString>
#include <filesystem>

class QAction;
class QWidget;

namespace brume {

// Modeless help windows.
void show_about(QWidget* parent);
void show_keys(QWidget* parent, const QList<QAction*>& actions);

// Opens the manual in `folder` with the desktop's browser. What went wrong; empty: nothing.
QString open_manual(const std::filesystem::path& folder);

}  // namespace brume
