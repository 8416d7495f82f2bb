// Packings for LAMMPS and its tools.

#include "suffuse/base/error.hpp"
#include "suffuse/io/atomic_file.hpp"
#include "suffuse/io/packing_export.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace suffuse::io {
namespace {

bool is_tilted(const Mat3& h) {
    return h(0, 1) != 0 || h(0, 2) != 0 || h(1, 2) != 0;
}

/// LAMMPS wants the first cell vector along x and the second in the xy plane. A cell that lies otherwise is turned
/// there, all that is in it too; h is upper triangular then.
class LammpsFrame {
public:
    explicit LammpsFrame(const Mat3& h) : h_(h), turns_(h(1, 0) != 0 || h(2, 0) != 0 || h(2, 1) != 0) {
        if (turns_) {
            const Vec3 x = h.column(0) / norm(h.column(0));
            const Vec3 normal = cross(h.column(0), h.column(1)), z = normal / norm(normal);
            turn_ = transpose(from_columns(x, cross(z, x), z));
            h_ = turn_ * h;
            h_(1, 0) = h_(2, 0) = h_(2, 1) = 0; // which rounding left
        }
    }

    [[nodiscard]] const Mat3& h() const { return h_; }

    /// A place, velocity or spin.
    [[nodiscard]] Vec3 of(const Vec3& v) const { return turns_ ? turn_ * v : v; }

private:
    Mat3 h_, turn_;
    bool turns_;
};

int type_of(const grains::Grains& grains, std::size_t g) {
    return grains.fine[g] != 0 ? 2 : 1;
}

} // namespace

void export_lammps_data(const std::filesystem::path& path, const grains::Grains& grains, const cell::Cell& cell) {
    const LammpsFrame frame(cell.h);
    const Mat3& h = frame.h();
    AtomicFile file(path);
    file.write(fmt::format(
        "suffuse: atom_style sphere, SI units\n\n{} atoms\n2 atom types\n\n0 {} xlo xhi\n0 {} ylo yhi\n0 {} zlo zhi\n",
        grains.size(), h(0, 0), h(1, 1), h(2, 2)
    ));
    if (is_tilted(h)) {
        file.write(fmt::format("{} {} {} xy xz yz\n", h(0, 1), h(0, 2), h(1, 2)));
    }
    file.write("\nAtoms # sphere\n\n");
    for (std::size_t g = 0; g < grains.size(); ++g) {
        const Vec3 x = frame.of(grains.position[g]);
        const double r = grains.radius[g];
        file.write(fmt::format(
            "{} {} {} {} {} {} {}\n", grains.id[g] + 1, type_of(grains, g), 2 * r, grains.mass[g] / sphere_volume(r),
            x.x, x.y, x.z
        ));
    }
    file.write("\nVelocities\n\n");
    for (std::size_t g = 0; g < grains.size(); ++g) {
        const Vec3 v = frame.of(grains.velocity[g]), w = frame.of(grains.spin[g]);
        file.write(fmt::format("{} {} {} {} {} {} {}\n", grains.id[g] + 1, v.x, v.y, v.z, w.x, w.y, w.z));
    }
    file.commit();
}

void export_lammps_dump(const std::filesystem::path& path, const dem::World& world) {
    const LammpsFrame frame(world.cell.h);
    const Mat3& h = frame.h();
    const double xy = h(0, 1), xz = h(0, 2), yz = h(1, 2);
    // The bounds are those of the bounding box.
    const std::array<double, 3> low{std::min({0.0, xy, xz, xy + xz}), std::min(0.0, yz), 0};
    const std::array<double, 3> high{h(0, 0) + std::max({0.0, xy, xz, xy + xz}), h(1, 1) + std::max(0.0, yz), h(2, 2)};
    const std::array<double, 3> tilt{xy, xz, yz};
    AtomicFile file(path);
    file.write(fmt::format(
        "ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\nITEM: BOX BOUNDS {}pp pp pp\n", world.clock.step,
        world.grains.size(), is_tilted(h) ? "xy xz yz " : ""
    ));
    for (std::size_t a = 0; a < 3; ++a) {
        file.write(
            is_tilted(h) ? fmt::format("{} {} {}\n", low[a], high[a], tilt[a]) : fmt::format("{} {}\n", low[a], high[a])
        );
    }
    file.write("ITEM: ATOMS id type x y z radius vx vy vz omegax omegay omegaz\n");
    const grains::Grains& grains = world.grains;
    for (std::size_t g = 0; g < grains.size(); ++g) {
        const Vec3 x = frame.of(grains.position[g]), v = frame.of(grains.velocity[g]), w = frame.of(grains.spin[g]);
        file.write(fmt::format(
            "{} {} {} {} {} {} {} {} {} {} {} {}\n", grains.id[g] + 1, type_of(grains, g), x.x, x.y, x.z,
            grains.radius[g], v.x, v.y, v.z, w.x, w.y, w.z
        ));
    }
    file.commit();
}

} // namespace suffuse::io
