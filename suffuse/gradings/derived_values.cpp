#include "suffuse/gradings/derived_values.hpp"

#include "suffuse/base/spelling.hpp"
#include "suffuse/gradings/grading_columns.hpp"
#include "suffuse/gradings/heading.hpp"
#include "suffuse/gradings/lexicon.hpp"
#include "suffuse/gradings/sheet.hpp"
#include "suffuse/gradings/sheet_values.hpp"
#include "suffuse/gradings/sieve_size.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace suffuse::gradings {

namespace {

using Kind = DerivedValue::Kind;

/// "d10", "d 10", "D(0.1)": the share passing.
std::optional<double> read_percentile(std::string_view text) {
    std::string plain;
    for (const char c : text) {
        plain += c == ',' ? '.' : c;
    }
    std::string_view rest = trimmed(plain);
    if (rest.empty() || (rest.front() != 'd' && rest.front() != 'D')) {
        return std::nullopt;
    }
    rest.remove_prefix(1);
    while (!rest.empty() && std::string_view(" _([v").find(rest.front()) != std::string_view::npos) {
        rest.remove_prefix(1);
    }
    const std::size_t end = std::min(rest.find_first_not_of("0123456789."), rest.size());
    const auto number = plain_number(rest.substr(0, end), false);
    rest.remove_prefix(end);
    const std::string after = plain_words(rest);
    const std::string_view unit = trimmed(after);
    const bool is_alone = unit.empty() || size_scale_of(unit) != SizeScale::Unknown || unit == "size";
    if (!number || !is_alone || !(*number > 0) || *number > 100) {
        return std::nullopt;
    }
    return *number < 1 ? *number : *number / 100;
}

std::optional<Kind> kind_of(std::string_view name) {
    const std::string plain = plain_words(name);
    const auto words = split_words(plain, " ");
    if (words == std::vector<std::string_view>{"f", "m"}) { // F.M., the fineness modulus
        return Kind::Other;
    }
    std::optional<Kind> found;
    for (const std::string_view word : words) {
        const auto known = result_named(word);
        if (!known) {
            if (!is_word_of(Topic::ResultFiller, word)) {
                return std::nullopt;
            }
            continue;
        }
        const bool are_fines = found && ((*found == Kind::Silt && *known == Kind::Clay) ||
                                         (*found == Kind::Clay && *known == Kind::Silt) ||
                                         (*found == Kind::Fines && *known != Kind::Other));
        const bool agree = !found || *found == *known;
        found = are_fines ? Kind::Fines : agree ? *known : Kind::Other;
    }
    return found;
}

/// "% passing No. 200": the sieve.
std::optional<double> sieve_in(std::string_view name) {
    const Heading heading = read_heading(name);
    const auto size = read_sieve_size(size_among_words(name), SizeScale::Unknown);
    const bool is_named = size && size->is_on_scale && size->notation != SizeNotation::Plain;
    return is_named && heading.meaning == ShareMeaning::Passing ? std::optional(size->diameter) : std::nullopt;
}

std::optional<DerivedValue> read_name(std::string_view name) {
    DerivedValue found;
    found.name = std::string(name);
    if (const auto share = read_percentile(name)) {
        found.kind = Kind::SizeAt, found.at = *share;
    } else if (name.starts_with('%') && plain_words(name).find(" 3 ") != std::string::npos && name.find('+') != std::string_view::npos) { // % +3"
        found.kind = Kind::Cobbles;
    } else if (const auto size = sieve_in(name)) {
        found.kind = Kind::Passing, found.at = *size;
    } else if (const auto kind = kind_of(name)) {
        found.kind = *kind;
    } else {
        return std::nullopt;
    }
    return found;
}

/// Where the value begins in a text that has it, too: "D10= 0.09", "Cu: 50", "D60 2.0 mm"; else its end.
std::size_t value_begin(std::string_view text) {
    const std::size_t mark = text.find_first_of("=:");
    if (mark != std::string_view::npos) {
        return mark + 1;
    }
    for (std::size_t at = text.find(' '); at < text.size(); at = text.find(' ', at + 1)) {
        std::string_view value = trimmed(text.substr(at));
        value = value.ends_with('%') ? trimmed(value.substr(0, value.size() - 1)) : value;
        const bool is_value = plain_number(value, true) || read_sieve_size(value, SizeScale::Millimeters);
        if (is_value && read_name(trimmed(text.substr(0, at)))) {
            return at;
        }
    }
    return text.size();
}

/// What stands between slashes.
std::vector<std::string_view> split_joined(std::string_view text) {
    std::vector<std::string_view> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find('/', begin), text.size());
        parts.push_back(trimmed(text.substr(begin, end - begin)));
        begin = end + 1;
    }
    return parts;
}

