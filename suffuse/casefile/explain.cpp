#include "suffuse/casefile/explain.hpp"

#include "suffuse/base/spelling.hpp"
#include "suffuse/casefile/names.hpp"
#include "suffuse/casefile/schema.hpp"
#include "suffuse/casefile/stage_traits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace suffuse::casefile {

namespace {

struct Code {
    std::string_view code, title, text;
};

constexpr std::array code_table = {
    Code{"E100", "the file is not text", "A case or data file is empty, binary, or not UTF-8. Save it as UTF-8 text."},
    Code{
        "E101", "the file is not TOML",
        "The text breaks the rules of TOML at the place shown. Outside of quotes and comments only plain ASCII is "
        "allowed; texts need straight quotes; each key occurs once."},
    Code{"E201", "something is missing", "A required key or table is missing."},
    Code{
        "E203", "unknown key",
        "Keys that the program does not know are errors, so that a misspelt one is not silently ignored."},
    Code{
        "E204", "a name or value is used twice",
        "Stages of one study have different names, for each is a folder and a possible start. Values of "
        "one swept key differ for the same reason."},
    Code{
        "E205", "wrong kind of value",
        "A number where a text is needed, a value where a list is needed, and the like."},
    Code{"E206", "unknown word", "The key has a fixed list of words, and this is none of them."},
    Code{"E207", "keys contradict each other", "Two keys exclude each other, or one requires another."},
    Code{"W208", "a key of earlier versions", "The key no longer has an effect; the rest of the case is read."},
    Code{
        "E209", "bad name",
        "Names of studies, soils, stages and presets become folders: letters, digits, - and _, with . between them, "
        "at most 64. The name of a stage has no ending of files that a run writes: .pvd, .py, .json and .jsonl."},
    Code{"E301", "not a quantity", "The text is no number with a unit that the program knows."},
    Code{
        "E310", "no unit",
        "A value with a dimension is written with its unit, \"100 kPa\": a bare number could be anything."},
    Code{"E311", "wrong dimension", "The unit is of another dimension than the key."},
    Code{"E312", "out of range", "The value is outside the range of the key."},
    Code{"E313", "not finite", "TOML knows inf and nan; no key of a case can be either."},
    Code{"E401", "unknown stage", "`from` names an earlier stage of the same study."},
    Code{"E402", "unknown soil", "`soil` names one of the [soil.NAME] tables of the case."},
    Code{
        "E403", "stages in the wrong order",
        "A stage starts from the end of an earlier one; the first of a study packs or imports its grains."},
    Code{"E404", "unknown preset", "A preset is a [presets.NAME] table; \"standard\" is the case as written."},
    Code{
        "E405", "bad --set",
        "--set KEY=VALUE takes the path of a key, study.NAME.stage.NAME.KEY for a stage, and for one that is swept "
        "study.NAME.sweep.KEY=[VALUE, VALUE]."},
    Code{"E406", "nothing to refine", "`refine` names a key of the study's `sweep`, whose values are quantities."},
    Code{
        "E407", "not a measure of this verb",
        "`measure` requests something that only other verbs have: stress-strain curves, for example, belong to "
        "triaxial tests."},
    Code{
        "E408", "unknown study",
        "--study NAME, and `studies` of a preset, take the NAME of a [study.NAME] table of the case."},
    Code{
        "E409", "a stage that never runs",
        "`only` of a stage names keys of the study's `sweep` or `rows`, and the values for which the stage runs."},
    Code{
        "W409", "a value that is not swept",
        "`only` of a stage names a value that the sweep does not have. Correct it, unless a preset or --set left it "
        "out."},
    Code{"E501", "no such file", "A path in a case starts at the folder of the case."},
    Code{
        "E502", "bad value in a data file",
        "A grading holds plain numbers, one for each column: with a decimal point, or with a decimal comma in all of "
        "them where columns are separated by semicolons or tabs."},
    Code{
        "E503", "grading not monotonic",
        "Percent passing cannot fall as the size grows by more than 0.1 %, and a size may occur twice only where two "
        "analyses meet that agree within 2 %."},
    Code{
        "E504", "impossible grading value",
        "Sizes are above 0, percent passing is between 0 and 100, and a curve runs from 0 to 100 %."},
    Code{"E505", "empty grading", "A grading has a header and at least two points."},
    Code{
        "E506", "bad header of a grading",
        "The first line names the columns, `d [mm],passing [%]`; other units may be in the brackets. Sizes may be "
        "called size, sieve or aperture, and shares finer, cumulative retained or retained on sieve, also in French, "
        "German, Spanish or Italian; what is retained may be a mass, `retained on sieve [g]`, with a line `pan`. "
        "docs/gradings.md has an example of each kind."},
    Code{
        "E507", "nothing between the sizes",
        "`sizes` selects the part of a grading that is modeled; there must be some mass between them."},
    Code{
        "E508", "no surrogate of this curve",
        "Two fractions stand for a soil by the median sizes of its coarse part and of its fines. Both sizes must be on "
        "the measured curve, and apart."},
    Code{
        "W508", "how a grading was read",
        "The reader interpreted or skipped something in the sheet: a pan, a total, a sieve that was not used, plain "
        "numbers that are sieve numbers. If the sentence is true, nothing is wrong."},
    Code{
        "W509", "named columns that end above the last line",
        "A line has no value in the columns that were named, and the lines from there on are not read. `--rows` "
        "selects "
        "other lines."},
    Code{
        "E509", "several samples in one file",
        "A soil of a case has one grading, and the file holds several. `suffuse new --psd FILE --sample NAME` writes a "
        "case with one of them; `suffuse assess FILE` judges all."},
    Code{
        "E601", "a sample too small for its largest grain",
        "The cell would be narrower than three of its largest grains, which then touch their own images. Use more "
        "grains, or cut the coarse end of the grading."},
    Code{"W602", "a narrow cell", "Below ten times the largest grain, results depend on the size of the sample."},
    Code{
        "E603", "overlaps too large",
        "At this stress, grains overlap by more than 5 % of their radius: the contact law no longer describes grains."},
    Code{"W603", "large overlaps", "At this stress, grains overlap by more than 2 % of their radius."},
    Code{
        "W604", "above the critical gradient",
        "Upward seepage at this gradient would lift the whole soil; without [gravity] grains have no weight, and with "
        "it the coarse ones are held."},
    Code{
        "E605", "no fines, or nothing else",
        "Erosion needs to know which grains are fine. With [gravity] a `detach` or `erode` stage finds which fines "
        "move through the coarse grains: its sample must have both."},
    Code{
        "W605", "nothing or everything is fine",
        "Without fines nothing can leave; without coarse grains there is no skeleton."},
    Code{
        "E606", "the grains cannot be drawn",
        "Grains are drawn from the grading before the first step: the limit of the fines must be within the curve, "
        "Kenney and Lau's split must exist if it is specified, and there must be enough grains to follow the curve "
        "within `grading_tolerance`. Where the curve is too wide, the message says at which size to cut it: number "
        "goes as 1/d^3, so that its fine end takes most of the grains. suffuse new --psd FILE --sizes FROM,TO does "
        "it. Or two fractions stand for the soil: suffuse new --psd FILE --surrogate."},
    Code{
        "W607", "few fines, or few coarse grains",
        "Below 100 fine or 50 coarse grains, shares of what leaves and the constrictions of the skeleton are the "
        "chance of one sample: take more grains, or several seeds."},
    Code{
        "E608", "a start from a sample without stress",
        "The pace of a triaxial test, and the size of the loads of stress probes, follow from the stress that the "
        "sample carries, an eroded skeleton settles under it, and contacts keep fines from detaching: a stage that "
        "compacts or settles it comes before."},
    Code{
        "W609", "fine grains squeezed between coarse ones",
        "Contact forces grow as the square of the size, the stiffness of a contact as the size of its smaller grain: "
        "fine grains in the force chains of much coarser ones overlap by far more than grains do on average. A modulus "
        "that grows as the square of the ratio of sizes keeps that small, and costs steps as the ratio."},
    Code{
        "W610", "a skeleton too narrow for more than one pass",
        "Erosion reads the constrictions of the coarse grains, and ends with the pass after which the cell is narrower "
        "than five of their median diameters. The width of the settled cell is estimated from the grains that will be "
        "drawn, at a porosity of 0.4, and warned of up to 5.25. Take more `particles`, or cut the coarse end of the "
        "grading."},
    Code{
        "W611", "a lowered friction that a search replaces",
        "If a void ratio is specified, all protocols but swift find the friction during compaction that leads to it, "
        "and ignore the one given. Leave either out; or take the protocol swift, which keeps the friction and searches "
        "the porosity at its start."},
    Code{
        "W613", "a way to travel where grains do not travel",
        "Only with passes_constriction = { size = \"flow-path\" } do detached grains follow the water, and leave when "
        "they have come the `distance` along it. With any other size they leave at once or not at all, and `forced` "
        "removes them in any case."},
    Code{
        "W614", "entries for passes that are not made",
        "`gradient`, `hold` and `detached` of an erosion may be lists, one entry a pass; `passes` says how many are "
        "made."},
    Code{
        "W615", "a protocol for wider gradings",
        "The protocol wide lends fine grains inertia, so that they roll on much coarser grains as on grains of their "
        "own size. If no grain is four times another, this has no use, and faithful is better validated."},
    Code{
        "W616", "a grading too wide for its protocol",
        "Where coarse grains are many times the size of the fine ones, the other protocols fail or mislead: the servo "
        "of slow rings, swift may not find its pressure, faithful takes ten times the steps of wide and leaves plain "
        "samples looser. docs/limits.md has the numbers."},
    Code{
        "E617", "grains that do not sink",
        "With [gravity] fines have weight less buoyancy: grains must be denser than the fluid."},
    Code{
        "E619", "a layer that is too thin, or a stack that is too narrow",
        "A layer of a stack, and the cell across the layers, have at least three of the largest grains: in less a "
        "grain meets its own image, and a filter has no depth in which a base could stop."},
    Code{
        "E620", "a filter finer than its base",
        "`layers` of a pack stand in the order of the flow. Each has a median size of at least that of the layer "
        "before it: what is finer holds everything, and filters nothing."},
    Code{
        "E621", "a stage that has no meaning in layers",
        "In a stack the first layer is the base: `migrate` moves its grains into the layers that follow, which are "
        "held. The plane between the layers must stay across the flow, so that no stage may shear the cell; and "
        "`detach`, `erode` and `remove` are for fines within one soil."},
    Code{
        "W622", "an unlikely density",
        "A fluid lighter than 500 or heavier than 2000 kg/m^3, or grains lighter than water: was 1 g/cm^3 meant where "
        "1 kg/m^3 is written? Heave, seepage forces and weights follow from both densities."},
    Code{
        "W623", "assumed of a laboratory's record",
        "A convention that neither the headings nor the numbers of a record decide, such as whether a stress is "
        "effective, or a column that nothing names. `suffuse import FILE --kind triaxial` shows all that is read."},
    Code{
        "E618", "a ramp that begins with heave",
        "With [gravity] the fines bear a gradient that rises. Above (1 - n)(rho_s - rho_f)/rho_f upward seepage lifts "
        "the whole soil: the ramp must begin below."},
};

/// A word or symbol with its sign and meaning; docs/notation.md has them all.
struct Convention {
    std::string_view words, text; ///< words between commas: each is known to `explain`
};

constexpr std::array convention_table = {
    Convention{"stress, strain", "compression positive; volumetric strain positive when the sample contracts"},
    Convention{
        "q, p",
        "p = tr sigma/3; q = sqrt(3 J2) of a state, in a triaxial curve the axial minus the mean lateral stress"},
    Convention{"e, n", "e = voids/solid, n = e/(1 + e)"},
    Convention{"e_g, e_eq", "voids with all fines counted as voids, with inactive fines counted as voids"},
    Convention{"active, b", "a grain with at least two contacts; b = active fines/fines, by volume"},
    Convention{"fines_content", "fines/all, by mass"},
    Convention{"Z, Z_m", "contacts per grain, 2 contacts/grains; without rattlers"},
    Convention{"I", "inertial number: strain rate x d50 x sqrt(density/p); slow below 1e-3"},
    Convention{"LL, LS, SS", "contacts of two coarse grains, of a coarse and a fine one, of two fines"},
    Convention{"gradient, i", "grad p = -i rho_w g along the direction of flow, g = 9.81 m/s2 exactly"},
    Convention{"gradings", "percent passing by mass against size, linear in log size between points"},
    Convention{"units", "SI inside; in a case, a value with a dimension is a text with its unit"},
};

std::vector<std::string_view> words_of(const Convention& convention) {
    std::vector<std::string_view> words;
    for (std::size_t at = 0; at < convention.words.size();) {
        const std::size_t end = std::min(convention.words.find(", ", at), convention.words.size());
        words.push_back(convention.words.substr(at, end - at));
        at = end + 2;
    }
    return words;
}

std::string all_conventions() {
    std::string text = "conventions\n";
    for (const Convention& convention : convention_table) {
        text += fmt::format("  {:16} {}\n", convention.words, convention.text);
    }
    return text;
}

/// The line of one word; nothing where it is none.
std::string convention_of(std::string_view what) {
    for (const Convention& convention : convention_table) {
        const auto words = words_of(convention);
        if (std::find(words.begin(), words.end(), what) != words.end()) {
            return fmt::format(
                "{}\n  {}\n  all of them: suffuse explain conventions\n", convention.words, convention.text
            );
        }
    }
    return {};
}

std::string describe(const Key& key) {
    std::string text = fmt::format("{}\n  {}\n  value    {}\n", key_place(key), key.text, value_text(key));
    if (key.is_required) {
        text += "  required\n";
    }
    if (!key.default_text.empty()) {
        text += fmt::format("  default  {}\n", key.default_text);
    }
    return text;
}

std::vector<std::string> parts_of(std::string_view path) {
    std::vector<std::string> parts{""};
    for (const char c : path) {
        if (c == '.') {
            parts.emplace_back();
        } else {
            parts.back() += c;
        }
    }
    return parts;
}

std::string full_name(const Key& key) {
    return key.table.empty() ? key.name : key.table + "." + key.name;
}

/// Where the key stands in a case, "*" for each name that the case gives: study.*.stage.*.prepare.friction, where the
/// key's own table has the verb in place of the stage.
std::vector<std::string> address_of(const Key& key) {
    std::vector<std::string> parts = parts_of(full_name(key));
    if (parts.front() != "stage") {
        return parts;
    }
    const bool has_verb = std::find(names::verbs.begin(), names::verbs.end(), parts[1]) != names::verbs.end();
    parts.erase(parts.begin(), parts.begin() + (has_verb ? 2 : 1));
    const std::vector<std::string> of_stage{"study", "*", "stage", "*"};
    parts.insert(parts.begin(), of_stage.begin(), of_stage.end());
    return parts;
}

/// The key's address with the names that stand at its places in `path`; nothing where the path is not as deep, or lacks
/// a name. A path may be the end of an address, as sweeps have it: stage.NAME.gradient.
std::optional<std::string> address_in(const Key& key, const std::vector<std::string>& path) {
    const std::vector<std::string> address = address_of(key);
    const bool is_end = address.size() > path.size() && path.front() == "stage";
    const std::vector<std::string> parts(address.begin() + (is_end ? 2 : 0), address.end());
    if (parts.size() != path.size()) {
        return std::nullopt;
    }
    std::string text;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        if (path[k].empty()) {
            return std::nullopt;
        }
        text += (k == 0 ? "" : ".") + (parts[k] == "*" ? path[k] : parts[k]);
    }
    return text;
}

