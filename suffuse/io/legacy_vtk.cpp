#include "suffuse/io/legacy_vtk.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/interruption.hpp"
#include "suffuse/io/text_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstring>

namespace suffuse::io {
namespace {

constexpr std::string_view blanks = " \t\r\n";

/// Bytes of a number of a VTK type; 0 for an unknown one.
std::size_t width_of(std::string_view type) {
    constexpr std::array<std::pair<std::string_view, std::size_t>, 13> widths{
        {{"float", 4},
         {"double", 8},
         {"int", 4},
         {"unsigned_int", 4},
         {"long", 8},
         {"unsigned_long", 8},
         {"vtktypeint64", 8},
         {"vtkidtype", 8},
         {"short", 2},
         {"unsigned_short", 2},
         {"char", 1},
         {"unsigned_char", 1},
         {"bit", 0}}};
    std::string small(type);
    std::transform(small.begin(), small.end(), small.begin(), [](unsigned char c) {
        return static_cast<char>(std::tolower(c));
    });
    const auto found = std::ranges::find(widths, small, &std::pair<std::string_view, std::size_t>::first);
    return found == widths.end() ? 0 : found->second;
}

template <class T>
double from_big_endian(const char* bytes) {
    std::array<char, sizeof(T)> reversed{};
    std::reverse_copy(bytes, bytes + sizeof(T), reversed.begin());
    T value{};
    std::memcpy(&value, reversed.data(), sizeof(T));
    return static_cast<double>(value);
}

double number_in(const char* bytes, std::string_view type, std::size_t width) {
    const bool is_unsigned = type.starts_with("unsigned");
    if (width == 8) {
        return type == "double" ? from_big_endian<double>(bytes) : from_big_endian<std::int64_t>(bytes);
    }
    if (width == 4) {
        return type == "float" ? from_big_endian<float>(bytes)
               : is_unsigned   ? from_big_endian<std::uint32_t>(bytes)
                               : from_big_endian<std::int32_t>(bytes);
    }
    if (width == 2) {
        return is_unsigned ? from_big_endian<std::uint16_t>(bytes) : from_big_endian<std::int16_t>(bytes);
    }
    return is_unsigned ? from_big_endian<std::uint8_t>(bytes) : from_big_endian<std::int8_t>(bytes);
}

class LegacyReader {
public:
    LegacyReader(const std::string& file, std::string_view text) : file_(file), text_(text) {}

    std::map<std::string, VtkColumn> read() {
        skip_line();
        skip_line(); // version and title
        const std::string_view kind = word();
        is_binary_ = kind == "BINARY";
        if (!is_binary_ && kind != "ASCII") {
            complain(fmt::format("found \"{}\", expected ASCII or BINARY in the third line", kind.substr(0, 20)));
        }
        while (at_ < text_.size()) {
            read_part(word());
        }
        return std::move(arrays_);
    }

private:
    static constexpr std::size_t values_between_looks = 4096; // see Interruption

    [[noreturn]] void complain(const std::string& what) const {
        const auto line = 1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at_), '\n');
        throw CaseError(fmt::format("{}:{}: {}", file_, line, what), file_, static_cast<int>(line));
    }

    void skip_line() { at_ = std::min(text_.size(), std::min(text_.find('\n', at_), text_.size()) + 1); }

    std::string_view word() {
        at_ = std::min(text_.find_first_not_of(blanks, at_), text_.size());
        const std::size_t end = std::min(text_.find_first_of(blanks, at_), text_.size());
        const std::string_view found = text_.substr(at_, end - at_);
        at_ = end;
        return found;
    }

    std::size_t count(std::string_view what) {
        const std::string_view found = word();
        const auto value = number_of<std::size_t>(found);
        if (!value || *value > text_.size()) { // each number takes a byte and more
            complain(fmt::format("found \"{}\", expected {}", found.substr(0, 20), what));
        }
        return *value;
    }

