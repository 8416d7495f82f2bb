#include "suffuse/io/vtk_reader.hpp"

#include "suffuse/base/base64.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/base/interruption.hpp"
#include "suffuse/io/text_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <optional>
#include <zlib.h>

namespace suffuse::io {
namespace {

constexpr std::size_t most_bytes = std::size_t{1} << 32; // of one array: a damaged length must not fill the memory

// What zlib packs into a byte at most, and a block that may be larger than that: a damaged length must not, either.
constexpr std::size_t most_packed = 1032, least_block = 64;

std::string_view attribute(std::string_view tag, std::string_view name) {
    for (std::size_t at = tag.find(name); at != std::string_view::npos; at = tag.find(name, at + 1)) {
        const std::size_t equals = at + name.size();
        const bool is_word = at > 0 && (tag[at - 1] == ' ' || tag[at - 1] == '\n' || tag[at - 1] == '\t');
        const std::string_view rest = tag.substr(equals);
        if (is_word && (rest.starts_with("=\"") || rest.starts_with("='"))) {
            const std::string_view value = rest.substr(2);
            return value.substr(0, value.find(rest[1]));
        }
    }
    return {};
}

class VtkReader {
public:
    VtkReader(const std::string& file, std::string_view text) : file_(file), text_(text) {}

    std::map<std::string, VtkColumn> read() {
        const std::size_t root = text_.find("<VTKFile");
        const std::string_view tag = tag_at(root);
        if (attribute(tag, "byte_order") == "BigEndian") {
            complain("", "is big-endian, expected LittleEndian: save it again as LittleEndian");
        }
        wide_header_ = attribute(tag, "header_type") == "UInt64";
        compressed_ = !attribute(tag, "compressor").empty();
        if (compressed_ && attribute(tag, "compressor") != "vtkZLibDataCompressor") {
            complain("", "is not compressed with zlib; save it again with vtkZLibDataCompressor, or plain");
        }
        std::size_t end = find_appended();
        std::string section;
        for (std::size_t at = text_.find('<', root + 1); at < end; at = text_.find('<', at + 1)) {
            const std::string_view here = tag_at(at);
            for (const std::string_view name :
                 {"PointData", "CellData", "FieldData", "Points", "Verts", "Lines", "Strips", "Polys", "Cells"}) {
                if (here.starts_with(name)) {
                    section = name;
                }
            }
            if (here.starts_with("DataArray") &&
                (section == "PointData" || section == "FieldData" || section == "Points")) {
                read_array(at, here, section);
            }
        }
        return std::move(arrays_);
    }

private:
    static constexpr std::size_t values_between_looks = 4096; // see Interruption

    [[noreturn]] void complain(std::string_view array, std::string_view what) const {
        throw CaseError(
            array.empty() ? fmt::format("{}: {}", file_, what) : fmt::format("{}: array {}: {}", file_, array, what),
            file_
        );
    }

    std::string_view tag_at(std::size_t at) const {
        if (at == std::string_view::npos) {
            complain("", "has no tag VTKFile; expected a .vtp file");
        }
        const std::string_view rest = text_.substr(at + 1);
        return rest.substr(0, rest.find('>'));
    }

    /// Where the XML before the appended data ends.
    std::size_t find_appended() {
        const std::size_t at = text_.find("<AppendedData");
        if (at == std::string_view::npos) {
            return text_.size();
        }
        appended_raw_ = attribute(tag_at(at), "encoding") == "raw";
        const std::size_t mark = text_.find('_', text_.find('>', at));
        appended_ = mark == std::string_view::npos ? std::string_view{} : text_.substr(mark + 1);
        return at;
    }

    void read_array(std::size_t at, std::string_view tag, const std::string& section) {
        const std::string name(attribute(tag, "Name")), type(attribute(tag, "type"));
        if (type == "String") {
            return;
        }
        Interruption::look_up();
        VtkColumn column;
        column.components = std::max<std::size_t>(1, number(attribute(tag, "NumberOfComponents"), name, 1));
        const std::string_view format = attribute(tag, "format");
        const std::size_t begin = text_.find('>', at) + 1;
        const std::string_view inside = text_.substr(begin, text_.find('<', begin) - begin);
        if (format == "ascii") {
            read_ascii(inside, name, column);
        } else {
            std::string bytes;
            if (format == "appended") {
                const std::size_t offset = number(attribute(tag, "offset"), name, 0);
                if (offset > appended_.size()) {
                    complain(name, "starts behind the end of the file; the file is not complete");
                }
                const std::string_view rest = appended_.substr(offset);
                bytes = appended_raw_ ? unpacked(rest, name)
                                      : unpacked(decoded(rest.substr(0, rest.find('<')), name), name);
            } else {
                bytes = unpacked(decoded(inside, name), name);
            }
            convert(bytes, type, name, column);
        }
        if (column.values.size() % column.components != 0) {
            complain(name, "ends within a row");
        }
        arrays_[section == "Points" ? section : section + "/" + name] = std::move(column);
    }

