#include "suffuse/gradings/grading_tables.hpp"

#include "suffuse/base/units.hpp"
#include "suffuse/gradings/grading_shares.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

namespace suffuse::gradings {

namespace {

const GradingPoint& coarsest(const std::vector<GradingPoint>& points) {
    return *std::ranges::max_element(points, {}, &GradingPoint::diameter);
}

const GradingPoint& finest(const std::vector<GradingPoint>& points) {
    return *std::ranges::min_element(points, {}, &GradingPoint::diameter);
}

/// Tables of one sheet, taken one after the other.
class TableJoiner {
public:
    TableJoiner(std::size_t tables, Problems& problems) : tables_(tables), problems_(problems) {}

    void take(const SheetTable& table, std::vector<SoilPoints> soils) {
        ++number_;
        const std::size_t before = soils_.size();
        for (SoilPoints& soil : soils) {
            soil.sample = table.name;
            append_word(soil.sample, soil.name);
            soil.name = tables_ > 1 ? soil.sample : soil.name;
            SoilPoints* above = find_above(table, soil, before);
            if (above != nullptr) {
                if (check_whole(*above, soil, table.dry.has_value()) && check_joint(*above, soil)) {
                    join(*above, std::move(soil));
                }
                continue;
            }
            if (tables_ > 1 && (soil.name.empty() || is_taken(soil.name))) {
                soil.name += fmt::format("{}table {}", soil.name.empty() ? "" : " ", number_);
            }
            soils_.push_back(std::move(soil));
        }
    }

    /// Empty where two tables do not go on, which is reported.
    std::optional<std::vector<SoilPoints>> finish() {
        if (soils_.size() == 1) {
            soils_.front().name.clear();
        }
        return is_good_ ? std::optional(std::move(soils_)) : std::nullopt;
    }

private:
    [[nodiscard]] bool is_taken(const std::string& name) const {
        return std::ranges::find(soils_, name, &SoilPoints::name) != soils_.end();
    }

    /// The curve that a table without a sample's name, or with the same, goes on with: a hydrometer's, or one whose
    /// sizes begin where the other ends.
    SoilPoints* find_above(const SheetTable& table, const SoilPoints& soil, std::size_t before) {
        constexpr double overlap = 1.6; // of sizes: a hydrometer starts above the finest sieve
        for (std::size_t k = before; k-- > 0;) {
            SoilPoints& above = soils_[k];
            const bool is_last = k + 1 == before && table.name.empty() && soil.name.empty();
            const bool goes_on =
                !soil.points.empty() && !above.points.empty() &&
                (table.is_hydrometer || coarsest(soil.points).diameter <= overlap * finest(above.points).diameter);
            if ((is_last || above.name == soil.name) && goes_on) {
                return &above;
            }
        }
        return nullptr;
    }

    /// Masses with a pan of their own below others that have one: a part of what passed was riffled and sieved on.
    bool check_whole(const SoilPoints& above, const SoilPoints& soil, bool has_dry_mass) {
        const bool are_two = above.reading.share_unit == "mass" && soil.reading.share_unit == "mass" && !has_dry_mass;
        if (are_two) {
            problems_.error(
                "E503", soil.points.front().passing_place,
                "a second table of masses goes on below the first, and each has a whole of its own: was a part of what "
                "passed riffled and sieved on?",
                "give masses of the whole sample in one table: multiply those of the part by the mass that passed over "
                "that of the part; or keep this table in a file of its own"
            );
            is_good_ = false;
        }
        return !are_two;
    }

    /// A hydrometer's shares are often of the part that went into its cylinder: then more passes than above.
    bool check_joint(const SoilPoints& above, const SoilPoints& soil) {
        constexpr double tolerance = 0.02; // as of a size that both have
        const GradingPoint& last = finest(above.points);
        for (const GradingPoint& point : soil.points) {
            if (point.diameter < last.diameter && point.passing > last.passing + tolerance) {
                problems_.error(
                    "E503", point.passing_place,
                    fmt::format(
                        "the second table does not continue the curve above: {:.4g} % pass {:.4g} mm, and {:.4g} % the "
                        "coarser {:.4g} mm",
                        100 * point.passing, 1e3 * point.diameter, 100 * last.passing, 1e3 * last.diameter
                    ),
                    fmt::format(
                        "is it of the part alone that passes a sieve? Multiply its shares by what passes that sieve, "
                        "{:.4g} where it is the one of {:.4g} mm; or keep this table in a file of its own",
                        last.passing, 1e3 * last.diameter
                    )
                );
                is_good_ = false;
                return false;
            }
        }
        return true;
    }

    void join(SoilPoints& above, SoilPoints soil) {
        problems_.warning(
            sheet_remark, soil.points.front().diameter_place,
            "a second table begins here and continues the curve above: both are joined into one"
        );
        const auto in_order = [](const std::vector<GradingPoint>& points) {
            return std::ranges::is_sorted(points, {}, &GradingPoint::diameter) ||
                   std::ranges::is_sorted(points, std::greater{}, &GradingPoint::diameter);
        };
        const bool are_ordered = in_order(above.points) && in_order(soil.points);
        above.points.insert(above.points.end(), soil.points.begin(), soil.points.end());
        above.derived.insert(above.derived.end(), soil.derived.begin(), soil.derived.end());
        if (are_ordered) { // each for itself; where they overlap both are measured
            std::ranges::stable_sort(above.points, std::greater{}, &GradingPoint::diameter);
        }
    }

