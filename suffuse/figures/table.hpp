#pragma once
// A tidy table: one row an observation, one named column a variable with its unit. It is the single source of a
// figure's chart, of its CSV file and of the numbers that the report prints below it. Values are in the figure's units
// (kPa, mm, %).

#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace suffuse::figures {

inline constexpr double missing = std::numeric_limits<double>::quiet_NaN(); ///< a cell without a number

struct Column {
    std::string name; ///< snake_case; the field's name in chart specifications
    std::string unit; ///< "kPa", "mm", "%"; "-" for a ratio; empty for words and counts
    /// A number that is not finite is a missing value.
    std::variant<std::vector<double>, std::vector<std::string>> values;
};

class Table {
public:
    void add(std::string name, std::string unit, std::vector<double> values);
    void add(std::string name, std::vector<std::string> words);
    /// A result, by the key of its fact; `values` are in the unit of files.
    void add_fact(const std::string& key, std::vector<double> values);

    [[nodiscard]] const std::vector<Column>& columns() const { return columns_; }

    [[nodiscard]] std::size_t rows() const;

    /// One value as text: all digits that its bits need, or `digits` significant ones; empty where it is missing.
    [[nodiscard]] std::string cell(std::size_t row, std::size_t column, int digits = 0) const;

    /// The numbers of a column. A column of words, or an unknown name, is a Bug.
    [[nodiscard]] const std::vector<double>& numbers(const std::string& name) const;

    /// The words of a column, likewise.
    [[nodiscard]] const std::vector<std::string>& words(const std::string& name) const;

private:
    void add_column(Column column);

    std::vector<Column> columns_;
};

/// "name [unit]", or "name" where there is no unit.
std::string heading(const Column& column);

/// CSV [RFC 4180] whose first lines are `# key: value`; numbers read back to the same bits.
std::string to_csv(const Table& table, const std::vector<std::pair<std::string, std::string>>& remarks);

} // namespace suffuse::figures
