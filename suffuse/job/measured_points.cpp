#include "suffuse/job/measured_points.hpp"

#include "suffuse/io/text_file.hpp"

#include <fmt/format.h>

#include <limits>
#include <map>

namespace suffuse::job {

figures::Points read_points(const std::filesystem::path& path) {
    const std::string text = io::read_text(path);
    io::LineReader reader(path.string(), text);
    if (!reader.next()) {
        reader.complain("there is no header; its first line names columns of the figure, as in axial_strain [%]");
    }
    std::vector<std::string> names, units;
    for (const std::string_view heading : io::split_at(reader.line(), ',')) {
        const std::size_t bracket = heading.find(" [");
        names.emplace_back(heading.substr(0, bracket));
        const bool has_unit = bracket != std::string_view::npos && heading.ends_with(']');
        units.emplace_back(has_unit ? heading.substr(bracket + 2, heading.size() - bracket - 3) : "");
    }
    std::vector<std::vector<double>> numbers(names.size());
    std::map<std::string, std::vector<std::string>> words; // of the columns that hold some
    const auto holds_words = [](const std::string& name) { return name == "series" || name == "panel"; };
    while (reader.next()) {
        const std::vector<std::string_view> fields = io::split_at(reader.line(), ',');
        if (fields.size() != names.size()) {
            reader.complain(fmt::format("{} fields, and the header has {}", fields.size(), names.size()));
        }
        for (std::size_t c = 0; c < fields.size(); ++c) {
            if (holds_words(names[c])) {
                words[names[c]].emplace_back(fields[c]);
            } else {
                numbers[c].push_back(
                    fields[c].empty() ? std::numeric_limits<double>::quiet_NaN()
                                      : io::to_number(reader, fields[c], names[c])
                );
            }
        }
    }
    figures::Points points;
    for (std::size_t c = 0; c < names.size(); ++c) {
        if (holds_words(names[c])) {
            points.add(names[c], words[names[c]]);
        } else {
            points.add(names[c], units[c], std::move(numbers[c]));
        }
    }
    return points;
}

} // namespace suffuse::job
