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
    LammpsParser(const std::string& file, std::string_view text, double density, std::optional<double> radius)
        : file_(file), reader_(file, text), density_(density), radius_(radius) {}

    ImportedPacking parse() {
        bool more = read_header();
        while (more) {
            const std::string section(reader_.line());
            const std::string style(reader_.comment());
            if (section == "Atoms") {
                take_style(style);
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
            } else if (is_header(words, 3, {"avec"}) || is_header(words, 3, {"bvec"}) || is_header(words, 3, {"cvec"})) {
                read_vector(words, words.back().front() - 'a');
            } else if (is_header(words, 3, {"abc", "origin"})) {
                origin_ = vector_of(words);
            } else if (words.size() == 6 && (words[3] == "xy" || words[3] == "xz" || words[3] == "yz")) {
                reader_.complain(fmt::format("found tilts {} {} {}, expected xy xz yz", words[3], words[4], words[5]));
            }
        }
        return false;
    }

    Vec3 vector_of(const std::vector<std::string_view>& words) {
        return {
            to_number(reader_, words[0], words[3]), to_number(reader_, words[1], words[3]),
            to_number(reader_, words[2], words[3])};
    }

    /// An edge of a general triclinic box.
    void read_vector(const std::vector<std::string_view>& words, int column) {
        const Vec3 edge = vector_of(words);
        for (int k = 0; k < 3; ++k) {
            h_(k, column) = edge[k];
        }
    }

    /// Where a row of the section has what: sphere; hybrid, whose first part is sphere; atomic, with one radius for
    /// all.
    void take_style(const std::string& style) {
        const bool is_hybrid = style.starts_with("hybrid");
        const bool has_other_first =
            is_hybrid && split_at_blanks(style).size() > 1 && split_at_blanks(style)[1] != "sphere";
        if ((!style.empty() && style != "sphere" && !is_hybrid && !(style == "atomic" && radius_)) || has_other_first) {
            reader_.complain(
                fmt::format("found atom style \"{}\", expected \"sphere\", or \"hybrid sphere ...\"", style)
            );
        }
        style_ = is_hybrid ? Style::Hybrid : style == "atomic" ? Style::Atomic : Style::Sphere;
        if (radius_ && style_ != Style::Atomic) {
            reader_.complain("the file contains diameters, and a radius for all was given: leave that out");
        }
        if (is_hybrid) {
            result_.warnings.push_back(fmt::format(
                "{}:{}: atom style hybrid is read as id, type, x, y, z, diameter, density, and the rest is ignored",
                file_, reader_.number()
            ));
        }
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
            const auto f = in_order_of_sphere(split_at_blanks(reader_.line()));
            if (style_ == Style::Atomic) {
                add_atom(f);
                continue;
            }
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

    /// Columns of a hybrid style as atom_style sphere has them.
    [[nodiscard]] std::vector<std::string_view> in_order_of_sphere(std::vector<std::string_view> f) const {
        if (style_ != Style::Hybrid || f.size() < 7) {
            return f;
        }
        return {f[0], f[1], f[5], f[6], f[2], f[3], f[4]};
    }

    /// id, type, x, y, z: a grain of the radius that was given.
    void add_atom(const std::vector<std::string_view>& f) {
        if (f.size() != 5 && f.size() != 8) {
            reader_.complain(
                fmt::format("found {} fields, expected 5 or 8: id, type, x, y, z and perhaps three images", f.size())
            );
        }
        const Vec3 x{to_number(reader_, f[2], "x"), to_number(reader_, f[3], "y"), to_number(reader_, f[4], "z")};
        const auto row = grains::add_grain(result_.grains, x - origin_, *radius_, density_);
        if (!row_of_.emplace(to_count(reader_, f[0], "atom id"), row).second) {
            reader_.complain(fmt::format("atom id {} occurs twice", f[0]));
        }
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
        result_.origin = origin_;
        if (determinant(h_) > 0) {
            result_.cell = cell::Cell{h_, {}};
        }
        return std::move(result_);
    }

    const std::string& file_;
    LineReader reader_;
    enum class Style { Sphere, Hybrid, Atomic };

    double density_;
    std::optional<double> radius_; // of all, where the file has none
    Style style_ = Style::Sphere;
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

ImportedPacking
parse_lammps(const std::string& file, std::string_view text, double density, std::optional<double> radius) {
    return LammpsParser(file, text, density, radius).parse();
}

} // namespace suffuse::io