/// "D10 / D30 / D60", "Cu/Cc": each of several names in one text, which may go on with "=" and values; else empty.
std::vector<DerivedValue> read_joined_names(std::string_view text) {
    const std::size_t mark = std::min(text.find_first_of("=:"), text.size());
    std::vector<DerivedValue> names;
    const auto parts = split_joined(text.substr(0, mark));
    for (const std::string_view part : parts) {
        if (auto name = parts.size() > 1 ? read_name(part) : std::nullopt) {
            names.push_back(std::move(*name));
        } else {
            return {};
        }
    }
    const auto whole = read_name(trimmed(text.substr(0, mark)));
    const bool is_one = whole && whole->kind != Kind::Other; // silt/clay are the fines
    return is_one ? std::vector<DerivedValue>{} : names;
}

SizeScale scale_in(std::string_view name) {
    const std::size_t open = name.find_first_of("([");
    const std::size_t close = name.find_first_of(")]", std::min(open, name.size()));
    if (open != std::string_view::npos && close != std::string_view::npos) {
        return size_scale_of(trimmed(name.substr(open + 1, close - open - 1)));
    }
    const std::size_t last = name.find_last_of(' ');
    return last == std::string_view::npos ? SizeScale::Unknown : size_scale_of(name.substr(last + 1));
}

bool is_size_kind(Kind kind) {
    return kind == Kind::SizeAt || kind == Kind::Largest;
}

/// "%", "g": what stands behind the last digit.
std::string_view unit_behind(std::string_view text) {
    return trimmed(text.substr(std::min(text.find_last_of("0123456789.") + 1, text.size())));
}

/// What a cell says of a named value, in SI.
std::optional<double> value_in(const DerivedValue& named, std::string_view text, SizeScale scale, bool comma) {
    if (is_size_kind(named.kind)) {
        const auto size = read_sieve_size(text, scale == SizeScale::Unknown ? SizeScale::Millimeters : scale, comma);
        return size ? std::optional(size->diameter) : std::nullopt;
    }
    const std::string_view unit = unit_behind(text);
    const bool is_percent = unit == "%";
    const bool is_mass = named.kind == Kind::Fines && share_unit_named(unit) == ShareUnit::Mass;
    text = trimmed(text);
    const auto number = plain_number(text.substr(0, text.size() - (is_percent || is_mass ? unit.size() : 0)), comma);
    const bool is_ratio = named.kind == Kind::Uniformity || named.kind == Kind::Curvature ||
                          named.kind == Kind::Other || named.kind == Kind::Loss;
    if (named.kind == Kind::Loss && is_percent) { // "Loss: 0.3 %" is computed from a loss, and none
        return std::nullopt;
    }
    return number ? std::optional(is_ratio ? *number : *number / 100) : std::nullopt;
}

/// The names of a cell, one or several between slashes, and the values behind them.
struct NamesOfCell {
    std::vector<DerivedValue> names;
    std::string_view values;
};

NamesOfCell read_names(std::string_view text) {
    if (auto names = read_joined_names(text); !names.empty()) {
        const std::size_t mark = std::min(text.find_first_of("=:"), text.size() - 1);
        return {std::move(names), text.substr(mark + 1)};
    }
    NamesOfCell cell;
    if (auto name = read_derived_name(text)) {
        cell.values = name->name == trimmed(text) ? "" : text.substr(value_begin(text));
        cell.names.push_back(std::move(*name));
    }
    return cell;
}

/// Names with their values behind them, one a soil: "D10,0.12,0.15", or "D10 / D30 / D60" and behind it
/// "0.12 / 0.29 / 0.66", one such cell a soil, or each value in a cell of its own.
class ResultRow {
public:
    ResultRow(const Sheet& sheet, const SheetRow& row) : sheet_(sheet), row_(row) {}

    std::vector<DerivedValue> read() {
        for (std::size_t k = 0; k < row_.cells.size(); ++k) {
            const std::string& text = row_.cells[k].text;
            if (auto cell = read_names(text); !cell.names.empty()) {
                begin(std::move(cell.names), row_.cells[k].place);
                take(cell.values, k);
            } else if (!found_.empty()) {
                scale_ = size_scale_of(text) == SizeScale::Unknown ? scale_ : size_scale_of(text);
                take(text, k);
            } else if (k == 0 && !is_blank(text)) {
                return {};
            }
        }
        return std::move(found_);
    }

private:
    void begin(std::vector<DerivedValue> names, const Place& place) {
        names_ = std::move(names), first_ = found_.size(), next_ = 0;
        scale_ = scale_in(names_.back().name);
        for (DerivedValue& name : names_) {
            name.place = place;
            found_.push_back(name);
        }
    }