/// "watch", "detached.over", "contact.modulus", "stage.erode.watch", "study.one.stage.erosion.watch".
bool is_meant(const Key& key, std::string_view what) {
    const bool is_end_of_name = ("." + full_name(key)).ends_with("." + std::string(what));
    return is_end_of_name || address_in(key, parts_of(what)) == what;
}

/// The keys of a table: "contact", "soil", "erode" for the stages that do it, with those of its inner tables.
std::string keys_of_table(std::string_view what) {
    struct Row {
        std::string path, usual, text;
    };

    std::string title;
    std::vector<Row> rows;
    const std::string name(what);
    for (const std::string& table : {name, "stage." + name, name + ".*"}) {
        for (const Key& key : schema()) {
            const bool is_inner = key.table.starts_with(table + ".") && !key.table.starts_with(table + ".*");
            if (name.empty() || (key.table != table && !is_inner) || key.kind == ValueKind::Table) {
                continue;
            }
            if (name == "stage" && is_inner) {
                continue; // those of one verb
            }
            title = title.empty() ? table_title(table) : title;
            rows.push_back(
                {is_inner ? key.table.substr(table.size() + 1) + "." + key.name : key.name,
                 key.is_required ? "required" : key.default_text, key.text}
            );
        }
    }
    const auto widest = [&](std::string Row::*column) {
        std::size_t width = 0;
        for (const Row& row : rows) {
            width = std::max(width, (row.*column).size());
        }
        return width;
    };
    std::string text = title.empty() ? "" : title + "\n";
    for (const Row& row : rows) {
        text +=
            fmt::format("  {:{}}  {:{}}  {}\n", row.path, widest(&Row::path), row.usual, widest(&Row::usual), row.text);
    }
    return text.empty() || find_verb(name) == nullptr ? text : text + "  what every stage has: suffuse explain stage\n";
}

} // namespace

