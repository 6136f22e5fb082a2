#pragma once

#include "app/window/workspace.h"

namespace brume {

// Shows in the message bar what happens to the scene's file, and what can be done about it.
void show_file_messages(const Workspace& work);

}  // namespace brume
