#include "suffuse/run/stage_work.hpp"

#include "suffuse/base/version.hpp"
#include "suffuse/dem/stable_dt.hpp"
#include "suffuse/io/checkpoint.hpp"
#include "suffuse/record/case_hash.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/stage_cache.hpp"

namespace suffuse::run {

void StageWork::save_partial(const nlohmann::json& state, const dem::World& of) const {
    const nlohmann::json all{
        {"state", state},
        {"history", history.to_json()},
        {"grain_steps", grain_steps},
        {"seconds", seconds()},
        {"world", record::describe_state(of)},
        {"commit", commit()},
        {"key", key}};
    // CBOR, as text has no word for numbers that are infinite, or none
    io::save_world(folder / record::partial_file, of, {}, made_by(), nlohmann::json::to_cbor(all));
}

io::Attributes StageWork::made_by() const {
    return {{"case_hash", record::case_hash(what)}, {"stage", place()}, {"key", key}};
}

erosion::Surroundings StageWork::surroundings() const {
    return {what.fluid, what.balance, variant.damping, what.mode, control.pulse(), own_rule};
}

void StageWork::note_state() {
    history.record(world);
    pictures.see(world);
}

void do_stage(StageWork& work) {
    struct Verb {
        StageWork& work;

        void operator()(const casefile::ImportSpec& spec) const { do_import(work, spec); }

        void operator()(const packing::PackSpec& spec) const { do_pack(work, spec); }

        void operator()(const packing::CompactSpec& spec) const { do_compact(work, spec); }

        void operator()(const dem::SettleSpec& spec) const { do_settle(work, spec); }

        void operator()(const triaxial::TriaxialSpec& spec) const { do_triaxial(work, spec); }

        void operator()(const triaxial::StressProbeSpec& spec) const { do_stress_probe(work, spec); }

        void operator()(const triaxial::StiffnessSpec& spec) const { do_stiffness(work, spec); }

        void operator()(const dem::AdvanceSpec& spec) const { do_advance(work, spec); }

        void operator()(const flow::FlowSpec& spec) const { do_flow(work, spec); }

        void operator()(const erosion::DetachStageSpec& spec) const { do_detach(work, spec); }

        void operator()(const erosion::ErodeSpec& spec) const { do_erode(work, spec); }

        void operator()(const erosion::RemoveSpec& spec) const { do_remove(work, spec); }

        void operator()(const erosion::MigrateSpec& spec) const { do_migrate(work, spec); }
    };

    std::visit(
        [&](const auto& spec) {
            if constexpr (requires { spec.time_step; }) {
                if (spec.time_step > 0) {
                    dem::check_time_step(work.world, spec.time_step, work.variant.damping);
                }
            }
        },
        work.stage.spec
    );
    std::visit(Verb{work}, work.stage.spec);
    work.control.save_with(nullptr);
    work.pictures.finish();
}

} // namespace suffuse::run
