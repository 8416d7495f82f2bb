#include "suffuse/report/page.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/report/live_page.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/sample_report.hpp"
#include "tests/support/temp_folder.hpp"
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <zlib.h>

namespace suffuse::report {
namespace {

namespace fs = std::filesystem;

using test::read_all;

/// The other way round of `packed`, from the element with this id.
std::string unpacked(const std::string& page, const std::string& id) {
    const std::string begin = "id=\"" + id + "\">";
    const std::size_t from = page.find(begin) + begin.size();
    std::string bytes;
    std::uint32_t bits = 0;
    int held = 0;
    const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (std::size_t at = from; page[at] != '<' && page[at] != '='; ++at) {
        bits = bits << 6U | static_cast<std::uint32_t>(letters.find(page[at]));
        held += 6;
        if (held >= 8) {
            held -= 8;
            bytes += static_cast<char>(bits >> static_cast<unsigned>(held) & 0xFFU);
        }
    }
    std::string text(std::size_t{1} << 25U, '\0');
    uLongf size = text.size();
    EXPECT_EQ(
        uncompress(
            reinterpret_cast<Bytef*>(text.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()
        ),
        Z_OK
    );
    text.resize(size);
    return text;
}

class Page : public testing::Test {
protected:
    void write_script(const std::string& code) const {
        fs::create_directories(folder / "page");
        std::ofstream(folder / "page/page.js") << code;
        std::ofstream(folder / "page/page.js.sha256") << "AbC+/123=\n";
        std::ofstream(folder / "page/notices.txt") << "Notice of <a library>\n";
    }

    test::TempFolder folder;
};

TEST_F(Page, WithoutItsScriptIsPlainAndSaysWhatIsMissing) {
    const WrittenReport written = write_report(folder.path(), test::sample_report("Sand"), folder / "nowhere");
    EXPECT_FALSE(written.has_charts);
    const std::string page = read_all(written.file);
    EXPECT_NE(page.find("This report is plain"), std::string::npos);
    EXPECT_NE(page.find("npm"), std::string::npos);
    EXPECT_EQ(page.find("<script"), std::string::npos);
    EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
    EXPECT_NE(page.find("✓ met"), std::string::npos);
    EXPECT_NE(page.find("? cannot tell"), std::string::npos);
    EXPECT_NE(page.find("figures/fig09.csv"), std::string::npos);
}

TEST_F(Page, WithItsScriptCarriesTheDataAndTheHash) {
    write_script("console.log(1)");
    const WrittenReport written = write_report(folder.path(), test::sample_report("Sand"), folder / "page");
    EXPECT_TRUE(written.has_charts);
    const std::string page = read_all(written.file);
    EXPECT_NE(page.find("script-src 'sha256-AbC+/123='"), std::string::npos);
    EXPECT_NE(page.find("<script>console.log(1)</script>"), std::string::npos);
    EXPECT_NE(page.find("Notice of &lt;a library&gt;"), std::string::npos);
    const auto data = nlohmann::json::parse(unpacked(page, "report-data"));
    ASSERT_EQ(data["figures"].size(), 23U);
    for (const auto& figure : data["figures"]) {
        EXPECT_EQ(
            figure["csv"].get<std::string>(), read_all(folder / "figures" / (figure["id"].get<std::string>() + ".csv"))
        );
    }
}

TEST_F(Page, OfARunThatIsNotCompleteSaysSoBeforeAnythingElse) {
    ReportData report = test::sample_report("Sand");
    const auto page = [&] { return read_all(write_report(folder.path(), report, folder / "nowhere").file); };
    EXPECT_EQ(page().find("id=\"unfinished\""), std::string::npos);
    report.unfinished = {"2 of 3 stages are missing: a/<b>, a/c", "suffuse resume runs/a-0001"};
    const std::string text = page();
    const std::size_t banner = text.find("2 of 3 stages are missing: a/&lt;b&gt;, a/c");
    ASSERT_NE(banner, std::string::npos);
    EXPECT_LT(banner, text.find("id=\"answer\""));
    EXPECT_NE(text.find("<code>suffuse resume runs/a-0001</code>"), std::string::npos);
}

TEST_F(Page, OpensWithVerdictConfidenceCardsAndPictureBeforeAnythingThatIsFolded) {
    const std::string text =
        read_all(write_report(folder.path(), test::sample_report("Sand"), folder / "nowhere").file);
    const std::string page = text.substr(text.find("<main>"));
    std::size_t last = 0;
    for (const char* part :
         {"<p class=\"verdict\"><span>Water at", "<p class=\"conf\"><b>One sample</b>", "<dl class=\"cards of4\">",
          "<div class=\"item key\">", "<small>up to</small>", "▲ Known to be too high.", "data-figure=\"own-triaxial\"",
          "Two answers disagree.", "<summary>In full", "▲ Warnings: 1"}) {
        const std::size_t at = page.find(part);
        ASSERT_NE(at, std::string::npos) << part;
        EXPECT_GT(at, last) << part;
        last = at;
    }
    EXPECT_EQ(
        page.find("data-figure=\"own-triaxial\"", page.find("data-figure=\"own-triaxial\"") + 1), std::string::npos
    ) << "a figure stands in the page once";
}

TEST_F(Page, NumbersItsFiguresAndTablesItselfAndNamesThePapersInBrackets) {
    const std::string page =
        read_all(write_report(folder.path(), test::sample_report("Sand"), folder / "nowhere").file);
    std::size_t at = 0;
    for (int number = 1; number <= 23; ++number) {
        const std::size_t next = page.find("<figcaption", at);
        ASSERT_NE(next, std::string::npos) << number;
        at = page.find("<b>Figure ", next);
        EXPECT_EQ(
            page.compare(at, fmt::format("<b>Figure {}.</b>", number).size(), fmt::format("<b>Figure {}.</b>", number)),
            0
        );
    }
    EXPECT_NE(page.find("(Paper: Figure 9.)"), std::string::npos);
    EXPECT_NE(page.find("<caption><b>Table 1."), std::string::npos);
}

TEST_F(Page, InPrintHasATitlePageWithContentsAndNumbersInItsMargins) {
    ReportData report = test::sample_report("A \"sand\" \\ of </style> Example");
    report.project = "Dyke <1>", report.author = "A. Engineer";
    const std::string page = read_all(write_report(folder.path(), report, folder / "nowhere").file);
    EXPECT_NE(
        page.find("<dt>Project</dt><dd>Dyke &lt;1&gt;</dd><dt>Author</dt><dd>A. Engineer</dd>"), std::string::npos
    );
    EXPECT_NE(page.find("<li><a href=\"#provenance\">Provenance</a></li>"), std::string::npos);
    EXPECT_NE(page.find("counter(pages)"), std::string::npos);
    // The title cannot leave its quotation marks, nor the style element.
    EXPECT_NE(page.find("content: \"A \\22 sand\\22  \\5c  of \\3c /style> Example\""), std::string::npos);
    EXPECT_EQ(page.find("</style>"), page.rfind("</style>"));
}

TEST_F(Page, ShowsChartsThatWereDrawnForItWithoutAnyScript) {
    write_script("1");
    ReportData report = test::sample_report("Sand");
    const auto page = [&] { return read_all(write_report(folder.path(), report, folder / "page").file); };
    EXPECT_NE(page().find("The charts are drawn by JavaScript"), std::string::npos);
    for (figures::Figure& figure : report.figures) {
        figure.still = "<svg class=\"marks\"><path/></svg>";
    }
    const std::string text = page();
    EXPECT_EQ(text.find("The charts are drawn by JavaScript"), std::string::npos);
    EXPECT_NE(
        text.find("data-chart=\"fig11\"><svg aria-labelledby=\"fig11-title\" aria-describedby=\"fig11-caption\" "
                  "class=\"marks\">"),
        std::string::npos
    );
}

TEST_F(Page, NamesTheAxesThatShowFacts) {
    write_script("1");
    ReportData report = test::sample_report("Sand");
    figures::Figure& chart = report.figures.front();
    chart.drawing.clear(), chart.flat.clear();
    chart.chart = {{"mark", "line"}, {"encoding", {{"x", {{"field", "mean_stress"}}}}}};
    const std::string page = read_all(write_report(folder.path(), report, folder / "page").file);
    EXPECT_NE(unpacked(page, "report-data").find("\"title\":\"mean stress p [kPa]\""), std::string::npos);
}

TEST_F(Page, ListsTheCallsThatMadeTheRun) {
    ReportData report = test::sample_report("Sand");
    report.calls.push_back({"suffuse resume runs/a-0001", "2026-01-02T12:00:00Z", "0.1.0 0000000", 3725});
    const std::string page = read_all(write_report(folder.path(), report, folder / "nowhere").file);
    EXPECT_LT(page.find("<td>suffuse run case.toml</td>"), page.find("<td>suffuse resume runs/a-0001</td>"));
    EXPECT_NE(page.find("<td class=\"number\">1 h 2 min</td>"), std::string::npos);
}

TEST_F(Page, WarningsOfTheCheckOfTheCaseStandUnderQuality) {
    ReportData report = test::sample_report("Sand");
    report.case_warnings = {"W602: a narrow cell; take more grains"};
    const std::string text = read_all(write_report(folder.path(), report, folder / "nowhere").file);
    EXPECT_GT(text.find("W602: a narrow cell; take more grains"), text.find("<section id=\"quality\""));
    EXPECT_LT(text.find("warned of 1 thing before the run"), text.find("<section id=\"quality\""));
}

TEST_F(Page, OfACaseThatFollowsNoPaperMentionsNone) {
    ReportData report = test::sample_report("My dyke");
    EXPECT_NE(
        read_all(write_report(folder.path(), report, folder / "nowhere").file).find("of the paper"), std::string::npos
    );
    report.paper.clear();
    report.findings.clear();
    report.opening.cards.clear();
    const std::string text = read_all(write_report(folder.path(), report, folder / "nowhere").file);
    EXPECT_EQ(text.find("the paper"), std::string::npos) << text.substr(text.find("the paper") - 100, 200);
    EXPECT_EQ(text.find("The paper"), std::string::npos);
}

TEST_F(Page, TextThatIsNotUtf8IsMended) {
    write_script("1");
    const std::string page =
        read_all(write_report(folder.path(), test::sample_report("caf\xe9"), folder / "page").file);
    EXPECT_NE(unpacked(page, "report-data").find("case: caf\uFFFD"), std::string::npos);
}

TEST_F(Page, AScriptThatCouldEndItsElementIsNotUsed) {
    write_script("let a = '</script>'");
    EXPECT_FALSE(write_report(folder.path(), test::sample_report("Sand"), folder / "page").has_charts);
}

TEST_F(Page, HostileTextStaysText) {
    write_script("1");
    const std::string hostile = "</script></title><img src=x onerror=alert(1)>\"'";
    ReportData report = test::sample_report(hostile);
    report.run = report.warnings[0] = report.answer[0] = report.findings[0].ours = report.stages[0].name = hostile;
    report.provenance.emplace_back(hostile, hostile);
    report.figures[0].caption = report.figures[0].title = hostile;
    report.opening.cards[0] = {hostile, hostile, hostile, hostile, hostile, hostile};
    report.opening.verdict[0] = report.opening.confidence = report.opening.about_confidence = hostile;
    report.calls[0] = {hostile, hostile, hostile, 1};
    report.project = report.author = report.flaws.emplace_back(hostile);
    report.assumed[0] = {hostile, hostile, hostile};
    report.redraw = report.scene.remark = report.scene.states[0].label = hostile;
    const std::string page = read_all(write_report(folder.path(), report, folder / "page").file);
    EXPECT_EQ(page.find("<img src"), std::string::npos); // a still picture has its words in front
    std::size_t script_ends = 0;
    for (std::size_t at = page.find("</script"); at != std::string::npos; at = page.find("</script", at + 1)) {
        ++script_ends;
    }
    EXPECT_EQ(script_ends, 3U);
    EXPECT_NE(page.find("&lt;img src=x onerror=alert(1)&gt;"), std::string::npos);
}

TEST_F(Page, EachChartIsASpecificationWithItsDataAndEachDrawingAnSvg) {
    const ReportData report = test::sample_report("Sand");
    write_report(folder.path(), report);
    for (const figures::Figure& figure : report.figures) {
        if (figure.drawing.empty()) {
            const auto chart = nlohmann::json::parse(read_all(folder / "figures" / (figure.id + ".vl.json")));
            EXPECT_EQ(chart["data"]["values"].size(), figure.table.rows()) << figure.id;
            EXPECT_NE(chart["$schema"].get<std::string>().find("vega-lite/v6"), std::string::npos);
        } else {
            const std::string drawing = read_all(folder / "figures" / (figure.id + ".svg"));
            EXPECT_EQ(drawing.rfind("<svg xmlns", 0), 0U);
            EXPECT_NE(drawing.find("<metadata>\nfigure: " + figure.id + "\n"), std::string::npos);
            for (const auto& [key, value] : report.provenance) { // as in the CSV
                EXPECT_NE(drawing.find("\n" + key + ": "), std::string::npos) << key;
            }
        }
    }
}

TEST_F(Page, TheSameRunGivesTheSameBytes) {
    write_report(folder / "a", test::sample_report("Sand"));
    write_report(folder / "b", test::sample_report("Sand"));
    EXPECT_EQ(read_all(folder / "a/report.html"), read_all(folder / "b/report.html"));
    EXPECT_GT(read_all(folder / "a/report.html").size(), 10'000U);
}

TEST_F(Page, AFolderThatCannotBeMadeIsNamed) {
    std::ofstream(folder / "file") << "not a folder";
    try {
        write_report(folder / "file", test::sample_report("Sand"));
        FAIL() << "no error";
    } catch (const IoError& error) {
        EXPECT_NE(std::string(error.what()).find("/file: cannot be made"), std::string::npos) << error.what();
    }
}

TEST_F(Page, AnEmptyReportIsStillAPage) {
    const std::string page = read_all(write_report(folder.path(), {}).file);
    EXPECT_NE(page.find("<h2 id=\"provenance-heading\">"), std::string::npos);
    EXPECT_EQ(page.find("id=\"erosion\""), std::string::npos);
}

// Not a check of its own: page/test.sh makes the runs that the browser tests open.
TEST(SampleRun, IsWrittenWhereTheBrowserTestsWantIt) {
    const char* folder = std::getenv("SUFFUSE_SAMPLE_FOLDER");
    const char* page = std::getenv("SUFFUSE_SAMPLE_PAGE");
    if (folder == nullptr || page == nullptr) {
        GTEST_SKIP() << "only page/test.sh asks for it";
    }
    const char* hostile = "</script><img src=x onerror=\"document.title='broken'\">";
    EXPECT_TRUE(
        write_report(fs::path(folder) / "sample", test::sample_report("Suffusion of a synthetic sand"), page).has_charts
    );
    ReportData migration = test::sample_report("Fines that migrate");
    migration.scene = test::sample_migration_scene();
    EXPECT_TRUE(write_report(fs::path(folder) / "migration", migration, page).has_charts);
    EXPECT_TRUE(write_report(fs::path(folder) / "hostile", test::sample_report(hostile), page).has_charts);
    LivePage live;
    live.title = hostile;
    live.refresh_seconds = 1;
    live.progress = "1 of 3 stages";
    live.left = "1.0-2 min";
    live.rows = {{"erosion/cloud", "pack", "done", "0.1 s", ""}, {hostile, "compact", "running", "3.2 s", "e 0.7"}};
    fs::create_directories(fs::path(folder) / "live");
    std::ofstream(fs::path(folder) / "live/report.html") << render_live_page(live);
    ReportData plain = test::sample_report("Suffusion of a synthetic sand");
    plain.unfinished = {
        "2 of 9 stages are missing: erosion/erosion, erosion/shear-after", "suffuse resume runs/x-0001"};
    plain.case_warnings = {"W602: a narrow cell; take more grains"};
    EXPECT_FALSE(write_report(fs::path(folder) / "plain", plain).has_charts);
}

} // namespace
} // namespace suffuse::report
