#include "suffuse/run/pass_pictures.hpp"

#include "suffuse/record/folder.hpp"
#include "suffuse/record/known_state.hpp"
#include "suffuse/run/grain_pictures.hpp"
#include "suffuse/run/mobility_record.hpp"

#include <fmt/format.h>

#include <unordered_map>

namespace suffuse::run {
namespace {

using PassOf = std::unordered_map<std::uint32_t, int>;

io::GrainColumn leaving_column(const dem::World& world, const PassOf& left_in) {
    io::GrainColumn column{"leaves_in_pass", 1, {}};
    for (const std::uint32_t id : world.grains.id) {
        const auto found = left_in.find(id);
        column.values.push_back(found == left_in.end() ? 0 : found->second);
    }
    return column;
}

std::vector<io::GrainColumn>
columns_before(const dem::World& world, const erosion::PassResult& pass, const PassOf& left_in) {
    std::vector<io::GrainColumn> columns =
        pass.mobility ? std::vector<io::GrainColumn>{{"mobile_gradient", 1, mobile_gradients(world, *pass.mobility)}}
                      : probe_columns(world, pass.probe);
    columns.push_back(leaving_column(world, left_in));
    return columns;
}

} // namespace

void write_pass_pictures(const StageWork& work, const erosion::ErosionResult& result) {
    const casefile::OutputSpec& output = work.what.output;
    if (output.snapshots.when == casefile::Snapshots::When::Never || work.stage.parent < 0) {
        return;
    }
    PassOf left_in;
    for (const erosion::LedgerRow& row : result.ledger) {
        left_in[row.grain] = row.pass;
    }
    const casefile::Stage& parent = work.variant.stages[static_cast<std::size_t>(work.stage.parent)];
    for (const erosion::PassResult& next : result.passes) {
        const int passes = next.pass - 1; // that lie behind the state
        const std::filesystem::path file =
            passes == 0 ? work.folder.parent_path() / parent.name / "state.h5" : record::pass_file(work.folder, passes);
        const dem::World world = record::KnownState(file, work.folder).load().world;
        write_grain_pictures(
            work.folder, fmt::format("pass-{}", passes), world, output.formats, columns_before(world, next, left_in)
        );
    }
}

} // namespace suffuse::run
