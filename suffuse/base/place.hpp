#pragma once
// Where something was written: what a message points at.

#include <memory>
#include <string>

namespace suffuse {

/// A text that was read: a file, or a --set on the command line.
struct Source {
    std::string name;
    std::string text;
};

/// A stretch of one line of a source, in characters from 1; line 0 = nowhere.
struct Place {
    std::shared_ptr<const Source> source;
    int line = 0, column = 0, length = 1;
};

/// "case.toml:14:1".
std::string to_string(const Place& place);

} // namespace suffuse
