#pragma once

class QMenuBar;

namespace brume {

class Document;
class ViewGrid;

// The menu Fog: ready-made fog and shapes, added where the active view looks.
void add_fog_menu(QMenuBar& bar, Document& document, ViewGrid& views);

}  // namespace brume
