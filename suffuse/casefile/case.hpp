#pragma once
// A case: what the user requested, as one Spec per module, in SI, with every default in place. A study is written once;
// its variants are the copies that sweeps and replicates make of it, ready to be run one after the other.

#include "suffuse/base/vec3.hpp"
#include "suffuse/casefile/import_spec.hpp"
#include "suffuse/dem/spec.hpp"
#include "suffuse/erosion/migrate_spec.hpp"
#include "suffuse/erosion/spec.hpp"
#include "suffuse/flow/fluid.hpp"
#include "suffuse/grains/material.hpp"
#include "suffuse/grains/sample_size.hpp"
#include "suffuse/grains/soil.hpp"
#include "suffuse/packing/spec.hpp"
#include "suffuse/triaxial/spec.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace suffuse::casefile {

using StageSpec = std::variant<
    ImportSpec, packing::PackSpec, packing::CompactSpec, dem::SettleSpec, triaxial::TriaxialSpec,
    triaxial::StressProbeSpec, dem::AdvanceSpec, flow::FlowSpec, erosion::DetachStageSpec, erosion::ErodeSpec,
    erosion::RemoveSpec, triaxial::OedometerSpec, triaxial::IsotropicSpec, triaxial::PlaneStrainSpec,
    triaxial::ShearSpec, triaxial::CyclicSpec, erosion::MigrateSpec, triaxial::StiffnessSpec>;

/// A value as it stands in the case file: a quantity stays a text with its unit.
using Scalar = std::variant<bool, std::int64_t, double, std::string>;

/// Values of one key, each of which makes a copy of the study.
struct Sweep {
    std::string key; ///< of the study, of its soil, "stage.NAME.KEY" or "contact.KEY"
    std::vector<Scalar> values;
};

struct Stage {
    std::string name;
    std::string from; ///< stage to start from; empty: the one before
    StageSpec spec;
    std::optional<std::int64_t> record_every; ///< steps between two rows of the history; without it [output] decides
    bool restore = false;                     ///< the stage after this one starts where this one started
    std::vector<std::string> measure;         ///< what to report beyond the usual numbers
    std::vector<Sweep> only;                  ///< run for these sweep values only
    int parent = -1; ///< row of the stage whose end is this one's start, `from` and `restore` resolved; -1 = none
};

/// One copy of a study: what the runner runs.
struct Variant {
    std::string folder;                   ///< below studies/: "erosion", or "fines-sweep/fc=20/rep=1"
    std::map<std::string, Scalar> values; ///< of the swept keys
    int replicate = 1;
    std::uint64_t seed = 0;
    std::string soil_name; ///< the study's, unless it is swept
    std::optional<grains::Soil> soil;
    std::int64_t particles = 0;
    std::optional<grains::SizedBy> sized_by; ///< the rule that decided on `particles`, where the study has rules
    grains::Material material;               ///< of the case, but for what is swept
    double damping = dem::usual_damping;     ///< likewise [-]
    std::vector<Stage> stages;
};

/// Values that are added to a sweep when its own have been run: on both sides of the extreme of a measured curve.
struct Refine {
    std::string key;             ///< that is swept
    bool maximum = false;        ///< where the curve is highest, instead of lowest
    std::string of;              ///< a number of stage.json, its mean over the replicates
    std::vector<std::string> at; ///< stages; each has its own curve
    int add = 1;                 ///< values between the extreme and each of its neighbors, evenly spaced
};

struct Study {
    std::string name;
    std::string soil;           ///< name of a soil of the case; empty where the grains are imported
    std::int64_t particles = 0; ///< 0 where the grains are imported, or `sample_size` decides for each variant
    std::optional<grains::SampleSizeSpec> sample_size;
    std::vector<Sweep> sweep;
    std::vector<Sweep> rows; ///< values of several keys that belong together; a sweep over "row" says which of them
    int replicates = 1;
    std::optional<Refine> refine;
    std::vector<Stage> stages;     ///< as written, sweeps not applied
    std::vector<Variant> variants; ///< at least one
};

/// When pictures of the state are written.
struct Snapshots {
    enum class When { PerStage, Never, Strain };
    When when = When::PerStage;
    double every = 0.01; ///< When::Strain: axial strain between two [-]
};

struct OutputSpec {
    std::vector<std::string> formats = {"vtp"}; ///< vtp, xyz; csv: tables of many rows for every stage
    Snapshots snapshots;
    double checkpoint = 600;            ///< wall-clock time between checkpoints [s]
    std::int64_t histories_every = 100; ///< steps between two rows of a history
};

struct ReportSpec {
    std::vector<std::string> figures = {"paper", "own"};
    bool reversed_size_axis = false;            ///< large grains on the left
    bool dilation_up = false;                   ///< how volumetric strain is drawn; its sign does not change
    std::string project, author;                ///< on the title page in print; may be empty
    std::map<std::string, std::string> overlay; ///< figure -> CSV of measured points
};

struct Case {
    int schema = 1;
    std::string title, paper;
    std::uint64_t seed = 1;
    std::string preset = "standard";     ///< in force; "standard" = the case as written
    grains::Material material;           ///< where no study sweeps it
    double damping = dem::usual_damping; ///< likewise; local, non-viscous [-]
    dem::Mode mode = dem::Mode::Reference;
    dem::BalanceSpec balance;
    flow::Fluid fluid;
    std::optional<erosion::Gravity> gravity; ///< nothing: the fines of a probe have no weight
    bool names_conductance = true;           ///< false: of a run made before there was a choice
    std::map<std::string, grains::Soil> soils;
    std::vector<Study> studies; ///< in the order of the file
    OutputSpec output;
    ReportSpec report;
};

/// What a laboratory test of any verb is to do; nothing of other stages.
const triaxial::TriaxialSpec* laboratory_test(const StageSpec& spec);

/// "pack", "erode", ...: the verb of a stage.
std::string verb_of(const StageSpec& spec);

} // namespace suffuse::casefile
