#include "suffuse/io/packing_export.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/io/atomic_file.hpp"
#include "suffuse/io/brought_home.hpp"
#include "suffuse/io/csv_writer.hpp"
#include "suffuse/io/vtk_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace suffuse::io {
namespace {

struct FormatRow {
    PackingFormat format;
    std::string_view name;
    std::vector<std::string_view> endings;
    bool needs_cell;
    void (*write)(const std::filesystem::path&, const dem::World&);
};

const std::vector<FormatRow>& formats() {
    using Path = std::filesystem::path;
    using dem::World;
    static const std::vector<FormatRow> rows = {
        {PackingFormat::Csv, "csv", {".csv"}, false, [](const Path& p, const World& w) { export_csv(p, w.grains); }},
        {PackingFormat::Yade, "yade", {".txt"}, false, [](const Path& p, const World& w) { export_yade(p, w.grains); }},
        {PackingFormat::ExtendedXyz,
         "xyz",
         {".xyz", ".extxyz"},
         true,
         [](const Path& p, const World& w) { export_extended_xyz(p, w.grains, w.cell); }},
        {PackingFormat::LammpsData,
         "lammps",
         {".data", ".lmp"},
         true,
         [](const Path& p, const World& w) { export_lammps_data(p, w.grains, w.cell); }},
        {PackingFormat::LammpsDump, "dump", {".dump", ".lammpstrj"}, true, export_lammps_dump},
        {PackingFormat::Vtp, "vtp", {".vtp"}, true, export_vtp},
    };
    return rows;
}

/// The row of a format. @throws Bug where it has none.
const FormatRow& row_of(PackingFormat format) {
    const auto row = std::ranges::find(formats(), format, &FormatRow::format);
    expects(row != formats().end(), "a packing format has its row in packing_export.cpp");
    return *row;
}

template <class Test>
std::optional<PackingFormat> format_where(const Test& is_so) {
    const auto row = std::ranges::find_if(formats(), is_so);
    return row == formats().end() ? std::nullopt : std::optional(row->format);
}

} // namespace

std::vector<std::string> packing_format_names() {
    std::vector<std::string> names;
    for (const FormatRow& row : formats()) {
        names.emplace_back(row.name);
    }
    return names;
}

std::optional<PackingFormat> packing_format_of_name(std::string_view name) {
    return format_where([&](const FormatRow& row) { return row.name == name; });
}

std::optional<PackingFormat> packing_format_of_file(const std::filesystem::path& path) {
    return format_where([ending = path.extension().string()](const FormatRow& row) {
        return std::ranges::count(row.endings, ending) > 0;
    });
}

bool needs_cell(PackingFormat format) {
    return row_of(format).needs_cell;
}

void export_packing(const std::filesystem::path& path, const dem::World& world, PackingFormat format) {
    row_of(format).write(path, world);
}

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

void export_extended_xyz(
    const std::filesystem::path& path, const grains::Grains& grains, const cell::Cell& cell,
    const std::vector<GrainColumn>& further
) {
    const Vec3 a = cell.h.column(0), b = cell.h.column(1), c = cell.h.column(2);
    const Mat3 inverse_h = inverse(cell.h);
    std::string names;
    for (const GrainColumn& column : further) {
        expects(column.values.size() == column.components * grains.size(), "a column has a row a grain");
        names += fmt::format(":{}:R:{}", column.name, column.components);
    }
    AtomicFile file(path);
    file.write(fmt::format(
        "{}\nLattice=\"{} {} {} {} {} {} {} {} {}\" "
        "Properties=species:S:1:pos:R:3:radius:R:1:velo:R:3:angular_velocity:R:3:id:I:1:fine:I:1{} pbc=\"T T T\"\n",
        grains.size(), a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, names
    ));
    for (std::size_t g = 0; g < grains.size(); ++g) {
        const auto [x, v] = brought_home(cell, inverse_h, {grains.position[g], grains.velocity[g]});
        const Vec3& w = grains.spin[g];
        file.write(fmt::format(
            "{} {} {} {} {} {} {} {} {} {} {} {} {}", grains.fine[g] != 0 ? "fine" : "coarse", x.x, x.y, x.z,
            grains.radius[g], v.x, v.y, v.z, w.x, w.y, w.z, grains.id[g], grains.fine[g]
        ));
        for (const GrainColumn& column : further) {
            for (std::size_t k = 0; k < column.components; ++k) {
                file.write(fmt::format(" {}", column.values[g * column.components + k]));
            }
        }
        file.write("\n");
    }
    file.commit();
}

void export_vtp(const std::filesystem::path& path, const dem::World& world) {
    const std::vector<int> coordination = dem::coordination(world);
    const Vec3 a = world.cell.h.column(0), b = world.cell.h.column(1), c = world.cell.h.column(2);
    VtkMesh mesh;
    mesh.precise = true;
    mesh.point = world.grains.position;
    mesh.corner.resize(mesh.point.size());
    std::iota(mesh.corner.begin(), mesh.corner.end(), 0);
    mesh.point_data = {
        VtkArray{"radius", 1, world.grains.radius},
        VtkArray{"id", 1, world.grains.id},
        VtkArray{"fine", 1, world.grains.fine},
        VtkArray{"coordination", 1, std::vector<std::int64_t>(coordination.begin(), coordination.end())},
        precise_vtk_vectors("velocity", world.grains.velocity),
        precise_vtk_vectors("angular_velocity", world.grains.spin)};
    mesh.field_data = {VtkArray{"cell", 9, std::vector<double>{a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z}}};
    write_mesh(path, mesh);
}

} // namespace suffuse::io
