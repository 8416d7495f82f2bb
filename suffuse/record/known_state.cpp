#include "suffuse/record/known_state.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/record/stage_cache.hpp"

#include <fmt/format.h>

namespace suffuse::record {
namespace {

std::string advice(const std::filesystem::path& to_remove) {
    return fmt::format("remove {} and resume: its stage is then computed anew", to_remove.string());
}

} // namespace

io::Checkpoint KnownState::load() const {
    try {
        return io::load_world(file_);
    } catch (const IoError& error) {
        throw IoError(fmt::format("{}; {}", error.what(), advice(to_remove_)));
    }
}

void KnownState::check(const dem::World& world, const std::string& expected) const {
    if (const std::string found = describe_state(world); !expected.empty() && found != expected) {
        complain(fmt::format("is not the state that was saved ({}, recorded {})", found, expected));
    }
}

void KnownState::refuse_other() const {
    throw IoError(fmt::format(
        "{}: is of another case, sample, stage or seed: its key is not that of this stage; {}", file_.string(),
        advice(to_remove_)
    ));
}

void KnownState::complain(const std::string& what) const {
    throw IoError(fmt::format("{}: {}: it was changed or damaged; {}", file_.string(), what, advice(to_remove_)));
}

} // namespace suffuse::record
