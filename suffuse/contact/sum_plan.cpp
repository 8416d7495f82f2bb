#include "suffuse/contact/sum_plan.hpp"

#include "suffuse/neighbors/pair_list.hpp"

namespace suffuse::contact {
namespace {

/// Columns that were longer once do not keep their memory.
template <class Column>
void resize_exactly(Column& column, std::size_t rows) {
    if (column.capacity() > rows + rows / 4) {
        column = {};
    }
    column.resize(rows);
}

void plan_images(const Contacts& contacts, SumPlan& plan) {
    plan.images.assign(1, cell::Image{}); // the home period first
    resize_exactly(plan.image, contacts.size());
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        plan.image[c] = neighbors::image_row(plan.images, contacts.image[c]);
    }
}

/// Rows of the sums for what other domains exert: ordered by grain, and for each grain by contact.
void plan_remote_rows(const Contacts& contacts, SumPlan& plan) {
    const auto domain_of = [&](std::uint32_t grain) { return grain / plan.domain_grains; };
    std::vector<std::uint32_t> next(plan.grains + 1, 0);
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        if (domain_of(contacts.second[c]) != domain_of(contacts.first[c])) {
            ++next[contacts.second[c] + 1];
        }
    }
    plan.remote_grain.clear();
    plan.remote_start.assign(1, static_cast<std::uint32_t>(plan.grains));
    next[0] = static_cast<std::uint32_t>(plan.grains);
    for (std::uint32_t g = 0; g < plan.grains; ++g) {
        plan.remote_grain.insert(plan.remote_grain.end(), next[g + 1], g);
        next[g + 1] += next[g];
        if ((g + 1) % plan.domain_grains == 0 || g + 1 == plan.grains) {
            plan.remote_start.push_back(next[g + 1]);
        }
    }
    resize_exactly(plan.second_sum, contacts.size());
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        const std::uint32_t j = contacts.second[c];
        plan.second_sum[c] = domain_of(j) == domain_of(contacts.first[c]) ? j : next[j]++;
    }
}

} // namespace

void plan_sums(const Contacts& contacts, std::size_t grains, SumPlan& plan) {
    plan.grains = grains;
    plan.domain_grains = domain_size(grains);
    plan_images(contacts, plan);
    plan_remote_rows(contacts, plan);
    plan.domain_start.assign((grains + plan.domain_grains - 1) / plan.domain_grains + 1, 0);
    for (const std::uint32_t first : contacts.first) {
        ++plan.domain_start[first / plan.domain_grains + 1];
    }
    for (std::size_t d = 1; d < plan.domain_start.size(); ++d) {
        plan.domain_start[d] += plan.domain_start[d - 1];
    }
}

} // namespace suffuse::contact
