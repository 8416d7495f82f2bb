#include "suffuse/gradings/plain_sizes.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace suffuse::gradings {

namespace {

class ScaleFinder {
public:
    ScaleFinder(const Sheet& sheet, const GradingColumns& columns) : sheet_(sheet), columns_(columns) {}

    [[nodiscard]] bool has_plain() const { return plain_ > 0; }

    /// Whether some sizes have a unit other than mm and others none, under a heading that does not say.
    [[nodiscard]] bool mixes_units() const {
        return columns_.size.scale == SizeScale::Unknown && plain_ > 0 && foreign_ > 0;
    }

    /// Reads the sizes as numbers of sieves where they only rise and fall as they should that way.
    SizeScale find() {
        constexpr std::size_t least = 3; // of sizes that show a scale
        const SizeScale named = columns_.size.scale;
        read_cells();
        if (named == SizeScale::SieveNumber) { // "Sieve No." above 4.75, 2.36 ...: those are openings
            return plain_ > 0 && whole_ == 0 ? SizeScale::Millimeters : named;
        }
        if (named == SizeScale::Unknown && smallest_ < 0 && are_phi_ && plain_ >= least) { // no grain is below nothing
            return SizeScale::Phi;
        }
        constexpr double widest = 2000, coarse = 60; // [mm] of what anybody sieves; of stones
        if (named == SizeScale::Unknown && largest_ > widest && smallest_ < coarse) {
            return SizeScale::Micrometers;
        }
        if (named != SizeScale::Unknown || plain_ == 0 || whole_ != plain_ || numbered_ != plain_) {
            return named;
        }
        const bool as_numbers = is_ordered(SizeScale::SieveNumber), as_openings = is_ordered(SizeScale::Millimeters);
        return as_numbers && !as_openings ? SizeScale::SieveNumber : named;
    }

private:
    void read_cells() {
        for (std::size_t k = columns_.first_row; k < sheet_.rows.size(); ++k) {
            const std::string text = split_size_text(text_at(sheet_.rows[k], columns_.size.index)).text;
            const auto size = read_sieve_size(text, SizeScale::Millimeters, sheet_.mark != ',');
            if (sheet_.rows[k].is_comment || !size) {
                continue;
            }
            rows_.push_back(k);
            foreign_ += size->notation == SizeNotation::WithUnit && text.find("mm") == std::string::npos ? 1U : 0U;
            if (size->notation == SizeNotation::Plain) {
                const double number = size->diameter * 1e3;
                are_phi_ = are_phi_ && std::abs(4 * number - std::round(4 * number)) < 1e-9; // in quarters
                largest_ = std::max(largest_, number), smallest_ = std::min(smallest_, number);
                ++plain_;
                whole_ += text.find_first_of(".,") == std::string::npos ? 1U : 0U;
                numbered_ += read_sieve_size(text, SizeScale::SieveNumber)->is_on_scale && number > 0 ? 1U : 0U;
            }
        }
    }

    /// Whether sizes go one way, and a share that is named as passing goes with them.
    [[nodiscard]] bool is_ordered(SizeScale scale) const {
        const ShareColumn& share = columns_.shares.front();
        std::vector<double> sizes, shares;
        for (const std::size_t k : rows_) {
            const std::string text = split_size_text(text_at(sheet_.rows[k], columns_.size.index)).text;
            const auto size = read_sieve_size(text, scale, sheet_.mark != ',');
            const auto value = number_at(sheet_, sheet_.rows[k], share.index);
            if (size && value) {
                sizes.push_back(size->diameter), shares.push_back(*value);
            }
        }
        const bool rise = std::ranges::is_sorted(sizes), fall = std::ranges::is_sorted(sizes, std::greater{});
        if (share.meaning != ShareMeaning::Passing || !(rise || fall)) {
            return rise || fall;
        }
        return rise ? std::ranges::is_sorted(shares) : std::ranges::is_sorted(shares, std::greater{});
    }

    const Sheet& sheet_;
    const GradingColumns& columns_;
    std::vector<std::size_t> rows_;
    std::size_t plain_ = 0, whole_ = 0, numbered_ = 0, foreign_ = 0;
    bool are_phi_ = true;
    double largest_ = 0, smallest_ = std::numeric_limits<double>::infinity();
};

} // namespace

PlainSizes judge_plain_sizes(const Sheet& sheet, const GradingColumns& columns) {
    ScaleFinder finder(sheet, columns);
    const SizeScale scale = finder.find();
    return {scale, finder.has_plain(), finder.mixes_units()};
}

} // namespace suffuse::gradings
