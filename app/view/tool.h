#pragma once

#include <QObject>
#include <QPointF>
#include <Qt>
#include <span>

class QHBoxLayout;

namespace brume {

class CameraRays;
class Document;
class View;
struct Overlay;

// Base of left-button tools. A tool changes the document by commands that merge while dragging, so
// a gesture is one undo step.
class Tool : public QObject {
  Q_OBJECT
 public:
  // `view`: the initial view.
  Tool(Document& document, View& view) : document_(document), view_(&view) {}

  // The view of mouse positions; constant while a button is down.
  [[nodiscard]] View& view() const { return *view_; }
  void set_view(View& view) { view_ = &view; }

  // One line for the status bar.
  [[nodiscard]] virtual QString hint() const = 0;
  // Adds the tool's option widgets to a row; they follow options_changed().
  virtual void add_options(QHBoxLayout& /*row*/) {}

  virtual void hover(QPointF /*position*/) {}
  virtual void leave() {}  // the mouse has left the viewport
  // Pressure of a pen from 0 to 1, or 1 of a mouse; called before press() and move().
  virtual void set_pressure(double /*pressure*/) {}
  virtual void press(QPointF position, Qt::KeyboardModifiers modifiers) = 0;
  // `path`: every position of the mouse since the last call, in order; not empty.
  virtual void move(std::span<const QPointF> path) = 0;
  virtual void release(QPointF position) = 0;
  virtual void cancel() = 0;  // reverts the gesture
  // Ends the gesture without changes, when the scene (and its ids) is replaced.
  virtual void abandon() = 0;
  // Called after any medium edit, its own or others, such as undo.
  virtual void medium_changed() {}

  // Draws over the picture: in world space for all views (a brush, handles), and in film space for
  // its own view (a lasso).
  virtual void draw(Overlay& /*overlay*/, const CameraRays& /*rays*/) const {}
  virtual void draw_on_film(Overlay& /*overlay*/) const {}
  // Whether Gaussian centers are shown for picking.
  [[nodiscard]] virtual bool shows_handles() const { return true; }
  [[nodiscard]] virtual Qt::CursorShape cursor() const { return Qt::ArrowCursor; }
  // Whether each position of a gesture counts from the press on, as of a brush. Else a gesture is a
  // click until it has become a MouseDrag.
  [[nodiscard]] virtual bool draws_strokes() const { return false; }
  // Whether the tool, not the view, uses Alt + left button.
  [[nodiscard]] virtual bool uses_alt() const { return false; }

  // Multiplies size or strength; no effect for tools without.
  virtual void change_size(double /*factor*/) {}
  virtual void change_strength(double /*factor*/) {}

 Q_SIGNALS:
  void appearance_changed();  // the drawing has changed
  void options_changed();
  void refused(const QString& problem);  // why a typed option was rejected

 protected:
  Document& document_;

 private:
  View* view_;
};

}  // namespace brume
