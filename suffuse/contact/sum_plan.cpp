#include "suffuse/contact/sum_plan.hpp"

#include "suffuse/base/parallel.hpp"
#include "suffuse/neighbors/number_images.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace suffuse::contact {
namespace {

/// Columns that were longer once do not keep their memory.
template <class Column>
void resize_exactly(Column& column, std::size_t rows) {
    if (column.capacity() > rows + rows / 4) {
        column = Column();
    }
    column.resize(rows);
}

/// Calls `work(d)` for each domain.
template <class Work>
void for_each_domain(const SumPlan& plan, Work&& work) {
    parallel_for(plan.domains(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t d = begin; d < end; ++d) {
            work(d);
        }
    });
}

void plan_domains(const ContactPairs& contacts, SumPlan& plan) {
    const std::size_t domains = (plan.grains + domain_grains - 1) / domain_grains;
    plan.domain_start.resize(domains + 1);
    for (std::size_t d = 0; d <= domains; ++d) {
        const auto start = std::ranges::lower_bound(contacts.first, d * domain_grains);
        plan.domain_start[d] = static_cast<std::uint32_t>(start - contacts.first.begin());
    }
}

void plan_images(const ContactPairs& contacts, SumPlan& plan) {
    resize_exactly(plan.image, contacts.size());
    neighbors::number_images(
        plan.domain_start, [&](std::size_t c) { return contacts.image[c]; }, plan.image, plan.images
    );
}

/// Contacts of one domain whose second grain lies in another.
struct Exit {
    std::uint32_t to;
    std::uint32_t rows; ///< at first how many, then the place of the next one
};

/// In rising order. The first grain of a pair is never the later one: all lead to later domains.
std::vector<Exit> find_exits(const ContactPairs& contacts, const SumPlan& plan, std::size_t from) {
    std::vector<std::uint32_t> to;
    for (std::size_t c = plan.domain_start[from]; c < plan.domain_start[from + 1]; ++c) {
        const auto domain = static_cast<std::uint32_t>(contacts.second[c] / domain_grains);
        if (domain != from) {
            to.push_back(domain);
        }
    }
    std::ranges::sort(to);
    std::vector<Exit> exits;
    for (const std::uint32_t domain : to) {
        if (exits.empty() || exits.back().to != domain) {
            exits.push_back({domain, 0});
        }
        ++exits.back().rows;
    }
    return exits;
}

void plan_reach(const std::vector<std::vector<Exit>>& exits, SumPlan& plan) {
    plan.reach.clear();
    plan.reach_start.assign(1, 0);
    plan.reached_by.assign(exits.size(), 1); // by itself
    for (std::size_t from = 0; from < exits.size(); ++from) {
        plan.reach.push_back(static_cast<std::uint32_t>(from));
        for (const Exit& exit : exits[from]) {
            plan.reach.push_back(exit.to);
            ++plan.reached_by[exit.to];
        }
        plan.reach_start.push_back(static_cast<std::uint32_t>(plan.reach.size()));
    }
}

/// Gives each domain's rows a run, those from one domain after those from another.
void place_exits(std::vector<std::vector<Exit>>& exits, SumPlan& plan) {
    plan.remote_start.assign(exits.size() + 1, 0);
    for (const auto& from : exits) {
        for (const Exit& exit : from) {
            plan.remote_start[exit.to] += exit.rows;
        }
    }
    std::exclusive_scan(plan.remote_start.begin(), plan.remote_start.end(), plan.remote_start.begin(), 0U);
    std::vector<std::uint32_t> next = plan.remote_start;
    for (auto& from : exits) {
        for (Exit& exit : from) {
            const std::uint32_t place = next[exit.to];
            next[exit.to] += std::exchange(exit.rows, place);
        }
    }
}

/// Rows of the sums for what other domains exert, in the order of the table.
void plan_remote_rows(const ContactPairs& contacts, SumPlan& plan) {
    std::vector<std::vector<Exit>> exits(plan.domains());
    for_each_domain(plan, [&](std::size_t from) { exits[from] = find_exits(contacts, plan, from); });
    plan_reach(exits, plan);
    place_exits(exits, plan);
    resize_exactly(plan.remote, plan.remote_start.back());
    resize_exactly(plan.second_sum, contacts.size());
    for_each_domain(plan, [&](std::size_t from) {
        for (std::size_t c = plan.domain_start[from]; c < plan.domain_start[from + 1]; ++c) {
            const std::uint32_t grain = contacts.second[c];
            const auto to = static_cast<std::uint32_t>(grain / domain_grains);
            plan.second_sum[c] = grain;
            if (to != from) {
                const auto exit = std::ranges::lower_bound(exits[from], to, {}, &Exit::to);
                plan.remote[exit->rows] = grain;
                plan.second_sum[c] = static_cast<std::uint32_t>(plan.grains) + exit->rows++;
            }
        }
    });
}

/// With one thread there are none.
void plan_far_rows(const ContactPairs& contacts, SumPlan& plan) {
    const std::size_t domains = plan.domains();
    plan.far.resize(domains);
    if (plan.grains > cached_grains) {
        return;
    }
    for_each_domain(plan, [&](std::size_t d) {
        plan.far[d].clear();
        std::size_t end = d; // of the domains of this thread
        while (end < domains && home_of(end, domains) == home_of(d, domains)) {
            ++end;
        }
        for (std::size_t c = plan.domain_start[d]; end < domains && c < plan.domain_start[d + 1]; ++c) {
            if (contacts.second[c] >= end * domain_grains) {
                plan.far[d].push_back(static_cast<std::uint32_t>(c));
            }
        }
    });
}

/// Who is in a row of the table: a first grain, a second of the same domain, or one that its domain collects for.
void plan_roster(const ContactPairs& contacts, std::span<const std::uint8_t> always, SumPlan& plan) {
    plan.roster.resize(plan.grains);
    plan.awake_end.resize(plan.domains());
    for_each_domain(plan, [&](std::size_t d) {
        const std::size_t begin = d * domain_grains, end = std::min(plan.grains, begin + domain_grains);
        std::vector<std::uint8_t> awake(end - begin, 0);
        if (!always.empty()) {
            std::ranges::copy(always.subspan(begin, end - begin), awake.begin());
        }
        for (std::size_t c = plan.domain_start[d]; c < plan.domain_start[d + 1]; ++c) {
            awake[contacts.first[c] - begin] = 1;
            if (plan.second_sum[c] < plan.grains) {
                awake[contacts.second[c] - begin] = 1;
            }
        }
        for (std::size_t k = plan.remote_start[d]; k < plan.remote_start[d + 1]; ++k) {
            awake[plan.remote[k] - begin] = 1;
        }
        auto next = static_cast<std::uint32_t>(begin);
        for (const std::uint8_t kind : {std::uint8_t{1}, std::uint8_t{0}}) {
            for (std::size_t g = begin; g < end; ++g) {
                if (awake[g - begin] == kind) {
                    plan.roster[next++] = static_cast<std::uint32_t>(g);
                }
            }
            if (kind == 1) {
                plan.awake_end[d] = next;
            }
        }
    });
}

} // namespace

void plan_sums(const ContactPairs& contacts, std::size_t grains, SumPlan& plan, std::span<const std::uint8_t> awake) {
    plan.grains = grains;
    plan_domains(contacts, plan);
    plan_images(contacts, plan);
    plan_remote_rows(contacts, plan);
    plan_far_rows(contacts, plan);
    plan_roster(contacts, awake, plan);
}

} // namespace suffuse::contact
