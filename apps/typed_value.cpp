#include "apps/typed_value.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/spelling.hpp"
#include "suffuse/base/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

namespace suffuse::apps {
namespace {

/// Between commas, in meters or with units.
std::vector<double> lengths_of(const std::string& text, const std::string& flag) {
    std::vector<double> values;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        values.push_back(quantity_of(text.substr(begin, end - begin), dimension::length, flag, true));
        begin = end + 1;
    }
    return values;
}

} // namespace

double quantity_of(const std::string& text, Dimension dimension, const std::string& flag, bool bare_is_si) {
    double value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, problem] = std::from_chars(text.data(), end, value);
    if (problem == std::errc() && stop == end && std::isfinite(value)) {
        if (bare_is_si) {
            return value;
        }
        constexpr double dense = 100; // [kg/m^3]: what is less means g/cm^3
        const std::string unit = dimension == dimension::time                       ? "min"
                                 : dimension == dimension::density && value < dense ? "g/cm^3"
                                                                                    : usual_units(dimension).front();
        const std::string number = dimension == dimension::time && value <= 0 ? "90" : shown(text); // 0min is no time
        throw UsageError(fmt::format("{} {} has no unit; write {}{}", flag, shown(text), number, unit));
    }
    try {
        return parse_quantity(text, dimension);
    } catch (const UnitError& error) {
        const bool means_minutes = dimension == dimension::time && text.ends_with('m');
        const std::string help = means_minutes ? fmt::format("for minutes write {}in", text) : error.help;
        throw UsageError(fmt::format("{} {}: {}; {}", flag, shown(text), shown(error.what()), help));
    }
}

std::optional<stability::FlowWay> flow_way_of(const std::string& text, const std::string& flag) {
    if (text.empty()) {
        return std::nullopt;
    }
    const auto way = stability::flow_way_of(text);
    if (!way) {
        throw UsageError(fmt::format("{} {}: expected {}", flag, shown(text), stability::flow_ways_text));
    }
    return way;
}

Mat3 cell_of(const std::string& text) {
    const std::vector<double> values = lengths_of(text, "--cell");
    Mat3 h{};
    if (values.size() == 3) {
        h = diagonal({values[0], values[1], values[2]});
    } else if (values.size() == 9) {
        for (int a = 0; a < 3; ++a) {
            for (int b = 0; b < 3; ++b) {
                h(a, b) = values[static_cast<std::size_t>(3 * a + b)];
            }
        }
    } else {
        throw UsageError(
            fmt::format("--cell {} has {} numbers; expected 3 edges or 9 numbers", shown(text), values.size())
        );
    }
    if (!(determinant(h) > 0) || !std::isfinite(determinant(h))) {
        throw UsageError(fmt::format("--cell {} has no volume; its edges are positive lengths", shown(text)));
    }
    return h;
}

io::Box box_of(const std::string& text) {
    const std::vector<double> v = lengths_of(text, "--box");
    if (v.size() != 6) {
        throw UsageError(fmt::format(
            "--box {} has {} numbers; expected 6: the lower corner, then the upper corner", shown(text), v.size()
        ));
    }
    return {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
}

} // namespace suffuse::apps
