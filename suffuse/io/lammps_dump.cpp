#include "suffuse/io/lammps_dump.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/io/columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace suffuse::io {
namespace {

constexpr std::string_view item = "ITEM: ";

struct Box {
    Vec3 origin; ///< its corner [m]
    Mat3 h;      ///< columns are the edges [m]
};

class DumpParser {
public:
    DumpParser(const std::string& file, std::string_view text, double density, std::optional<double> radius)
        : file_(file), reader_(file, text), density_(density), radius_(radius) {}

    ImportedPacking parse() {
        ImportedPacking last;
        int frames = 0;
        bool more = reader_.next();
        while (more) {
            const std::string_view head = reader_.line();
            if (head == "ITEM: NUMBER OF ATOMS") {
                need_line("the number of atoms");
                atoms_ = to_count(reader_, reader_.line(), "number of atoms");
            } else if (head.starts_with("ITEM: BOX BOUNDS")) {
                read_boundaries(head);
                if (head.find("abc origin") != std::string_view::npos) {
                    read_general_box();
                } else {
                    check_tilt_words(head);
                    read_box(head.find("xy xz yz") != std::string_view::npos);
                }
            } else if (head.starts_with("ITEM: ATOMS")) {
                last = read_atoms(split_at_blanks(head.substr(item.size() + 5)));
                ++frames;
            }
            more = reader_.next();
        }
        if (frames == 0) {
            reader_.complain("found no section ITEM: ATOMS, expected one");
        }
        if (frames > 1) {
            last.warnings.push_back(fmt::format("{}: the last of {} frames is read", file_, frames));
        }
        return last;
    }

private:
    void need_line(std::string_view what) {
        if (!reader_.next()) {
            reader_.complain(fmt::format("the file ends, expected {}", what));
        }
    }

    /// Behind the words stand two letters an axis, one a side: p is periodic; f, s and m are walls or empty space. Old
    /// versions write none.
    void read_boundaries(std::string_view head) {
        const auto words = split_at_blanks(head);
        no_cell_.clear();
        for (std::size_t axis = 0; axis < 3 && words.size() >= 6 && no_cell_.empty(); ++axis) {
            const std::string_view sides = words[words.size() - 3 + axis];
            if (sides.find_first_not_of("fsm") == std::string_view::npos) {
                no_cell_ = not_periodic(file_, reader_.number(), fmt::format("boundaries {}", sides), axis);
            }
        }
    }

    /// Tilts stand in this order; another one would shear the box the wrong way.
    void check_tilt_words(std::string_view head) const {
        const bool has_tilt = head.find(" xy") != std::string_view::npos ||
                              head.find(" yz") != std::string_view::npos || head.find(" xz") != std::string_view::npos;
        if (has_tilt && head.find("xy xz yz") == std::string_view::npos) {
            reader_.complain("found tilts in another order, expected xy xz yz");
        }
    }

    /// Three rows, each an edge of the box and a coordinate of its corner.
    void read_general_box() {
        std::array<Vec3, 3> edges;
        for (int k = 0; k < 3; ++k) {
            need_line("an edge of the box and a coordinate of its origin");
            const auto f = split_at_blanks(reader_.line());
            if (f.size() != 4) {
                reader_.complain(
                    fmt::format("found {} numbers, expected an edge and a coordinate of the origin", f.size())
                );
            }
            edges[static_cast<std::size_t>(k)] = {
                to_number(reader_, f[0], "edge"), to_number(reader_, f[1], "edge"), to_number(reader_, f[2], "edge")};
            box_.origin[k] = to_number(reader_, f[3], "origin");
        }
        box_.h = from_columns(edges[0], edges[1], edges[2]);
        if (!(determinant(box_.h) > 0)) {
            reader_.complain("the edges of the box span no volume, or are left-handed");
        }
    }

