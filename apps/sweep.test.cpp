// Sweeps and the cache as a user calls them: tasks for other machines, run by a shell, and what is gathered from them.

#include "suffuse/record/stage_sums.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/temp_folder.hpp"
#include <cstdlib>
#include <map>
#include <sys/wait.h>

namespace suffuse {
namespace {

using test::read_all;
using test::TempFolder;

const std::string text = R"(schema = 1
[soil.sand]
psd = { d = ["0.2 mm", "0.3 mm", "0.4 mm"], passing = ["0 %", "50 %", "100 %"] }
[study.s]
soil       = "sand"
particles  = 200
sweep      = { "stage.cloud.porosity" = [0.6, 0.65, 0.7] }
refine     = { key = "stage.cloud.porosity", around = "minimum", of = "void_ratio", at = ["moved"], add = 1 }
replicates = 1
[[study.s.stage]]
name     = "cloud"
do       = "pack"
porosity = 0.6
[[study.s.stage]]
name        = "moved"
do          = "advance"
steps       = 20
time_step   = "1e-9 s"
strain_rate = ["1 1/s", "0 1/s", "0 1/s"]
)";

class SweepVerb : public testing::Test {
protected:
    SweepVerb() {
        std::ofstream(folder / "case.toml") << text;
        install("scontrol", "exit 1"); // whatever Slurm this machine has is none of the tests'
    }

