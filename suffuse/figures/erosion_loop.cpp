// Figure 7: the erosion loop as a drawing, with a column of counts for each pass next to its arrows.
#include "suffuse/base/escaped.hpp"
#include "suffuse/base/words.hpp"
#include "suffuse/facts/ending_words.hpp"
#include "suffuse/figures/figures.hpp"
#include "suffuse/study/erosion_span.hpp"
#include "suffuse/study/passes.hpp"

#include <fmt/format.h>

namespace suffuse::figures {

namespace {

using erosion::ErosionResult;
using erosion::PassResult;

constexpr std::size_t most_columns = 4; ///< passes drawn; the table below the figure has them all

// Lengths of the drawing, in its own pixels.
constexpr int left = 30, box_width = 300, box_height = 50, line_height = 22, top = 40, column_width = 92;
constexpr int arrow_x = left + 24, label_x = left + 38, columns_x = left + box_width + 20;

struct Quantity {
    const char* name;
    std::vector<std::string> values; ///< one a pass
};

struct Step {
    const char* name;
    std::string what;
    std::vector<Quantity> after; ///< on the arrow that leaves it
};

/// That a pass looked at.
std::size_t fines_of(const PassResult& pass) {
    return pass.mobility ? pass.mobility->id.size() : pass.probe.id.size();
}

/// What the probe of a pass says; left open where it has none.
std::string of_probe(const PassResult& pass, std::string text) {
    return pass.probe.id.empty() ? "–" : std::move(text);
}

template <typename Read>
Quantity quantity(const char* name, const std::vector<const PassResult*>& passes, Read read) {
    Quantity quantity{name, {}};
    for (const PassResult* pass : passes) {
        quantity.values.push_back(read(*pass));
    }
    return quantity;
}

/// @param all of the erosion, of which some passes are drawn
std::vector<Step> steps_of(const std::vector<const PassResult*>& passes, const study::ErosionSpan& all) {
    const bool is_forced = all.is_by_force();
    const auto count = [](auto n) { return grouped(static_cast<long long>(n)); };
    return {
        {"1  Equilibrium",
         "under the stresses held",
         {quantity(
             "fine grains", passes, [&](const PassResult& p) { return fines_of(p) == 0 ? "–" : count(fines_of(p)); }
         )}},
        {"2  Pore flow",
         is_forced ? "for the permeability alone" : "hydraulic gradient i = " + all.gradients(),
         {quantity(
             "fluid force / contact force [-]", passes,
             [](const PassResult& p) { return of_probe(p, short_number(p.probe.fluid_over_contact, 2)); }
         )}},
        {"3  Probe on a copy",
         is_forced                  ? "not used: the removal is forced"
         : passes.front()->mobility ? "coarse grains held, the gradient ramped on fines of weight"
                                    : "coarse grains held, forces ramped on the fines",
         {quantity("detachable", passes, [&](const PassResult& p) { return count(p.detachable); })}},
        {"4  Constrictions",
         is_forced                                ? "not used: the removal is forced"
         : passes.front()->transport.distance > 0 ? "that grains meet on their way with the water"
                                                  : "of the coarse skeleton against grain sizes",
         {quantity(
              "mean constriction of the skeleton [mm]", passes,
              [](const PassResult& p) { return short_number(1e3 * p.constrictions.mean); }
          ),
          quantity("held back", passes, [&](const PassResult& p) { return count(p.held_back); })}},
        {"5  Extraction",
         "from the equilibrium of step 1",
         {quantity("removed", passes, [&](const PassResult& p) { return count(p.removed); }),
          quantity(
              "eroded mass [%]", passes, [](const PassResult& p) { return short_number(p.eroded_mass_percent); }
          )}},
        {"6  New equilibrium",
         "at constant volume, then by the servo",
         {quantity(
              "mean stress p at constant volume [kPa]", passes,
              [](const PassResult& p) { return short_number(dem::mean_stress(p.stress_constant_volume) / 1e3, 4); }
          ),
          quantity(
              "volumetric strain εᵥ [%]", passes,
              [](const PassResult& p) { return percent_beyond_noise(100 * p.volumetric_strain); }
          ),
          quantity(
              "porosity n [-]", passes, [](const PassResult& p) { return fmt::format("{:.4f}", p.porosity_after); }
          )}},
    };
}

std::string
text(int x, int y, const char* css_class, const char* anchor, const std::string& words, const char* more = "") {
    return fmt::format(
        R"(<text class="{}" x="{}" y="{}" text-anchor="{}" fill="#333333"{}>{}</text>)"
        "\n",
        css_class, x, y, anchor, more, escaped(words)
    );
}

std::string draw_box(int y, const Step& step) {
    return fmt::format(
               R"(<rect class="flow-box" x="{}" y="{}" width="{}" height="{}" rx="6" fill="#f4f1ea" stroke="#8a8577"/>)"
               "\n",
               left, y, box_width, box_height
           ) +
           text(left + 14, y + 21, "flow-name", "start", step.name, R"( font-weight="bold")") +
           text(left + 14, y + 39, "flow-what", "start", step.what, R"( font-size="12")");
}

std::string draw_quantity(int y, const Quantity& quantity) {
    std::string out = text(label_x, y, "flow-label", "start", quantity.name, R"( font-size="12")");
    for (std::size_t k = 0; k < quantity.values.size(); ++k) {
        out += text(
            columns_x + column_width * (static_cast<int>(k) + 1) - 10, y, "flow-value", "end", quantity.values[k],
            R"( font-weight="bold")"
        );
    }
    return out;
}

std::string draw(const std::vector<Step>& steps, const std::vector<const PassResult*>& shown) {
    int y = top;
    std::string out;
    for (std::size_t k = 0; k < shown.size(); ++k) {
        out += text(
            columns_x + column_width * (static_cast<int>(k) + 1) - 10, top - 16, "flow-label", "end",
            study::pass_name(shown[k]->pass)
        );
    }
    for (std::size_t s = 0; s < steps.size(); ++s) {
        out += draw_box(y, steps[s]);
        y += box_height;
        const int begin = y;
        y += 18;
        for (const Quantity& quantity : steps[s].after) {
            out += draw_quantity(y + 2, quantity);
            y += line_height;
        }
        y -= 4;
        if (s + 1 < steps.size()) {
            out += fmt::format(
                R"svg(<path class="flow-arrow" d="M{0} {1}V{2}" stroke="#666666" fill="none" marker-end="url(#flow-head)"/>)svg"
                "\n",
                arrow_x, begin, y - 2
            );
        } else {
            out += fmt::format(
                R"svg(<path class="flow-arrow" d="M{0} {1}V{2}H10V{3}H{4}" stroke="#666666" fill="none" marker-end="url(#flow-head)"/>)svg"
                "\n",
                arrow_x, begin, y, top + box_height / 2, left - 2
            );
        }
    }
    const int width = columns_x + column_width * static_cast<int>(shown.size()), height = y + 12;
    return fmt::format(
               R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0} {1}" width="{0}" height="{1}" )"
               R"(font-family="Helvetica, Arial, 'DejaVu Sans', sans-serif" font-size="14" role="img">)"
               "\n"
               R"(<defs><marker id="flow-head" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="8" markerHeight="8" orient="auto">)"
               R"(<path class="flow-head" d="M0 0L8 4L0 8Z" fill="#666666"/></marker></defs>)"
               "\n",
               width, height
           ) +
           out + "</svg>\n";
}

Table table_of(const std::vector<Step>& steps, const std::vector<const PassResult*>& passes) {
    Table table;
    std::vector<std::string> step, quantity;
    std::vector<std::vector<std::string>> values(passes.size());
    for (const Step& each : steps) {
        for (const Quantity& row : each.after) {
            step.emplace_back(each.name);
            quantity.emplace_back(row.name);
            for (std::size_t k = 0; k < passes.size(); ++k) {
                values[k].push_back(row.values[k]);
            }
        }
    }
    table.add("step", std::move(step));
    table.add("quantity", std::move(quantity));
    for (std::size_t k = 0; k < passes.size(); ++k) {
        table.add(fmt::format("pass_{}", passes[k]->pass), std::move(values[k]));
    }
    return table;
}

} // namespace

