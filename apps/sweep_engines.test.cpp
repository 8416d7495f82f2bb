#include "apps/sweep_engines.hpp"

#include "suffuse/base/error.hpp"

#include <gtest/gtest.h>

namespace suffuse::apps {
namespace {

TEST(SweepEngines, AKeyIsFilledInAndALineWithoutItsValueIsLeftOut) {
    const std::string text = "cpus=@n@ of @n@\nqueue=@q@\nsignal=USR1@@60\n";
    EXPECT_EQ(fill_template(text, {{"n", "2"}, {"q", "long"}}), "cpus=2 of 2\nqueue=long\nsignal=USR1@60\n");
    EXPECT_EQ(fill_template(text, {{"n", "@q@"}, {"q", ""}}), "cpus=@q@ of @q@\nsignal=USR1@60\n")
        << "a value is no template";
    EXPECT_EQ(fill_template("no end", {}), "no end");
    EXPECT_THROW(fill_template(text, {{"n", "2"}}), Bug);
}

TEST(SweepEngines, EachHasWhatItsKindNeeds) {
    EXPECT_EQ(engine_names(), (std::vector<std::string>{"slurm", "pbs", "sge", "lsf", "snakemake", "parallel"}));
    EXPECT_EQ(find_engine("condor"), nullptr);
    for (const Engine& engine : engines()) {
        EXPECT_EQ(find_engine(engine.name), &engine);
        const bool has_arrays = engine.most_tasks > 0;
        for (const std::string_view part :
             {engine.log, engine.directives, engine.index, engine.go_on, engine.submit, engine.job, engine.joint,
              engine.gather}) {
            EXPECT_EQ(!part.empty(), has_arrays) << engine.name;
        }
        EXPECT_EQ(engine.command.empty(), has_arrays) << engine.name;
    }
}

} // namespace
} // namespace suffuse::apps
