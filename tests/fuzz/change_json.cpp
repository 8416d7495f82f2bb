#include "tests/fuzz/change_json.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace suffuse::fuzz {
namespace {

using nlohmann::json;

/// What a reader may not have thought of.
json strange_value(Bytes& bytes) {
    static const std::array<json, 20> values = {
        json(),
        true,
        0,
        -1,
        1,
        7,
        std::numeric_limits<std::int64_t>::max(),
        std::numeric_limits<std::int64_t>::min(),
        std::numeric_limits<std::uint64_t>::max(),
        0.5,
        -1e-300,
        1e300,
        std::nan(""),
        std::numeric_limits<double>::infinity(),
        "",
        "\xff\x1b[31m",
        std::string(300, 'x'),
        json::array(),
        json::object(),
        json::array({json::array({0, 0}), json::array({1e9, -1})})};
    return values[bytes.next() % values.size()];
}

void change_here(json& value, Bytes& bytes) {
    const std::uint8_t what = bytes.next() % 8;
    if (what < 4 || !value.is_structured() || value.empty()) {
        value =
            value.is_number() && what == 0 ? json(value.get<double>() * (bytes.next() - 100)) : strange_value(bytes);
        return;
    }
    const auto at = std::next(value.begin(), static_cast<std::ptrdiff_t>(bytes.next_pair() % value.size()));
    if (value.is_object()) {
        const std::string key = at.key();
        const json moved = *at;
        value.erase(key);
        if (what != 4) {
            value[what == 5 ? "" : what == 6 ? key + "x" : value.empty() ? key : value.begin().key()] = moved;
        }
        return;
    }
    switch (what) {
    case 4:
        value.erase(at);
        break;
    case 5:
        value.erase(at, value.end());
        break;
    case 6:
        value.push_back(json(*at));
        break;
    default:
        std::swap(*at, value.front());
    }
}

} // namespace

void change(json& document, Bytes& bytes) {
    json* place = &document;
    while (place->is_structured() && !place->empty() && bytes.next() % 8 != 7) {
        place = &*std::next(place->begin(), static_cast<std::ptrdiff_t>(bytes.next_pair() % place->size()));
    }
    change_here(*place, bytes);
}

} // namespace suffuse::fuzz