    /// For a tilted box LAMMPS writes the bounds of its bounding box.
    void read_box(bool tilted) {
        std::array<Vec3, 3> rows;
        for (Vec3& row : rows) {
            need_line("the bounds of the box");
            const auto f = split_at_blanks(reader_.line());
            if (f.size() != (tilted ? 3U : 2U)) {
                reader_.complain(fmt::format("found {} bounds, expected {}", f.size(), tilted ? 3 : 2));
            }
            row = {
                to_number(reader_, f[0], "low"), to_number(reader_, f[1], "high"),
                tilted ? to_number(reader_, f[2], "tilt") : 0.0};
        }
        const double xy = rows[0].z, xz = rows[1].z, yz = rows[2].z;
        rows[0].x -= std::min({0.0, xy, xz, xy + xz});
        rows[0].y -= std::max({0.0, xy, xz, xy + xz});
        rows[1].x -= std::min(0.0, yz);
        rows[1].y -= std::max(0.0, yz);
        box_.origin = {rows[0].x, rows[1].x, rows[2].x};
        for (int a = 0; a < 3; ++a) {
            const Vec3& row = rows[static_cast<std::size_t>(a)];
            if (!(row.y > row.x)) {
                reader_.complain(fmt::format("found a box from {} to {}, expected the second larger", row.x, row.y));
            }
            box_.h(a, a) = row.y - row.x;
        }
        box_.h(0, 1) = xy, box_.h(0, 2) = xz, box_.h(1, 2) = yz;
    }

    ImportedPacking read_atoms(const std::vector<std::string_view>& names) {
        const NamedColumns columns(names);
        auto position = columns.find("x", "y", "z");
        if (!position) {
            position = columns.find("xu", "yu", "zu");
        }
        const bool scaled = !position;
        if (scaled) {
            position = columns.find("xs", "ys", "zs");
        }
        if (!position) {
            position = columns.find("xsu", "ysu", "zsu");
        }
        const auto radius = columns.find("radius"), diameter = columns.find("diameter");
        if (!position || (!radius && !diameter && !radius_)) {
            reader_.complain(fmt::format(
                "found columns {}, expected x y z and radius (of equal grains one may be given): dump ID all custom N "
                "FILE id type x y z radius",
                fmt::join(names, " ")
            ));
        }
        const auto velocity = columns.find("vx", "vy", "vz"), spin = columns.find("omegax", "omegay", "omegaz");
        ImportedPacking packing;
        packing.no_cell = no_cell_;
        packing.origin = box_.origin;
        if (no_cell_.empty()) {
            packing.cell = cell::Cell{box_.h, {}};
        }
        for (std::size_t row = 0; row < atoms_; ++row) {
            need_line(fmt::format("{} atoms, found {}", atoms_, row));
            const auto f = split_at_blanks(reader_.line());
            if (f.size() != names.size()) {
                reader_.complain(fmt::format("found {} fields, expected {}", f.size(), names.size()));
            }
            const Vec3 x = vector_in(reader_, f, *position);
            const double r = radius     ? positive_in(reader_, f[*radius], "radius")
                             : diameter ? 0.5 * positive_in(reader_, f[*diameter], "diameter")
                                        : *radius_;
            const auto g = grains::add_grain(packing.grains, scaled ? box_.h * x : x - box_.origin, r, density_);
            packing.grains.velocity[g] = velocity ? vector_in(reader_, f, *velocity) : Vec3{};
            packing.grains.spin[g] = spin ? vector_in(reader_, f, *spin) : Vec3{};
        }
        return packing;
    }

    const std::string& file_;
    LineReader reader_;
    double density_;
    std::optional<double> radius_; // of all, where the file has none
    std::size_t atoms_ = 0;
    Box box_;
    std::string no_cell_; // why the box is none
};

} // namespace

bool looks_like_lammps_dump(std::string_view text) {
    return text.starts_with(item);
}

ImportedPacking
parse_lammps_dump(const std::string& file, std::string_view text, double density, std::optional<double> radius) {
    return DumpParser(file, text, density, radius).parse();
}

} // namespace suffuse::io
