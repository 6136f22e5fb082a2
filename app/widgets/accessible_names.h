#pragma once

class QWidget;

namespace brume {

// Names a widget that one acts on for programs that read the screen, unless its own text or
// accessible name says what it is: by the label before it, its tool tip, or the panel it is in.
// Called again, it updates a name that it gave.
void update_accessible_name(QWidget& widget);

}  // namespace brume
