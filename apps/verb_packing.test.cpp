// import, export and bench as a user calls them.

#include "tests/support/program.hpp"

namespace suffuse {
namespace {

using namespace test;

TEST_F(Cli, PackingsTravel) {
    say({"new", "soil", "--from", "replay"});
    const std::string cell = "1.4360856339985508e-3,1.4358137235332051e-3,1.436026846625529e-3";
    const Said looked = say({"import", "soil/packing.csv", "--cell", cell, "--json"});
    EXPECT_EQ(looked.json().at("grains"), 500);
    EXPECT_NEAR(looked.json().at("void_ratio").get<double>(), 0.674, 0.001); // packing500.json: n = 0.4026
    ASSERT_EQ(say({"run", "soil/case.toml", "-o", "here", "--until", "start"}).code, 0);
    for (const std::string file : {"a.csv", "a.txt", "a.xyz"}) {
        EXPECT_EQ(say({"export", "here/studies/replay/start", "-o", file}).code, 0) << file;
    }
    EXPECT_EQ(say({"import", "a.csv", "--json"}).json().at("grains"), 500);
    EXPECT_EQ(say({"export", "here/studies/replay/start", "-o", "a.doc"}).code, 2);
}

TEST_F(Cli, BenchSpeaksTheNamesThatScriptsRelyOn) {
    say({"new", "soil", "--from", "replay"});
    const std::string cell = "1.4360856339985508e-3,1.4358137235332051e-3,1.436026846625529e-3";
    const Said step = say(
        {"bench", "step", "--packing", "soil/packing.csv", "--cell", cell, "--steps", "50", "--threads", "2", "--json"}
    );
    ASSERT_EQ(step.code, 0) << step.error;
    for (const char* name :
         {"contacts_before", "grains", "contacts", "steps_per_second", "particle_steps_per_second",
          "contact_steps_per_second", "ns_per_contact", "rebuilds", "candidates_per_contact", "state_hash"}) {
        EXPECT_TRUE(step.json().contains(name)) << name;
    }
    EXPECT_EQ(step.json().at("mode"), "reference");
    const Said fast = say(
        {"bench", "step", "--packing", "soil/packing.csv", "--cell", cell, "--steps", "50", "--mode", "fast", "--json"}
    );
    ASSERT_EQ(fast.code, 0) << fast.error;
    EXPECT_EQ(fast.json().at("mode"), "fast");
    EXPECT_NE(fast.json().at("state_hash"), step.json().at("state_hash")); // single precision has been at work
    const Said flow = say({"bench", "flow", "--packing", "soil/packing.csv", "--cell", cell, "--json"});
    ASSERT_EQ(flow.code, 0) << flow.error;
    for (const char* name : {"triangulate", "conductance", "solve", "forces"}) {
        EXPECT_TRUE(flow.json().at("seconds").contains(name)) << name;
    }
}

} // namespace
} // namespace suffuse
