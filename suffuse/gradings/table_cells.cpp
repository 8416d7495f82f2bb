#include "suffuse/gradings/table_cells.hpp"

#include "suffuse/base/spelling.hpp"
#include "suffuse/base/units.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace suffuse::gradings {

namespace {

/// "1,000" between quotes may be a thousand or one.
bool may_be_thousands(std::string_view text) {
    const std::size_t comma = text.find(',');
    return comma != std::string_view::npos && comma > 0 && comma < 4 && text[0] != '0' && text.size() == comma + 4;
}

bool has_point(const SheetRow& row, std::size_t column) {
    const std::string& text = text_at(row, column);
    const std::size_t at = text.find('.');
    const bool is_for_thousands = text.find(',', std::min(at, text.size())) != std::string::npos; // 1.496,37
    return at != std::string::npos && !is_for_thousands && at + 1 < text.size() && is_digit(text[at + 1]) &&
           (at == 0 || is_digit(text[at - 1]));
}

/// A larger phi is a finer grain.
SizeSense turned(SizeSense sense) {
    return sense == SizeSense::Finer ? SizeSense::Coarser : sense == SizeSense::Coarser ? SizeSense::Finer : sense;
}

std::string no_size(const std::string& text) {
    if (is_blank(text)) {
        return "a value is missing";
    }
    std::string_view unit = text;
    unit.remove_prefix(std::min(unit.find_first_not_of("0123456789.,eE+- "), unit.size()));
    try {
        parse_quantity(fmt::format("1 {}", unit), dimension::length);
    } catch (const UnitError& problem) {
        if (is_digit(text[0]) && problem.kind == UnitError::Kind::OtherDimension) {
            return fmt::format("\"{}\": {}", text, problem.what());
        }
    }
    return fmt::format("\"{}\" is not a number", text);
}

} // namespace

TableCells::TableCells(const Sheet& sheet, const GradingColumns& columns, bool mixes_units, Problems& problems)
    : sheet_(sheet), columns_(columns), problems_(problems), mixes_units_(mixes_units) {
    has_points_ = std::ranges::any_of(value_rows(sheet, columns.first_row), [&columns](const SheetRow* row) {
        return has_point(*row, columns.size.index) || has_point(*row, columns.shares.front().index);
    });
}

void TableCells::complain(const Place& place, const std::string& what, const std::string& advice) {
    problems_.error("E502", place, what, advice);
    has_failed_ = true;
}

/// Shares without a unit are fractions where none is above 1.
ShareUnit TableCells::decide_unit(const ShareColumn& share) {
    if (share.unit != ShareUnit::Unknown) {
        return share.unit;
    }
    constexpr double least_end = 0.5; // a curve of percents that ends below is refused later on
    double most = 0;
    const SheetRow* at = nullptr;
    for (const SheetRow* row : value_rows(sheet_, columns_.first_row)) {
        const auto value = number_at(sheet_, *row, share.index);
        const bool has_percent = text_at(*row, share.index).find('%') != std::string::npos;
        if (has_percent || (value && *value > 1.0000001)) {
            return ShareUnit::Percent;
        }
        if (value && *value > most) {
            most = *value, at = row;
        }
    }
    if (!(most > least_end) || at == nullptr) {
        return ShareUnit::Percent;
    }
    problems_.warning(
        sheet_remark, place_at(*at, share.index),
        fmt::format("shares are read as fractions of 1 because none is above {:.4g}", most),
        "name the column `passing [-]` to say so"
    );
    return ShareUnit::Fraction;
}

