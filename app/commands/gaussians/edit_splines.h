#pragma once

#include <QString>

#include "brume/painted_spline.h"

namespace brume {

class Document;

// Edits of splines that fog was painted along, each one undo step; their points are edited by
// app/tools/brushes/spline_tool. Ids of splines that are not there change nothing.

// A new one with an id and name of its own, not in the scene yet.
PaintedSpline new_spline(const Document& document);
// Selects those of its Gaussians that can be selected.
void select_spline(Document& document, SplineId spline);
// Without blanks at its ends; numbered if another spline has the name. An empty one changes
// nothing.
void rename_spline(Document& document, SplineId spline, const QString& name);
// With its Gaussians; or without, which then cannot be painted again.
void delete_spline(Document& document, SplineId spline);
void release_spline(Document& document, SplineId spline);

// Those of its Gaussians that are still in the medium.
std::vector<GaussianId> present_gaussians(const Document& document, const PaintedSpline& spline);

}  // namespace brume