    void take(std::string_view text, std::size_t column) {
        const auto parts = names_.size() > 1 ? split_joined(text) : std::vector<std::string_view>{text};
        if (parts.size() == names_.size()) {
            for (std::size_t i = 0; i < parts.size(); ++i) {
                set(i, parts[i], column, column);
            }
        } else if (parts.size() == 1 && !is_blank(text)) { // in whose column a value stands says nothing
            set(next_, text, column, std::string::npos);
            next_ = (next_ + 1) % names_.size();
        }
    }

    void set(std::size_t name, std::string_view text, std::size_t column, std::size_t of_soil) {
        const auto value = value_in(names_[name], text, scale_, commas_are_decimal(sheet_, row_, column));
        if (!value) {
            return;
        }
        const bool is_more = found_[first_ + name].value.has_value(); // of the next column's soil
        if (is_more) {
            found_.push_back(names_[name]);
        }
        DerivedValue& derived = is_more ? found_.back() : found_[first_ + name];
        derived.value = value, derived.column = of_soil, derived.unit = unit_behind(text);
    }

    const Sheet& sheet_;
    const SheetRow& row_;
    std::vector<DerivedValue> found_, names_;
    std::size_t first_ = 0, next_ = 0;
    SizeScale scale_ = SizeScale::Unknown;
};

/// Whether a row has values alone, two or more, as many joined in a cell as names are above.
bool are_values_of(const Sheet& sheet, const SheetRow& names, const SheetRow& row) {
    std::size_t numbers = 0;
    for (std::size_t k = 0; k < row.cells.size(); ++k) {
        const std::string& text = row.cells[k].text;
        const auto joined = read_joined_names(text_at(names, k));
        const auto parts = split_joined(text);
        const bool are_joined = !joined.empty() && joined.size() == parts.size();
        if ((are_joined || number_at(sheet, row, k)) && (are_joined || joined.empty())) {
            numbers += parts.size();
        } else if (!is_blank(text)) {
            return false;
        }
    }
    return numbers > 1;
}

} // namespace

std::optional<DerivedValue> read_derived_name(std::string_view text) {
    constexpr std::size_t longest = 80; // of a name
    if (text.size() > longest) {
        return std::nullopt;
    }
    if (auto whole = read_name(trimmed(text))) { // D 10, % passing No. 200
        return whole;
    }
    const std::string_view name = text.substr(0, value_begin(text));
    return read_name(trimmed(name.substr(0, name.find_last_not_of("=: ") + 1)));
}

std::vector<DerivedValue> read_derived(const Sheet& sheet, const SheetRow& row) {
    return ResultRow(sheet, row).read();
}

std::vector<DerivedValue> read_derived_below(const Sheet& sheet, const SheetRow& names, const SheetRow& values) {
    std::vector<DerivedValue> found;
    for (std::size_t k = 0; k < names.cells.size(); ++k) {
        auto named = read_names(names.cells[k].text).names;
        const SizeScale scale_of_all = named.empty() ? SizeScale::Unknown : scale_in(named.back().name);
        const auto parts =
            named.size() > 1 ? split_joined(text_at(values, k)) : std::vector<std::string_view>{text_at(values, k)};
        for (std::size_t i = 0; i < named.size(); ++i) {
            named[i].place = place_at(values, k), named[i].column = k;
            named[i].value = value_in(
                named[i], i < parts.size() ? parts[i] : std::string_view{}, scale_of_all,
                commas_are_decimal(sheet, values, k)
            );
            found.push_back(std::move(named[i]));
        }
    }
    return found;
}

DerivedRows find_derived_rows(
    const Sheet& sheet, std::size_t first, std::size_t end, const std::function<bool(const SheetRow&)>& is_sieve
) {
    DerivedRows rows;
    rows.are_derived.assign(end - std::min(first, end), false);
    for (std::size_t k = first; k < end; ++k) {
        const SheetRow& row = sheet.rows[k];
        if (rows.are_derived[k - first] || row.is_comment || is_sieve(row)) {
            continue;
        }
        auto found = read_derived(sheet, row);
        const bool are_names = found.size() > 1 && std::ranges::none_of(found, [](const DerivedValue& value) {
                                   return value.value.has_value();
                               });
        if (are_names && k + 1 < end && are_values_of(sheet, row, sheet.rows[k + 1])) {
            found = read_derived_below(sheet, row, sheet.rows[k + 1]);
            rows.are_derived[k + 1 - first] = true;
        }
        rows.are_derived[k - first] = !found.empty();
        rows.values.insert(rows.values.end(), found.begin(), found.end());
    }
    return rows;
}

} // namespace suffuse::gradings
