#pragma once

class QMenu;

namespace brume {

class Document;

// A menu of the groups that the selection can be moved to.
void fill_group_menu(QMenu& menu, Document& document);

}  // namespace brume
