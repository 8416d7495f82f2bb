#pragma once
// Pictures of the state while a sample is strained: one each time the largest strain of the stage passes a further
// multiple of what [output] snapshots specifies, named after it, so that a stage that was stopped goes on with the same
// names.

#include "suffuse/casefile/case.hpp"
#include "suffuse/dem/world.hpp"

#include <filesystem>

namespace suffuse::run {

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
    int last_ = 0; ///< multiples of the specified strain that were passed
};

} // namespace suffuse::run
