#include "suffuse/io/packing_export.hpp"

#include "suffuse/io/atomic_file.hpp"
#include "suffuse/io/csv_writer.hpp"

#include <fmt/format.h>

namespace suffuse::io {

void export_csv(const std::filesystem::path& path, const grains::Grains& grains) {
    CsvWriter table(path, "x,y,z,r,vx,vy,vz,wx,wy,wz");
    for (std::size_t g = 0; g < grains.size(); ++g) {
        table.row(grains.position[g], grains.radius[g], grains.velocity[g], grains.spin[g]);
    }
    table.finish();
}

void export_yade(const std::filesystem::path& path, const grains::Grains& grains) {
    AtomicFile file(path);
    file.write("#format x_y_z_r\n");
    for (std::size_t g = 0; g < grains.size(); ++g) {
        const Vec3& x = grains.position[g];
        file.write(fmt::format("{} {} {} {}\n", x.x, x.y, x.z, grains.radius[g]));
    }
    file.commit();
}

void export_extended_xyz(const std::filesystem::path& path, const grains::Grains& grains, const cell::Cell& cell) {
    const Vec3 a = cell.h.column(0), b = cell.h.column(1), c = cell.h.column(2);
    const Mat3 inverse_h = inverse(cell.h);
    AtomicFile file(path);
    file.write(fmt::format(
        "{}\nLattice=\"{} {} {} {} {} {} {} {} {}\" "
        "Properties=species:S:1:pos:R:3:radius:R:1:velo:R:3:id:I:1:fine:I:1 pbc=\"T T T\"\n",
        grains.size(), a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z
    ));
    for (std::size_t g = 0; g < grains.size(); ++g) {
        const Vec3 x = cell::wrapped(cell.h, inverse_h, grains.position[g]), &v = grains.velocity[g];
        file.write(fmt::format(
            "{} {} {} {} {} {} {} {} {} {}\n", grains.fine[g] != 0 ? "fine" : "coarse", x.x, x.y, x.z, grains.radius[g],
            v.x, v.y, v.z, grains.id[g], grains.fine[g]
        ));
    }
    file.commit();
}

} // namespace suffuse::io
