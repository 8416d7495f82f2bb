#include "apps/test_import.hpp"

#include "suffuse/base/amounts.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/base/spelling.hpp"
#include "suffuse/laboratory/read_test.hpp"
#include "suffuse/laboratory/test_heading.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/exit_code.hpp"
#include "apps/json_text.hpp"
#include <algorithm>
#include <optional>

namespace suffuse::apps {
namespace {

using laboratory::NamedTest;
using laboratory::TestColumn;
using laboratory::TestRecord;

laboratory::TestKind kind_of(const std::string& kind) {
    if (const auto found = laboratory::test_kind_named(kind)) {
        return *found;
    }
    const std::vector<std::string> known = kinds_of_files();
    throw UsageError(
        fmt::format("unknown kind {}{}; there are {}", shown(kind), near_hint(kind, known), fmt::join(known, ", "))
    );
}

std::optional<bool> sign_of(const std::string& contraction) {
    if (contraction.empty()) {
        return std::nullopt;
    }
    if (contraction != "positive" && contraction != "negative") {
        throw UsageError(fmt::format("--contraction {}: it is positive or negative", shown(contraction)));
    }
    return contraction == "positive";
}

/// Of what the column says, with its sign as it is read: compression positive.
std::string range_text(const TestColumn& column) {
    const auto [least, most] = std::ranges::minmax(column.values);
    const laboratory::QuantityRow& row = laboratory::row_of(column.quantity);
    const std::string unit = column.unit.empty() ? std::string(row.usual_unit) : column.unit;
    const double factor = laboratory::unit_in_si(unit, row.dimension).value_or(1);
    return fmt::format(
        "{} to {}{}", digits_text(least / factor, 4), digits_text(most / factor, 4),
        unit == "1" || unit == "-" ? "" : " " + unit
    );
}

std::string role_text(const TestColumn& column) {
    const std::string_view name = laboratory::row_of(column.quantity).name;
    return column.is_effective ? fmt::format("{} {}", *column.is_effective ? "effective" : "total", name)
                               : std::string(name);
}

nlohmann::json describe_column(const TestColumn& column) {
    const auto [least, most] = std::ranges::minmax(column.values);
    nlohmann::json json = {
        {"heading", column.heading},
        {"role", laboratory::row_of(column.quantity).key},
        {"unit", column.unit},
        {"factor", column.factor},
        {"range", {least, most}}};
    if (column.is_effective) {
        json["effective"] = *column.is_effective;
    }
    return json;
}

nlohmann::json describe(const TestRecord& record, const std::string& file, const std::string& kind) {
    nlohmann::json json = {
        {"file", file},
        {"kind", kind},
        {"rows", record.rows()},
        {"unread", record.unread},
        {"titles", record.titles},
        {"tests", nlohmann::json::array()},
        {"columns", nlohmann::json::array()},
        {"decided", nlohmann::json::array()},
        {"assumed", nlohmann::json::array()}};
    for (const NamedTest& test : record.tests) {
        nlohmann::json first = nlohmann::json::object(), last = first;
        for (const TestColumn& column : record.columns) {
            const std::string role(laboratory::row_of(column.quantity).key);
            first[role] = column.values[test.begin];
            last[role] = column.values[test.end - 1];
        }
        json["tests"].push_back({{"name", test.name}, {"rows", test.end - test.begin}, {"first", first}, {"last", last}}
        );
    }
    for (const TestColumn& column : record.columns) {
        json["columns"].push_back(describe_column(column));
    }
    for (const laboratory::Finding& finding : record.findings) {
        json[finding.is_assumed ? "assumed" : "decided"].push_back(finding.text);
    }
    return json;
}

std::string tests_text(const TestRecord& record) {
    const NamedTest &first = record.tests.front(), &last = record.tests.back();
    return record.tests.size() == 1
               ? fmt::format("1 test, {}", shown(first.name))
               : fmt::format(
                     "{} tests, {} to {}", count_text(std::ssize(record.tests)), shown(first.name), shown(last.name)
                 );
}

void print(const TestRecord& record, const std::string& file, const std::string& kind, const Console& console) {
    console.result(fmt::format(
        "{}: {}, {}, {}", file, kind, tests_text(record), plural(static_cast<std::int64_t>(record.rows()), "row")
    ));
    std::size_t heading = 0, role = 0; // widths
    for (const TestColumn& column : record.columns) {
        heading = std::max(heading, shown(column.heading).size());
        role = std::max(role, role_text(column).size());
    }
    for (const TestColumn& column : record.columns) {
        console.result(fmt::format(
            "  {:<{}}  {:<{}}  {}", shown(column.heading), heading, role_text(column), role, range_text(column)
        ));
    }
    for (const laboratory::Finding& finding : record.findings) {
        console.result(fmt::format("  {} {}", finding.is_assumed ? "assumed:" : "found:  ", finding.text));
    }
    if (!record.unread.empty()) {
        console.talk(fmt::format("warning: {}: not read: \"{}\"", file, fmt::join(record.unread, "\", \"")));
    }
    if (!record.titles.empty()) {
        console.talk(
            fmt::format("warning: {}: {} above the headings not read", file, plural(std::ssize(record.titles), "line"))
        );
    }
}

} // namespace

std::vector<std::string> kinds_of_files() {
    std::vector<std::string> kinds{packing_kind};
    kinds.insert(kinds.end(), laboratory::test_kind_names().begin(), laboratory::test_kind_names().end());
    return kinds;
}

int import_test(
    const std::string& file, const std::string& kind, const std::string& contraction, const Console& console
) {
    const TestRecord record =
        laboratory::read_test(file, {.kind = kind_of(kind), .contraction_is_positive = sign_of(contraction)});
    print(record, file, kind, console);
    console.document(json_text(describe(record, file, kind)));
    return Done;
}

} // namespace suffuse::apps
