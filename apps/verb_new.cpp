// new: a commented case and its data, from an example or from a grading curve of the user's.

#include "suffuse/base/error.hpp"
#include "suffuse/base/spelling.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/exit_code.hpp"
#include "apps/grading_input.hpp"
#include "apps/json_text.hpp"
#include "apps/new_case.hpp"
#include "apps/templates.hpp"
#include "apps/verb.hpp"
#include "apps/verbs.hpp"
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace suffuse::apps {
namespace {

namespace fs = std::filesystem;

struct NewVerb final : Verb {
    NewVerb()
        : Verb(
              "new", "write a commented case and its data as a starting point",
              "suffuse new my-dyke --psd dyke.csv --flow level -i 12m/30m"
          ) {}

    std::string given;           ///< folder, or a file of a grading curve
    std::string folder_of_curve; ///< behind that file
    std::string from;            ///< template
    SoilRequest own;

    void add_to(Options& options) override {
        options.argument(
            "DIR", given,
            "folder to write it to; the name of the template or of the curve unless given. A file of a grading curve "
            "instead is short for --psd FILE"
        );
        options.argument("FOLDER", folder_of_curve, "behind such a file: the folder to write it to");
        const Option example =
            options.value("--from", from, "an example to start from").type("NAME").suggest(template_names);
        options
            .value(
                "--psd", own.curve_file,
                std::string("of your own soil ") + grading_text +
                    "; read as by assess: --size, --passing, --retained, --share, --mass, --by, --sheet, --rows"
            )
            .type("FILE")
            .excludes(example);
        options.value("--sample", own.sample, "with --psd: only this sample of a table with several").type("NAME");
        own.reading.add_to(options, "");
        const Option part =
            options.value("--sizes", own.sizes, "with --psd: the part of the curve to model, as in 0.1mm,4mm")
                .type("FROM,TO");
        const Option surrogate =
            options
                .flag(
                    "--surrogate", own.surrogate,
                    "with --psd: two fractions stand for a soil too wide to simulate, with its size ratio and fines "
                    "content"
                )
                .excludes(part)
                .excludes(example);
        const Option filter = options
                                  .value(
                                      "--filter", own.filter,
                                      "with --psd: another grading, packed behind the soil: does it hold it? "
                                      "--filter-sample NAME takes it out of a table with several"
                                  )
                                  .type("FILE")
                                  .excludes(part)
                                  .excludes(surrogate)
                                  .excludes(example);
        options.value(filter_sample_flag, own.filter_sample, "only this sample of the filter's table")
            .type("NAME")
            .needs(filter)
            .of_group("");
        options
            .value(
                "--fines", own.fines,
                "with --psd: the size below which grains are fine; found on the curve unless given"
            )
            .type("D")
            .excludes(filter); // a stack is a base and a filter, of as many grains as its layers hold
        options
            .value(
                "--particles", own.particles, "with --psd: grains of the preset quick; by default as few as possible"
            )
            .type("N")
            .whole_number(1, 10'000'000)
            .excludes(filter);
        options.value("--pressure", own.pressure, "with --psd: the effective stress on the soil; 100kPa is assumed")
            .type("P");
        options
            .value(
                "-i,--gradient", own.gradient,
                "with --psd: the hydraulic gradient of the seepage, as in 0.4 or 12m/30m; 0.05 is assumed, and 1 in a "
                "base on its filter"
            )
            .type("I")
            .ratio(0);
        options
            .value(
                "--flow", own.flow,
                "with --psd: up, down, level or a rise as 30deg; the fines then have weight, and the report gives the "
                "gradient that moves them"
            )
            .type("WAY");
    }

    [[nodiscard]] int act(const CommandLine&, const Console& console) const override;
};

int new_from_template(const NewVerb& verb, const Console& console) {
    const std::vector<std::string> names = template_names();
    if (std::find(names.begin(), names.end(), verb.from) == names.end()) {
        throw UsageError(fmt::format(
            "no template {}{}; there are {}", shown(verb.from), near_hint(verb.from, names), fmt::join(names, ", ")
        ));
    }
    const fs::path folder = verb.given.empty() ? verb.from : verb.given;
    std::vector<NewFile> files;
    for (const TemplateFile& file : template_files()) {
        if (file.name == verb.from) {
            files.push_back({folder / file.path, std::string(file.text)});
        }
    }
    const std::vector<std::string> written = write_new(files);
    console.result(fmt::format("{}", fmt::join(written, "\n")));
    console.document(json_text({{"written", written}}));
    print_next_steps(folder, console);
    return Done;
}

/// @throws UsageError for what belongs to a curve where there is none.
void expect_no_curve_options(const NewVerb& verb) {
    for (const auto& [option, is_given] :
         {std::pair{"--sample", !verb.own.sample.empty()},
          {"--size", !verb.own.reading.is_empty()},
          {"--sizes", !verb.own.sizes.empty()},
          {"--fines", !verb.own.fines.empty()},
          {"--surrogate", verb.own.surrogate},
          {"--filter", !verb.own.filter.empty()},
          {"--particles", verb.own.particles.has_value()},
          {"--pressure", !verb.own.pressure.empty()},
          {"--gradient", verb.own.gradient.has_value()},
          {"--flow", !verb.own.flow.empty()}}) {
        if (is_given) {
            throw UsageError(fmt::format("{} needs --psd FILE: it is about the soil of a grading curve", option));
        }
    }
}

int NewVerb::act(const CommandLine&, const Console& console) const {
    std::error_code ignored;
    const bool is_short = from.empty() && own.curve_file.empty() && fs::is_regular_file(given, ignored); // new soil.csv
    if (!is_short && !folder_of_curve.empty()) {
        throw UsageError(
            fmt::format("new: {} is no file of a grading curve; a second folder, {}, needs one", given, folder_of_curve)
        );
    }
    if (is_short || !own.curve_file.empty()) {
        SoilRequest request = own;
        request.curve_file = is_short ? given : own.curve_file;
        request.folder = is_short ? folder_of_curve : given;
        return new_from_soil(request, console);
    }
    expect_no_curve_options(*this);
    if (from.empty()) {
        throw UsageError(fmt::format(
            "new: FILE or --psd FILE for your own soil, from its grading curve; or --from NAME for an example: {}",
            fmt::join(template_names(), ", ")
        ));
    }
    return new_from_template(*this, console);
}

} // namespace

MadeVerb make_new_verb() {
    return std::make_unique<NewVerb>();
}

} // namespace suffuse::apps