std::optional<CellSize> TableCells::read_size(const SheetRow& row) {
    const std::size_t column = columns_.size.index;
    const std::string& text = text_at(row, column);
    const bool comma = commas_are_decimal(sheet_, row, column);
    if (!check_comma(row, column)) {
        return std::nullopt;
    }
    const SizeText split = split_size_text(text);
    const auto size = read_sieve_size(split.text, columns_.size.scale, comma);
    if (!size) {
        complain(
            place_at(row, column), no_size(text),
            "a size is a number in mm, or as in 75 um, 3/8\", No. 200; a comment begins with # and a blank"
        );
        return std::nullopt;
    }
    if (size->notation == SizeNotation::WithUnit && mixes_units_) {
        complain(
            place_at(row, column), fmt::format("\"{}\" has its own unit, and other sizes have none", text),
            "write a unit at every size, or name it in the heading: `d [mm]`"
        );
        return std::nullopt;
    }
    if (size->notation == SizeNotation::SieveNumber && !size->is_on_scale) {
        complain(
            place_at(row, column), fmt::format("\"{}\" is not a sieve number of ASTM E11", text),
            "write its opening with a unit, as in 4.75 mm; a comment begins with # and a blank"
        );
        return std::nullopt;
    }
    if (size->notation == SizeNotation::Inches && !size->is_on_scale) {
        problems_.warning(
            sheet_remark, place_at(row, column),
            fmt::format("\"{}\" is not a sieve of ASTM E11: read as {:.4g} mm", text, 1e3 * size->diameter)
        );
    }
    const bool has_unit = columns_.size.scale != SizeScale::Unknown || size->notation != SizeNotation::Plain;
    const std::string& bound = columns_.upper ? text_at(row, *columns_.upper) : split.upper;
    const auto upper = read_sieve_size(bound, columns_.size.scale, comma);
    return CellSize{
        size->diameter, has_unit, columns_.size.scale == SizeScale::Phi ? turned(split.sense) : split.sense,
        upper ? upper->diameter : 0};
}

/// A decimal comma where commas separate, or together with decimal points.
bool TableCells::check_comma(const SheetRow& row, std::size_t column) {
    const std::string& text = text_at(row, column);
    const bool is_ambiguous = has_points_ || (sheet_.mark == ',' && may_be_thousands(text));
    if (text.find(',') == std::string::npos || !is_ambiguous || text.find('/') != std::string::npos) {
        return true;
    }
    complain(
        row.cells[column].place, fmt::format("\"{}\" has a comma", text),
        sheet_.mark == ',' ? "commas separate the columns here: write a decimal point"
                           : "other numbers have a decimal point: write the same mark everywhere, and none between "
                             "thousands"
    );
    return false;
}

std::optional<double> TableCells::read_amount(const SheetRow& row, const ShareColumn& share) {
    const auto amount = read_value(row, share.index, share);
    if (!amount || !share.tare) {
        return amount;
    }
    const auto tare = read_value(row, *share.tare, share);
    if (tare && *tare > *amount) {
        complain(
            place_at(row, share.index),
            fmt::format("a sieve with soil of {:.6g} g, and empty of {:.6g} g", 1e3 * *amount, 1e3 * *tare),
            "the sieve with what it keeps is the heavier one: are the columns exchanged?"
        );
    }
    return tare ? std::optional(*amount - *tare) : std::nullopt;
}

std::optional<double> TableCells::read_value(const SheetRow& row, std::size_t column, const ShareColumn& share) {
    const ShareUnit unit = share.unit;
    std::string text(trimmed(text_at(row, column)));
    if (!check_comma(row, column)) {
        return std::nullopt;
    }
    if (commas_are_decimal(sheet_, row, column)) {
        std::replace(text.begin(), text.end(), ',', '.');
    }
    const char* const own = unit == ShareUnit::Percent ? "%" : unit == ShareUnit::Mass ? share.mass_unit : "1";
    const double part = unit == ShareUnit::PerMille ? 1e-3 : 1;
    const Dimension dimension = unit == ShareUnit::Mass ? dimension::mass : dimension::none;
    const std::string advice = fmt::format(
        "write a plain number; it is read in {}", unit == ShareUnit::Fraction   ? "shares of 1"
                                                  : unit == ShareUnit::PerMille ? "\u2030"
                                                                                : own
    );
    try {
        const bool has_unit = parse_quantity(text).has_unit;
        if (has_unit && (unit == ShareUnit::Fraction || unit == ShareUnit::PerMille)) {
            complain(place_at(row, column), fmt::format("\"{}\" has its own unit", text), advice);
            return std::nullopt;
        }
        return part * parse_quantity(has_unit ? text : fmt::format("{} {}", text, own), dimension);
    } catch (const UnitError& problem) {
        const std::string what = text.empty() ? "a value is missing" : problem.what();
        const bool is_no_number = !text.empty() && problem.kind == UnitError::Kind::NoNumber;
        complain(place_at(row, column), is_no_number ? fmt::format("\"{}\" is not a number", text) : what, advice);
        return std::nullopt;
    }
}

} // namespace suffuse::gradings
