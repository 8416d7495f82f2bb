#include "suffuse/casefile/calibration_places.hpp"

#include "suffuse/casefile/calibration_case.hpp"

#include <algorithm>
#include <set>
#include <sstream>
#include <tuple>

namespace suffuse::casefile {
namespace {

/// Of a line of a case that was written by print_file: the table it is in, and its key.
struct WrittenPlace {
    std::vector<std::string> table; ///< "contact"; "soil", "sand"
    std::string key;
    std::string line; ///< up to what is wrong, and that
};

std::vector<std::string> parts_of(const std::string& heading) {
    std::vector<std::string> parts;
    std::istringstream names(heading.substr(heading.find_first_not_of('[')));
    for (std::string name; std::getline(names, name, '.');) {
        std::erase_if(name, [](char c) { return c == ']' || c == '"'; });
        parts.push_back(name);
    }
    return parts;
}

WrittenPlace written_place(const std::string& text, int line, int end) {
    WrittenPlace place;
    std::istringstream lines(text);
    for (int k = 1; k <= line && std::getline(lines, place.line); ++k) {
        if (place.line.starts_with("[")) {
            place.table = parts_of(place.line);
        }
    }
    if (const std::size_t key_end = place.line.find_first_of(" ="); !place.line.starts_with("[")) {
        place.key = place.line.substr(0, key_end);
    }
    place.line = place.line.substr(0, static_cast<std::size_t>(std::max(end, 0)));
    return place;
}

/// Of the deepest part that the user wrote; none where even the first is not his.
Place users_place(const WrittenPlace& at, const Node& base) {
    Place found;
    const Node* node = &base;
    std::vector<std::string> path = at.table;
    path.push_back(at.key);
    for (const std::string& name : path) {
        const Node::Entry* entry = node == nullptr ? nullptr : node->find(name);
        if (entry == nullptr || entry->place.line == 0) {
            break;
        }
        found = entry->place;
        node = entry->value.is_table() ? &entry->value : nullptr;
    }
    return found;
}

/// Of what a study comes from: the last unknown that the line names, or the target.
Place asking_place(const WrittenPlace& at, const CalibrateSpec& spec) {
    if (at.key == "particles") {
        return spec.particles_place;
    }
    const CalibrateUnknown* last = nullptr;
    std::size_t begin = 0;
    for (const CalibrateUnknown& unknown : spec.unknowns) {
        const std::size_t named = at.line.rfind('"' + unknown.key + '"');
        if (at.key == void_ratio_key && is_void_ratio(unknown.key)) {
            return unknown.place;
        }
        if (named != std::string::npos && (last == nullptr || named > begin)) {
            last = &unknown;
            begin = named;
        }
    }
    if (last != nullptr) {
        return last->place;
    }
    for (const CalibrateTarget& target : spec.targets) {
        if (at.table.size() > 1 && at.table[1].starts_with(target.name + "-")) {
            return target.place;
        }
    }
    return spec.targets.empty() ? Place() : spec.targets.front().place;
}

} // namespace

std::vector<Diagnostic>
at_users_places(const std::vector<Diagnostic>& problems, const std::string& text, const CalibrationCase& what) {
    Problems placed;
    std::set<std::tuple<std::string, int, bool>> seen;
    for (const Diagnostic& problem : problems) {
        const WrittenPlace at = written_place(text, problem.line, problem.column - 1 + problem.length);
        const bool is_of_sample = at.table.empty() ? at.key.empty() : at.table.front() == "study";
        Place place = is_of_sample ? asking_place(at, what.spec) : users_place(at, what.base);
        if (place.line == 0) {
            place = asking_place({}, what.spec);
        }
        if (!seen.insert({problem.code, place.line, problem.is_warning}).second) {
            continue;
        }
        if (problem.is_warning) {
            placed.warning(problem.code, place, problem.message, problem.help);
        } else {
            placed.error(problem.code, place, problem.message, problem.help);
        }
    }
    return placed.sorted();
}

} // namespace suffuse::casefile
