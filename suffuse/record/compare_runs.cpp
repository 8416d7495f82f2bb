#include "suffuse/record/compare_runs.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/facts/by_key.hpp"
#include "suffuse/record/checksums.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/stage_sums.hpp"
#include "suffuse/record/stored.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace suffuse::record {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::array<const char*, 6> circumstances = {"version", "commit", "compiler", "seed", "mode", "preparation"};

/// Every stage.json below studies/, by the name of its stage.
std::map<std::string, json> read_stages(const fs::path& run) {
    std::map<std::string, json> stages;
    if (!fs::exists(run / "studies")) {
        return stages;
    }
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(run / "studies")) {
        if (entry.path().filename() == "stage.json") {
            check_file(entry.path());
            const json numbers = read_json(entry.path());
            take_from(entry.path(), [&] { return numbers.value("state_hash", ""); }); // other values may be of any type
            stages[entry.path().parent_path().lexically_relative(run / "studies").string()] = numbers;
        }
    }
    return stages;
}

/// The two values as one reads them.
std::string text_of(const json& value) {
    constexpr std::size_t longest = 60;
    std::string text = value.is_string() ? value.get<std::string>() : value.dump();
    return text.size() > longest ? text.substr(0, longest) + "..." : text;
}

class Comparer {
public:
    Comparer(double tolerance, Comparison& found) : tolerance_(tolerance), found_(found) {}

    /// @param least_scale what a difference is relative to where both numbers are smaller
    void compare(const std::string& where, double a, double b, Relevance about, double least_scale = 0) {
        ++found_.numbers;
        const double scale = std::max({std::abs(a), std::abs(b), least_scale});
        const double off = scale > 0 ? std::abs(a - b) / scale : 0;
        const bool are_both_undefined = std::isnan(a) && std::isnan(b);
        if (!(off <= tolerance_) && !are_both_undefined) {
            const double relative = std::isnan(off) ? 1 : off; // one of the two is undefined
            found_.differences.push_back({where, fmt::format("{}", a), fmt::format("{}", b), relative, about, true});
        }
    }

    void compare(const std::string& where, const json& a, const json& b, Relevance about, double least_scale = 0) {
        if (a.is_number() && b.is_number()) {
            compare(where, a.get<double>(), b.get<double>(), about, least_scale);
        } else if (a.is_object() && b.is_object()) {
            compare_objects(where, a, b, about);
        } else if (a.is_array() && b.is_array() && a.size() == b.size()) {
            const double rounding = rounding_of(a, b), scale = is_matrix(a) ? largest_of(a, b) : least_scale;
            for (std::size_t k = 0; k < a.size(); ++k) {
                const bool is_rounding = std::max(size_of(a[k]), size_of(b[k])) < rounding;
                compare(
                    fmt::format("{}[{}]", where, k), a[k], b[k], is_rounding ? Relevance::Computation : about, scale
                );
            }
        } else if (a != b) {
            differ(where, text_of(a), text_of(b), about);
        }
    }

    void differ(const std::string& where, const std::string& a, const std::string& b, Relevance about) {
        found_.differences.push_back({where, a, b, 1, about});
    }

private:
    static double size_of(const json& value) {
        return value.is_number() ? std::abs(value.get<double>()) : std::numeric_limits<double>::infinity();
    }

    /// A stress, a permeability, a cell: what stands next to its diagonal is chance around zero, and no number of its
    /// own.
    static bool is_matrix(const json& value) {
        constexpr std::size_t rows = 3;
        return value.size() == rows && std::ranges::all_of(value, [](const json& row) {
                   return row.is_array() && row.size() == rows &&
                          std::ranges::all_of(row, [](const json& number) { return number.is_number(); });
               });
    }

    static double largest_of(const json& a, const json& b) {
        double largest = 0;
        for (const json* matrix : {&a, &b}) {
            for (const json& row : *matrix) {
                for (const json& number : row) {
                    largest = std::max(largest, number.is_number() ? size_of(number) : 0);
                }
            }
        }
        return largest;
    }

    /// Below it, a component of a vector is what rounding left of a zero: next to its largest it says nothing.
    static double rounding_of(const json& a, const json& b) {
        constexpr double share = 1e-12;
        double largest = 0;
        for (const json* vector : {&a, &b}) {
            for (const json& component : *vector) {
                largest = std::max(largest, size_of(component));
            }
        }
        return std::isfinite(largest) ? share * largest : 0;
    }

