// import, export and bench as a user calls them.

#include "tests/support/program.hpp"

namespace suffuse {
namespace {

using namespace test;

TEST_F(Cli, CheckReadsThePackingsOfACase) {
    write_to(folder / "two.csv", "x,y,z,r\n0,0,0,1e-4\n0,0,3e-4,1e-4\n");
    const auto checked = [&](const std::string& cell) {
        write_to(
            folder / "case.toml", "schema = 1\n[study.s]\n[[study.s.stage]]\nname = \"i\"\ndo = \"import\"\npacking = "
                                  "\"two.csv\"\n" +
                                      cell
        );
        return run_suffuse({"check", "case.toml"});
    };
    const ProgramResult good = checked("cell = [\"0.5 mm\", \"0.5 mm\", \"0.5 mm\"]\n");
    EXPECT_EQ(good.code, 0) << good.error;
    EXPECT_EQ(good.error.find("share"), std::string::npos) << good.error;
    EXPECT_EQ(checked("").code, 3);
    EXPECT_EQ(checked("cell = [\"1 mm\", \"1 mm\", \"0.3 mm\"]\n").code, 3); // they overlap through the boundary
    const ProgramResult wide = checked("cell = [\"1 m\", \"1 m\", \"1 m\"]\n");
    EXPECT_EQ(wide.code, 0);
    expect_in("check the cell and the unit of lengths", wide.error);
}

TEST_F(Cli, PackingsTravel) {
    run_suffuse({"new", "soil", "--from", "replay"});
    const std::string cell = "1.4360856339985508e-3,1.4358137235332051e-3,1.436026846625529e-3";
    const ProgramResult looked = run_suffuse({"import", "soil/packing.csv", "--cell", cell, "--json"});
    EXPECT_EQ(looked.json().at("grains"), 500);
    expect_in("4.4 times as wide as the largest grain", looked.json().at("warnings").at(0));
    EXPECT_NEAR(looked.json().at("void_ratio").get<double>(), 0.674, 0.001); // packing500.json: n = 0.4026
    ASSERT_EQ(run_suffuse({"run", "soil/case.toml", "-o", "here", "--until", "start"}).code, 0);
    const auto stage = nlohmann::json::parse(read_all(folder / "here/studies/replay/start/stage.json"));
    expect_in("replay/start: the cell is 4.4 times as wide as the largest grain", stage.at("warnings").dump());
    for (const std::string file : {"a.csv", "a.txt", "a.xyz"}) {
        EXPECT_EQ(run_suffuse({"export", "here/studies/replay/start", "-o", file}).code, 0) << file;
    }
    EXPECT_EQ(run_suffuse({"import", "a.csv", "--json"}).json().at("grains"), 500);
    EXPECT_EQ(run_suffuse({"export", "here/studies/replay/start", "-o", "a.doc"}).code, 2);
    const ProgramResult where = run_suffuse({"export", "here/studies/replay/start"});
    EXPECT_EQ(where.code, 2);
    expect_in("suffuse export here/studies/replay/start -o grains.csv", where.error);
    const ProgramResult which = run_suffuse({"export", "here", "-o", "a.csv"});
    EXPECT_EQ(which.code, 2);
    expect_in("here is a run; give one of its stages: here/studies/replay/start", which.error);
}

TEST_F(Cli, ARunWhosePackingHasChangedIsNotDone) {
    run_suffuse({"new", "soil", "--from", "replay"});
    const std::vector<std::string> run = {"run", "soil/case.toml", "-o", "here", "--until", "start", "--no-cache"};
    ASSERT_EQ(run_suffuse(run).code, 0);
    const std::string packing = read_all(folder / "soil/packing.csv");
    write_to(folder / "soil/packing.csv", packing + "\n");
    for (const auto& again : {run, {"resume", "here", "--until", "start", "--no-cache"}}) {
        const ProgramResult refused = run_suffuse(again);
        EXPECT_EQ(refused.code, 3) << refused.out;
        expect_in("here: holds a run of another case", refused.error);
        expect_in("soil/packing.csv has changed since it was imported", refused.error);
    }
    EXPECT_EQ(run_suffuse({"verify", "here", "--json"}).json().at("damages").size(), 0U) << "the run itself is whole";
    write_to(folder / "soil/packing.csv", packing);
    expect_in("nothing to do", run_suffuse(run).out);
}

TEST_F(Cli, NothingIsWrittenOverTheFilesOfARun) {
    run_suffuse({"new", "soil", "--from", "replay"});
    ASSERT_EQ(run_suffuse({"run", "soil/case.toml", "-o", "here", "--until", "start", "--no-cache"}).code, 0);
    write_to(folder / "sand.csv", "d [mm],passing [%]\n0.1,0\n0.2,40\n0.5,100\n");
    const std::string stage = "here/studies/replay/start";
    const std::vector<std::vector<std::string>> calls = {
        {"export", stage, "-o", stage + "/state.h5", "--format", "csv"},
        {"export", stage, "-o", "here/case.toml", "--format", "csv"},
        {"export", stage, "-o", "grains.csv", "--contacts", "here/contacts.csv"},
        {"import", "soil/packing.csv", "--cell", "2e-3,2e-3,2e-3", "-o", "here/p.csv"},
        {"assess", "sand.csv", "-o", "here"},
        {"assess", "sand.csv", "-o", "here/new"},
        {"assess", "sand.csv", "--page", "-o", "here/page.html"},
        {"figures", "here", "-o", "here/studies"},
        {"figures", "other", "-o", "here/figures"}};
    for (const std::vector<std::string>& call : calls) {
        const ProgramResult refused = run_suffuse(call);
        EXPECT_EQ(refused.code, 2) << call.back() << refused.out;
        expect_in("would be written into the run folder", refused.error);
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "grains.csv"));
    const ProgramResult verified = run_suffuse({"verify", "here", "--json"});
    EXPECT_EQ(verified.json().at("damages").size(), 0U) << verified.out;
    EXPECT_EQ(verified.json().at("came_later").size(), 0U) << verified.out;
}

TEST_F(Cli, ContactsTravelNextToAPacking) {
    run_suffuse({"new", "soil", "--from", "replay"});
    ASSERT_EQ(run_suffuse({"run", "soil/case.toml", "-o", "here", "--until", "settled"}).code, 0);
    const ProgramResult out =
        run_suffuse({"export", "here/studies/replay/settled", "-o", "p.xyz", "--contacts", "c.csv", "--json"});
    ASSERT_EQ(out.code, 0) << out.error;
    EXPECT_EQ(out.json().at("contacts"), "c.csv");
    const auto import_with = [&](const std::string& more) {
        write_to(
            folder / "case.toml", "schema = 1\n[study.s]\n[[study.s.stage]]\nname = \"i\"\ndo = \"import\"\npacking = "
                                  "\"p.xyz\"\n" +
                                      more
        );
        std::filesystem::remove_all(folder / "there");
        const ProgramResult run = run_suffuse({"run", "case.toml", "-o", "there", "--no-cache"});
        EXPECT_EQ(run.code, 0) << run.error;
        return nlohmann::json::parse(read_all(folder / "there/studies/s/i/stage.json"));
    };
    const auto settled = nlohmann::json::parse(read_all(folder / "here/studies/replay/settled/stage.json"));
    const auto plain = import_with(""), handed = import_with("contacts = \"c.csv\"\n");
    expect_in("carries no contact memory", plain.at("warnings").dump());
    EXPECT_EQ(handed.at("warnings").dump().find("contact memory"), std::string::npos);
    EXPECT_GT(handed.at("imported_contacts"), 500);
    const double unbalanced = settled.at("unbalanced_force");
    EXPECT_LT(handed.at("unbalanced_force"), 10 * unbalanced); // the last step moved the grains after its forces
    EXPECT_GT(plain.at("unbalanced_force"), 1000 * unbalanced);
    write_to(folder / "c.csv", "first,second\n");
    const ProgramResult refused = run_suffuse({"check", "case.toml"});
    EXPECT_EQ(refused.code, 3);
    expect_in("c.csv:1: found \"first,second\", expected the header", refused.error);
}

TEST_F(Cli, APackingInMillimetersIsWarnedOfAndReadWithItsUnit) {
    write_to(folder / "mm.csv", "x,y,z,r\n1,1,1,0.4\n3,1,1,0.6\n1,3,1,0.6\n");
    const ProgramResult passed = run_suffuse({"import", "mm.csv", "--cell", "4,4,4", "--json"});
    expect_in("median diameter is 1.2 m, coarser than gravel", passed.json().at("warnings").dump());
    expect_in("--unit mm", passed.json().at("warnings").dump());
    const ProgramResult read = run_suffuse({"import", "mm.csv", "--unit", "mm", "--cell", "4mm,4mm,4mm", "--json"});
    ASSERT_EQ(read.code, 0) << read.error;
    EXPECT_EQ(read.json().at("warnings").dump().find("median"), std::string::npos);
    EXPECT_DOUBLE_EQ(read.json().at("radius").at(1).get<double>(), 0.6e-3);
    EXPECT_EQ(read.json().at("void_ratio"), passed.json().at("void_ratio"));
    const ProgramResult other = run_suffuse({"import", "mm.csv", "--unit", "kPa"});
    EXPECT_EQ(other.code, 2);
    expect_in("--unit kPa: ", other.error);
}

TEST_F(Cli, ImportCutsABoxOutOfABedBetweenWalls) {
    write_to(folder / "bed.csv", "x,y,z,r\n0,0,0,1e-4\n1e-3,1e-3,1e-3,1e-4\n2e-3,1e-3,1e-3,1e-4\n");
    const ProgramResult cut =
        run_suffuse({"import", "bed.csv", "--box", "0.5mm,0.5mm,0.5mm,2.5mm,2.5mm,2.5mm", "-o", "cell.xyz", "--json"});
    ASSERT_EQ(cut.code, 0) << cut.error;
    EXPECT_EQ(cut.json().at("grains"), 2);
    EXPECT_EQ(cut.json().at("outside_box"), 1);
    EXPECT_EQ(cut.json().at("across_faces"), 0);
    const ProgramResult cell = run_suffuse({"import", "cell.xyz", "--json"});
    EXPECT_NEAR(cell.json().at("cell").at(0).at(0).get<double>(), 2e-3, 1e-15); // rounding
    expect_in(
        "left out: 1 outside of the box, 0 that overlap",
        run_suffuse({"import", "bed.csv", "--box", "0.1mm,0,0,1,1,1"}).out
    );
    EXPECT_EQ(run_suffuse({"import", "bed.csv", "--box", "0,0,0,1,1"}).code, 2);
    EXPECT_EQ(run_suffuse({"import", "bed.csv", "--box", "0,0,0,1,1,1", "--cell", "1,1,1"}).code, 2);
    EXPECT_EQ(run_suffuse({"import", "bed.csv", "--box", "1,1,1,0,0,0"}).code, 3);
}

TEST_F(Cli, ImportPrintsWhatItUnderstandsOfALaboratoryTest) {
    const std::string head = "eps1 [%],epsv [%],q [kPa]\n";
    write_to(folder / "t.csv", head + "0,0,0\n1,0.1,50\n2,-0.1,80\n");
    EXPECT_EQ(run_suffuse({"import", "t.csv", "--kind", "triaxial"}).code, 3); // which sign?
    const ProgramResult read = run_suffuse({"import", "t.csv", "--kind", "triaxial", "--contraction", "positive"});
    ASSERT_EQ(read.code, 0) << read.error;
    expect_in("t.csv: triaxial, 1 test, t, 3 rows", read.out);
    expect_in("  q [kPa]   deviator stress    0 to 80 kPa", read.out);
    const auto json =
        run_suffuse({"import", "t.csv", "--kind", "triaxial", "--contraction", "negative", "--json"}).json();
    EXPECT_EQ(json.at("columns").at(1).at("role"), "volumetric_strain");
    EXPECT_DOUBLE_EQ(json.at("columns").at(1).at("range").at(0).get<double>(), -0.001);
    EXPECT_EQ(run_suffuse({"import", "t.csv", "--kind", "triaxal"}).code, 2);
    EXPECT_EQ(run_suffuse({"import", "t.csv", "--kind", "triaxial", "--unit", "mm"}).code, 2);
    EXPECT_EQ(run_suffuse({"import", "t.csv", "--contraction", "positive"}).code, 2);
}

TEST_F(Cli, ImportReportsARadiusThatIsTooSmallForANormalNumber) {
    write_to(folder / "tiny.csv", "x,y,z,r\n0,0,0,1e-310\n0,0,3e-4,1e-4\n");
    const ProgramResult looked = run_suffuse({"import", "tiny.csv"});
    EXPECT_EQ(looked.code, 0) << looked.error;
    expect_in("tiny.csv: 2 grains, d 2e-3", looked.out);
}

TEST_F(Cli, ImportSaysWhatACaseWouldRefuse) {
    const std::string rows = "0 0 0 1e-4\n0 0 1.5e-4 1e-4\n";
    write_to(folder / "two.txt", "##PERIODIC:: 3e-3 3e-3 3e-3\n" + rows);
    const ProgramResult looked = run_suffuse({"import", "two.txt", "--cell", "4e-3,4e-3,4e-3"});
    EXPECT_EQ(looked.code, 0) << looked.error;
    expect_in("warning: two.txt: the cell given, 0.004 x 0.004 x 0.004 m, is taken, not the file's own", looked.error);
    expect_in("warning: two.txt: grains 0 and 1 overlap by 0.5 of the smaller radius", looked.error);
    expect_in("largest overlap 50 % of the smaller radius", looked.out);
    const std::string stage =
        "schema = 1\n[study.s]\n[[study.s.stage]]\nname = \"i\"\ndo = \"import\"\npacking = \"two.txt\"\n";
    write_to(folder / "case.toml", stage);
    for (const std::string verb : {"check", "plan", "run"}) {
        const ProgramResult refused = run_suffuse({verb, "case.toml"});
        EXPECT_EQ(refused.code, 3) << verb;
        expect_in("grains 0 and 1 overlap by 0.5 of the smaller radius", refused.error);
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "runs")); // before anything runs
    write_to(folder / "case.toml", stage + "max_overlap = 0.6\ncell = [\"4 mm\", \"4 mm\", \"4 mm\"]\n");
    const ProgramResult allowed = run_suffuse({"check", "case.toml"});
    EXPECT_EQ(allowed.code, 0) << allowed.error;
    expect_in("warning: s/i: the cell given, 0.004 x", allowed.error);
}

