#pragma once

#include <QIcon>
#include <QImage>
#include <filesystem>

class QMenu;

namespace brume {

// Small pictures of scenes that were open lately, in the user's cache: by the names of their files,
// so that each has one.
void save_recent_picture(const std::filesystem::path& scene, const QImage& picture);
QIcon recent_picture(const std::filesystem::path& scene);  // null if there is none

// Lets a menu show icons of that size.
void show_large_icons(QMenu& menu);

}  // namespace brume
