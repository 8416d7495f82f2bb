#include "suffuse/gradings/derived_values.hpp"

#include "suffuse/base/spelling.hpp"
#include "suffuse/gradings/grading_columns.hpp"
#include "suffuse/gradings/sheet_values.hpp"

#include <algorithm>

namespace suffuse::gradings {

namespace {

using Kind = DerivedValue::Kind;

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

/// What a cell says of a named value, in SI.
std::optional<double> value_in(const DerivedValue& named, std::string_view text, SizeScale scale, bool comma) {
    if (is_size_kind(named.kind)) {
        const auto size = read_sieve_size(text, scale == SizeScale::Unknown ? SizeScale::Millimeters : scale, comma);
        return size ? std::optional(size->diameter) : std::nullopt;
    }
    text = trimmed(text);
    const bool is_percent = text.ends_with('%');
    const auto number = plain_number(is_percent ? text.substr(0, text.size() - 1) : text, comma);
    const bool is_ratio = named.kind == Kind::Uniformity || named.kind == Kind::Curvature || named.kind == Kind::Other;
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
        derived.value = value, derived.column = of_soil;
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