    std::size_t tables_, number_ = 0;
    Problems& problems_;
    std::vector<SoilPoints> soils_;
    bool is_good_ = true;
};

/// The derived values that stand in a soil's column; all of them where it is alone.
std::vector<DerivedValue> derived_of(const TableNotes& notes, std::size_t column, bool is_alone) {
    std::vector<DerivedValue> own;
    for (const DerivedValue& value : notes.derived) {
        if (is_alone || value.column == column) {
            own.push_back(value);
        }
    }
    return own;
}

/// What was lost in sieving is of no known size, and no fines.
void take_losses(SievedSoil& soil, const std::vector<DerivedValue>& derived, Problems& problems) {
    for (const DerivedValue& value : derived) {
        if (value.kind != DerivedValue::Kind::Loss || !value.value) {
            continue;
        }
        const Heading heading = read_heading(value.name); // "Loss (g)"
        const ShareUnit unit = heading.unit == ShareUnit::Unknown ? soil.unit : heading.unit;
        const std::string mass_unit = heading.unit == ShareUnit::Mass ? heading.mass_unit : soil.mass_unit;
        const bool is_mass = unit == ShareUnit::Mass;
        problems.warning(
            sheet_remark, value.place,
            fmt::format(
                "sieving loss of {:.6g}{}, left out", *value.value,
                is_mass                      ? " " + mass_unit
                : unit == ShareUnit::Percent ? " %"
                                             : ""
            )
        );
        if (is_mass && soil.unit == ShareUnit::Mass) {
            soil.lost += *value.value * parse_quantity("1 " + mass_unit, dimension::mass);
        } else if (unit == ShareUnit::Percent && soil.unit == ShareUnit::Percent) {
            soil.lost += *value.value / 100;
        }
    }
}

/// A line `Fines` next to the pan, out of the notes: its number may be a mass. With shares of gravel or sand it is one
/// of several results.
void take_fines(SievedSoil& soil, TableNotes& notes) {
    using Kind = DerivedValue::Kind;
    const bool are_results = std::ranges::any_of(notes.derived, [](const DerivedValue& value) {
        return value.kind == Kind::Gravel || value.kind == Kind::Sand;
    });
    const auto fines = std::ranges::find_if(notes.derived, [&soil](const DerivedValue& value) {
        return value.kind == Kind::Fines && value.value && value.column == soil.column && value.unit != "%" &&
               value.name.find('%') == std::string::npos && read_heading(value.name).unit != ShareUnit::Percent;
    });
    if (soil.unit != ShareUnit::Mass || !soil.pan || are_results || fines == notes.derived.end()) {
        return;
    }
    const Heading heading =
        read_heading(fines->unit.empty() ? fines->name : fmt::format("fines ({})", fines->unit)); // "Fines (g)"
    const bool is_mass = heading.unit == ShareUnit::Mass;
    const std::string unit = is_mass ? heading.mass_unit : soil.mass_unit;
    soil.fines = {
        100 * *fines->value, parse_quantity("1 " + unit, dimension::mass), is_mass, fines->name, fines->place};
    notes.derived.erase(fines);
}

SheetReading reading_of(const SievedSoil& soil) {
    const char* const unit = soil.unit == ShareUnit::Mass       ? "mass"
                             : soil.unit == ShareUnit::Count    ? "number"
                             : soil.unit == ShareUnit::Fraction ? "shares of 1"
                             : soil.unit == ShareUnit::PerMille ? "\u2030"
                                                                : "%";
    const char* const flag = soil.meaning == ShareMeaning::Passing              ? "passing"
                             : soil.meaning == ShareMeaning::CumulativeRetained ? "retained"
                             : soil.unit == ShareUnit::Percent                  ? "share"
                                                                                : "mass";
    return {soil.size_heading, soil.size_unit, soil.heading, std::string(words_of(soil.meaning)), unit, flag};
}

} // namespace

std::optional<std::vector<SoilPoints>>
points_of(std::vector<SievedSoil> soils, const TableNotes& notes, Problems& problems) {
    std::vector<SoilPoints> found;
    bool is_good = true;
    agree_on_meaning(soils);
    for (SievedSoil& soil : soils) {
        auto derived = derived_of(notes, soil.column, soils.size() == 1);
        take_losses(soil, derived, problems);
        auto points = find_passing(soil, problems);
        is_good = is_good && points;
        if (points) {
            found.push_back({soil.name, soil.name, std::move(*points), std::move(derived), reading_of(soil)});
        }
    }
    return is_good ? std::optional(std::move(found)) : std::nullopt;
}

std::optional<std::vector<SoilPoints>> read_tables(std::vector<SheetTable>& tables, Problems& problems) {
    TableJoiner joiner(tables.size(), problems);
    bool is_good = true;
    for (SheetTable& table : tables) {
        auto soils = read_sieve_rows(table.sheet, *table.columns, problems);
        if (soils) {
            std::ranges::for_each(*soils, [&table](SievedSoil& soil) { take_fines(soil, table.notes); });
        }
        remark_on_notes(table.notes, problems);
        if (soils && soils->size() == 1) {
            soils->front().dry = table.dry;
        }
        if (soils && table.unused_mass &&
            std::ranges::any_of(*soils, [](const SievedSoil& soil) { return soil.unit == ShareUnit::Mass; })) {
            problems.warning(
                sheet_remark, *table.unused_mass, "no mass of the whole sample is taken from the titles",
                "state one `dry mass (g)` if the shares are of it"
            );
        }
        auto points = soils ? points_of(std::move(*soils), table.notes, problems) : std::nullopt;
        is_good = is_good && points;
        if (points) {
            joiner.take(table, std::move(*points));
        }
    }
    auto joined = joiner.finish();
    return is_good ? std::move(joined) : std::nullopt;
}

} // namespace suffuse::gradings