TEST_F(Cli, BenchPrintsTheNamesThatScriptsRelyOn) {
    run_suffuse({"new", "soil", "--from", "replay"});
    const std::string cell = "1.4360856339985508e-3,1.4358137235332051e-3,1.436026846625529e-3";
    const ProgramResult step = run_suffuse(
        {"bench", "step", "--packing", "soil/packing.csv", "--cell", cell, "--steps", "50", "--threads", "2", "--json"}
    );
    ASSERT_EQ(step.code, 0) << step.error;
    for (const char* name :
         {"contacts_before", "grains", "contacts", "steps_per_second", "particle_steps_per_second",
          "contact_steps_per_second", "ns_per_contact", "rebuilds", "candidates_per_contact", "state_hash"}) {
        EXPECT_TRUE(step.json().contains(name)) << name;
    }
    EXPECT_EQ(step.json().at("mode"), "reference");
    const ProgramResult fast = run_suffuse(
        {"bench", "step", "--packing", "soil/packing.csv", "--cell", cell, "--steps", "50", "--mode", "fast", "--json"}
    );
    ASSERT_EQ(fast.code, 0) << fast.error;
    EXPECT_EQ(fast.json().at("mode"), "fast");
    EXPECT_NE(fast.json().at("state_hash"), step.json().at("state_hash")); // single precision has been at work
    const ProgramResult flow =
        run_suffuse({"bench", "flow", "--packing", "soil/packing.csv", "--cell", cell, "--json"});
    ASSERT_EQ(flow.code, 0) << flow.error;
    for (const char* name : {"triangulate", "conductance", "solve", "forces"}) {
        EXPECT_TRUE(flow.json().at("seconds").contains(name)) << name;
    }
    const ProgramResult imported = run_suffuse(
        {"bench", "step", "--packing", "soil/packing.csv", "--cell", cell, "--steps", "50", "--threads", "1"}
    );
    expect_in("500 grains on 1 thread: ", imported.out);
    expect_in(
        "500 grains on 1 thread: a flow in ",
        run_suffuse({"bench", "flow", "--packing", "soil/packing.csv", "--cell", cell, "--threads", "1"}).out
    );
}

