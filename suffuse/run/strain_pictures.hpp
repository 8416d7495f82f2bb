#pragma once
// Pictures of the state while a sample is strained: one each time the largest strain of the stage passes a further
// multiple of what [output] snapshots asks, named after it, so that a stage that was stopped goes on with the same
// names.

#include "suffuse/casefile/case.hpp"
#include "suffuse/dem/world.hpp"
#include "suffuse/io/vtk_writer.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace suffuse::run {

/// Writes the picture files that the formats ask for: grains (vtp, xyz) as `stem`.vtp and `stem`.xyz.
/// @param further columns of the first, a row a grain
void write_grain_pictures(
    const std::filesystem::path& folder, const std::string& stem, const dem::World& world,
    const std::vector<std::string>& formats, const std::vector<io::VtkArray>& further = {}
);

class StrainPictures {
public:
    /// @param start the state from which the stage goes on: its strain is not pictured again
    StrainPictures(const casefile::OutputSpec& output, std::filesystem::path folder, const dem::World& start);

    /// Pictures the state when it is due.
    void see(const dem::World& world);

    /// A stage that begins anew from `start`: earlier pictures of it go.
    void begin_anew(const dem::World& start);

    /// Lists the pictures for ParaView, in strain-series.pvd: strain [-] in place of time.
    void finish() const;

private:
    [[nodiscard]] int multiples(const dem::World& world) const;
    [[nodiscard]] std::filesystem::path file(int multiple, const char* ending) const;

    const casefile::OutputSpec* output_;
    std::filesystem::path folder_;
    int last_ = 0; ///< multiples of the strain asked that were passed
};

} // namespace suffuse::run
