#include "suffuse/io/tables.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/io/csv_writer.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace suffuse::io {
namespace {

std::vector<std::uint32_t> rows_by_id(const grains::Grains& grains) {
    std::vector<std::uint32_t> rows(grains.size());
    std::iota(rows.begin(), rows.end(), 0U);
    std::ranges::sort(rows, [&](std::uint32_t a, std::uint32_t b) { return grains.id[a] < grains.id[b]; });
    return rows;
}

/// Contacts by ids, the lower one first, whatever rows the grains are stored in.
std::vector<dem::ContactView> contacts_by_id(const dem::World& world) {
    std::vector<dem::ContactView> contacts = dem::inspect_contacts(world);
    for (dem::ContactView& c : contacts) {
        c.i = world.grains.id[c.i];
        c.j = world.grains.id[c.j];
        if (c.i <= c.j) {
            continue;
        }
        std::swap(c.i, c.j);
        c.image = -c.image;
        c.normal = -c.normal;
        c.normal_force = -c.normal_force;
        c.shear_force = -c.shear_force;
        c.moment = -c.moment;
    }
    std::ranges::sort(contacts, [](const dem::ContactView& a, const dem::ContactView& b) {
        return std::tie(a.i, a.j, a.image) < std::tie(b.i, b.j, b.image);
    });
    return contacts;
}

} // namespace

void write_grains_csv(
    const std::filesystem::path& path, const dem::World& world, std::span<const double> mobile_gradient
) {
    const grains::Grains& grains = world.grains;
    const std::vector<int> contacts = dem::coordination(world);
    const std::string columns = "id,x,y,z,r,vx,vy,vz,wx,wy,wz,fx,fy,fz,tx,ty,tz,contacts,fine";
    CsvWriter table(path, mobile_gradient.empty() ? columns : columns + ",mobile_gradient");
    for (const std::uint32_t g : rows_by_id(grains)) {
        const auto write = [&](const auto&... more) {
            table.row(
                grains.id[g], grains.position[g], grains.radius[g], grains.velocity[g], grains.spin[g], grains.force[g],
                grains.torque[g], contacts[g], grains.fine[g], more...
            );
        };
        if (mobile_gradient.empty()) {
            write();
        } else {
            write(mobile_gradient[g]);
        }
    }
    table.finish();
}

void write_contacts_csv(const std::filesystem::path& path, const dem::World& world) {
    CsvWriter table(path, "i,j,overlap,nx,ny,nz,fnx,fny,fnz,fsx,fsy,fsz,mx,my,mz");
    for (const dem::ContactView& c : contacts_by_id(world)) {
        table.row(c.i, c.j, c.overlap, c.normal, c.normal_force, c.shear_force, c.moment);
    }
    table.finish();
}

void write_grain_forces_csv(
    const std::filesystem::path& path, const grains::Grains& grains, const grains::GrainLoad& load
) {
    expects(load.force.size() == grains.size(), "a load has a row for each grain");
    CsvWriter table(path, "id,fx,fy,fz");
    for (const std::uint32_t g : rows_by_id(grains)) {
        table.row(grains.id[g], load.force[g]);
    }
    table.finish();
}

} // namespace suffuse::io
