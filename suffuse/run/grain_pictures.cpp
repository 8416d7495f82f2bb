#include "suffuse/run/grain_pictures.hpp"

#include "suffuse/io/vtk.hpp"
#include "suffuse/stats/stress_by_fraction.hpp"

#include <limits>
#include <unordered_map>
#include <utility>

namespace suffuse::run {
namespace {

/// Row after row, as ParaView wants a tensor.
io::GrainColumn stress_column(const std::vector<Mat3>& stress) {
    io::GrainColumn column{"stress", 9, {}};
    for (const Mat3& s : stress) {
        for (int row = 0; row < 3; ++row) {
            for (int k = 0; k < 3; ++k) {
                column.values.push_back(s(row, k));
            }
        }
    }
    return column;
}

io::GrainColumn mean_stress_column(const std::vector<Mat3>& stress) {
    io::GrainColumn column{"mean_stress", 1, {}};
    for (const Mat3& s : stress) {
        column.values.push_back((s(0, 0) + s(1, 1) + s(2, 2)) / 3);
    }
    return column;
}

/// OVITO takes a property of this name for the color: fines red, coarse grains sand, as in the report.
io::GrainColumn color_column(const grains::Grains& grains) {
    io::GrainColumn column{"color", 3, {}};
    for (const std::uint8_t fine : grains.fine) {
        const Vec3 color = fine != 0 ? Vec3{0.78, 0.20, 0.17} : Vec3{0.81, 0.64, 0.34};
        column.values.insert(column.values.end(), {color.x, color.y, color.z});
    }
    return column;
}

std::vector<io::VtkArray> vtk_arrays(const std::vector<io::GrainColumn>& columns) {
    std::vector<io::VtkArray> arrays;
    for (const io::GrainColumn& column : columns) {
        arrays.push_back(io::vtk_scalars(column.name, column.values));
        arrays.back().components = static_cast<int>(column.components);
    }
    return arrays;
}

} // namespace

void write_grain_pictures(
    const std::filesystem::path& folder, const std::string& stem, const dem::World& world,
    const std::vector<std::string>& formats, const std::vector<io::GrainColumn>& further
) {
    const std::vector<Mat3> stress = stats::grain_stresses(world);
    std::vector<io::GrainColumn> columns{mean_stress_column(stress)};
    columns.insert(columns.end(), further.begin(), further.end());
    for (const std::string& format : formats) {
        if (format == "vtp") {
            std::vector<io::VtkArray> arrays = vtk_arrays(columns);
            arrays.push_back(vtk_arrays({stress_column(stress)}).front());
            io::write_grains_vtp(folder / (stem + ".vtp"), world, std::move(arrays));
        } else if (format == "xyz") {
            columns.push_back(color_column(world.grains));
            io::export_extended_xyz(folder / (stem + ".xyz"), world.grains, world.cell, columns);
        }
    }
}

io::GrainColumn picture_column(std::string name, const std::vector<Vec3>& values) {
    io::GrainColumn column{std::move(name), 3, {}};
    for (const Vec3& v : values) {
        column.values.insert(column.values.end(), {v.x, v.y, v.z});
    }
    return column;
}

std::vector<io::GrainColumn> probe_columns(const dem::World& world, const erosion::ProbeResult& probe) {
    std::unordered_map<std::uint32_t, std::size_t> row_of;
    for (std::size_t k = 0; k < probe.id.size(); ++k) {
        row_of[probe.id[k]] = k;
    }
    io::GrainColumn force{"probe_fluid_force", 1, {}}, speed{"probe_speed", 1, {}};
    for (const std::uint32_t id : world.grains.id) {
        const auto found = row_of.find(id);
        const bool is_seen = found != row_of.end();
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        force.values.push_back(is_seen ? probe.fluid_force[found->second] : none);
        speed.values.push_back(is_seen ? probe.speed[found->second].back() : none);
    }
    return {std::move(force), std::move(speed)};
}

} // namespace suffuse::run
