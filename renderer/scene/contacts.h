#pragma once
#include <vector>

#include "scene/scene.h"

namespace brewster {

/// For each chart, the lines within its rectangle along which other surfaces touch or cross its plane: where light may
/// jump, so where bins should be split first. Lines along the rectangle's own border are left out, pieces of one line
/// are joined, and a chart keeps its 64 longest. Curved patches neither get nor leave any: only straight lines can be
/// borders of bins. A scene of more than 20000 surfaces gets none: its facets are so small that lines on them help no
/// bin. O(n log n) unless everything touches everything.
std::vector<std::vector<Contact>> chart_contacts(const Scene& scene);

}  // namespace brewster
