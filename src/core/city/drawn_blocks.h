#pragma once

#include "core/city/footprint_layout.h"

namespace pcg {

// Blocks that somebody drew, divided into lots as those of other layouts are: a pavement along the inside of each outline, and lots of about `lot_front`
// by `lot_front` * `lot_aspect`, all with a front on that pavement. What lies between blocks, and a street's width around all, is carriageway
// without crossings. A side's street is as wide as the way straight across to the next outline, up to 40 m; `street_width` where none is nearer. Corners
// that stand out by less than a twentieth of `lot_front` (curves have many) are left out. All lots of a block have its type and height. Errors are those
// of layout_of_footprints(), parameters out of their limits, and blocks that have no room for a lot in any; some without are a warning that names them.
std::optional<Layout> layout_of_blocks(const std::vector<Footprint> &blocks, const LayoutParameters &parameters, Diagnostics &diagnostics);

} // namespace pcg
