// figures as a user calls it.

#include "tests/support/program.hpp"

namespace suffuse {
namespace {

using namespace test;

/// A run's figures as `report` leaves them: one chart, one drawing.
void write_figures(const std::filesystem::path& run) {
    write_to(run / "figures/fig07.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"9\" height=\"9\"/>");
    write_to(run / "figures/fig11.vl.json", R"({"data": {"values": [{"a": 1, "b": 2}, {"a": 2, "b": 3}]},
        "mark": "bar", "encoding": {"x": {"field": "a"}, "y": {"field": "b", "type": "quantitative"}},
        "description": "two < three", "$schema": "https://vega.github.io/schema/vega-lite/v6.json"})");
}

/// A stand-in for a program of the system, which notes the words that it is called with.
void write_stand_in(const std::filesystem::path& bin, const std::string& name) {
    write_to(bin / name, "#!/bin/sh\necho \"$@\" >>\"$0.called\"\necho drawn >\"$4\"\n"); // behind --output
    std::filesystem::permissions(bin / name, std::filesystem::perms::owner_all);
}

TEST_F(Cli, FiguresAreRequestedByNumberOrNameAndAnUnknownOneIsCodeTwo) {
    write_figures(folder / "run");
    const ProgramResult drawn = run_suffuse({"figures", "run", "--figure", "7", "-o", "drawn"});
    EXPECT_EQ(drawn.code, 0) << drawn.error;
    EXPECT_EQ(drawn.out, "drawn/fig07.svg\n");
    EXPECT_EQ(read_all(folder / "drawn/fig07.svg"), read_all(folder / "run/figures/fig07.svg"));
    for (const char* name : {"fig7", "fig07", "figure-7"}) {
        EXPECT_EQ(run_suffuse({"figures", "run", "--figure", name, "-o", "drawn"}).code, 0) << name;
    }
    for (const char* figure : {"fig07", "fig09", "fig10"}) {
        write_to(
            folder / "three/figures" / (std::string(figure) + ".svg"), "<svg xmlns=\"http://www.w3.org/2000/svg\"/>"
        );
    }
    const ProgramResult both = run_suffuse({"figures", "three", "--figure", "9,10", "-o", "both"});
    EXPECT_EQ(both.code, 0) << both.error;
    EXPECT_EQ(both.out, "both/fig09.svg\nboth/fig10.svg\n");
    const ProgramResult unknown = run_suffuse({"figures", "run", "--figure", "12"});
    EXPECT_EQ(unknown.code, 2);
    EXPECT_NE(unknown.error.find("it has fig07, fig11"), std::string::npos) << unknown.error;
    for (const auto& [number, file] :
         {std::pair{"1", "silty-sand-2016/case.toml"},
          {"2", "silty-sand-2016/case.toml"},
          {"9", "fontainebleau-2016/case.toml"}}) {
        EXPECT_NE(run_suffuse({"figures", "run", "--figure", number}).error.find(file), std::string::npos) << number;
    }
    const ProgramResult nothing = run_suffuse({"figures", "nowhere"});
    EXPECT_EQ(nothing.code, 74);
    EXPECT_NE(nothing.error.find("suffuse report nowhere"), std::string::npos) << nothing.error;
}

TEST_F(Cli, FiguresSayWhatIsMissingAndCallTheConverterForPixels) {
    write_figures(folder / "run");
    write_to(folder / "empty/readme", "");
    const ProgramResult no_node = run_suffuse({"figures", "run"}, {"PATH=" + (folder / "empty").string()});
    EXPECT_EQ(no_node.code, 74);
    EXPECT_NE(no_node.error.find("node is missing"), std::string::npos) << no_node.error;
    const ProgramResult no_converter =
        run_suffuse({"figures", "run", "--figure", "7", "--format", "png"}, {"PATH=" + (folder / "empty").string()});
    EXPECT_EQ(no_converter.code, 74);
    EXPECT_NE(no_converter.error.find("librsvg2-bin"), std::string::npos) << no_converter.error;
    write_stand_in(folder / "bin", "rsvg-convert");
    const std::string path = "PATH=" + (folder / "bin").string() + ":/usr/bin:/bin";
    write_to(folder / "drawn/precious", "precious");
    std::filesystem::create_symlink(folder / "drawn/precious", folder / "drawn/fig07.png");
    EXPECT_EQ(run_suffuse({"figures", "run", "--figure", "7", "--format", "png", "-o", "drawn"}, {path}).code, 0);
    EXPECT_EQ(read_all(folder / "drawn/fig07.png"), "drawn\n");
    EXPECT_EQ(read_all(folder / "drawn/precious"), "precious") << "no link is followed";
    EXPECT_EQ(run_suffuse({"figures", "run", "--figure", "7", "--format", "pdf", "-o", "drawn"}, {path}).code, 0);
    const std::string calls = read_all(folder / "bin/rsvg-convert.called");
    EXPECT_EQ(calls.rfind("--format png --output /", 0), 0U) << calls;
    expect_in("/fig07.png --zoom 3 --background-color white /", calls);
    expect_in("/fig07.pdf /", calls);
}

using DrawingCli = Drawing<Cli>;

TEST_F(DrawingCli, FiguresDrawSpecificationsWhereTheirProgramIsBuilt) {
    write_figures(folder / "run");
    const ProgramResult drawn = run_suffuse({"figures", "run", "--json"});
    ASSERT_EQ(drawn.code, 0) << drawn.error;
    EXPECT_EQ(drawn.json()["figures"].size(), 2U);
    const std::string svg = read_all(folder / "run/figures/fig11.svg");
    EXPECT_EQ(svg.rfind("<svg", 0), 0U);
    EXPECT_NE(svg.find("<desc>two &lt; three</desc>"), std::string::npos);
}

TEST_F(DrawingCli, AFigureThatCannotBeDrawnIsNamedAndOthersAreDrawn) {
    write_figures(folder / "run");
    write_to(folder / "run/figures/a-broken-one.vl.json", "{");
    const ProgramResult result = run_suffuse({"figures", "run", "-o", "drawn"});
    EXPECT_EQ(result.code, 74);
    expect_in("a-broken-one.vl.json: ", result.error);
    expect_in("others that were drawn: 2 in drawn", result.error);
    EXPECT_EQ(read_all(folder / "drawn/fig11.svg").rfind("<svg", 0), 0U);
}

} // namespace
} // namespace suffuse
