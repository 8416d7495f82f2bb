#include "suffuse/casefile/soil_fields.hpp"

#include "suffuse/base/read_text.hpp"
#include "suffuse/casefile/special_fields.hpp"
#include "suffuse/gradings/read_grading.hpp"
#include "suffuse/grains/grading.hpp"
#include "suffuse/grains/surrogate.hpp"
#include "suffuse/io/text_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace suffuse::casefile {

namespace {

using grains::Grading;

/// A curve from a file; each file is read once a case, however many sweeps use it.
std::optional<Grading>
read_curve_file(Reader& v, const Node& node, gradings::CurveEnds ends, const gradings::ReadingOptions& options = {}) {
    const std::string path = resolved_path(v.context().folder, node.text);
    auto& known = v.context().gradings;
    const auto key = std::pair(path + gradings::command_words(options), ends);
    if (const auto found = known.find(key); found != known.end()) {
        return found->second;
    }
    std::error_code failed;
    if (!std::filesystem::is_regular_file(path, failed)) {
        v.error(
            "E501", node.place,
            fmt::format(
                "there is no file {}{}", path, std::filesystem::is_directory(path, failed) ? ": it is a folder" : ""
            ),
            "paths start at the folder of the case; a grading is a CSV file with the columns `d [mm],passing [%]`"
        );
        return std::nullopt;
    }
    const std::string shown = (std::filesystem::path(v.context().folder) / node.text).lexically_normal().string();
    try {
        const auto source = std::make_shared<Source>(Source{shown, read_whole_file(path)});
        auto grading = gradings::parse_grading(source, v.context().problems, ends, options);
        if (grading) {
            grading->origin = node.text;
        }
        return known[key] = grading;
    } catch (const IoError& problem) {
        v.error("E501", node.place, problem.what(), "make the file readable");
        return std::nullopt;
    }
}

/// A file and how it is read: { file = "soil.csv", size = "1:um", share = "2" }.
std::optional<Grading> read_curve_by_columns(Reader& v, const Node& node, gradings::CurveEnds ends) {
    gradings::ReadingOptions options;
    const Node* file = nullptr;
    std::string sheet;
    const std::vector<std::pair<std::string_view, std::string*>> texts{
        {"size", &options.size},   {"passing", &options.passing}, {"retained", &options.retained},
        {"share", &options.share}, {"mass", &options.mass},       {"by", &options.by},
        {"sheet", &sheet},         {"rows", &options.rows}};
    bool is_good = true;
    for (const auto& [key, place, value] : node.entries) {
        const auto known = std::ranges::find(texts, key, &std::pair<std::string_view, std::string*>::first);
        if (!value.is_text() || (key != "file" && known == texts.end())) {
            v.error(
                value.is_text() ? "E203" : "E205", place, fmt::format("`{}` of a grading in a file", key),
                "texts of `file`, `size`, `passing`, `retained`, `share`, `mass`, `by`, `sheet` and `rows`"
            );
            is_good = false;
        } else if (key == "file") {
            file = &value;
        } else {
            *known->second = value.text;
        }
    }
    options.sheet = io::number_of<std::int64_t>(sheet);
    if (!sheet.empty() && !options.sheet) {
        v.error("E205", node.place, fmt::format("`sheet` is \"{}\"", sheet), "the number of the table, as in \"2\"");
        is_good = false;
    }
    return is_good && file != nullptr ? read_curve_file(v, *file, ends, options) : std::nullopt;
}

/// A curve written out: { d = [...], passing = [...], origin = "..." }.
std::optional<Grading> read_curve_table(Reader& v, const Node& node, gradings::CurveEnds ends) {
    const Node::Entry *sizes = node.find("d"), *shares = node.find("passing"), *origin = node.find("origin");
    for (const auto& [key, place, value] : node.entries) {
        if (key != "d" && key != "passing" && key != "origin") {
            v.error(
                "E203", place, fmt::format("unknown key `{}` in a grading", key),
                "a grading has `d`, `passing` and `origin`", "not a key of a grading"
            );
        }
    }
    if (sizes == nullptr || shares == nullptr) {
        v.error(
            "E201", node.place, "a grading needs the lists `d` and `passing`",
            "as in { d = [\"0.1 mm\", \"1 mm\"], passing = [\"0 %\", \"100 %\"] }"
        );
        return std::nullopt;
    }
    const std::vector<Node>* d = v.list("psd", sizes->value);
    const std::vector<Node>* passing = v.list("psd", shares->value);
    if (d == nullptr || passing == nullptr) {
        return std::nullopt;
    }
    if (d->size() != passing->size()) {
        v.error(
            "E205", shares->value.place,
            fmt::format("a grading needs as many `passing` as `d`, and there are {} and {}", passing->size(), d->size())
        );
        return std::nullopt;
    }
    Key size, share;
    size.name = "d";
    size.kind = ValueKind::Quantity;
    size.dimension = dimension::length;
    share.name = "passing";
    share.kind = ValueKind::Ratio;
    std::vector<gradings::GradingPoint> points;
    for (std::size_t k = 0; k < d->size(); ++k) {
        const auto diameter = v.number(size, (*d)[k]);
        const auto fraction = v.number(share, (*passing)[k]);
        if (diameter && fraction) {
            points.push_back({*diameter, *fraction, (*d)[k].place, (*passing)[k].place});
        }
    }
    if (points.size() != d->size()) {
        return std::nullopt;
    }
    const std::string from = origin != nullptr && origin->value.is_text() ? origin->value.text : "";
    return gradings::make_grading(std::move(points), from, node.place, v.context().problems, ends);
}

std::optional<Grading> read_curve(Reader& v, gradings::CurveEnds ends = gradings::CurveEnds::Closed) {
    const Node* node = v.take("psd");
    if (node == nullptr) {
        return std::nullopt;
    }
    if (node->is_table()) {
        return node->find("file") != nullptr ? read_curve_by_columns(v, *node, ends) : read_curve_table(v, *node, ends);
    }
    if (node->is_text()) {
        return read_curve_file(v, *node, ends);
    }
    v.wrong_type("psd", *node, "the path of a CSV file");
    return std::nullopt;
}

/// The part of the curve between the `sizes`, where they are given: what lies beyond them is left out.
void read_part(Reader& v, grains::Soil& soil) {
    std::vector<double> sizes;
    v.field("sizes", sizes);
    const Node* node = v.take("sizes");
    if (node == nullptr || !soil.whole || sizes.empty()) {
        return;
    }
    const Grading& curve = *soil.whole;
    if (sizes.size() != 2 || !(sizes[0] < sizes[1])) {
        v.error("E205", node->place, "`sizes` needs the finest and the coarsest size", R"(as in ["0.3 mm", "4 mm"])");
        return;
    }
    const double finest = std::max(sizes[0], curve.diameter.front()),
                 coarsest = std::min(sizes[1], curve.diameter.back());
    if (!(grains::passing(curve, finest) < grains::passing(curve, coarsest))) {
        v.error(
            "E507", node->place, "there is no mass between the `sizes`",
            fmt::format(
                "the curve runs from {} to {}", print_quantity(curve.diameter.front(), dimension::length),
                print_quantity(curve.diameter.back(), dimension::length)
            )
        );
        return;
    }
    soil.measured = std::move(soil.whole);
    soil.whole = grains::part_between(*soil.measured, finest, coarsest);
}

/// Two fractions that stand for the curve, which fixes all of them.
void read_surrogate(Reader& v, grains::Soil& soil) {
    if (!v.has("surrogate")) {
        return;
    }
    Place place;
    grains::SurrogateSpec spec;
    std::optional<double> finer_than;
    v.table("surrogate", [&](Reader& inner) {
        place = inner.place();
        inner.field("finer_than", finer_than);
        inner.field("size_ratio", spec.size_ratio);
        inner.field("coarse_width", spec.coarse_width);
        inner.field("fines_width", spec.fines_width);
    });
    for (const char* const key : {"sizes", "coarse", "fines", "fines_content"}) {
        if (v.has(key)) {
            v.error(
                "E207", place, fmt::format("{} has a `surrogate` and also `{}`", v.title(), key),
                fmt::format("leave `{}` out: a surrogate has two fractions, which follow from `psd`", key)
            );
        }
    }
    if (!finer_than || !soil.whole) {
        return; // reported where they are read
    }
    spec.finer_than = *finer_than;
    const std::optional<double> of_curve = grains::size_ratio(*soil.whole, *finer_than);
    if (!of_curve || spec.size_ratio.value_or(*of_curve) < grains::least_size_ratio) {
        v.error(
            "E508", place,
            of_curve
                ? fmt::format("both parts of this curve have nearly the same size: their ratio is {:.3g}", *of_curve)
                : fmt::format(
                      "split at {}, the curve does not show the median size of both parts",
                      print_quantity(*finer_than, dimension::length)
                  ),
            "choose another `finer_than`; suffuse new --psd FILE --surrogate finds one"
        );
        return;
    }
    soil = grains::surrogate_of(*soil.whole, spec);
}

void read_fines(Reader& v, grains::Soil& soil) {
    const Node* node = v.take("fines");
    if (node == nullptr) {
        return;
    }
    if (node->is_text() && node->text == "kenney-lau") {
        soil.kenney_lau = true;
        return;
    }
    if (!node->is_table()) {
        return v.wrong_type("fines", *node, v.key_of("fines").form);
    }
    Reader inner(v.context(), *node, node->place, {"soil.*.fines"}, v.path() + ".fines");
    soil.fines = read_curve(inner);
    inner.field("finer_than", soil.finer_than);
    inner.finish();
    if (inner.has("psd") == inner.has("finer_than")) {
        v.error("E207", node->place, "`fines` needs either `psd` or `finer_than`", "keep one of them");
    }
}

/// One grading with a size, or two with a fines content: nothing in between.
void check_parts(Reader& v, bool fines_have_curve, const Node::Entry* content) {
    const bool has_whole = v.has("psd"), has_coarse = v.has("coarse"), has_content = content != nullptr;
    if (has_whole && has_coarse) {
        v.error(
            "E207", v.place(), fmt::format("{} has both `psd` and `coarse`", v.title()),
            "give `psd` for one grading, or `coarse`, `fines` and `fines_content` for two"
        );
    } else if (!has_whole && !has_coarse) {
        v.error(
            "E201", v.place(), fmt::format("{} needs a grading", v.title()),
            "psd = \"data/sand.csv\", or `coarse`, `fines` and `fines_content`"
        );
    } else if (v.has("sizes") && !has_whole) {
        v.error(
            "E207", v.place(), fmt::format("{} has `sizes` but no `psd` to select from", v.title()),
            "leave `sizes` out: the two gradings define the grains"
        );
    } else if (has_whole && has_content) {
        v.error(
            "E207", content->value.place, // in the soil, or in the sweep that gives it
            fmt::format("{} has a `psd` for all grains, which fixes its fines content", v.title()),
            "leave `fines_content` out here, or give the soil `coarse`, `fines` and `fines_content` instead of `psd`"
        );
    } else if (has_whole && fines_have_curve) {
        v.error(
            "E207", v.place(), fmt::format("{} has a `psd` for all grains and also a second grading", v.title()),
            "write fines = { finer_than = \"0.26 mm\" }, or give `coarse` instead of `psd`"
        );
    } else if (has_coarse && !(fines_have_curve && has_content)) {
        v.error(
            "E201", v.place(),
            fmt::format(
                "{} has a `coarse` part and needs `{}`", v.title(),
                fines_have_curve ? "fines_content" : "fines = { psd = ... }"
            ),
            fines_have_curve
                ? "fines_content = \"20 %\", by mass; also where each study sweeps it, which then replaces it"
                : "a soil of two fractions has `coarse`, `fines` and `fines_content`"
        );
    }
}

Node write_curve(const Grading& grading) {
    std::vector<Node> d, passing;
    for (std::size_t k = 0; k < grading.diameter.size(); ++k) {
        d.push_back(make_node(Scalar(print_quantity(grading.diameter[k], dimension::length))));
        passing.push_back(make_node(Scalar(grading.passing[k])));
    }
    Node curve, table;
    curve.set("d", make_array(std::move(d)));
    curve.set("passing", make_array(std::move(passing)));
    if (!grading.origin.empty()) {
        curve.set("origin", make_node(Scalar(grading.origin)));
    }
    table.set("psd", std::move(curve));
    return table;
}

} // namespace

