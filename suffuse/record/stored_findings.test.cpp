#include "suffuse/record/stored_findings.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/io/atomic_file.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/result_json.hpp"

#include <gtest/gtest.h>

#include "tests/support/temp_folder.hpp"

namespace suffuse::record {
namespace {

using nlohmann::json;
using test::TempFolder;

json some_results() {
    flow::ThroatFlux flux;
    flux.throats = 3;
    flux.mean = 1e-9;
    flux.quantile = flux.carried = {0, 0.5, 1};
    return {{"throat_flux", flux}, {"curve", std::vector<triaxial::PathRow>(2)}, {"erosion", erosion::ErosionResult{}}};
}

/// What is said of them; empty where they are read.
std::string complaint_about(const TempFolder& folder) {
    try {
        static_cast<void>(read_findings(folder.path()));
        return "";
    } catch (const IoError& error) {
        return error.what();
    }
}

TEST(StoredFindings, ComeBack) {
    const TempFolder folder;
    write_cbor(folder / "results.cbor", some_results());
    const StageFindings findings = read_findings(folder.path());
    ASSERT_TRUE(findings.throat_flux);
    EXPECT_EQ(findings.throat_flux->mean, 1e-9);
    EXPECT_EQ(findings.curve.size(), 2U);
    EXPECT_TRUE(findings.erosion);
    EXPECT_FALSE(read_findings(folder / "of a verb that leaves none").throat_flux);
}

TEST(StoredFindings, WithoutAKeyOrOfAnotherTypeAreRefusedWithTheFileAndWhatHelps) {
    const TempFolder folder;
    json without_key = some_results(), other_type = some_results(), no_object = json::array({1, 2});
    without_key["throat_flux"].erase("mean");
    other_type["throat_flux"]["mean"] = "much";
    const std::string name = (folder / "results.cbor").string();
    for (const auto& [results, found] :
         {std::pair{without_key, "(key 'mean' not found)"}, {other_type, "(type must be number, but is string)"}}) {
        write_cbor(folder / "results.cbor", results);
        EXPECT_EQ(
            complaint_about(folder), name + ": has changed since it was written " + found +
                                         ": it was modified or damaged, or belongs to another version; remove " +
                                         folder.path().string() + " and resume: its stage is then computed anew"
        );
    }
    io::write_file(folder / "results.cbor", "\xa1");
    EXPECT_NE(
        complaint_about(folder).find(name + ": has changed since it was written (no valid CBOR)"), std::string::npos
    );
}

// Figures take a row of one column for a row of all.
TEST(StoredFindings, WithColumnsOfOtherLengthsAreRefused) {
    const TempFolder folder;
    json results = some_results();
    results["throat_flux"]["carried"] = {0, 1};
    write_cbor(folder / "results.cbor", results);
    EXPECT_NE(
        complaint_about(folder).find(
            "results.cbor: has changed since it was written (throat_flux has 3 of quantile and 2 of "
            "carried): it was modified or damaged"
        ),
        std::string::npos
    );
}

// Whether a value was changed is shown by the checksums of its stage.
TEST(StoredFindings, AreReadOrRefusedWithTheFileWhateverByteHasChanged) {
    const TempFolder folder;
    write_cbor(folder / "results.cbor", some_results());
    const std::string whole = test::read_all(folder / "results.cbor");
    int refused = 0;
    for (std::size_t at = 0; at < whole.size(); ++at) {
        for (const int bit : {0, 3, 5, 7}) {
            std::string changed = whole;
            changed[at] = static_cast<char>(changed[at] ^ (1 << bit));
            io::write_file(folder / "results.cbor", changed);
            const std::string complaint = complaint_about(folder); // another exception fails the test
            refused += complaint.empty() ? 0 : 1;
            EXPECT_TRUE(complaint.empty() || complaint.find("results.cbor") != std::string::npos) << complaint;
        }
    }
    EXPECT_GT(refused, 0);
}

} // namespace
} // namespace suffuse::record
