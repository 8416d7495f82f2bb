#pragma once
// One stage: the world it starts from goes in, the world it ends with and its numbers come out. Each verb is a
// function.

#include "suffuse/casefile/case.hpp"
#include "suffuse/erosion/loop.hpp"
#include "suffuse/io/checkpoint.hpp"
#include "suffuse/io/packing_export.hpp"
#include "suffuse/record/finished_stage.hpp"
#include "suffuse/record/samples.hpp"
#include "suffuse/run/control.hpp"
#include "suffuse/run/history.hpp"
#include "suffuse/run/strain_pictures.hpp"
#include "suffuse/triaxial/run_path.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <vector>

namespace suffuse::run {

struct StageWork {
    const casefile::Case& what;
    const casefile::Variant& variant;
    const casefile::Stage& stage;
    std::filesystem::path folder; ///< of the stage
    bool write_tables;            ///< CSV tables of many rows
    Control& control;

    dem::World world;
    History history;
    StrainPictures pictures;
    nlohmann::json numbers = nlohmann::json::object(); ///< of stage.json, beyond those of every state
    record::StageFindings findings;
    std::vector<double> mobile_gradient;   ///< of the world's grains; empty if not requested [-]
    std::vector<io::GrainColumn> pictured; ///< of the world's grains, for pictures beyond what every state has
    std::vector<std::string> warnings, flaws;
    double time_step = 0;         ///< of the last burst [s]
    std::int64_t grain_steps = 0; ///< grains x steps, for the rate

    double earlier_seconds = 0; ///< wall time before the stage was taken up again [s]

    /// "STUDY/SAMPLE/STAGE", as warnings say where.
    [[nodiscard]] std::string place() const { return record::stage_name(variant, stage); }

    /// Steps that the grains of the world now have made.
    void count_steps(std::int64_t steps) { grain_steps += steps * static_cast<std::int64_t>(world.grains.size()); }

    /// Where a state that the stage saves is from, for those who find it alone, and to know it by.
    [[nodiscard]] io::Attributes made_by() const;

    /// What an erosion or a removal needs of the case.
    [[nodiscard]] erosion::Surroundings surroundings() const;

    /// The state after a burst: a row of the history and a picture, where they are due.
    void note_state();

    /// Wall time of the stage, over all its parts [s].
    [[nodiscard]] double seconds() const { return earlier_seconds + control.stage_seconds(); }

    /// Saves the half-done stage with the verb's own `state`, and a world; the verb finds them again in `resumed` and
    /// `world`.
    void save_partial(const nlohmann::json& state, const dem::World& of) const;

    void save_partial(const nlohmann::json& state) const { save_partial(state, world); }

    nlohmann::json resumed;          ///< null: from the start
    std::optional<dem::World> start; ///< what it began with, where it goes on from another world
    bool has_two_makers = false;     ///< another version of the program began it: no result of this one alone
    const erosion::OwnRule* own_rule = nullptr; ///< that decides what detaches, in place of the case's
    std::string start_state; ///< describe_state of what it starts from; empty where it makes its own sample
    std::string key;         ///< key_of_stage: every file that the stage leaves is known by it

    /// Files of its folder, and when they were written, before the stage began or went on.
    std::map<std::string, std::filesystem::file_time_type> there_before;
};

/// Runs the stage's verb.
void do_stage(StageWork& work);

// The verbs.
void do_import(StageWork& work, const casefile::ImportSpec& spec);
void do_pack(StageWork& work, const packing::PackSpec& spec);
void do_compact(StageWork& work, const packing::CompactSpec& spec);
void do_settle(StageWork& work, const dem::SettleSpec& spec);
void do_triaxial(StageWork& work, const triaxial::TriaxialSpec& spec);
void do_stress_probe(StageWork& work, const triaxial::StressProbeSpec& spec);
void do_stiffness(StageWork& work, const triaxial::StiffnessSpec& spec);
void do_advance(StageWork& work, const dem::AdvanceSpec& spec);
void do_flow(StageWork& work, const flow::FlowSpec& spec);
void do_detach(StageWork& work, const erosion::DetachStageSpec& spec);
void do_erode(StageWork& work, const erosion::ErodeSpec& spec);
void do_remove(StageWork& work, const erosion::RemoveSpec& spec);
void do_migrate(StageWork& work, const erosion::MigrateSpec& spec);

} // namespace suffuse::run
