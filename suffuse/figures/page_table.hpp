#pragma once
// A table of words and numbers at the head of one of the report's sections.

#include <string>
#include <vector>

namespace suffuse::figures {

struct PageTable {
    std::string section; ///< as of a figure: "Soils", ...
    std::string title;
    std::string note; ///< a sentence below the title; may be empty
    std::vector<std::string> header;
    std::vector<std::vector<std::string>> rows; ///< each as wide as the header
    std::vector<bool> numeric;                  ///< which columns are set flush right
};

} // namespace suffuse::figures
