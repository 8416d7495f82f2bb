// The checks that every packing from elsewhere meets, for every caller.

#include "suffuse/io/packing_checks.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/io/atomic_file.hpp"

#include <gtest/gtest.h>

#include "tests/support/temp_folder.hpp"
#include <algorithm>
#include <string>

namespace suffuse::io {
namespace {

using test::TempFolder;

TakenPacking take(const std::string& text, PackingRequest request = {}) {
    const TempFolder folder;
    write_file(folder / "p.any", text);
    request.file = folder / "p.any";
    return take_packing(request);
}

std::string complaint(const std::string& text, const PackingRequest& request = {}) {
    try {
        take(text, request);
    } catch (const CaseError& error) {
        const std::string message = error.what();
        return message.substr(message.find("p.any")); // without the folder
    }
    return "";
}

bool warns(const TakenPacking& taken, const std::string& words) {
    return std::ranges::any_of(taken.warnings, [&](const std::string& w) {
        return w.find(words) != std::string::npos;
    });
}

PackingRequest in_box(double edge) {
    PackingRequest request;
    request.cell = diagonal({edge, edge, edge});
    return request;
}

const std::string two = "x,y,z,r\n0,0,0,1e-4\n0,0,1.9e-4,1e-4\n"; // they overlap by a tenth of a radius, and rounding

TEST(PackingChecks, APackingIsTakenWithItsCellAndItsLargestOverlap) {
    PackingRequest request = in_box(3e-3);
    request.max_overlap = 0.2;
    const TakenPacking taken = take(two, request);
    EXPECT_EQ(taken.grains.size(), 2U);
    EXPECT_EQ(taken.h, diagonal({3e-3, 3e-3, 3e-3}));
    EXPECT_NEAR(taken.overlap, 0.1, 1e-12); // rounding
    EXPECT_EQ(taken.contacts, 1U);
    EXPECT_EQ(taken.mean_overlap, taken.overlap);
    EXPECT_TRUE(taken.no_cell.empty());
}

TEST(PackingChecks, WithoutACellThereIsAReasonAndNoOverlap) {
    const TakenPacking taken = take(two);
    EXPECT_FALSE(taken.h.has_value());
    EXPECT_NE(taken.no_cell.find("p.any carries no cell"), std::string::npos);
    EXPECT_TRUE(taken.warnings.empty());
}

TEST(PackingChecks, AnOverlapIsRefusedOrForOneWhoOnlyLooksWarnedOf) {
    PackingRequest request = in_box(3e-3);
    request.max_overlap = 0.05;
    EXPECT_EQ(
        complaint(two, request), "p.any: grains 0 and 1 overlap by 0.1 of the smaller radius (0.1 mm), allowed 0.05; "
                                 "check that the cell is the packing's own, that radii are not diameters and that "
                                 "lengths are in m, or allow a larger overlap"
    );
    request.only_looks = true;
    EXPECT_TRUE(warns(take(two, request), "grains 0 and 1 overlap by 0.1"));
    for (const double share : {0.0, -0.1, 2.1}) {
        request.max_overlap = share;
        EXPECT_THROW(take(two, request), CaseError) << share;
    }
}

TEST(PackingChecks, TwoGrainsInOnePlaceAreRefusedWhateverIsAllowed) {
    PackingRequest request = in_box(3e-3);
    request.max_overlap = 2;
    request.only_looks = true;
    EXPECT_EQ(
        complaint("x,y,z,r\n1e-3,0,0,1e-4\n2e-3,0,0,1e-4\n1e-3,0,3e-3,2e-4\n", request),
        "p.any: grains 0 and 2 are at the same place; check that each grain has one row"
    );
}

TEST(PackingChecks, ReplacingTheFilesCellIsReported) {
    const std::string own = "##PERIODIC:: 4e-3 4e-3 4e-3\n0 0 0 1e-4\n";
    EXPECT_TRUE(warns(
        take(own, in_box(3e-3)), "p.any: the cell given, 0.003 x 0.003 x 0.003 m, is taken, not the file's own, 0.004 x"
    ));
    EXPECT_FALSE(warns(take(own, in_box(4e-3 * (1 + 1e-12))), "is taken")); // copied with fewer digits
    EXPECT_FALSE(warns(take(own), "is taken"));
}

TEST(PackingChecks, ABoxWithWallsIsACellOnlyForOneWhoSaysSo) {
    const std::string dump = "ITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff pp pp\n0 4e-3\n0 4e-3\n0 4e-3\n"
                             "ITEM: ATOMS x y z radius\n0 0 0 1e-4\n";
    const TakenPacking box = take(dump);
    EXPECT_FALSE(box.h.has_value());
    EXPECT_NE(box.no_cell.find("p.any:3: found boundaries ff along x"), std::string::npos) << box.no_cell;
    EXPECT_TRUE(warns(
        take(dump, in_box(4e-3)), "ff along x, and samples must be periodic along all axes, so its box is not a cell; "
                                  "the cell given is, and grains meet across its faces"
    ));
}

TEST(PackingChecks, ImpossibleLengthsAreReportedInTheNameOfTheCaller) {
    PackingRequest request = in_box(1);
    request.where = "study/start";
    EXPECT_TRUE(warns(take("0 0 0 1e-4\n", request), "study/start: the grains fill a share of 4.2e-12 of the cell"));
    EXPECT_TRUE(warns(take("0 0 0 0.4\n"), "the median diameter is 0.8 m, coarser than gravel"));
    EXPECT_TRUE(warns(take("0 0 0 0.0316\n"), "coarser than gravel"));
    EXPECT_FALSE(warns(take("0 0 0 0.0314\n"), "coarser than gravel"));
    EXPECT_TRUE(warns(take("0 0 0 1e-8\n"), "finer than clay"));
    EXPECT_TRUE(take("0 0 0 0.4e-3\n").warnings.empty());
    std::string crowd = "x,y,z,r\n";
    for (int k = 0; k < 100; ++k) {
        crowd += "0,0,0.0" + std::to_string(k) + ",0.3\n";
    }
    EXPECT_NE(complaint(crowd, in_box(1)).find("the grains have 11.3 times the volume of the cell"), std::string::npos);
}

TEST(PackingChecks, ACellNarrowerThanTenGrainsIsWarnedOf) {
    // The narrowest way across a sheared cell: 2 edges long, sheared by 45 degrees, sqrt(2) wide.
    PackingRequest request;
    request.cell = from_columns({2, 0, 0}, {2, 2, 0}, {0, 0, 2});
    const std::string grains = "0.5 0.5 0.5 0.01\n0.2 0.5 0.5 0.1\n";
    EXPECT_TRUE(warns(take(grains, request), "p.any: the cell is 7.1 times as wide as the largest grain"));
    EXPECT_FALSE(warns(take(grains, in_box(2)), "times as wide"));
}

TEST(PackingChecks, OverlapBeyondTheShareNamesTheWorstPair) {
    grains::Grains grains;
    grains::add_grain(grains, {0.5, 0.5, 0.5}, 0.1, 2600);
    grains::add_grain(grains, {0.65, 0.5, 0.5}, 0.1, 2600); // overlap 0.05
    grains::add_grain(grains, {0.98, 0.5, 0.5}, 0.05, 2600);
    grains::add_grain(grains, {1.02, 0.5, 0.5}, 0.05, 2600); // overlap 0.06, and through the period of the cell
    cell::Cell cell;
    EXPECT_NEAR(check_overlaps(grains, cell, 1.3), 1.2, 1e-12); // rounding
    try {
        check_overlaps(grains, cell, 0.1, "p.csv");
        FAIL() << "expected a CaseError";
    } catch (const CaseError& error) {
        EXPECT_NE(
            std::string(error.what()).find("p.csv: grains 2 and 3 overlap by 1.2 of the smaller"), std::string::npos
        ) << error.what();
    }
    grains::Grains large;
    grains::add_grain(large, {0, 0, 0}, 0.6, 2600);
    EXPECT_THROW(check_overlaps(large, cell, 0.1), CaseError); // wider than the cell: overlaps its own image
    large.radius[0] = 600;
    try { // as a packing in mm read in m: not looked for as pairs, there would be too many
        check_overlaps(large, cell, 0.1, "mm.csv");
        FAIL() << "expected a CaseError";
    } catch (const CaseError& error) {
        EXPECT_EQ(
            std::string(error.what()), "mm.csv: grain 0 has a radius of 600 m and does not fit into a cell 1 m wide; "
                                       "lengths are in m: check that none was given in mm"
        );
    }
}

TEST(PackingChecks, ACellThatIsShearedToNothingIsRefusedBeforeGrainsAreSoughtInItsImages) {
    const auto found = [](double tilt) {
        grains::Grains grains;
        grains::add_grain(grains, {0, 0, 0}, 0.1, 2600);
        cell::Cell cell;
        cell.h(0, 1) = tilt;
        try {
            check_overlaps(grains, cell, 2, "p.data");
        } catch (const CaseError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(found(1), "");
    for (const double tilt : {1e4, 1e34}) {
        EXPECT_NE(found(tilt).find("p.data: the cell is sheared until"), std::string::npos) << found(tilt);
    }
}

TEST(PackingChecks, APositionFarFromTheCellIsAMistakeOfTheFile) {
    for (const double x : {1e300, 1e5, -1e5}) {
        grains::Grains grains;
        grains::add_grain(grains, {0.5, 0.5, 0.5}, 0.1, 2600);
        grains::add_grain(grains, {0.5, x, 0.5}, 0.1, 2600);
        try {
            check_overlaps(grains, {}, 0.1, "p.csv");
            ADD_FAILURE() << "expected a CaseError for " << x;
        } catch (const CaseError& error) {
            EXPECT_NE(std::string(error.what()).find("p.csv: grain 1: found the position (0.5, "), std::string::npos)
                << error.what();
        }
    }
    grains::Grains outside; // of the cell, by some periods: as LAMMPS and Yade write them
    grains::add_grain(outside, {100.5, -3, 0.5}, 0.1, 2600);
    EXPECT_EQ(check_overlaps(outside, {}, 0.1), 0);
}

} // namespace
} // namespace suffuse::io