    /// Exit code of a command in the folder; what it says is in `out` and `error`.
    int sh(const std::string& command) {
        const std::string line = "cd '" + folder.path().string() + "' && PATH=\"$PWD/bin:$PATH\" && ( " + command +
                                 " ) >out 2>error </dev/null";
        const int status = std::system(line.c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

    int suffuse(const std::string& words) { return sh(SUFFUSE_PROGRAM " " + words); }

    /// A program of a cluster, as the commands of this test find it.
    void install(const std::string& name, const std::string& script) {
        std::filesystem::create_directories(folder / "bin");
        const std::filesystem::path file = folder / "bin" / name;
        std::ofstream(file) << "#!/bin/sh\n" << script << "\n";
        std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    }

    [[nodiscard]] std::string output() const { return read_all(folder / "out") + read_all(folder / "error"); }

    [[nodiscard]] std::map<std::string, std::string> hashes(const std::string& run) const {
        std::map<std::string, std::string> found;
        const std::filesystem::path studies = folder / (run + "/studies");
        for (const auto& entry : std::filesystem::recursive_directory_iterator(studies)) {
            if (entry.path().filename() == "stage.json") {
                found[std::filesystem::relative(entry.path(), studies)] =
                    nlohmann::json::parse(read_all(entry.path())).at("state_hash");
            }
        }
        return found;
    }

    TempFolder folder;
};

TEST_F(SweepVerb, TasksRunByAShellEndWithTheBitsOfAPlainRun) {
    ASSERT_EQ(suffuse("run case.toml -o whole --no-cache"), 0) << output();
    const auto whole = hashes("whole");
    ASSERT_EQ(whole.size(), 2U * 4) << "three values, and one between the lowest and its neighbor";

    ASSERT_EQ(suffuse("sweep case.toml --emit parallel -o parts --no-cache"), 0) << output();
    EXPECT_NE(output().find("3 tasks in parts"), std::string::npos) << output();
    EXPECT_EQ(suffuse("runs ."), 0);
    EXPECT_NE(output().find("parts  tasks emitted  0/3"), std::string::npos) << output();
    ASSERT_EQ(sh("head -n 1 parts/tasks.txt | sh"), 0) << output();
    EXPECT_EQ(suffuse("runs ."), 0);
    EXPECT_NE(output().find("parts  tasks emitted  1/3"), std::string::npos) << output();
    EXPECT_EQ(suffuse("watch parts/studies/s/*"), 0) << output();
    EXPECT_NE(output().find("sample ends       done"), std::string::npos) << output();
    EXPECT_EQ(suffuse("watch parts"), 2);
    EXPECT_NE(output().find("suffuse sweep --collect parts"), std::string::npos) << output();
    EXPECT_EQ(suffuse("sweep --collect parts"), 75) << output();
    EXPECT_NE(output().find("1 of 3 samples done"), std::string::npos) << output();
    EXPECT_NE(output().find("suffuse sweep parts --emit parallel writes tasks"), std::string::npos) << output();
    const std::filesystem::path provenance = folder / "parts/provenance.json";
    const std::string old = "2000-01-01T00:00:00Z"; // seconds may be too few to distinguish one gathering from the next
    auto first = nlohmann::json::parse(read_all(provenance));
    first.at("finished") = old;
    std::ofstream(provenance) << first;
    std::filesystem::remove(folder / "parts/SHA256SUMS"); // of the provenance that was
    ASSERT_EQ(sh("sh parts/tasks.txt"), 0) << output();
    // With the last value the refinement is known, and there is one sample more.
    EXPECT_EQ(suffuse("sweep --collect parts"), 75) << output();
    EXPECT_NE(output().find("3 of 4 samples done"), std::string::npos) << output();
    ASSERT_EQ(suffuse("sweep parts --emit parallel"), 0) << output();
    ASSERT_EQ(sh("sh parts/tasks.txt"), 0) << output();
    EXPECT_EQ(suffuse("sweep --collect parts"), 0) << output();
    EXPECT_EQ(hashes("parts"), whole);
    EXPECT_LT(old, nlohmann::json::parse(read_all(provenance)).at("finished").get<std::string>())
        << "each gathering has its own";
    EXPECT_TRUE(std::filesystem::exists(folder / "parts/report.html"));
    const auto summary = nlohmann::json::parse(read_all(folder / "parts/summary.json"));
    EXPECT_EQ(summary.at("samples").at("done"), 4);
    EXPECT_EQ(summary.at("studies").at("s").at("stages").at("moved").size(), 4U);
}

TEST_F(SweepVerb, ARunThatEndsWithAStageIsRefinedByTheCurvesItHasAndAsFar) {
    ASSERT_EQ(suffuse("run case.toml -o run --until cloud --no-cache"), 0) << output();
    EXPECT_EQ(hashes("run").size(), 3U) << "the curve that requires more is of the next stage";
    ASSERT_EQ(suffuse("resume run --until moved"), 0) << output();
    EXPECT_EQ(hashes("run").size(), 2U * 4);
    EXPECT_TRUE(std::filesystem::exists(folder / "run/refinement.json"));

    ASSERT_EQ(sh("sed 's/at = ..moved../at = [\"cloud\"]/' case.toml > other.toml"), 0);
    ASSERT_EQ(suffuse("run other.toml -o other --until cloud --no-cache"), 0) << output();
    EXPECT_EQ(hashes("other").size(), 4U) << "the new sample goes no further than the others";
}

TEST_F(SweepVerb, GatheringNamesTheFlaws) {
    ASSERT_EQ(suffuse("run case.toml -o whole --no-cache"), 0) << output();
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / "whole/studies")) {
        if (entry.path().filename() == "stage.json") {
            nlohmann::json numbers = nlohmann::json::parse(read_all(entry.path()));
            numbers["flaws"] = {"s/moved: bent"};
            record::seal_stage(entry.path().parent_path(), numbers); // as a stage that ended so
            break;
        }
    }
    EXPECT_EQ(suffuse("sweep --collect whole"), 4) << output();
    EXPECT_NE(output().find("flaw: s/moved: bent"), std::string::npos) << output();
    EXPECT_NE(output().find("4 of 4 samples done with flaws"), std::string::npos) << output();
}

TEST_F(SweepVerb, SlurmGetsAJobArrayWithATaskForEachSample) {
    ASSERT_EQ(suffuse("sweep case.toml --emit slurm -o array --time-limit 2h -j 2 --partition long --account dams"), 0)
        << output();
    const std::string script = read_all(folder / "array/sweep.sbatch");
    for (const std::string part :
         {"#!/bin/sh\n", "#SBATCH --array=1-3\n", "#SBATCH --cpus-per-task=2\n", "#SBATCH --time=122\n",
          "#SBATCH --signal=B:USR1@60\n", "#SBATCH --open-mode=append\n", "#SBATCH --requeue\n",
          "#SBATCH --partition=long\n", "#SBATCH --account=dams\n"}) {
        EXPECT_NE(script.find(part), std::string::npos) << part << " in\n" << script;
    }
    EXPECT_NE(read_all(folder / "array/gather.sbatch").find("#SBATCH --account=dams\n"), std::string::npos);
    EXPECT_EQ(sh("sh -n array/sweep.sbatch && sh -n array/gather.sbatch && sh -n array/submit.sh"), 0) << output();
    // What Slurm does with it: one task.
    EXPECT_EQ(sh("SLURM_ARRAY_TASK_ID=2 sh array/sweep.sbatch"), 0) << output();
    EXPECT_EQ(hashes("array").size(), 2U);
    // An array that was submitted before tasks.txt was written anew, with fewer tasks.
    for (const char* index : {"4", "0", ""}) {
        EXPECT_EQ(sh(fmt::format("SLURM_ARRAY_TASK_ID={} sh array/sweep.sbatch", index)), 2) << output();
        EXPECT_NE(output().find("array/tasks.txt has no task"), std::string::npos) << output();
    }
    EXPECT_EQ(suffuse("resume array --sample s/porosity=0.66"), 2);
    EXPECT_NE(output().find("s/porosity=0.6"), std::string::npos) << output();
    EXPECT_EQ(suffuse("sweep case.toml"), 2);
    EXPECT_EQ(suffuse("sweep case.toml --emit parallel --account dams -o other"), 2);
    EXPECT_NE(output().find("--account is for --emit of a cluster"), std::string::npos) << output();
    EXPECT_EQ(suffuse("sweep case.toml --emit slurm --task-time 0s -o other"), 2);
    EXPECT_EQ(suffuse("sweep case.toml --emit slurm --partition 'a b' -o other"), 2);
    EXPECT_FALSE(std::filesystem::exists(folder / "other"));
}

TEST_F(SweepVerb, MoreSamplesThanAnArrayMayHaveArePackedOrGoIntoSeveral) {
    install("scontrol", "echo 'MaxArraySize            = 3'"); // indices end before it
    ASSERT_EQ(suffuse("sweep case.toml --emit slurm -o array"), 0) << output();
    EXPECT_NE(output().find("3 samples as 1 task in array"), std::string::npos) << output();
    EXPECT_NE(read_all(folder / "array/sweep.sbatch").find("--array=1-1\n"), std::string::npos);

    ASSERT_EQ(suffuse("sweep array --emit slurm --task-time 1ms"), 0) << output();
    EXPECT_NE(output().find("3 tasks in array"), std::string::npos) << output();
    EXPECT_NE(read_all(folder / "array/sweep.sbatch").find("--array=1-2\n"), std::string::npos);
    const std::string second = read_all(folder / "array/sweep-2.sbatch");
    EXPECT_NE(second.find("--array=1-1\n"), std::string::npos) << second;
    EXPECT_NE(second.find("/array/tasks/2-%a.txt"), std::string::npos) << second;
    ASSERT_EQ(sh("SLURM_ARRAY_TASK_ID=1 sh array/sweep-2.sbatch"), 0) << output();
    EXPECT_EQ(hashes("array").count("s/porosity=0.7/moved/stage.json"), 1U) << "the third sample";

    install("sbatch", "echo \"$@\" >>said; echo \"$(wc -l <said);west\"");
    ASSERT_EQ(sh("sh array/submit.sh"), 0) << output();
    const std::string run = (folder / "array").string();
    EXPECT_EQ(
        read_all(folder / "said"), fmt::format(
                                       "--parsable {0}/sweep.sbatch\n--parsable {0}/sweep-2.sbatch\n"
                                       "--dependency=afterany:1:2 {0}/gather.sbatch\n",
                                       run
                                   )
    );
    ASSERT_EQ(suffuse("sweep array --emit slurm"), 0) << output();
    EXPECT_FALSE(std::filesystem::exists(folder / "array/sweep-2.sbatch")) << "it would run what others run now";
    install("sbatch", "exit 1");
    EXPECT_EQ(sh("sh array/submit.sh"), 1);

    install("scontrol", "echo 'MaxArraySize = 0'");
    EXPECT_EQ(suffuse("sweep array --emit slurm"), 2);
    EXPECT_NE(output().find("takes no arrays"), std::string::npos) << output();
}

TEST_F(SweepVerb, ATaskWhoseTimeIsOverGoesBackIntoTheQueueOfSlurm) {
    install("scontrol", "echo \"$@\" >>said; [ \"$1\" = requeue ]");
    ASSERT_EQ(suffuse("sweep case.toml --emit slurm -o array --time-limit 1ns"), 0) << output();
    const std::string task = "SLURM_JOB_ID=9 SLURM_ARRAY_TASK_ID=1 sh array/sweep.sbatch";
    EXPECT_EQ(sh("rm -f said; " + task), 0) << output();
    EXPECT_EQ(read_all(folder / "said"), "requeue 9\n");
    EXPECT_NE(output().find("to be continued"), std::string::npos) << output();
    EXPECT_EQ(sh("SLURM_RESTART_COUNT=1000 " + task), 75) << "not for ever";
    install("scontrol", "exit 1");
    EXPECT_EQ(sh(task), 75);
    EXPECT_NE(output().find("suffuse sweep " + (folder / "array").string() + " --emit slurm"), std::string::npos)
        << output();
}

TEST_F(SweepVerb, ScriptsOfOtherClustersAreShellScriptsThatRunTheirTasks) {
    const std::vector<std::vector<std::string>> clusters = {
        {"pbs", "PBS_ARRAY_INDEX", "#PBS -J 1-3\n", "#PBS -q long\n"},
        {"sge", "SGE_TASK_ID", "#$ -t 1-3\n", "#$ -q long\n"},
        {"lsf", "LSB_JOBINDEX", "#BSUB -J \"suffuse-run[1-3]\"\n", "#BSUB -q long\n"}};
    for (const std::vector<std::string>& cluster : clusters) {
        const std::string &name = cluster[0], script = "run/sweep." + name;
        ASSERT_EQ(suffuse("sweep case.toml -o run --partition long --time-limit 2h --emit " + name), 0) << output();
        EXPECT_NE(output().find("has never run such a script"), std::string::npos) << output();
        EXPECT_EQ(sh("for file in run/sweep* run/gather* run/submit.sh; do sh -n $file || exit 1; done"), 0)
            << output();
        const std::string script_text = read_all(folder / script);
        for (const std::string& part : {std::string("Never run by"), cluster[2], cluster[3]}) {
            EXPECT_NE(script_text.find(part), std::string::npos) << part << " in\n" << script_text;
        }
        EXPECT_EQ(sh(fmt::format("{}=2 sh {}", cluster[1], script)), 0) << output();
        EXPECT_EQ(hashes("run").size(), 2U) << "of the second sample";
        ASSERT_EQ(suffuse("sweep run --emit parallel"), 0) << output();
        EXPECT_FALSE(std::filesystem::exists(folder / script)) << "it would run what others run now";
        std::filesystem::remove_all(folder / "run");
    }
}

TEST_F(SweepVerb, OneCallRunsSeveralSamplesAndOneThatFailsKeepsNoneWaiting) {
    ASSERT_EQ(suffuse("run case.toml -o whole --no-cache"), 0) << output();
    ASSERT_EQ(suffuse("sweep case.toml --emit parallel -o parts --no-cache --task-time 1h"), 0) << output();
    EXPECT_NE(output().find("3 samples as 1 task in parts"), std::string::npos) << output();
    std::filesystem::create_directories(folder / "parts/studies/s/porosity=0.6");
    ASSERT_EQ(sh("flock parts/studies/s/porosity=0.6 true; mkdir parts/studies/s/porosity=0.6/.lock"), 0);
    EXPECT_NE(sh("sh parts/tasks.txt"), 0);
    EXPECT_EQ(hashes("parts").size(), 2U * 2) << output();
    ASSERT_EQ(sh("rmdir parts/studies/s/porosity=0.6/.lock && sh parts/tasks.txt"), 0) << output();
    EXPECT_EQ(suffuse("sweep --collect parts"), 75) << "the refinement, which is known now";
    ASSERT_EQ(suffuse("sweep parts --emit parallel --no-cache && sh parts/tasks.txt"), 0) << output();
    EXPECT_EQ(suffuse("sweep --collect parts"), 0) << output();
    EXPECT_EQ(hashes("parts"), hashes("whole"));

    EXPECT_EQ(suffuse("resume parts --sample s/porosity=0.6 --sample s/porosity=0.65 --time-limit 1ns --no-cache"), 75);
    EXPECT_NE(output().find("time limit reached before s/porosity=0.6"), std::string::npos) << output();
    EXPECT_EQ(suffuse("resume parts --sample s/porosity=0.6 --sample s/porosity=0.65 --json"), 2);
}

TEST_F(SweepVerb, SlurmGetsNamesOfFoldersWithBlanksAndPatternsAsTheyAre) {
    ASSERT_EQ(suffuse("sweep case.toml --emit slurm -o 'my \"%j\" array'"), 0) << output();
    EXPECT_NE(output().find("sh 'my \"%j\" array/submit.sh'"), std::string::npos) << output();
    const std::string script = read_all(folder / "my \"%j\" array/sweep.sbatch");
    EXPECT_NE(script.find("/my \\\"%%j\\\" array/tasks/%a.txt\"\n"), std::string::npos) << script;
    EXPECT_NE(script.find("#SBATCH --job-name=\"suffuse-my \\\"%j\\\" array\"\n"), std::string::npos) << script;
    EXPECT_EQ(sh("SLURM_ARRAY_TASK_ID=1 sh 'my \"%j\" array/sweep.sbatch'"), 0) << output();
    EXPECT_EQ(suffuse("sweep case.toml --emit parallel -o 'two\nlines'"), 2) << output();
}

TEST_F(SweepVerb, ASecondRunTakesItsStagesFromTheCacheNextToIt) {
    ASSERT_EQ(suffuse("run case.toml"), 0) << output();
    ASSERT_TRUE(std::filesystem::exists(folder / "runs/suffuse-cache/cache.json"));
    ASSERT_EQ(suffuse("plan case.toml --json"), 0) << output();
    const auto plan = nlohmann::json::parse(read_all(folder / "out"));
    ASSERT_EQ(plan.at("samples").size(), 3U);
    EXPECT_EQ(plan.at("samples").at(0).at("cached"), 2);
    EXPECT_EQ(plan.at("steps").at(1), 0);
    ASSERT_EQ(suffuse("run case.toml"), 0) << output();
    EXPECT_NE(output().find("holds 6 of the 6 stages"), std::string::npos) << output();
    EXPECT_NE(output().find("from the cache"), std::string::npos) << output();
    EXPECT_EQ(
        hashes("runs/" + std::filesystem::relative(folder.path()).filename().string() + "-0002"),
        hashes("runs/" + std::filesystem::relative(folder.path()).filename().string() + "-0001")
    );
    ASSERT_EQ(suffuse("run case.toml --no-cache -o fresh"), 0) << output();
    EXPECT_EQ(output().find("from the cache"), std::string::npos) << output();
    ASSERT_EQ(suffuse("cache"), 0) << output();
    EXPECT_NE(output().find("8 stages"), std::string::npos) << output();
    ASSERT_EQ(suffuse("cache --clear --json"), 0) << output();
    EXPECT_EQ(nlohmann::json::parse(read_all(folder / "out")).at("dropped"), 8);
    EXPECT_EQ(suffuse("cache nowhere"), 2);
}

} // namespace
} // namespace suffuse
