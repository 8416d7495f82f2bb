#include "suffuse/base/place.hpp"

#include <fmt/format.h>

namespace suffuse {

std::string to_string(const Place& place) {
    if (!place.source) {
        return "the case";
    }
    return place.line == 0 ? place.source->name : fmt::format("{}:{}:{}", place.source->name, place.line, place.column);
}

} // namespace suffuse
