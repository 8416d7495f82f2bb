#pragma once
// Our own numbers of figures and tables, in the order in which the page shows them.

#include <fmt/format.h>

#include <string>

namespace suffuse::report {

class Numbering {
public:
    std::string next_figure() { return fmt::format("Figure {}.", ++figures_); }

    std::string next_table() { return fmt::format("Table {}.", ++tables_); }

private:
    int figures_ = 0, tables_ = 0;
};

} // namespace suffuse::report