    void read_part(std::string_view keyword) {
        if (keyword == "POINTS") {
            rows_ = count("the number of points");
            section_ = "Points";
            arrays_["Points"] = numbers(rows_, 3, word());
        } else if (keyword == "POINT_DATA") {
            section_ = "PointData";
            rows_ = count("the number of points");
        } else if (keyword == "CELL_DATA") {
            section_ = "CellData";
            rows_ = count("the number of cells");
        } else if (keyword == "SCALARS") {
            read_scalars();
        } else if (keyword == "VECTORS" || keyword == "NORMALS") {
            const std::string name(word());
            keep(name, numbers(rows_, 3, word()));
        } else if (keyword == "FIELD") {
            read_field();
        } else if (keyword == "VERTICES" || keyword == "LINES" || keyword == "POLYGONS" || keyword == "CELLS") {
            count("the number of cells");
            numbers(count("the size of the list"), 1, "int");
        } else if (keyword == "CELL_TYPES") {
            numbers(count("the number of cells"), 1, "int");
        } else if (keyword == "METADATA") {
            skip_metadata();
        }
        // DATASET, POLYDATA and the like say nothing to us
    }

    void read_scalars() {
        const std::string name(word());
        const std::string_view type = word();
        const std::size_t line_end = text_.find('\n', at_), next = text_.find_first_not_of(" \t\r", at_);
        const std::size_t components = next < line_end ? count("the number of components") : 1;
        if (word() != "LOOKUP_TABLE") {
            complain(fmt::format("SCALARS {}: expected LOOKUP_TABLE behind them", name));
        }
        word();
        keep(name, numbers(rows_, components, type));
    }

    void read_field() {
        word(); // its name
        const std::size_t arrays = count("the number of arrays");
        for (std::size_t k = 0; k < arrays && at_ < text_.size(); ++k) {
            const std::string name(word());
            if (name == "METADATA") {
                skip_metadata();
                --k;
                continue;
            }
            const std::size_t components = count("the number of components"), rows = count("the number of rows");
            keep(name, numbers(rows, components, word()));
        }
    }

    /// Up to the next blank line.
    void skip_metadata() {
        skip_line();
        while (at_ < text_.size() && text_[at_] != '\n') {
            skip_line();
        }
    }

    void keep(const std::string& name, VtkColumn column) {
        if (section_ == "PointData") {
            arrays_[section_ + "/" + name] = std::move(column);
        } else if (section_.empty()) {
            arrays_["FieldData/" + name] = std::move(column);
        }
    }

    VtkColumn numbers(std::size_t rows, std::size_t components, std::string_view type) {
        Interruption::look_up();
        VtkColumn column;
        column.components = std::max<std::size_t>(1, components);
        const std::size_t width = width_of(type);
        if (type == "string" || width == 0) {
            complain(
                fmt::format("found numbers of type \"{}\", expected float, double or whole numbers", type.substr(0, 20))
            );
        }
        if (rows > text_.size() / column.components) {
            complain(fmt::format("found {} rows of {}, more than the file holds", rows, components));
        }
        const std::size_t wanted = rows * column.components;
        column.values.reserve(wanted);
        if (is_binary_) {
            skip_line();
            if (wanted > (text_.size() - at_) / width) {
                complain(fmt::format("the file ends within {} numbers; it is not complete", wanted));
            }
            for (std::size_t k = 0; k < wanted; ++k, at_ += width) {
                column.values.push_back(number_in(text_.data() + at_, type, width));
            }
            return column;
        }
        for (std::size_t k = 0; k < wanted; ++k) {
            if (k % values_between_looks == 0) {
                Interruption::look_up();
            }
            const std::string_view field = word();
            const auto value = number_of<double>(field);
            if (!value) {
                complain(fmt::format("found \"{}\", expected {} numbers and {} of them", field.substr(0, 20), wanted, k)
                );
            }
            column.values.push_back(*value);
        }
        return column;
    }

    const std::string& file_;
    std::string_view text_;
    std::size_t at_ = 0, rows_ = 0;
    bool is_binary_ = false;
    std::string section_;
    std::map<std::string, VtkColumn> arrays_;
};

} // namespace

bool looks_like_legacy_vtk(std::string_view text) {
    return text.starts_with("# vtk DataFile");
}

std::map<std::string, VtkColumn> read_legacy_vtk_arrays(const std::string& file, std::string_view text) {
    return LegacyReader(file, text).read();
}

} // namespace suffuse::io
