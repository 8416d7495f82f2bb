#include "suffuse/contact/sum_plan.hpp"

#include "suffuse/base/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace suffuse::contact {
namespace {

TEST(SumPlan, GivesEveryShareFromAnotherDomainARowOfItsOwnInTheOrderOfTheTable) {
    constexpr std::uint32_t there = domain_grains; // the first grain of the second domain
    Contacts contacts;
    const std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs{
        {0, 1}, {0, there}, {1, there + 1}, {2, there}, {there, there + 1}};
    for (const auto& [i, j] : pairs) {
        contacts.first.push_back(i);
        contacts.second.push_back(j);
        contacts.image.push_back({j == 1 ? 0 : 1, 0, 0});
    }
    const std::uint32_t grains = there + 3;
    SumPlan plan;
    plan_sums(contacts, grains, plan);
    EXPECT_EQ(plan.domain_start, (std::vector<std::uint32_t>{0, 4, 5}));
    EXPECT_EQ(plan.second_sum, (std::vector<std::uint32_t>{1, grains, grains + 1, grains + 2, there + 1}));
    EXPECT_EQ(plan.remote, (std::vector<std::uint32_t>{there, there + 1, there}));
    EXPECT_EQ(plan.remote_start, (std::vector<std::uint32_t>{0, 0, 3}));
    EXPECT_EQ(plan.reach, (std::vector<std::uint32_t>{0, 1, 1}));
    EXPECT_EQ(plan.reach_start, (std::vector<std::uint32_t>{0, 2, 3}));
    EXPECT_EQ(plan.reached_by, (std::vector<std::uint32_t>{1, 2}));
    EXPECT_EQ(plan.rows(), grains + 3);
    EXPECT_EQ(plan.images, (std::vector<cell::Image>{{0, 0, 0}, {1, 0, 0}}));
    EXPECT_EQ(plan.image, (std::vector<std::uint16_t>{0, 1, 1, 1, 1}));
}

constexpr std::uint32_t many_grains = 5 * domain_grains + 17;

/// Each grain but the last touches two of those after it.
Contacts contacts_anywhere() {
    RandomStream random(8, "plan");
    Contacts contacts;
    for (std::uint32_t i = 0; i + 1 < many_grains; ++i) {
        for (int k = 0; k < 2; ++k) {
            contacts.first.push_back(i);
            contacts.second.push_back(i + 1 + static_cast<std::uint32_t>(random.uniform() * (many_grains - 1 - i)));
            contacts.image.push_back({static_cast<int>(random.uniform() * 3) - 1, 0, 0});
        }
    }
    return contacts;
}

TEST(SumPlan, OfManyDomainsHasEachRowCollectedOnceByTheDomainOfItsGrain) {
    const Contacts contacts = contacts_anywhere();
    SumPlan plan;
    plan_sums(contacts, many_grains, plan);
    for (std::size_t d = 0; d < plan.domains(); ++d) {
        for (std::uint32_t k = plan.remote_start[d]; k < plan.remote_start[d + 1]; ++k) {
            ASSERT_EQ(plan.remote[k] / domain_grains, d);
        }
    }
    std::vector<std::uint32_t> next_row(plan.remote_start.begin(), plan.remote_start.end() - 1);
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        const std::uint32_t second = contacts.second[c];
        const std::size_t to = second / domain_grains;
        ASSERT_EQ(plan.images[plan.image[c]], contacts.image[c]);
        if (contacts.first[c] / domain_grains == to) {
            ASSERT_EQ(plan.second_sum[c], second);
        } else {
            const std::uint32_t row = next_row[to]++; // in the order of the table
            ASSERT_EQ(plan.second_sum[c], many_grains + row);
            ASSERT_EQ(plan.remote[row], second);
        }
    }
    EXPECT_TRUE(std::equal(next_row.begin(), next_row.end(), plan.remote_start.begin() + 1));
}

TEST(SumPlan, OfADomainKnowsWhichOnesReachIt) {
    const Contacts contacts = contacts_anywhere();
    SumPlan plan;
    plan_sums(contacts, many_grains, plan);
    std::set<std::pair<std::size_t, std::size_t>> expected, found;
    for (std::size_t d = 0; d < plan.domains(); ++d) {
        expected.emplace(d, d);
    }
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        expected.emplace(contacts.first[c] / domain_grains, contacts.second[c] / domain_grains);
    }
    std::vector<std::uint32_t> reached_by(plan.domains(), 0);
    for (std::size_t d = 0; d < plan.domains(); ++d) {
        for (std::uint32_t k = plan.reach_start[d]; k < plan.reach_start[d + 1]; ++k) {
            found.emplace(d, plan.reach[k]);
            ++reached_by[plan.reach[k]];
        }
    }
    EXPECT_EQ(found, expected);
    EXPECT_EQ(plan.reached_by, reached_by);
}

TEST(SumPlan, ListsTheGrainsOfADomainThoseOfSomeContactFirst) {
    constexpr std::uint32_t there = domain_grains;
    Contacts contacts;
    for (const auto& [i, j] : {std::pair{2U, 5U}, {2U, there + 1}, {7U, 2U * there}}) {
        contacts.first.push_back(i);
        contacts.second.push_back(j);
        contacts.image.push_back({});
    }
    SumPlan plan;
    plan_sums(contacts, 2 * there + 3, plan);
    EXPECT_EQ(plan.awake_end, (std::vector<std::uint32_t>{3, there + 1, 2 * there + 1}));
    EXPECT_EQ(std::vector(plan.roster.begin(), plan.roster.begin() + 5), (std::vector<std::uint32_t>{2, 5, 7, 0, 1}));
    EXPECT_EQ(plan.roster[there], there + 1);
    EXPECT_EQ(plan.roster[2 * there], 2 * there);
    std::ranges::sort(plan.roster);
    for (std::uint32_t g = 0; g < plan.grains; ++g) {
        ASSERT_EQ(plan.roster[g], g);
    }
}

} // namespace
} // namespace suffuse::contact