    void compare_objects(const std::string& where, const json& a, const json& b, Relevance about) {
        std::set<std::string> keys;
        for (const json* object : {&a, &b}) {
            for (const auto& [key, value] : object->items()) {
                keys.insert(key);
            }
        }
        for (const std::string& key : keys) {
            const facts::Kind kind = facts::kind_of(key);
            if (kind == facts::Kind::Origin) {
                continue;
            }
            const Relevance of_key = kind == facts::Kind::Computation ? Relevance::Computation : about;
            const std::string inner = where + (where.ends_with(": ") ? "" : ".") + key;
            if (!a.contains(key) || !b.contains(key)) {
                differ(
                    inner, a.contains(key) ? text_of(a.at(key)) : "-", b.contains(key) ? text_of(b.at(key)) : "-",
                    of_key
                );
            } else {
                compare(inner, a.at(key), b.at(key), of_key);
            }
        }
    }

    double tolerance_;
    Comparison& found_;
};

void compare_stages(const fs::path& first, const fs::path& second, double tolerance, Comparison& found) {
    Comparer comparer(tolerance, found);
    const auto a = read_stages(first), b = read_stages(second);
    for (const auto& [name, numbers] : a) {
        const auto other = b.find(name);
        if (other == b.end()) {
            found.only_first.push_back(name);
            comparer.differ(name, "done", "not there", Relevance::Presence);
            continue;
        }
        ++found.stages;
        const bool is_same = numbers.value("state_hash", "") == other->second.value("state_hash", "");
        ++(is_same ? found.same_states : found.other_states);
        if (!is_same && tolerance == 0) {
            comparer.differ(
                name + ": state_hash", numbers.value("state_hash", "-"), other->second.value("state_hash", "-"),
                Relevance::Computation
            );
        }
        comparer.compare(name + ": ", numbers, other->second, Relevance::Result);
    }
    for (const auto& [name, numbers] : b) {
        if (!a.contains(name)) {
            found.only_second.push_back(name);
            comparer.differ(name, "not there", "done", Relevance::Presence);
        }
    }
}

/// The cells of a row; an empty one is a number that is missing, also at the end.
std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> cells(1);
    bool is_quoted = false;
    for (const char letter : line) {
        if (letter == '"') {
            is_quoted = !is_quoted;
        } else if (letter == ',' && !is_quoted) {
            cells.emplace_back();
        } else {
            cells.back() += letter;
        }
    }
    return cells;
}

std::optional<double> number_of(const std::string& text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc{} && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

/// Lines of a CSV without its head of provenance.
std::vector<std::string> read_table(const fs::path& path) {
    std::ifstream file(path);
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with('#')) {
            lines.push_back(line);
        }
    }
    return lines;
}

void compare_tables(const std::string& name, const fs::path& first, const fs::path& second, Comparer& comparer) {
    const std::vector<std::string> a = read_table(first), b = read_table(second);
    if (a.empty() || b.empty() || a.front() != b.front() || a.size() != b.size()) {
        const auto about = [](const std::vector<std::string>& table) {
            return fmt::format("{} rows of {}", table.size(), table.empty() ? "nothing" : table.front());
        };
        if (a != b) {
            comparer.differ(name, about(a), about(b), Relevance::Figure);
        }
        return;
    }
    const std::vector<std::string> columns = split(a.front());
    for (std::size_t row = 1; row < a.size(); ++row) {
        const std::vector<std::string> left = split(a[row]), right = split(b[row]);
        if (left.size() != columns.size() || right.size() != columns.size()) { // damaged: no column has a name
            if (a[row] != b[row]) {
                comparer.differ(fmt::format("{}: row {}", name, row), a[row], b[row], Relevance::Figure);
            }
            continue;
        }
        for (std::size_t k = 0; k < columns.size(); ++k) {
            const std::string where = fmt::format("{}: {}, row {}", name, columns[k], row);
            const auto x = number_of(left[k]), y = number_of(right[k]);
            if (x && y) {
                comparer.compare(where, *x, *y, Relevance::Figure);
            } else if (left[k] != right[k]) {
                comparer.differ(where, left[k], right[k], Relevance::Figure);
            }
        }
    }
}

std::set<std::string> figures_of(const fs::path& run) {
    std::set<std::string> names;
    if (fs::exists(run / "figures")) {
        for (const fs::directory_entry& entry : fs::directory_iterator(run / "figures")) {
            if (entry.path().extension() == ".csv") {
                names.insert(entry.path().stem().string());
            }
        }
    }
    return names;
}

