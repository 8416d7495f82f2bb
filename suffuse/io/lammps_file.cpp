#include "suffuse/io/lammps_file.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/io/text_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace suffuse::io {
namespace {

constexpr double density_tolerance = 1e-6; // relative; below, the file and the case mean the same material

bool names_a_section(std::string_view line) {
    constexpr std::array sections{"Masses",     "Atoms", "Velocities", "Bonds",
                                  "Ellipsoids", "Lines", "Bodies",     "Pair Coeffs"};
    return std::ranges::any_of(sections, [&](std::string_view name) { return line == name; });
}

/// Whether a header line is so many numbers followed by these words.
bool is_header(
    const std::vector<std::string_view>& words, std::size_t numbers, std::initializer_list<std::string_view> last
) {
    return words.size() == numbers + last.size() &&
           std::equal(last.begin(), last.end(), words.begin() + static_cast<std::ptrdiff_t>(numbers));
}

class LammpsParser {
public:
    LammpsParser(const std::string& file, std::string_view text, double density)
        : file_(file), reader_(file, text), density_(density) {}

    ImportedPacking parse() {
        bool more = read_header();
        while (more) {
            const std::string section(reader_.line());
            const std::string style(reader_.comment());
            if (section == "Atoms") {
                if (!style.empty() && style != "sphere") {
                    reader_.complain(fmt::format("found atom style \"{}\", expected \"sphere\"", style));
                }
                more = read_atoms();
            } else if (section == "Velocities") {
                more = read_velocities();
            } else {
                result_.warnings.push_back(fmt::format("{}:{}: section {} ignored", file_, reader_.number(), section));
                more = skip_section();
            }
        }
        return finish();
    }

private:
    /// Counts and box, up to the first section; other lines, such as the title, say nothing to us. @return whether
    /// there is one.
    bool read_header() {
        while (reader_.next()) {
            if (names_a_section(reader_.line())) {
                return true;
            }
            const auto words = split_at_blanks(reader_.line());
            if (is_header(words, 1, {"atoms"})) {
                atoms_ = to_count(reader_, words.front(), "number of atoms");
            } else if (is_header(words, 2, {"xlo", "xhi"})) {
                read_edge(words, 0);
            } else if (is_header(words, 2, {"ylo", "yhi"})) {
                read_edge(words, 1);
            } else if (is_header(words, 2, {"zlo", "zhi"})) {
                read_edge(words, 2);
            } else if (is_header(words, 3, {"xy", "xz", "yz"})) {
                h_(0, 1) = to_number(reader_, words[0], "xy");
                h_(0, 2) = to_number(reader_, words[1], "xz");
                h_(1, 2) = to_number(reader_, words[2], "yz");
            }
        }
        return false;
    }

    void read_edge(const std::vector<std::string_view>& words, int axis) {
        const double low = to_number(reader_, words[0], words[2]), high = to_number(reader_, words[1], words[3]);
        if (!(high > low)) {
            reader_.complain(fmt::format("found a box from {} to {}, expected the second to be larger", low, high));
        }
        origin_[axis] = low;
        h_(axis, axis) = high - low;
    }

    bool skip_section() {
        while (reader_.next()) {
            if (names_a_section(reader_.line())) {
                return true;
            }
        }
        return false;
    }

    /// id, type, diameter, density, x, y, z and perhaps three image counts.
    bool read_atoms() {
        while (reader_.next()) {
            if (names_a_section(reader_.line())) {
                return true;
            }
            const auto f = split_at_blanks(reader_.line());
            if (f.size() != 7 && f.size() != 10) {
                reader_.complain(fmt::format(
                    "found {} fields, expected 7 or 10: id, type, diameter, density, x, y, z and perhaps three images",
                    f.size()
                ));
            }
            const std::size_t id = to_count(reader_, f[0], "atom id");
            const double diameter = to_number(reader_, f[2], "diameter");
            if (!(diameter > 0)) {
                reader_.complain(fmt::format("found diameter {}, expected a positive one", diameter));
            }
            const double own_density = to_number(reader_, f[3], "density");
            if (!(own_density > 0)) {
                reader_.complain(fmt::format(
                    "found density {}, expected a positive one: atom_style sphere has id, type, diameter, density, x, "
                    "y, z",
                    own_density
                ));
            }
            if (std::abs(own_density - density_) > density_tolerance * density_) {
                ++other_density_;
            }
            const Vec3 x{to_number(reader_, f[4], "x"), to_number(reader_, f[5], "y"), to_number(reader_, f[6], "z")};
            const auto row = grains::add_grain(result_.grains, x - origin_, 0.5 * diameter, density_);
            if (!row_of_.emplace(id, row).second) {
                reader_.complain(fmt::format("atom id {} occurs twice", id));
            }
        }
        return false;
    }

    /// id, velocity, spin.
    bool read_velocities() {
        while (reader_.next()) {
            if (names_a_section(reader_.line())) {
                return true;
            }
            const auto f = split_at_blanks(reader_.line());
            if (f.size() != 7) {
                reader_.complain(fmt::format("found {} fields, expected 7: id, vx, vy, vz, wx, wy, wz", f.size()));
            }
            const auto grain = row_of_.find(to_count(reader_, f[0], "atom id"));
            if (grain == row_of_.end()) {
                reader_.complain(fmt::format("velocity of atom {}, which section Atoms does not have", f[0]));
            }
            const auto number = [&](std::size_t k, const char* name) { return to_number(reader_, f[k], name); };
            result_.grains.velocity[grain->second] = {number(1, "vx"), number(2, "vy"), number(3, "vz")};
            result_.grains.spin[grain->second] = {number(4, "wx"), number(5, "wy"), number(6, "wz")};
        }
        return false;
    }

    ImportedPacking finish() {
        if (result_.grains.size() != atoms_) {
            reader_.complain(
                fmt::format("found {} atoms at the end of the file, expected {}", result_.grains.size(), atoms_)
            );
        }
        if (other_density_ > 0) {
            result_.warnings.push_back(fmt::format(
                "{}: the density of {} atoms is not used; grains are of {} kg/m3", file_, other_density_, density_
            ));
        }
        if (determinant(h_) > 0) {
            result_.cell = cell::Cell{h_, {}};
        }
        return std::move(result_);
    }

    const std::string& file_;
    LineReader reader_;
    double density_;
    ImportedPacking result_;
    std::unordered_map<std::size_t, std::uint32_t> row_of_; // by atom id
    Mat3 h_{};
    Vec3 origin_{};
    std::size_t atoms_ = 0, other_density_ = 0;
};

} // namespace

bool looks_like_lammps(std::string_view text) {
    constexpr int head = 40; // lines: longer than any header
    LineReader reader("", text);
    for (int k = 0; k < head && reader.next(); ++k) {
        const auto words = split_at_blanks(reader.line());
        if (is_header(words, 1, {"atoms"})) {
            return true;
        }
    }
    return false;
}

ImportedPacking parse_lammps(const std::string& file, std::string_view text, double density) {
    return LammpsParser(file, text, density).parse();
}

} // namespace suffuse::io