std::vector<std::string> codes() {
    std::vector<std::string> list;
    for (const Code& code : code_table) {
        list.emplace_back(code.code);
    }
    return list;
}

std::optional<std::string> explain(std::string_view what) {
    if (what == "conventions") {
        return all_conventions();
    }
    for (const Code& code : code_table) {
        if (edit_distance(code.code, what) == 0) {
            return fmt::format("{}: {}\n  {}\n", code.code, code.title, code.text);
        }
    }
    std::string text = convention_of(what) + keys_of_table(what);
    for (const Key& key : schema()) {
        if (is_meant(key, what)) {
            text += fmt::format("{}{}", text.empty() ? "" : "\n", describe(key));
        }
    }
    return text.empty() ? std::nullopt : std::optional(text);
}

std::optional<std::string> nearest_key(std::string_view path) {
    std::vector<std::string> addresses;
    for (const Key& key : schema()) {
        if (const auto address = address_in(key, parts_of(path))) {
            addresses.push_back(*address);
        }
    }
    return nearest_word(path, addresses);
}

std::vector<std::string> topics() {
    std::vector<std::string> words = codes();
    words.emplace_back("conventions");
    for (const Convention& convention : convention_table) {
        for (const std::string_view word : words_of(convention)) {
            words.emplace_back(word);
        }
    }
    for (const Key& key : schema()) {
        words.push_back(key.name);
    }
    words.insert(words.end(), names::verbs.begin(), names::verbs.end());
    std::sort(words.begin(), words.end());
    words.erase(std::unique(words.begin(), words.end()), words.end());
    return words;
}

} // namespace suffuse::casefile
