#include "suffuse/casefile/schema.hpp"

#include "suffuse/casefile/case_for_tests.hpp"
#include "suffuse/casefile/explain.hpp"
#include "suffuse/casefile/names.hpp"

#include <gtest/gtest.h>

#include "tests/support/reference.hpp"
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>

namespace {

using namespace suffuse;
using namespace suffuse::casefile;

const Key& key_of(const std::string& table, const std::string& name) {
    for (const Key& key : schema()) {
        if (key.table == table && key.name == name) {
            return key;
        }
    }
    throw std::runtime_error("no key " + name);
}

TEST(Schema, EveryKeyStandsOnceWithOneSentence) {
    std::set<std::string> known;
    for (const Key& key : schema()) {
        EXPECT_TRUE(known.insert(key.table + "." + key.name).second) << key_place(key);
        EXPECT_TRUE(key.text.ends_with(".")) << key_place(key);
        EXPECT_FALSE(value_text(key).empty()) << key_place(key);
    }
}

TEST(Schema, DefaultsAreThoseOfTheSpecs) {
    EXPECT_EQ(key_of("contact", "modulus").default_text, "\"356 MPa\"");
    EXPECT_EQ(key_of("contact", "friction").default_text, "\"37 deg\"");
    EXPECT_EQ(key_of("stage.pack", "porosity").default_text, "0.65");
    EXPECT_EQ(key_of("stage.compact", "time_step").default_text, "\"computed\"");
    EXPECT_EQ(key_of("stage.erode.detached", "rule").default_text, "\"still-accelerating\"");
    EXPECT_EQ(key_of("stage.erode.passes_constriction", "size").default_text, "\"mean\"");
    EXPECT_EQ(key_of("stage.erode.passes_constriction", "merge").default_text, "\"none\"");
    EXPECT_EQ(key_of("stage.detach", "gradients").default_text, "[0.0, 0.01, 0.05, 0.1]");
    EXPECT_EQ(key_of("output", "checkpoint").default_text, "\"600 s\"");
    EXPECT_EQ(key_of("stage.compact", "pressure").default_text, "") << "a required key has none";
}

/// Codes in quotes, "E312", in the sources of the program.
std::set<std::string> codes_in_use() {
    std::set<std::string> found;
    const std::regex quoted_code("\"([EW][0-9]{3})\"");
    for (const char* folder : {"suffuse", "apps", "python/bindings"}) {
        for (const auto& entry : std::filesystem::recursive_directory_iterator(test::in_checkout(folder))) {
            const std::string name = entry.path().filename().string();
            if (!name.ends_with("pp") || name.find(".test.") != std::string::npos || name == "explain.cpp") {
                continue;
            }
            std::ifstream file(entry.path());
            const std::string text{std::istreambuf_iterator<char>(file), {}};
            for (std::sregex_iterator at(text.begin(), text.end(), quoted_code), end; at != end; ++at) {
                found.insert((*at)[1]);
            }
        }
    }
    return found;
}

TEST(Schema, EveryCodeIsExplainedAndEveryExplainedCodeIsInUse) {
    const std::vector<std::string> list = codes();
    EXPECT_EQ(codes_in_use(), std::set<std::string>(list.begin(), list.end()));
    for (const std::string& code : list) {
        EXPECT_GT(explain(code).value_or("").size(), code.size() + 20) << code;
    }
}

TEST(Schema, EveryKeyAndEveryConventionIsExplained) {
    for (const Key& key : schema()) {
        const std::string full = key.table.empty() ? key.name : key.table + "." + key.name;
        for (const std::string& word : {key.name, full}) {
            EXPECT_NE(explain(word).value_or("").find(key.text), std::string::npos) << word;
        }
    }
    for (const std::string& word : topics()) {
        EXPECT_TRUE(explain(word)) << word;
    }
    EXPECT_NE(explain("e_eq")->find("inactive fines"), std::string::npos);
    EXPECT_NE(explain("stress")->find("compression positive"), std::string::npos);
    EXPECT_EQ(explain("e_qe"), std::nullopt);
}

TEST(Schema, EveryVerbHasKeys) {
    for (const std::string_view verb : names::verbs) {
        const std::string table = "stage." + std::string(verb);
        EXPECT_TRUE(std::any_of(schema().begin(), schema().end(), [&](const Key& key) { return key.table == table; }))
            << verb;
    }
}

TEST(Schema, RangesAreWrittenInWords) {
    EXPECT_EQ(range_text(key_of("contact", "damping")), "at least 0 and below 1");
    EXPECT_EQ(range_text(key_of("contact", "friction")), "at least 0 and below 90 deg");
    EXPECT_EQ(range_text(key_of("stage.detach", "watch")), "at least 10");
    EXPECT_EQ(range_text(key_of("contact", "rolling_friction")), "");
}

TEST(Schema, ThePageHasEveryKey) {
    const std::string page = schema_markdown();
    for (const Key& key : schema()) {
        EXPECT_NE(page.find("| `" + key.name + "` |"), std::string::npos) << key.name;
        EXPECT_EQ(key.text.find('|'), std::string::npos) << "would break the table";
    }
}

TEST(Schema, ThePageOfKeysIsTheOneThatTheProgramPrints) {
    std::ostringstream page;
    page << std::ifstream(test::in_checkout("docs/case-reference.md")).rdbuf();
    EXPECT_EQ(page.str(), schema_markdown()) << "suffuse schema > docs/case-reference.md";
}

TEST(Explain, KnowsKeysCodesAndConventions) {
    EXPECT_NE(explain("modulus")->find("default  \"356 MPa\""), std::string::npos);
    EXPECT_NE(explain("contact.modulus")->find("[contact] modulus"), std::string::npos);
    EXPECT_NE(explain("detached.over")->find("[study.NAME.stage.erode.detached] over"), std::string::npos);
    EXPECT_EQ(explain("soil")->find("*"), std::string::npos); // its table stands for any name, and appears once
    EXPECT_NE(explain("e310")->find("unit"), std::string::npos);
    EXPECT_NE(explain("conventions")->find("compression positive"), std::string::npos);
    const auto adhesion = explain("study.x.stage.y.prepare.adhesion.normal");
    EXPECT_EQ(adhesion, explain("stage.compact.prepare.adhesion.normal"));
    EXPECT_EQ(adhesion, explain("stage.y.prepare.adhesion.normal")); // as sweeps have it
    EXPECT_NE(explain("study.x.particles")->find("[study.NAME] particles"), std::string::npos);
    EXPECT_NE(explain("study.x.stage.y.gradient")->find("[study.NAME.stage.erode] gradient"), std::string::npos);
    EXPECT_NE(explain("presets.quick.passes")->find("[presets.NAME] passes"), std::string::npos);
    EXPECT_EQ(explain("soil.dyke.fines.finer_than"), explain("fines.finer_than"));
    EXPECT_NE(explain("erode")->find("a stage that does \"erode\"\n  passes"), std::string::npos);
    EXPECT_NE(explain("erode")->find("  detached.rule"), std::string::npos);
    EXPECT_NE(explain("contact")->find("[contact]\n"), std::string::npos);
    EXPECT_NE(explain("soil")->find("  psd"), std::string::npos);
    EXPECT_FALSE(explain("study.x.stage.y.prepare.adhesion.nromal"));
    EXPECT_FALSE(explain("study.x"));
    EXPECT_FALSE(explain("modulos"));
    EXPECT_FALSE(explain(""));
}

TEST(Explain, OffersTheNearestKeyAtAPlaceOfACaseAndKeepsItsNames) {
    EXPECT_EQ(nearest_key("study.x.stage.y.voi_ratio"), "study.x.stage.y.void_ratio");
    EXPECT_EQ(nearest_key("stage.y.prepare.adhesion.nromal"), "stage.y.prepare.adhesion.normal");
    EXPECT_EQ(nearest_key("study.x.stge.y.void_ratio"), "study.x.stage.y.void_ratio");
    EXPECT_EQ(nearest_key("study.x.stage.y.nothing"), std::nullopt);
    EXPECT_EQ(nearest_key(""), std::nullopt);
}

TEST(Explain, EveryHintInAMessageLeadsSomewhere) {
    for (const std::string& word : topics()) {
        EXPECT_TRUE(explain(word)) << word;
    }
    for (const Key& key : schema()) {
        EXPECT_TRUE(explain(key.name)) << key.name;
    }
}

} // namespace
