#include "suffuse/calibration/posterior.hpp"

#include "suffuse/base/random.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace suffuse::calibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kept_share = 0.5; // of the samples that a step of temperature leaves effective
constexpr int moves_a_step = 6;    // of each sample, at least
constexpr int most_moves = 200;    // at the last temperature
constexpr double forgotten = 0.1;  // squared correlation with where the moves began
constexpr double wanted_accepted = 0.3;

struct Sample {
    Point point;
    double log_likelihood = 0;
};

class Sampler {
public:
    explicit Sampler(const PosteriorProblem& problem) : problem_(problem), stream_(problem.seed, "posterior") {}

    Posterior run() {
        draw_prior();
        double temperature = 0; // the share of the log likelihood that is in
        while (temperature < problem_.share) {
            const double next = next_temperature(temperature);
            resample(next - temperature);
            temperature = next;
            const bool is_last = temperature >= problem_.share;
            begin_ = samples_;
            for (int move = 0; move < (is_last ? most_moves : moves_a_step); ++move) {
                if (is_last && move >= moves_a_step && remembered() < forgotten) {
                    break;
                }
                move_all(temperature);
            }
        }
        return result();
    }

private:
    void draw_prior() {
        const auto wanted = static_cast<std::size_t>(problem_.samples);
        constexpr int most_tries = 100; // a sample
        for (int k = 0; samples_.size() < wanted; ++k) {
            if (k >= most_tries * problem_.samples) {
                throw std::runtime_error("almost no point of the ranges meets the constraints");
            }
            Point point = design_points(static_cast<std::uint32_t>(k), 1, problem_.dimensions, problem_.seed).front();
            if (!problem_.is_allowed || problem_.is_allowed(point)) {
                const double value = problem_.log_likelihood(point);
                samples_.push_back({std::move(point), value});
            }
        }
        begin_ = samples_;
        keep_best();
    }

    [[nodiscard]] std::vector<double> weights(double step) const {
        double highest = -std::numeric_limits<double>::infinity(), sum = 0;
        for (const Sample& sample : samples_) {
            highest = std::max(highest, sample.log_likelihood);
        }
        std::vector<double> weights;
        weights.reserve(samples_.size());
        for (const Sample& sample : samples_) {
            weights.push_back(std::exp(step * (sample.log_likelihood - highest)));
            sum += weights.back();
        }
        for (double& weight : weights) {
            weight /= sum;
        }
        return weights;
    }

    [[nodiscard]] double effective(double step) const {
        double squares = 0;
        for (const double weight : weights(step)) {
            squares += weight * weight;
        }
        return 1 / squares;
    }

    [[nodiscard]] double next_temperature(double now) const {
        const double wanted = kept_share * static_cast<double>(samples_.size());
        if (effective(problem_.share - now) >= wanted) {
            return problem_.share;
        }
        double low = 0, high = problem_.share - now;
        for (int k = 0; k < 50; ++k) {
            const double middle = (low + high) / 2;
            (effective(middle) >= wanted ? low : high) = middle;
        }
        return now + high;
    }

    /// Systematic: each sample as often as its weight, up to less than one.
    void resample(double step) {
        const std::vector<double> weight = weights(step);
        const double start = stream_.uniform();
        std::vector<Sample> drawn;
        drawn.reserve(samples_.size());
        double sum = 0;
        for (std::size_t k = 0; k < samples_.size(); ++k) {
            sum += weight[k] * static_cast<double>(samples_.size());
            while (static_cast<double>(drawn.size()) + start < sum && drawn.size() < samples_.size()) {
                drawn.push_back(samples_[k]);
            }
        }
        while (drawn.size() < samples_.size()) { // rounding of the sum
            drawn.push_back(samples_.back());
        }
        samples_ = std::move(drawn);
    }

    [[nodiscard]] MatrixXd proposal() const {
        const auto n = static_cast<Index>(samples_.size()), d = static_cast<Index>(problem_.dimensions);
        MatrixXd all(n, d);
        for (Index i = 0; i < n; ++i) {
            all.row(i) = Eigen::Map<const VectorXd>(samples_[i].point.data(), d).transpose();
        }
        const Eigen::RowVectorXd center = all.colwise().mean();
        all.rowwise() -= center;
        MatrixXd covariance = all.transpose() * all / static_cast<double>(n);
        covariance.diagonal().array() += 1e-12; // samples may all be the same
        return MatrixXd(covariance.llt().matrixL()) * (2.38 / std::sqrt(static_cast<double>(d)));
    }

    /// A step of Metropolis for each sample; its length follows how many were taken.
    void move_all(double temperature) {
        const MatrixXd shape = proposal();
        int accepted = 0;
        VectorXd normal(problem_.dimensions);
        for (Sample& sample : samples_) {
            for (double& value : normal) {
                value = stream_.normal();
            }
            const VectorXd step = length_ * (shape * normal);
            const double chance = stream_.uniform();
            Point point = sample.point;
            bool is_inside = true;
            for (Index d = 0; d < step.size(); ++d) {
                point[d] += step[d];
                is_inside = is_inside && point[d] >= 0 && point[d] <= 1;
            }
            if (!is_inside || (problem_.is_allowed && !problem_.is_allowed(point))) {
                continue;
            }
            const double value = problem_.log_likelihood(point);
            if (chance < std::exp(temperature * (value - sample.log_likelihood))) {
                sample = {std::move(point), value};
                ++accepted;
            }
        }
        const double share = static_cast<double>(accepted) / static_cast<double>(samples_.size());
        length_ = std::clamp(length_ * std::exp(share - wanted_accepted), 0.05, 2.0);
        keep_best();
    }

    /// The largest squared correlation of an unknown now with itself where the moves began.
    [[nodiscard]] double remembered() const {
        const auto n = static_cast<Index>(samples_.size());
        double largest = 0;
        for (int d = 0; d < problem_.dimensions; ++d) {
            VectorXd now(n), then(n);
            for (Index i = 0; i < n; ++i) {
                now[i] = samples_[i].point[d];
                then[i] = begin_[i].point[d];
            }
            now.array() -= now.mean();
            then.array() -= then.mean();
            const double norm = now.squaredNorm() * then.squaredNorm();
            largest = std::max(largest, norm > 0 ? std::pow(now.dot(then), 2) / norm : 1.0);
        }
        return largest;
    }

    void keep_best() {
        for (const Sample& sample : samples_) {
            if (best_.point.empty() || sample.log_likelihood > best_.log_likelihood) {
                best_ = sample;
            }
        }
    }

    [[nodiscard]] Posterior result() const {
        Posterior found;
        found.samples.reserve(samples_.size());
        for (const Sample& sample : samples_) {
            found.samples.push_back(sample.point);
        }
        found.effective = static_cast<double>(samples_.size()) * (1 - remembered());
        found.best = best_.point;
        found.best_log_likelihood = best_.log_likelihood;
        return found;
    }

    const PosteriorProblem& problem_;
    RandomStream stream_;
    std::vector<Sample> samples_, begin_;
    Sample best_;
    double length_ = 1;
};

} // namespace

Posterior sample_posterior(const PosteriorProblem& problem) {
    return Sampler(problem).run();
}

} // namespace suffuse::calibration
