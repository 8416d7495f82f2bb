#pragma once
// The works that a page names, resolved to a list: docs/references.bib, embedded when the library is built.

#include <string>
#include <string_view>
#include <vector>

namespace suffuse::report {

/// A work of the bibliography, ready to be read.
struct Work {
    std::string key;   ///< "KenneyLau1985"
    std::string cited; ///< as texts name it: "Kenney and Lau 1985"
    std::string entry; ///< "Kenney, T. C. and Lau, D. (1985). Internal stability of granular filters. ..."
};

/// The bibliography as it was embedded: BibTeX.
std::string_view bibliography();

/// In the order of the file.
std::vector<Work> read_works(std::string_view bibtex);

/// Of a page's sections: those works that it names, by key or as texts do, in the order in which they first are. Keys
/// that stand alone in a cell become numbers that lead to the list.
struct CitedWorks {
    std::string html;        ///< the sections, with numbers for keys
    std::vector<Work> works; ///< cited
};

CitedWorks resolve_citations(std::string html, const std::vector<Work>& works);

/// HTML of the list, numbered from 1; empty without works.
std::string references_content(const std::vector<Work>& works);

} // namespace suffuse::report