void compare_figures(const fs::path& first, const fs::path& second, double tolerance, Comparison& found) {
    Comparer comparer(tolerance, found);
    std::set<std::string> names = figures_of(first);
    names.merge(figures_of(second));
    for (const std::string& name : names) {
        const fs::path file = fs::path("figures") / (name + ".csv");
        if (!fs::exists(first / file) || !fs::exists(second / file)) {
            comparer.differ(
                "figure " + name, fs::exists(first / file) ? "there" : "not there",
                fs::exists(second / file) ? "there" : "not there", Relevance::Presence
            );
        } else {
            compare_tables("figure " + name, first / file, second / file, comparer);
        }
    }
}

/// The lines of a resolved case, a key a line as it is written, each with the place of its key: as --set takes it.
std::vector<std::string> lines_with_places(const fs::path& run) {
    std::vector<std::string> lines;
    std::string table;
    for (const std::string& line : read_table(run / resolved_case_file)) {
        if (line.starts_with('[')) {
            table = line.substr(line.find_first_not_of('['));
            table = table.substr(0, table.find(']')) + ".";
        } else if (line.starts_with("name = \"") && table.ends_with(".stage.")) {
            table += line.substr(8, line.size() - 9) + "."; // the first key of a stage
            lines.push_back("[" + table.substr(0, table.size() - 1) + "]");
        } else if (!line.empty()) {
            lines.push_back(table + line);
        }
    }
    return lines;
}

/// Lines of the resolved case that only one of the runs has.
void compare_cases(const fs::path& first, const fs::path& second, std::vector<std::string>& found) {
    const std::vector<std::string> a = lines_with_places(first), b = lines_with_places(second);
    const auto add_lines = [&](const std::vector<std::string>& own, const std::vector<std::string>& other, char side) {
        for (const std::string& line : own) {
            if (std::find(other.begin(), other.end(), line) == other.end()) {
                found.push_back(fmt::format("case {} {}", side, line));
            }
        }
    };
    add_lines(a, b, '-');
    add_lines(b, a, '+');
}

void compare_circumstances(const fs::path& first, const fs::path& second, std::vector<std::string>& found) {
    compare_cases(first, second, found);
    if (!fs::exists(first / "provenance.json") || !fs::exists(second / "provenance.json")) {
        return;
    }
    const auto provenance_in = [](const fs::path& file) {
        const json provenance = read_json(file);
        return take_from(file, [&] { return provenance.get<std::map<std::string, json>>(); });
    };
    std::map<std::string, json> a = provenance_in(first / "provenance.json"),
                                b = provenance_in(second / "provenance.json");
    for (const char* const key : circumstances) {
        const json &left = a[key], &right = b[key];
        if (left != right) {
            found.push_back(fmt::format("{}: {} and {}", key, text_of(left), text_of(right)));
        }
    }
}

} // namespace

Comparison compare_runs(const fs::path& first, const fs::path& second, double tolerance) {
    expects(tolerance >= 0, "a tolerance is not negative");
    for (const fs::path& run : {first, second}) {
        check_is_run(run);
        require_same_inputs(run);
        require_same_figures(run, {}, {".csv"});
    }
    Comparison found;
    compare_stages(first, second, tolerance, found);
    compare_circumstances(first, second, found.circumstances);
    compare_figures(first, second, tolerance, found);
    std::ranges::stable_sort(found.differences, [](const Difference& a, const Difference& b) {
        return std::pair(a.about, -a.relative) < std::pair(b.about, -b.relative);
    });
    return found;
}

const char* name_of(Relevance about) {
    switch (about) {
    case Relevance::Presence:
        return "presence";
    case Relevance::Result:
        return "result";
    case Relevance::Figure:
        return "figure";
    case Relevance::Computation:
        break;
    }
    return "computation";
}

void to_json(json& json, const Comparison& comparison) {
    nlohmann::json list = nlohmann::json::array();
    for (const Difference& difference : comparison.differences) {
        list.push_back(
            {{"where", difference.where},
             {"first", difference.first},
             {"second", difference.second},
             {"relative", difference.relative},
             {"about", name_of(difference.about)}}
        );
    }
    json = {
        {"circumstances", comparison.circumstances},
        {"stages", comparison.stages},
        {"same_states", comparison.same_states},
        {"other_states", comparison.other_states},
        {"only_first", comparison.only_first},
        {"only_second", comparison.only_second},
        {"numbers", comparison.numbers},
        {"differences", list}};
}

} // namespace suffuse::record
