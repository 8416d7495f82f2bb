// export: the grains of a stage for other programs.

#include "suffuse/base/amounts.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/base/shell_word.hpp"
#include "suffuse/base/spelling.hpp"
#include "suffuse/dem/order.hpp"
#include "suffuse/io/checkpoint.hpp"
#include "suffuse/io/contact_table.hpp"
#include "suffuse/io/packing_export.hpp"
#include "suffuse/job/run_folder.hpp"
#include "suffuse/record/stage_sums.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/exit_code.hpp"
#include "apps/json_text.hpp"
#include "apps/shared_options.hpp"
#include "apps/verb.hpp"
#include "apps/verbs.hpp"
#include <algorithm>
#include <filesystem>
#include <memory>
#include <vector>

namespace suffuse::apps {
namespace {

namespace fs = std::filesystem;

struct ExportVerb final : Verb {
    ExportVerb()
        : Verb(
              "export", "write the grains of a stage for other programs",
              "suffuse export runs/dyke-0001/studies/erosion/initial -o initial.xyz"
          ) {}

    std::string stage;
    PackingOutput output;
    std::string contacts; ///< file for what the contacts remember

    void add_to(Options& options) override {
        options.argument("STATE", stage, "a stage's state.h5, or the stage's folder").required();
        output.add_to(options);
        options.value("--contacts", contacts, "also write shear forces and moments of the contacts to this CSV file")
            .type("FILE");
    }

    [[nodiscard]] int act(const CommandLine&, const Console& console) const override;
};

/// Where the user names a run instead of a stage, the error lists the stages that it has.
void check_is_no_run(const fs::path& given) {
    if (!fs::is_directory(given / "studies")) {
        return;
    }
    std::vector<std::string> stages;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(given / "studies")) {
        if (entry.path().filename() == "state.h5") {
            stages.push_back(entry.path().parent_path().string());
        }
    }
    std::sort(stages.begin(), stages.end());
    throw UsageError(fmt::format(
        "{} is a run; give one of its stages: {}", shown(given.string()),
        stages.empty() ? "none is finished yet" : fmt::format("{}", fmt::join(stages, ", "))
    ));
}

int ExportVerb::act(const CommandLine&, const Console& console) const {
    const fs::path given = stage;
    check_is_no_run(given);
    if (output.file.empty()) {
        throw UsageError(fmt::format(
            "export: where to? -o FILE names the file, and by its ending the format (--format for others): suffuse "
            "export {} -o grains.csv; there are {}",
            shell_word(stage), fmt::join(io::packing_format_names(), ", ")
        ));
    }
    const io::PackingFormat format = output.chosen_format();
    job::require_outside_runs(output.file);
    if (!contacts.empty()) {
        job::require_outside_runs(contacts);
    }
    const fs::path state = fs::is_directory(given) ? given / "state.h5" : given;
    record::check_file(state);
    dem::World world = io::load_world(state).world;
    dem::sort_by_id(world);
    io::export_packing(output.file, world, format);
    console.result(fmt::format("{}: {} grains", output.file, count_text(std::ssize(world.grains.radius))));
    nlohmann::json document = {{"written", output.file}, {"grains", world.grains.size()}};
    if (!contacts.empty()) {
        io::export_contacts(contacts, world);
        console.result(fmt::format("{}: their contacts", contacts));
        document["contacts"] = contacts;
    }
    console.document(json_text(document));
    return Done;
}

} // namespace

MadeVerb make_export_verb() {
    return std::make_unique<ExportVerb>();
}

} // namespace suffuse::apps
