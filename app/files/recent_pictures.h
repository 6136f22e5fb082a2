#pragma once

#include <QIcon>
#include <QImage>
#include <filesystem>

class QMenu;

namespace brume {

// Thumbnails of recent scenes in the user's cache, by file name.
void save_recent_picture(const std::filesystem::path& scene, const QImage& picture);
QIcon recent_picture(const std::filesystem::path& scene);  // null if none
QImage recent_image(const std::filesystem::path& scene);   // the same, for any thread

// Lets a menu show icons of that size.
void show_large_icons(QMenu& menu);

}  // namespace brume
