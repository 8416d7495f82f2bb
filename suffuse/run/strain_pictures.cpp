#include "suffuse/run/strain_pictures.hpp"

#include "suffuse/cell/strain.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/io/vtk.hpp"
#include "suffuse/run/grain_pictures.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace suffuse::run {
namespace {

using When = casefile::Snapshots::When;

std::string stem(int multiple) {
    return fmt::format("strain-{:04}", multiple);
}

} // namespace

StrainPictures::StrainPictures(
    const casefile::OutputSpec& output, std::filesystem::path folder, const dem::World& start
)
    : output_(&output), folder_(std::move(folder)), last_(multiples(start)) {}

int StrainPictures::multiples(const dem::World& world) const {
    if (output_->snapshots.when != When::Strain || world.grains.size() == 0) {
        return 0;
    }
    const double largest = cell::largest_strain(dem::strain(world));
    constexpr double rounding = 1e-9;
    return static_cast<int>(std::floor(largest / output_->snapshots.every * (1 + rounding)));
}

std::filesystem::path StrainPictures::file(int multiple, const char* ending) const {
    return folder_ / (stem(multiple) + ending);
}

void StrainPictures::see(const dem::World& world) {
    const int now = multiples(world);
    if (now > last_) {
        last_ = now;
        write_grain_pictures(folder_, stem(now), world, output_->formats);
    }
}

void StrainPictures::begin_anew(const dem::World& start) {
    for (int k = 1; k <= last_; ++k) {
        std::filesystem::remove(file(k, ".vtp"));
        std::filesystem::remove(file(k, ".xyz"));
    }
    last_ = multiples(start);
}

void StrainPictures::finish() const {
    std::vector<io::VtkFrame> frames;
    for (int k = 1; k <= last_; ++k) {
        if (std::filesystem::exists(file(k, ".vtp"))) {
            frames.push_back({k * output_->snapshots.every, stem(k) + ".vtp"});
        }
    }
    if (!frames.empty()) {
        io::write_pvd(folder_ / "strain-series.pvd", frames);
    }
}

} // namespace suffuse::run
