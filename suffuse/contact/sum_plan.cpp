#include "suffuse/contact/sum_plan.hpp"

#include "suffuse/base/parallel.hpp"
#include "suffuse/neighbors/pair_list.hpp"

#include <algorithm>
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
    const std::size_t domains = (plan.grains + plan.domain_grains - 1) / plan.domain_grains;
    plan.domain_start.resize(domains + 1);
    for (std::size_t d = 0; d <= domains; ++d) {
        const auto start = std::ranges::lower_bound(contacts.first, d * plan.domain_grains);
        plan.domain_start[d] = static_cast<std::uint32_t>(start - contacts.first.begin());
    }
}

/// Each domain numbers the images that it meets, the home period first; then all of them get one numbering.
void plan_images(const ContactPairs& contacts, SumPlan& plan) {
    std::vector<std::vector<cell::Image>> met(plan.domains());
    resize_exactly(plan.image, contacts.size());
    for_each_domain(plan, [&](std::size_t d) {
        met[d].assign(1, cell::Image{});
        for (std::size_t c = plan.domain_start[d]; c < plan.domain_start[d + 1]; ++c) {
            plan.image[c] = neighbors::image_row(met[d], contacts.image[c]);
        }
    });
    plan.images.assign(1, cell::Image{});
    std::vector<std::vector<std::uint16_t>> number(plan.domains());
    for (std::size_t d = 0; d < plan.domains(); ++d) {
        for (const cell::Image& image : met[d]) {
            number[d].push_back(neighbors::image_row(plan.images, image));
        }
    }
    for_each_domain(plan, [&](std::size_t d) {
        for (std::size_t c = plan.domain_start[d]; c < plan.domain_start[d + 1]; ++c) {
            plan.image[c] = number[d][plan.image[c]];
        }
    });
}

/// Rows of the sums for what other domains exert, in the order of the table.
void plan_remote_rows(const ContactPairs& contacts, SumPlan& plan) {
    const std::size_t domains = plan.domains();
    const auto domain_of = [&](std::uint32_t grain) { return grain / plan.domain_grains; };
    std::vector<std::uint32_t> place(domains * domains); // of what goes from one domain to another: first its number
    for_each_domain(plan, [&](std::size_t from) {
        for (std::size_t c = plan.domain_start[from]; c < plan.domain_start[from + 1]; ++c) {
            const std::size_t to = domain_of(contacts.second[c]);
            place[from * domains + to] += to != from ? 1 : 0;
        }
    });
    plan.reach.clear();
    plan.reach_start.assign(1, 0);
    plan.reached_by.assign(domains, 0);
    for (std::size_t from = 0; from < domains; ++from) {
        for (std::size_t to = from; to < domains; ++to) {
            if (to == from || place[from * domains + to] > 0) {
                plan.reach.push_back(static_cast<std::uint32_t>(to));
                ++plan.reached_by[to];
            }
        }
        plan.reach_start.push_back(static_cast<std::uint32_t>(plan.reach.size()));
    }
    plan.remote_start.assign(1, 0);
    std::uint32_t collected = 0;
    for (std::size_t to = 0; to < domains; ++to) {
        for (std::size_t from = 0; from < domains; ++from) {
            collected += std::exchange(place[from * domains + to], collected);
        }
        plan.remote_start.push_back(collected);
    }
    resize_exactly(plan.remote, collected);
    resize_exactly(plan.second_sum, contacts.size());
    for_each_domain(plan, [&](std::size_t from) {
        for (std::size_t c = plan.domain_start[from]; c < plan.domain_start[from + 1]; ++c) {
            const std::uint32_t grain = contacts.second[c];
            const std::size_t to = domain_of(grain);
            plan.second_sum[c] = grain;
            if (to != from) {
                const std::uint32_t k = place[from * domains + to]++;
                plan.remote[k] = grain;
                plan.second_sum[c] = static_cast<std::uint32_t>(plan.grains) + k;
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
            if (contacts.second[c] >= end * plan.domain_grains) {
                plan.far[d].push_back(static_cast<std::uint32_t>(c));
            }
        }
    });
}

/// Who is in a row of the table: a first grain, a second of the same domain, or one that its domain collects for.
void plan_roster(const ContactPairs& contacts, SumPlan& plan) {
    plan.roster.resize(plan.grains);
    plan.awake_end.resize(plan.domains());
    for_each_domain(plan, [&](std::size_t d) {
        const std::size_t begin = d * plan.domain_grains, end = std::min(plan.grains, begin + plan.domain_grains);
        std::vector<std::uint8_t> awake(end - begin, 0);
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

void plan_sums(const ContactPairs& contacts, std::size_t grains, SumPlan& plan) {
    plan.grains = grains;
    plan.domain_grains = domain_size(grains);
    plan_domains(contacts, plan);
    plan_images(contacts, plan);
    plan_remote_rows(contacts, plan);
    plan_far_rows(contacts, plan);
    plan_roster(contacts, plan);
}

} // namespace suffuse::contact
