#include "suffuse/io/vtk.hpp"

#include "suffuse/dem/inspect.hpp"
#include "suffuse/io/atomic_file.hpp"
#include "suffuse/io/brought_home.hpp"

#include <fmt/format.h>

#include <iterator>
#include <numeric>
#include <utility>

namespace suffuse::io {
namespace {

std::vector<Vec3> home_positions(const dem::World& world) {
    const Mat3 inverse_h = inverse(world.cell.h);
    std::vector<Vec3> home;
    home.reserve(world.grains.size());
    for (const Vec3& x : world.grains.position) {
        home.push_back(cell::wrapped(world.cell.h, inverse_h, x));
    }
    return home;
}

std::string escaped(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        switch (c) {
        case '&':
            safe += "&amp;";
            break;
        case '<':
            safe += "&lt;";
            break;
        case '"':
            safe += "&quot;";
            break;
        default:
            safe += c;
        }
    }
    return safe;
}

} // namespace

void write_grains_vtp(const std::filesystem::path& path, const dem::World& world, std::vector<VtkArray> further) {
    const std::vector<int> coordination = dem::coordination(world);
    VtkMesh mesh;
    std::vector<Vec3> velocity;
    const Mat3 inverse_h = inverse(world.cell.h);
    for (std::size_t g = 0; g < world.grains.size(); ++g) {
        const auto home = brought_home(world.cell, inverse_h, {world.grains.position[g], world.grains.velocity[g]});
        mesh.point.push_back(home.position);
        velocity.push_back(home.velocity);
    }
    mesh.corner.resize(mesh.point.size());
    std::iota(mesh.corner.begin(), mesh.corner.end(), 0);
    mesh.point_data = {
        vtk_scalars("radius", world.grains.radius), VtkArray{"id", 1, world.grains.id},
        VtkArray{"fine", 1, world.grains.fine},
        VtkArray{"coordination", 1, std::vector<std::int64_t>(coordination.begin(), coordination.end())},
        vtk_vectors("velocity", velocity)};
    std::move(further.begin(), further.end(), std::back_inserter(mesh.point_data));
    write_mesh(path, mesh);
}

void write_contacts_vtp(const std::filesystem::path& path, const dem::World& world) {
    const std::vector<Vec3> home = home_positions(world);
    std::vector<double> normal_force, shear_force, overlap;
    VtkMesh mesh;
    mesh.cell = VtkCell::Line;
    for (const dem::ContactView& c : dem::inspect_contacts(world)) {
        const double distance = world.grains.radius[c.i] + world.grains.radius[c.j] - c.overlap;
        for (const Vec3& end : {home[c.i], home[c.i] + distance * c.normal}) {
            mesh.corner.push_back(static_cast<std::int64_t>(mesh.point.size()));
            mesh.point.push_back(end);
        }
        normal_force.push_back(-dot(c.normal_force, c.normal));
        shear_force.push_back(norm(c.shear_force));
        overlap.push_back(c.overlap);
    }
    mesh.cell_data = {
        vtk_scalars("normal_force", normal_force), vtk_scalars("shear_force", shear_force),
        vtk_scalars("overlap", overlap)};
    write_mesh(path, mesh);
}

void write_pores_vtu(
    const std::filesystem::path& path, const std::vector<std::array<Vec3, 4>>& pores, std::vector<VtkArray> columns
) {
    VtkMesh mesh;
    mesh.cell = VtkCell::Tetrahedron;
    for (const std::array<Vec3, 4>& pore : pores) {
        mesh.point.insert(mesh.point.end(), pore.begin(), pore.end());
    }
    mesh.corner.resize(mesh.point.size());
    std::iota(mesh.corner.begin(), mesh.corner.end(), 0);
    mesh.cell_data = std::move(columns);
    write_mesh(path, mesh);
}

void write_cell_vtp(const std::filesystem::path& path, const cell::Cell& cell) {
    VtkMesh mesh;
    mesh.cell = VtkCell::Line;
    for (int corner = 0; corner < 8; ++corner) { // bit a of its number: whether it lies at the far end of vector a
        mesh.point.push_back(cell::shift(cell.h, {corner & 1, corner >> 1 & 1, corner >> 2 & 1}));
        for (int a = 0; a < 3; ++a) {
            if ((corner & 1 << a) == 0) {
                mesh.corner.push_back(corner);
                mesh.corner.push_back(corner | 1 << a);
            }
        }
    }
    write_mesh(path, mesh);
}

void write_pvd(const std::filesystem::path& path, const std::vector<VtkFrame>& frames) {
    std::string xml = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
    for (const VtkFrame& frame : frames) {
        xml += fmt::format(
            "<DataSet timestep=\"{}\" part=\"{}\" file=\"{}\"/>\n", frame.time, frame.part, escaped(frame.file)
        );
    }
    write_file(path, xml + "</Collection>\n</VTKFile>\n");
}

} // namespace suffuse::io
