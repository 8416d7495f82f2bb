#include "suffuse/record/stored.hpp"

#include "suffuse/casefile/load_case.hpp"
#include "suffuse/io/atomic_file.hpp"
#include "suffuse/plan/plan_record.hpp"
#include "suffuse/record/folder.hpp"

#include <gtest/gtest.h>

#include "tests/support/reference.hpp"
#include "tests/support/temp_folder.hpp"
#include <functional>

namespace suffuse::plan {
namespace {

using test::TempFolder;

std::string complaint_of(const std::function<void()>& use) {
    try {
        use();
        return "";
    } catch (const IoError& error) {
        return error.what();
    }
}

TEST(Stored, WhatIsTakenComesThrough) {
    const nlohmann::json numbers = {{"steps", 7}};
    EXPECT_EQ(record::take_from("stage.json", [&] { return numbers.at("steps").get<int>(); }), 7);
    EXPECT_THROW(record::take_from("stage.json", [] { throw CaseError("another kind"); }), CaseError);
}

TEST(Stored, WhatHelpsDependsOnTheFile) {
    const auto message_for = [](const char* file) { return std::string(record::not_as_stored(file, "broken").what()); };
    EXPECT_NE(message_for("r/studies/s/a/stage.json").find("; remove r/studies/s/a and resume"), std::string::npos);
    EXPECT_NE(message_for("r/plan.json").find("; remove it and resume"), std::string::npos);
    EXPECT_NE(message_for("r/run_options.json").find("; restore its contents"), std::string::npos);
    const TempFolder folder;
    EXPECT_NE(
        std::string(record::not_as_stored(folder.path(), "broken").what())
            .find("suffuse verify " + folder.path().string()),
        std::string::npos
    );
}

TEST(Stored, FilesOfARunThatLackAKeyAreNamed) {
    const TempFolder folder;
    const casefile::Case what = casefile::load_case(test::in_checkout("examples/replay/case.toml")).value;
    const std::filesystem::path stage =
        record::stage_folder(folder.path(), what.studies[0].variants[0], what.studies[0].variants[0].stages[0]);
    std::filesystem::create_directories(stage);
    record::write_json(stage / record::failure_file, {{"sample", "replay"}});
    EXPECT_NE(
        complaint_of([&] { record::read_failures(folder.path(), what); }
        ).find("failed.json: has changed since it was written (key 'stage'"),
        std::string::npos
    );
    record::write_json(folder / "plan.json", {{"stages", 3}});
    EXPECT_NE(
        complaint_of([&] { record_outcome(folder.path()); }).find("plan.json: has changed since"), std::string::npos
    );
    io::write_file(folder / "plan.json", "{");
    EXPECT_NE(
        complaint_of([&] { record_outcome(folder.path()); }
        ).find("plan.json: has changed since it was written (no valid JSON)"),
        std::string::npos
    );
}

} // namespace
} // namespace suffuse::plan