grains::Soil read_soil(ReadContext& context, const Node& table, const Place& place, const std::string& path) {
    Reader v(context, table, place, {"soil.*"}, path);
    grains::Soil soil;
    const bool may_be_open = v.has("sizes") || v.has("surrogate");
    soil.whole = read_curve(v, may_be_open ? gradings::CurveEnds::MayBeOpen : gradings::CurveEnds::Closed);
    read_part(v, soil);
    read_surrogate(v, soil);
    v.table("coarse", [&](Reader& inner) { soil.coarse = read_curve(inner); });
    read_fines(v, soil);
    const Node::Entry* fines = table.find("fines");
    const bool fines_have_curve = fines != nullptr && fines->value.is_table() && fines->value.find("psd") != nullptr &&
                                  fines->value.find("finer_than") == nullptr;
    v.field("fines_content", soil.fines_content);
    v.field("grading_tolerance", soil.grading_tolerance);
    if (const Node* automatic = v.take("fines_auto")) {
        soil.report_kenney_lau =
            v.find_word("fines_auto", *automatic, v.key_of("fines_auto").choices) == std::optional<std::size_t>(0);
    }
    check_parts(v, fines_have_curve, table.find("fines_content"));
    v.finish();
    return soil;
}

Node write_soil(const grains::Soil& soil) {
    Writer v({"soil.*"});
    Node fines;
    if (soil.measured || soil.whole) {
        v.set("psd", write_curve(soil.measured ? *soil.measured : *soil.whole).find("psd")->value);
    }
    if (soil.surrogate) {
        v.table("surrogate", [&](Writer& inner) {
            inner.field("finer_than", soil.surrogate->finer_than);
            inner.field("size_ratio", soil.surrogate->size_ratio);
            inner.field("coarse_width", soil.surrogate->coarse_width);
            inner.field("fines_width", soil.surrogate->fines_width);
        });
        v.field("grading_tolerance", soil.grading_tolerance);
        return v.node();
    }
    if (soil.measured) {
        v.field("sizes", std::vector{soil.whole->diameter.front(), soil.whole->diameter.back()});
    }
    if (soil.coarse) {
        v.set("coarse", write_curve(*soil.coarse));
    }
    if (soil.fines) {
        v.set("fines", write_curve(*soil.fines));
        v.field("fines_content", soil.fines_content);
    } else if (soil.finer_than) {
        fines.set("finer_than", make_node(Scalar(print_quantity(*soil.finer_than, dimension::length))));
        v.set("fines", std::move(fines));
    } else if (soil.kenney_lau) {
        v.set("fines", make_node("kenney-lau"));
    }
    v.set("fines_auto", make_node(soil.report_kenney_lau ? "kenney-lau" : "none"));
    v.field("grading_tolerance", soil.grading_tolerance);
    return v.node();
}

} // namespace suffuse::casefile
