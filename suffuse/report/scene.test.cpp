#include "suffuse/report/scene.hpp"

#include "suffuse/base/base64.hpp"
#include "suffuse/report/still.hpp"

#include <gtest/gtest.h>

#include "tests/support/sample_scene.hpp"
#include <algorithm>
#include <cstring>
#include <zlib.h>

namespace suffuse::report {
namespace {

template <class T>
std::vector<T> column(const nlohmann::json& json) {
    const std::string bytes = from_base64(json.at("data").get<std::string>()).value();
    std::vector<T> values(bytes.size() / sizeof(T));
    std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
}

TEST(Scene, ColumnsReadBackToTheGrains) {
    const Scene scene = test::sample_scene();
    const nlohmann::json json = scene_json(scene);
    EXPECT_EQ(column<std::uint32_t>(json.at("id")), scene.id);
    EXPECT_EQ(column<std::uint8_t>(json.at("fine")), scene.fine);
    const SceneState& first = scene.states[0];
    const auto place = column<std::uint16_t>(json.at("states")[0].at("place"));
    const double finest = norm(first.h * Vec3{1, 1, 1}) / 65535; // one step of each fraction
    for (std::size_t g = 0; g < scene.id.size(); ++g) {
        const Vec3 x = first.h * (Vec3{1.0 * place[3 * g], 1.0 * place[3 * g + 1], 1.0 * place[3 * g + 2]} / 65535);
        EXPECT_LT(norm(x - first.position[g]), finest);
        EXPECT_EQ(column<float>(json.at("radius"))[g], static_cast<float>(scene.radius[g]));
    }
}

TEST(Scene, ContactsLeadToTheImageThatIsTouched) {
    const Scene scene = test::sample_scene();
    const SceneState& state = scene.states[0];
    const nlohmann::json contacts = scene_json(scene).at("states")[0].at("contacts");
    const auto ends = column<std::uint16_t>(contacts.at("ends"));
    const auto period = column<std::uint8_t>(contacts.at("period"));
    ASSERT_EQ(ends.size(), 2 * state.contacts.size());
    bool has_crossing = false;
    for (std::size_t c = 0; c < period.size(); ++c) {
        const Vec3 periods{period[c] % 3 - 1.0, period[c] / 3 % 3 - 1.0, period[c] / 9 - 1.0};
        has_crossing = has_crossing || norm(periods) > 0;
        const Vec3 branch = state.position[ends[2 * c + 1]] + state.h * periods - state.position[ends[2 * c]];
        const double touching = scene.radius[ends[2 * c]] + scene.radius[ends[2 * c + 1]];
        EXPECT_NEAR(norm(branch), touching, 1e-9 * touching); // rounding
    }
    EXPECT_TRUE(has_crossing);
}

TEST(Scene, LaterStatesCountOnlyTheGrainsThatStayed) {
    const Scene scene = test::sample_scene();
    const auto left = std::count_if(scene.left_in.begin(), scene.left_in.end(), [](int pass) { return pass == 1; });
    ASSERT_GT(left, 0);
    const SceneCount before = count_scene(scene, scene.states[0]), after = count_scene(scene, scene.states[1]);
    EXPECT_EQ(before.grains, std::ssize(scene.id));
    EXPECT_EQ(before.grains - after.grains, left);
    EXPECT_GT(before.strong, 0);
    EXPECT_LT(before.strong, before.contacts);
    EXPECT_GE(before.largest_force, before.mean_force);
}

TEST(Scene, ContactsThatAreLeftOutStillCount) {
    Scene scene = test::sample_scene();
    SceneState& state = scene.states[0];
    const SceneCount all = count_scene(scene, state);
    leave_out_weak_contacts(scene, state);
    EXPECT_EQ(std::ssize(state.contacts), all.strong);
    const SceneCount counted = count_scene(scene, state);
    EXPECT_EQ(counted.contacts, all.contacts);
    EXPECT_EQ(counted.mean_force, all.mean_force);
    EXPECT_EQ(counted.strong, all.strong);
    EXPECT_EQ(counted.rattlers, all.rattlers);
}

TEST(Scene, OfAMigrationSaysWhereAndWhenEachGrainIs) {
    const Scene scene = test::sample_migration_scene();
    const nlohmann::json json = scene_json(scene);
    EXPECT_EQ(column<std::uint8_t>(json.at("fate")), scene.fate);
    EXPECT_EQ(json.at("fates").get<std::vector<std::string>>(), scene.fates);
    const auto entered = column<std::uint16_t>(json.at("entered_in"));
    EXPECT_TRUE(std::equal(entered.begin(), entered.end(), scene.entered_in.begin(), scene.entered_in.end()));
    const auto crossed = column<std::int16_t>(json.at("states")[3].at("period"));
    EXPECT_EQ(crossed.size(), 3 * scene.id.size());
    EXPECT_EQ(std::ranges::count(crossed, 1), std::ranges::count_if(scene.states[3].period, [](const auto& period) {
                  return period[0] == 1;
              }));
    EXPECT_GT(std::ranges::count(crossed, 1), 0);
    std::vector<double> times, gradients;
    for (const nlohmann::json& state : json.at("states")) {
        times.push_back(state.at("time"));
        gradients.push_back(state.at("gradient"));
    }
    EXPECT_EQ(times, (std::vector<double>{0, 0.5, 1, 1.5}));
    EXPECT_EQ(gradients, (std::vector<double>{0.2, 0.2, 0.4, 0.4}));
    std::vector<std::int64_t> fines;
    for (const SceneState& state : scene.states) {
        fines.push_back(count_scene(scene, state).fines);
    }
    EXPECT_EQ(fines, (std::vector<std::int64_t>{34, 34, 34, 34})) << "two come in where two others leave";
    const auto g = static_cast<std::size_t>(
        std::find(scene.entered_in.begin(), scene.entered_in.end(), 2) - scene.entered_in.begin()
    );
    EXPECT_FALSE(is_present(scene, scene.states[1], g));
    EXPECT_TRUE(is_present(scene, scene.states[2], g));
    const nlohmann::json passes = scene_json(test::sample_scene());
    for (const char* name : {"entered_in", "fate", "fates"}) {
        EXPECT_FALSE(passes.contains(name)) << name;
    }
    for (const char* name : {"time", "gradient", "period"}) {
        EXPECT_FALSE(passes.at("states")[0].contains(name)) << name;
    }
}

/// Indices of a square PNG of one byte a pixel, row by row, each row behind the byte of its filter; checks every chunk.
std::vector<std::uint8_t> unpacked(const std::string& png, std::size_t pixels, std::string& chunks) {
    std::vector<std::uint8_t> rows(pixels * (pixels + 1));
    const auto number = [&](std::size_t from) {
        std::uint32_t value = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            value = value << 8 | static_cast<std::uint8_t>(png[from + k]);
        }
        return value;
    };
    for (std::size_t at = 8; at < png.size(); at += 12 + number(at)) {
        const std::uint32_t size = number(at);
        const std::string name = png.substr(at + 4, 4);
        chunks += name;
        const auto* checked = reinterpret_cast<const Bytef*>(png.data() + at + 4);
        EXPECT_EQ(number(at + 8 + size), crc32(0, checked, size + 4)) << name;
        if (name == "IDAT") {
            uLongf length = rows.size();
            EXPECT_EQ(uncompress(rows.data(), &length, checked + 4, size), Z_OK);
            EXPECT_EQ(length, rows.size());
        }
    }
    return rows;
}

TEST(Still, IsAPngWhosePixelsUncompress) {
    const Scene scene = test::sample_scene();
    const std::string png = still_picture(scene, scene.states[0], 120);
    ASSERT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
    std::string chunks;
    const std::vector<std::uint8_t> rows = unpacked(png, 120, chunks);
    EXPECT_EQ(chunks, "IHDRPLTEtRNSIDATIEND");
    const auto drawn = std::count_if(rows.begin(), rows.end(), [](std::uint8_t index) { return index != 0; });
    EXPECT_GT(drawn, 120 * 120 / 4);      // the cell fills the picture
    EXPECT_LT(drawn, 120 * 120 * 9 / 10); // and leaves its corners free
}

TEST(Still, OfOneGrainIsADiscOfItsSize) {
    Scene scene;
    scene.id = {0};
    scene.radius = {1};
    scene.fine = {1};
    scene.left_in = {0};
    scene.states.emplace_back();
    scene.states[0].h = diagonal({8, 8, 8});
    scene.states[0].position = {{4, 4, 4}};
    scene.states[0].coordination = {0};
    constexpr int pixels = 400;
    constexpr std::uint8_t first_of_grains = 2; // after the ground and the outline
    const auto disc = [&] {
        struct {
            int left = pixels, right = -1, top = pixels, bottom = -1, count = 0;
        } seen;
        std::string chunks;
        const auto rows = unpacked(still_picture(scene, scene.states[0], pixels), pixels, chunks);
        for (int row = 0; row < pixels; ++row) {
            for (int column = 0; column < pixels; ++column) {
                if (rows[static_cast<std::size_t>(row * (pixels + 1) + 1 + column)] >= first_of_grains) {
                    seen.left = std::min(seen.left, column);
                    seen.right = std::max(seen.right, column);
                    seen.top = std::min(seen.top, row);
                    seen.bottom = std::max(seen.bottom, row);
                    ++seen.count;
                }
            }
        }
        return seen;
    };
    // Along the eye (1, -1.6, 0.9) the cube of side 8 reaches farthest to the side: 4 (1.6 + 1)/sqrt(1.6^2 + 1), and
    // upward: 4 (|u1| + |u2| + |u3|) with u = (-0.9, 1.44, 3.56)/sqrt(0.9^2 + 1.44^2 + 3.56^2). The grain is next to
    // it.
    const double side = 4 * 2.6 / std::sqrt(3.56);
    const double upward = 4 * (0.9 + 1.44 + 3.56) / std::sqrt(0.81 + 2.0736 + 12.6736);
    const double radius = 0.5 * pixels / (1.01 * (std::max(side, upward) + 1));
    const auto seen = disc();
    // Pixels whose middle lies in the disc; the thin outline of the cell may cross it, but not at all of its ends.
    EXPECT_NEAR(seen.right - seen.left + 1, 2 * radius, 1.01);
    EXPECT_NEAR(seen.bottom - seen.top + 1, 2 * radius, 1.01);
    EXPECT_NEAR(0.5 * (seen.left + seen.right + 1), 0.5 * pixels, 1);
    EXPECT_NEAR(0.5 * (seen.top + seen.bottom + 1), 0.5 * pixels, 1);
    const double area = 3.14159265 * radius * radius;
    EXPECT_LT(seen.count, 1.02 * area);
    EXPECT_GT(seen.count, 0.85 * area) << "three edges two pixels wide cross it at the most";
    scene.left_in = {1};
    scene.states[0].passes = 1;
    EXPECT_EQ(disc().count, 0) << "gone after pass 1";
}

} // namespace
} // namespace suffuse::report
