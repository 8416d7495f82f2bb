#pragma once
// The atlas: which gradients move the fines of simulated gap-graded soils. A row is one sample under one flow, made by
// validation/atlas.py; its parts are two fractions of nearly equal grains of 2,650 kg/m3. The rows lie in gradients.csv
// and are built into the program.

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace suffuse::atlas {

enum class Density { Loose, Medium, Dense };
enum class Flow { Up, Level };

/// "loose", "medium", "dense"; "up", "level".
const char* name_of(Density density);
const char* name_of(Flow flow);

/// The gradient that moves a share of the fines' mass; none where the ramp of gradients ended before it.
struct Threshold {
    std::optional<double> gradient;
    bool is_at_most = false; ///< an upper bound: motion had not ended when the gradient rose
};

struct Row {
    double size_ratio = 0;    ///< D50/d50 of the two fractions [-]
    double fines_content = 0; ///< by mass [-]
    int seed = 0;
    Density density = Density::Loose;
    Flow flow = Flow::Up;
    std::int64_t grains = 0;
    double porosity = 0;         ///< [-]
    double alpha = 0;            ///< mean effective stress in the fines over that in the soil [-]
    std::optional<double> heave; ///< i_c, of upward flow alone
    Threshold moves_1, moves_10, moves_50;
    double drag_share = 0;   ///< of the seepage force, on the fines [-]
    double load_bearing = 0; ///< share of the fines' mass that carries load [-]
    double sifting = 0;      ///< share of the fines' mass that falls through the skeleton without any flow [-]
};

/// i_c = (Gs - 1)(1 - n), of a row of level flow too: what gradients of different soils are compared by.
double heave_gradient(const Row& row);

/// The highest gradient of a row's ramp: what was not reached needs more. Upward flow rises no higher than i_c.
double last_gradient(const Row& row);

/// The columns may come in any order. @throws CaseError with the line where a cell is missing or is no number.
std::vector<Row> parse_rows(std::string_view csv);

/// The rows that are built in, and the text that they were read from.
const std::vector<Row>& shipped_rows();
std::string_view shipped_table();

} // namespace suffuse::atlas
