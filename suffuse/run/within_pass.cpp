#include "suffuse/run/within_pass.hpp"

#include "suffuse/record/result_json.hpp"

#include <utility>

namespace suffuse::run {
namespace {

constexpr const char* key = "pass_under_way";

} // namespace

void save_within_pass(const StageWork& work, const erosion::PassUnderWay& now, nlohmann::json state) {
    if (now.at == erosion::PassUnderWay::At::Start) {
        work.save_partial(state);
        return;
    }
    state[key] = now;
    work.save_partial(state, now.world);
}

erosion::PassUnderWay pass_under_way(const StageWork& work) {
    if (!work.resumed.is_object() || !work.resumed.contains(key)) {
        return {};
    }
    auto now = work.resumed.at(key).get<erosion::PassUnderWay>();
    now.world = work.world;
    return now;
}

} // namespace suffuse::run
