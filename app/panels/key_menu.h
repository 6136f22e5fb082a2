#pragma once

#include <functional>

class QPoint;
class QWidget;

namespace brume {

class Document;
struct Track;

// Shows the menu of a keyframe of `owner`: its interpolation, and Delete, which calls `erase`.
void show_key_menu(QWidget& owner, Document& document, const Track& row, double time,
                   const std::function<void()>& erase, const QPoint& global_position);

}  // namespace brume
