#pragma once

#include <QWidgetList>

class QWidget;

namespace brume {

// The label and the values of the row of a form that a widget is in, the label first; empty: it is
// in none.
QWidgetList row_with(QWidget* widget);

}  // namespace brume
