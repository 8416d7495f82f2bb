#include "suffuse/io/flow_tables.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/io/csv_writer.hpp"
#include "suffuse/io/vtk.hpp"

namespace suffuse::io {

void write_pores_csv(
    const std::filesystem::path& path, const pores::PoreNetwork& network, std::span<const double> pressure,
    std::span<const Vec3> velocity
) {
    const pores::Pores& pores = network.pores;
    expects(pressure.size() == pores.size(), "there is a pressure for each pore");
    expects(velocity.size() == pores.size(), "there is a velocity for each pore");
    CsvWriter table(path, "x,y,z,volume,void_volume,pressure,vx,vy,vz");
    for (std::size_t p = 0; p < pores.size(); ++p) {
        table.row(pores.center[p], pores.volume[p], pores.void_volume[p], pressure[p], velocity[p]);
    }
    table.finish();
}

void write_throats_csv(
    const std::filesystem::path& path, const pores::PoreNetwork& network, std::span<const double> conductance,
    std::span<const double> flux
) {
    const pores::Throats& throats = network.throats;
    expects(conductance.size() == throats.size() && flux.size() == throats.size(), "there is a flux for each throat");
    expects(throats.inscribed_radius.size() == throats.size(), "constrictions are measured before they are written");
    CsvWriter table(path, "pore_1,pore_2,area,hydraulic_radius,inscribed_radius,length,conductance,flux");
    for (std::size_t t = 0; t < throats.size(); ++t) {
        table.row(
            throats.side[t][0], throats.side[t][1], throats.void_area[t], throats.hydraulic_radius[t],
            throats.inscribed_radius[t], throats.length[t], conductance[t], flux[t]
        );
    }
    table.finish();
}

void write_pores_vtu(
    const std::filesystem::path& path, const pores::PoreNetwork& network, std::span<const Vec3> position,
    std::span<const double> pressure, std::span<const Vec3> velocity
) {
    const pores::Pores& pores = network.pores;
    expects(pressure.size() == pores.size(), "there is a pressure for each pore");
    expects(velocity.size() == pores.size(), "there is a velocity for each pore");
    std::vector<std::array<Vec3, 4>> corners(pores.size());
    for (std::size_t p = 0; p < pores.size(); ++p) {
        for (std::size_t k = 0; k < 4; ++k) {
            corners[p][k] = position[pores.grain[p][k]] + cell::shift(network.h, pores.grain_image[p][k]);
        }
    }
    write_pores_vtu(
        path, corners,
        {vtk_scalars("pressure", {pressure.begin(), pressure.end()}), vtk_scalars("void_volume", pores.void_volume),
         vtk_vectors("velocity", {velocity.begin(), velocity.end()})}
    );
}

} // namespace suffuse::io
