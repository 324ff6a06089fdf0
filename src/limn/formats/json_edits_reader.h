// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "limn/editing/edits.h"
#include "limn/model/drawing_stamp.h"

namespace limn {

struct EditsFile {
  std::vector<Edit> edits;
  // The drawing of the page that they were made in.
  DrawingStamp drawing;
};

// Reads the edits of a drawing that were made by hand, in the order in which they are applied:
//   {"format": "limn_edits", "format_version": 1,
//    "drawing": {"name": TEXT, "fingerprint": TEXT}, "edits": [EDIT, ...]}
// "drawing" may be missing.
// EDIT is one of
//   {"edit": "delete"|"restore", "links": [REF, ...]}
//   {"edit": "set_kind", "links": [REF, ...],
//    "kind": "edge"|"paint"|"shadow"|"contour"|"texture"|"unknown"}
//   {"edit": "split", "link": REF, "at": PLACE}
//   {"edit": "join", "ends": [END, END]}
//   {"edit": "merge", "links": [REF, REF]}
//   {"edit": "dimension", "from": {"link": REF, "at": PLACE}, "to": {"link": REF, "at": PLACE},
//    "shift": [x, y, z]}
//   {"edit": "remove_dimension", "from": PLACE, "to": PLACE}
// REF: {"id", "closed", "points": [PLACE, ...]}, 2 to 16 points evenly spaced along the link; END:
// {"link": REF, "end": 0|1}; PLACE: [x, y, z] in the model's coordinates, as in drawing.json.
// Members of other names are ignored. Throws IoError that names the place, such as
// edits[3].links[0].points[2].
EditsFile ReadJsonEdits(const std::string& path);

// The same from the text of a file, called `name` in messages.
EditsFile ParseJsonEdits(const std::string& name, const std::string& text);

}  // namespace limn
