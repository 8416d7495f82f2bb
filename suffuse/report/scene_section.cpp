#include "suffuse/report/scene_section.hpp"

#include "suffuse/base/base64.hpp"
#include "suffuse/base/words.hpp"
#include "suffuse/report/html.hpp"
#include "suffuse/report/still.hpp"

#include <fmt/format.h>

namespace suffuse::report {

namespace {

std::string count_table(const Scene& scene, Numbering& numbering) {
    std::vector<std::vector<std::string>> rows;
    for (const SceneState& state : scene.states) {
        const SceneCount count = count_scene(scene, state);
        const double ends = 2 * static_cast<double>(count.contacts);
        rows.push_back(
            {state.label, grouped(count.grains), grouped(count.fines), grouped(count.rattlers), grouped(count.contacts),
             count.grains > 0 ? fmt::format("{:.2f}", ends / static_cast<double>(count.grains)) : "–",
             short_number(count.mean_force), short_number(count.largest_force), grouped(count.strong)}
        );
    }
    std::vector<bool> numeric(9, true);
    numeric[0] = false;
    return html_table(
        {"state", "grains", "fines", "with fewer than 2 contacts", "contacts", "coordination Z [-]",
         "mean normal force [N]", "largest [N]", "contacts above the mean"},
        rows, numeric, "scene-counts",
        fmt::format("<b>{} Grains and contacts of each state.</b>", numbering.next_table())
    );
}

std::string stills(const Scene& scene) {
    std::string out = "<div class=\"stills\">\n";
    for (const std::size_t k : still_states(scene)) {
        const SceneState& state = scene.states[k];
        out += fmt::format(
            "<figure class=\"still\"><img alt=\"{0} grains in their cell, {1}; fines in red, coarse grains in sand\" "
            "width=\"450\" height=\"450\" src=\"data:image/png;base64,{2}\"><figcaption>{3}: {0} "
            "grains</figcaption></figure>\n",
            grouped(count_scene(scene, state).grains), escaped(state.label), base64(still_picture(scene, state)),
            escaped(as_sentence(state.label))
        );
    }
    return out + "</div>\n";
}

const char* const view_places =
    "<div class=\"view3d\" data-scene hidden>\n<div class=\"stage\"><div class=\"picture\" tabindex=\"0\" "
    "role=\"application\" "
    "aria-label=\"Grains in 3D. Arrow keys turn, plus and minus zoom, Enter chooses the grain in the middle, Escape "
    "lets it go, Home resets.\"></div>\n<p class=\"quiet keys\">Drag to turn, scroll to zoom, click a grain. Keys: "
    "arrows, + and −, Enter, Escape, Home.</p></div>\n<div class=\"panel\" role=\"group\" aria-label=\"What the view "
    "shows\"></div>\n</div>\n"
    "<p class=\"missing\" role=\"note\" data-no-view hidden>The view in 3D needs WebGL 2, which this browser does not "
    "offer here (<span></span>): still pictures stand in for it. Another browser, or hardware acceleration switched on "
    "in the settings, brings it back.</p>\n";

const char* const plain_scene_sentence =
    "<p class=\"quiet\">Still pictures: the view that can be turned needs the page's script, see above.</p>\n";

} // namespace

std::vector<std::size_t> still_states(const Scene& scene) {
    if (scene.states.empty()) {
        return {};
    }
    return scene.states.size() == 1 ? std::vector<std::size_t>{0}
                                    : std::vector<std::size_t>{0, scene.states.size() - 1};
}

std::string scene_section(const Scene& scene, bool has_script, bool has_stills, Numbering& numbering) {
    std::string out;
    if (!scene.remark.empty()) {
        out += "<p>" + escaped(kept_together(scene.remark)) + "</p>\n";
    }
    out += has_script ? view_places : plain_scene_sentence;
    return out + (has_stills ? "" : stills(scene)) + count_table(scene, numbering);
}

} // namespace suffuse::report
