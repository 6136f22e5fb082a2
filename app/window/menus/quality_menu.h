#pragma once

class QMenu;

namespace brume {

class PerformancePanel;
class ViewGrid;

// Fills View > Quality: the method of all views, remembered; and the reference, which the active
// view shows as its mode Path Traced. `performance` has the bound of auto.
void fill_quality_menu(QMenu& menu, ViewGrid& views, PerformancePanel& performance);

}  // namespace brume