    [[nodiscard]] std::size_t number(std::string_view text, const std::string& name, std::size_t otherwise) const {
        const std::optional<std::size_t> value = text.empty() ? otherwise : number_of<std::size_t>(text);
        if (!value) {
            complain(name, fmt::format("found \"{}\", expected a whole number", text));
        }
        return *value;
    }

    [[nodiscard]] std::string decoded(std::string_view text, const std::string& name) const {
        std::optional<std::string> bytes = from_base64(text);
        if (!bytes) {
            complain(name, "is not in base64, or cut short; the file is damaged");
        }
        return std::move(*bytes);
    }

    void read_ascii(std::string_view inside, const std::string& name, VtkColumn& column) const {
        std::string line(inside);
        std::replace(line.begin(), line.end(), '\n', ' ');
        for (const std::string_view field : split_at_blanks(line)) {
            const std::optional<double> value = number_of<double>(field);
            if (!value) {
                complain(name, fmt::format("found \"{}\", expected a number", field));
            }
            column.values.push_back(*value);
            if (column.values.size() % values_between_looks == 0) {
                Interruption::look_up();
            }
        }
    }

    /// A length of the header, which is of four or eight bytes.
    std::size_t length_at(std::string_view bytes, std::size_t k, const std::string& name) const {
        const std::size_t width = wide_header_ ? 8 : 4;
        if ((k + 1) * width > bytes.size()) {
            complain(name, "ends within its header; the file is not complete");
        }
        std::uint64_t value = 0;
        std::memcpy(&value, bytes.data() + k * width, width);
        if (value > most_bytes) {
            complain(name, "has a length beyond 4 GiB; the file is damaged");
        }
        return value;
    }

    /// The bytes of an array behind its header, decompressed.
    std::string unpacked(std::string_view bytes, const std::string& name) const {
        const std::size_t width = wide_header_ ? 8 : 4;
        if (!compressed_) {
            const std::size_t size = length_at(bytes, 0, name);
            if (size > bytes.size() - width) {
                complain(name, "is cut short; the file is not complete");
            }
            return std::string(bytes.substr(width, size));
        }
        const std::size_t blocks = length_at(bytes, 0, name), block = length_at(bytes, 1, name),
                          last = length_at(bytes, 2, name);
        std::size_t at = (3 + blocks) * width;
        std::string all;
        for (std::size_t b = 0; b < blocks; ++b) {
            Interruption::look_up();
            const std::size_t packed = length_at(bytes, 3 + b, name), size = b + 1 == blocks && last > 0 ? last : block;
            if (at > bytes.size() || packed > bytes.size() - at || all.size() + size > most_bytes) {
                complain(name, "is cut short; the file is not complete");
            }
            if (size > most_packed * packed + least_block) {
                complain(name, "cannot be decompressed; the file is damaged");
            }
            std::string part(size, '\0');
            auto room = static_cast<uLongf>(size);
            const auto* from = reinterpret_cast<const Bytef*>(bytes.data() + at);
            if (uncompress(reinterpret_cast<Bytef*>(part.data()), &room, from, packed) != Z_OK || room != size) {
                complain(name, "cannot be decompressed; the file is damaged");
            }
            all += part;
            at += packed;
        }
        return all;
    }

    template <class T>
    static void append(std::string_view bytes, VtkColumn& column) {
        column.values.reserve(bytes.size() / sizeof(T));
        for (std::size_t at = 0; at + sizeof(T) <= bytes.size(); at += sizeof(T)) {
            T value{};
            std::memcpy(&value, bytes.data() + at, sizeof(T));
            column.values.push_back(static_cast<double>(value));
        }
    }

    void convert(std::string_view bytes, std::string_view type, const std::string& name, VtkColumn& column) const {
        if (type == "Float64") {
            append<double>(bytes, column);
        } else if (type == "Float32") {
            append<float>(bytes, column);
        } else if (type == "Int64") {
            append<std::int64_t>(bytes, column);
        } else if (type == "UInt64") {
            append<std::uint64_t>(bytes, column);
        } else if (type == "Int32") {
            append<std::int32_t>(bytes, column);
        } else if (type == "UInt32") {
            append<std::uint32_t>(bytes, column);
        } else if (type == "Int8") {
            append<std::int8_t>(bytes, column);
        } else if (type == "UInt8") {
            append<std::uint8_t>(bytes, column);
        } else {
            complain(name, fmt::format("is of type {}, expected Float32, Float64 or a type of whole numbers", type));
        }
    }

    const std::string& file_;
    std::string_view text_, appended_;
    bool wide_header_ = false, compressed_ = false, appended_raw_ = false;
    std::map<std::string, VtkColumn> arrays_;
};

} // namespace

std::map<std::string, VtkColumn> read_vtk_arrays(const std::string& file, std::string_view text) {
    return VtkReader(file, text).read();
}

} // namespace suffuse::io