TEST_F(Cli, AnImportedPackingWithoutTheSoilsFinesIsRefusedBeforeAnythingRuns) {
    std::string text =
        replaced(read_all(examples + "replay/case.toml"), "do        = \"flow\"", "do        = \"erode\"");
    text = replaced(replaced(text, "tensor    = true", ""), "gradient  = 0.05", "passes = 1\ngradient  = 0.05");
    text = replaced(
        text, "[study.replay]\n",
        "[soil.mix]\n"
        "coarse = { psd = { d = [\"1.2 mm\", \"1.5 mm\"], passing = [\"0 %\", \"100 %\"] } }\n"
        "fines = { psd = { d = [\"1.0 mm\", \"1.2 mm\"], passing = [\"0 %\", \"100 %\"] } }\n"
        "fines_content = \"30 %\"\n[study.replay]\nsoil = \"mix\"\n"
    );
    write_to(folder / "case.toml", text);
    write_to(folder / "packing.csv", read_all(examples + "replay/packing.csv"));
    const ProgramResult refused =
        run_suffuse({"run", "case.toml", "-o", "here"}); // all grains are finer than its fines
    EXPECT_EQ(refused.code, 3) << refused.error;
    expect_in("leaves no skeleton", refused.error);
    EXPECT_FALSE(std::filesystem::exists(folder / "here/studies"));
}

} // namespace
} // namespace suffuse
