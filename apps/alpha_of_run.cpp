#include "apps/alpha_of_run.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/spelling.hpp"
#include "suffuse/job/sample_stress.hpp"
#include "suffuse/record/folder.hpp"

#include <filesystem>

namespace suffuse::apps {

stability::AssessSpec with_alpha_of_run(
    const AlphaSource& source, stability::AssessSpec spec, const std::string& soil, const Console& console
) {
    if (source.run.empty()) {
        return spec;
    }
    if (source.alpha) {
        throw UsageError("--alpha and the alpha of a run: give one of them");
    }
    const job::SampleStress stress = job::read_sample_stress(source.run, soil);
    spec.seepage = job::seepage_of(stress, source.gradient, source.porosity, source.density);
    console.talk(job::words_of(stress, shown(source.run)));
    return spec;
}

std::string case_of_run(const std::string& file) {
    if (!std::filesystem::is_directory(file)) {
        return file;
    }
    record::check_is_run(file);
    return (std::filesystem::path(file) / record::resolved_case_file).string();
}

} // namespace suffuse::apps
