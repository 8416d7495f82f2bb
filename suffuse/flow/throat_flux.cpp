#include "suffuse/flow/throat_flux.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/quantile.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace suffuse::flow {
namespace {

constexpr int shares = 100;         ///< of the throats, in a distribution
constexpr std::size_t classes = 24; ///< of sizes, equally many throats in each ...
constexpr std::size_t least = 20;   ///< ... which are at least so many, or there are fewer classes

struct Throat {
    double diameter, flux; ///< [m], [m3/s]
};

/// Open throats with the size of their flux.
std::vector<Throat> open_throats(const pores::PoreNetwork& network, std::span<const double> flux) {
    expects(
        network.throats.inscribed_radius.size() == flux.size(), "sizes of throats are measured before their fluxes"
    );
    std::vector<Throat> open;
    for (std::size_t t = 0; t < network.throats.size(); ++t) {
        if (!pores::is_internal(network.throats, t) && network.throats.void_area[t] > 0 &&
            network.throats.hydraulic_radius[t] > 0) {
            open.push_back({2 * network.throats.inscribed_radius[t], std::abs(flux[t])});
        }
    }
    return open;
}

/// Share of the flow through the largest of the throats, and how few of them carry half; `ratio` sorted upward.
void add_concentration(const std::vector<double>& ratio, ThroatFlux& out) {
    std::vector<double> sum{0}; // through the k largest
    for (auto each = ratio.rbegin(); each != ratio.rend(); ++each) {
        sum.push_back(sum.back() + *each);
    }
    for (double& each : sum) {
        each /= sum.back();
    }
    for (int k = 0; k <= shares; ++k) { // sum of 0 .. n throats: a curve of n + 1 points
        out.carried.push_back(quantile_of_sorted(sum, static_cast<double>(k) / shares));
    }
    const auto half = std::lower_bound(sum.begin(), sum.end(), 0.5);
    out.half_carried_by = static_cast<double>(half - sum.begin()) / static_cast<double>(ratio.size());
}

void add_classes(std::vector<Throat> throats, double mean, ThroatFlux& out) {
    std::erase_if(throats, [](const Throat& throat) { return !(throat.diameter > 0); }); // between overlapping grains
    std::sort(throats.begin(), throats.end(), [](const Throat& a, const Throat& b) {
        return a.diameter != b.diameter ? a.diameter < b.diameter : a.flux < b.flux;
    });
    const std::size_t count = std::min(classes, throats.size() / least);
    for (std::size_t k = 0; k < count; ++k) {
        std::vector<double> diameter, ratio;
        for (std::size_t t = k * throats.size() / count; t < (k + 1) * throats.size() / count; ++t) {
            diameter.push_back(throats[t].diameter);
            ratio.push_back(throats[t].flux / mean);
        }
        std::sort(ratio.begin(), ratio.end());
        out.diameter.push_back(quantile_of_sorted(diameter, 0.5));
        out.flux_10.push_back(quantile_of_sorted(ratio, 0.1));
        out.flux_50.push_back(quantile_of_sorted(ratio, 0.5));
        out.flux_90.push_back(quantile_of_sorted(ratio, 0.9));
    }
}

} // namespace

ThroatFlux describe_fluxes(const pores::PoreNetwork& network, std::span<const double> flux, double gradient) {
    expects(flux.size() == network.throats.size(), "there is a flux for each throat");
    std::vector<Throat> throats = open_throats(network, flux);
    ThroatFlux out;
    out.throats = std::ssize(throats);
    std::vector<double> ratio;
    for (const Throat& throat : throats) {
        ratio.push_back(throat.flux);
    }
    std::sort(ratio.begin(), ratio.end());
    const double sum = std::accumulate(ratio.begin(), ratio.end(), 0.0);
    if (!(sum > 0)) {
        return out;
    }
    const double mean = sum / static_cast<double>(ratio.size());
    out.mean = mean / std::abs(gradient);
    for (double& each : ratio) {
        each /= mean;
    }
    for (int k = 0; k <= shares; ++k) {
        out.quantile.push_back(quantile_of_sorted(ratio, static_cast<double>(k) / shares));
    }
    add_concentration(ratio, out);
    add_classes(std::move(throats), mean, out);
    return out;
}

} // namespace suffuse::flow