std::optional<Figure> erosion_loop(const ErosionResult& erosion) {
    if (erosion.passes.empty()) {
        return std::nullopt;
    }
    std::vector<const PassResult*> all, shown;
    for (const PassResult& pass : erosion.passes) {
        all.push_back(&pass);
    }
    shown = all;
    if (shown.size() > most_columns) {
        shown.resize(most_columns - 1);
        shown.push_back(all.back());
    }
    Figure figure;
    figure.id = "fig07";
    figure.section = "Erosion";
    figure.title = "The erosion loop, with this run's counts on its arrows";
    figure.caption = fmt::format("{} {} of the loop took", all.size(), all.size() == 1 ? "turn" : "turns");
    for (const PassResult* pass : shown) {
        figure.caption += fmt::format(
            "{} {} of {} detachable among {} fines", pass == shown.front() ? "" : ", then", grouped(pass->removed),
            grouped(pass->detachable), grouped(static_cast<long long>(fines_of(*pass)))
        );
    }
    const erosion::Ending& ending = erosion.passes.back().verdict;
    figure.caption += ending ? "; it stopped because: " + facts::words_of(ending) + "." : ".";
    const study::ErosionSpan span = *study::span_of({&erosion});
    figure.table = table_of(steps_of(all, span), all);
    figure.drawing = draw(steps_of(shown, span), shown);
    return figure;
}

} // namespace suffuse::figures
