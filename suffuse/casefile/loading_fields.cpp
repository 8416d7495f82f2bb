// Special fields of cells and loads: three axes, each with its own control.

#include "suffuse/casefile/special_fields.hpp"

#include <fmt/format.h>

#include <array>

namespace suffuse::casefile {

namespace {

constexpr std::string_view unset = "-"; ///< an axis that the other key gives

using Axes = std::array<std::optional<double>, 3>;

/// Three entries, each a quantity or "-".
std::optional<Axes> read_axes(Reader& v, std::string_view key, const Node& node) {
    const std::vector<Node>* items = v.list(key, node);
    if (items == nullptr) {
        return std::nullopt;
    }
    if (items->size() != 3) {
        v.error(
            "E205", node.place, fmt::format("`{}` needs three values, and there are {}", key, items->size()),
            "one for each axis, x, y, z"
        );
        return std::nullopt;
    }
    Axes axes;
    bool is_good = true;
    for (std::size_t a = 0; a < 3; ++a) {
        const Node& item = (*items)[a];
        if (item.is_text() && item.text == unset) {
            continue;
        }
        axes[a] = v.number(key, item);
        is_good = is_good && axes[a];
    }
    return is_good ? std::optional(axes) : std::nullopt;
}

std::optional<Node>
write_axes(const Writer& v, std::string_view key, const cell::Loading& loading, cell::Control control) {
    std::vector<Node> items;
    bool is_used = false;
    for (const cell::AxisControl& axis : loading.axis) {
        const bool is_mine = axis.control == control;
        is_used = is_used || is_mine;
        items.push_back(is_mine ? v.number(key, axis.value) : make_node("-"));
    }
    return is_used ? std::optional(make_array(std::move(items))) : std::nullopt;
}

std::optional<Mat3> read_rows(Reader& v, std::string_view key, const std::vector<Node>& rows) {
    Mat3 matrix;
    bool is_good = true;
    for (int a = 0; a < 3; ++a) {
        const auto row = v.vector(key, rows[static_cast<std::size_t>(a)]);
        is_good = is_good && row;
        if (row) {
            matrix[a] = {row->x, row->y, row->z};
        }
    }
    return is_good ? std::optional(matrix) : std::nullopt;
}

Node write_rows(const Writer& v, std::string_view key, const Mat3& matrix) {
    return make_array({v.vector(key, matrix.row(0)), v.vector(key, matrix.row(1)), v.vector(key, matrix.row(2))});
}

std::optional<Mat3> read_gradient(Reader& v, const Node& node) {
    const std::vector<Node>* rows = v.list("velocity_gradient", node);
    if (rows == nullptr) {
        return std::nullopt;
    }
    if (rows->size() != 3) {
        v.error(
            "E205", node.place, fmt::format("`velocity_gradient` needs three rows, and there are {}", rows->size()),
            "three rows of three rates, [[...], [...], [...]]"
        );
        return std::nullopt;
    }
    return read_rows(v, "velocity_gradient", *rows);
}

/// Joins the two lists of an advance stage; every axis must be given exactly once.
void join_axes(Reader& v, const Axes& rate, const Axes& stress, cell::Loading& loading) {
    for (std::size_t a = 0; a < 3; ++a) {
        const char name = "xyz"[a];
        if (rate[a] && stress[a]) {
            v.error(
                "E207", v.place(), fmt::format("{} gives both a stress and a strain rate along {}", v.title(), name),
                "write \"-\" for that axis in one of the two lists"
            );
        } else if (!rate[a] && !stress[a]) {
            v.error(
                "E207", v.place(), fmt::format("{} gives neither a stress nor a strain rate along {}", v.title(), name),
                "give one of them; \"0 1/s\" keeps the axis at its length"
            );
        } else if (rate[a]) {
            loading.axis[a] = {cell::Control::StrainRate, *rate[a]};
        } else {
            loading.axis[a] = {cell::Control::Stress, *stress[a]};
        }
    }
}

} // namespace

void cell_field(Reader& v, Mat3& h) {
    const Node* node = v.take("cell");
    if (node == nullptr) {
        return;
    }
    Key key = v.key_of("cell");
    key.kind = ValueKind::Quantity;
    key.dimension = dimension::length;
    const std::vector<Node>* items = v.list("cell", *node);
    if (items == nullptr) {
        return;
    }
    const auto read_three = [&](const Node& list) -> std::optional<Vec3> {
        Vec3 three;
        bool is_good = list.items.size() == 3;
        if (!is_good) {
            v.error(
                "E205", list.place, fmt::format("`cell` needs three lengths here, and there are {}", list.items.size()),
                "three edge lengths, or three rows of three"
            );
        }
        for (int a = 0; is_good && a < 3; ++a) {
            const auto length = v.number(key, list.items[static_cast<std::size_t>(a)]);
            is_good = is_good && length;
            three[a] = length.value_or(0);
        }
        return is_good ? std::optional(three) : std::nullopt;
    };
    if (items->size() == 3 && (*items)[0].is_array()) {
        for (int a = 0; a < 3; ++a) {
            const Node& row = (*items)[static_cast<std::size_t>(a)];
            if (!row.is_array()) {
                return v.wrong_type("cell", row, "a row of three lengths");
            }
            const auto three = read_three(row);
            if (!three) {
                return;
            }
            h[a] = {three->x, three->y, three->z};
        }
    } else {
        const auto edges = read_three(*node);
        if (!edges) {
            return;
        }
        h = diagonal(*edges);
    }
    if (!(determinant(h) > 0)) {
        v.error(
            "E312", node->place, "`cell` has no volume, or its vectors are left-handed",
            "edge lengths are above 0; the columns of a matrix are the cell vectors, right-handed"
        );
    }
}

void cell_field(Writer& v, const Mat3& h) {
    if (h == Mat3{}) { // the packing file's own
        return;
    }
    const auto list = [](const Vec3& lengths) {
        const auto one = [](double length) { return make_node(Scalar(print_quantity(length, dimension::length))); };
        return make_array({one(lengths.x), one(lengths.y), one(lengths.z)});
    };
    const Vec3 edges{h(0, 0), h(1, 1), h(2, 2)};
    v.set("cell", h == diagonal(edges) ? list(edges) : make_array({list(h.row(0)), list(h.row(1)), list(h.row(2))}));
}

void settle_stress_fields(Reader& v, cell::Loading& loading) {
    const Node* pressure = v.take("pressure");
    const Node* stress = v.take("stress");
    if (pressure != nullptr && stress != nullptr) {
        v.error(
            "E207", stress->place, fmt::format("{} gives both `pressure` and `stress`", v.title()), "keep one of them"
        );
        return;
    }
    Axes axes;
    if (pressure != nullptr) {
        axes.fill(v.number("pressure", *pressure));
    } else if (stress != nullptr) {
        axes = read_axes(v, "stress", *stress).value_or(Axes{});
    }
    for (std::size_t a = 0; a < 3; ++a) {
        if (axes[a]) {
            loading.axis[a] = {cell::Control::Stress, *axes[a]};
        }
    }
}

void settle_stress_fields(Writer& v, const cell::Loading& loading) {
    if (auto list = write_axes(v, "stress", loading, cell::Control::Stress)) {
        v.set("stress", std::move(*list));
    }
}

void gradient_field(Reader& v, std::optional<Mat3>& gradient) {
    if (const Node* node = v.take("velocity_gradient")) {
        gradient = read_gradient(v, *node);
    }
}

void gradient_field(Writer& v, const std::optional<Mat3>& gradient) {
    if (gradient) {
        v.set("velocity_gradient", write_rows(v, "velocity_gradient", *gradient));
    }
}

void loading_fields(Reader& v, cell::Loading& loading) {
    const Node* rate = v.take("strain_rate");
    const Node* stress = v.take("stress");
    const Node* gradient = v.take("velocity_gradient");
    if (gradient != nullptr) {
        if (rate != nullptr || stress != nullptr) {
            v.error(
                "E207", gradient->place,
                fmt::format("{} gives `velocity_gradient` together with `stress` or `strain_rate`", v.title()),
                "keep one of them"
            );
        }
        loading.velocity_gradient = read_gradient(v, *gradient);
        return;
    }
    if (rate == nullptr && stress == nullptr) {
        return v.error(
            "E207", v.place(), fmt::format("{} does not say how the cell moves", v.title()),
            "give `strain_rate`, `stress` or `velocity_gradient`; [\"0 1/s\", \"0 1/s\", \"0 1/s\"] keeps it as it is"
        );
    }
    const auto rates = rate != nullptr ? read_axes(v, "strain_rate", *rate) : Axes{};
    const auto stresses = stress != nullptr ? read_axes(v, "stress", *stress) : Axes{};
    if (rates && stresses) {
        join_axes(v, *rates, *stresses, loading);
    }
}

void loading_fields(Writer& v, const cell::Loading& loading) {
    if (loading.velocity_gradient) {
        return v.set("velocity_gradient", write_rows(v, "velocity_gradient", *loading.velocity_gradient));
    }
    if (auto list = write_axes(v, "strain_rate", loading, cell::Control::StrainRate)) {
        v.set("strain_rate", std::move(*list));
    }
    if (auto list = write_axes(v, "stress", loading, cell::Control::Stress)) {
        v.set("stress", std::move(*list));
    }
}

void check_servo(Reader& v, const cell::ServoSpec& s) {
    if (s.kind == cell::ServoKind::Inertial && !(s.mass > 0)) {
        v.error(
            "E201", v.place(), "an inertial servo needs its `mass`",
            "twice the mass of all grains / edge of the cell is stable, as in mass = \"0.0063 kg/m\""
        );
    }
}

void check_servo(Writer&, const cell::ServoSpec&) {}

void check_path(Reader& v, const triaxial::TriaxialSpec& s) {
    const bool proportional = s.path == triaxial::Path::Proportional;
    if (proportional && !s.strain_ratio) {
        v.error(
            "E207", v.place(), fmt::format("{} keeps to a `strain_ratio`, and gives none", v.title()),
            "the volumetric over the axial strain: strain_ratio = 1 is an oedometer, below 0 the sample is made to "
            "dilate"
        );
    } else if (!proportional && s.strain_ratio) {
        v.error(
            "E207", v.place(), fmt::format("{} gives `strain_ratio`, and its path keeps to none", v.title()),
            "add path = \"proportional\", or take it out"
        );
    }
    if (s.deviator_stress && s.stress_ratio) {
        v.error(
            "E207", v.place(), fmt::format("{} stops at a `deviator_stress` and at a `stress_ratio`", v.title()),
            "keep one of them"
        );
    } else if (s.deviator_stress && s.path == triaxial::Path::ConstantDeviator) {
        v.error(
            "E207", v.place(), fmt::format("{} holds the deviator stress, and stops at another", v.title()),
            "stop at a stress_ratio instead, or take the key out"
        );
    }
    if (s.b && (s.path != triaxial::Path::Drained || s.stops_at_stress())) {
        v.error(
            "E207", v.place(), fmt::format("{} gives `b`, which a drained test to a strain keeps to", v.title()),
            "take out `path` and the stress to stop at, or take out `b`"
        );
    }
    if (s.direction == triaxial::Direction::Extension && s.path == triaxial::Path::ConstantDeviator) {
        v.error(
            "E207", v.place(), fmt::format("{} holds the deviator stress, and extends", v.title()),
            "take out `direction`: the sign of the deviator stress is that of the state it starts from"
        );
    }
}

void check_path(Writer&, const triaxial::TriaxialSpec&) {}

void check_cycles(Reader& v, const triaxial::CyclicSpec& s) {
    if (s.cycles->csr.has_value() == s.cycles->strain.has_value()) {
        v.error(
            "E207", v.place(),
            fmt::format("{} gives {} amplitude", v.title(), s.cycles->csr ? "a stress and a strain as its" : "no"),
            "give either csr = 0.2 (amplitude of q over twice the mean stress) or strain_amplitude = \"0.1 %\""
        );
    } else if (s.cycles->strain && 2 * *s.cycles->strain >= s.cycles->double_amplitude) {
        v.error(
            "E207", v.place(),
            fmt::format(
                "{} imposes {:.3g} % of strain from turn to turn, and would end at {:.3g} % of it, whatever the soil "
                "does",
                v.title(), 200 * *s.cycles->strain, 100 * s.cycles->double_amplitude
            ),
            fmt::format(
                "add until = {{ double_amplitude = \"{:.3g} %\" }}, or lower strain_amplitude", 400 * *s.cycles->strain
            )
        );
    }
}

void check_cycles(Writer&, const triaxial::CyclicSpec&) {}

void check_start(Reader& v, const packing::CompactSpec& s) {
    if (s.start_porosity && s.protocol != packing::Protocol::Swift) {
        v.error(
            "E207", v.place(),
            fmt::format(
                "{} gives `start_porosity`, and its protocol is \"{}\"", v.title(), packing::name_of(s.protocol)
            ),
            "add protocol = \"swift\", or give the porosity to the stage that packs"
        );
    }
    if (s.time_step > 0 && s.protocol == packing::Protocol::Wide) {
        v.error(
            "E207", v.place(),
            fmt::format(
                "{} gives a `time_step`, and protocol \"wide\" lends grains inertia for longer ones", v.title()
            ),
            "leave `time_step` out, or take protocol = \"faithful\", which lends no inertia with a given time step"
        );
    }
}

void check_start(Writer&, const packing::CompactSpec&) {}

void check_void_ratio(Reader& v, const packing::CompactSpec& s) {
    if (s.void_ratio && s.intergranular_void_ratio) {
        v.error(
            "E207", v.place(),
            fmt::format("{} specifies both a `void_ratio` and an `intergranular_void_ratio`", v.title()),
            "keep one of them: with the fines content each gives the other"
        );
    }
    if (s.prepared_as && !s.void_ratio && !s.intergranular_void_ratio) {
        v.error(
            "E207", v.place(),
            fmt::format("{} is `prepared_as` another sample, for whose preparation there is no search", v.title()),
            "specify a `void_ratio` or an `intergranular_void_ratio`, or only `prepare`"
        );
    }
}

void check_void_ratio(Writer&, const packing::CompactSpec&) {}

void check_skeleton_first(Reader& v, const packing::CompactSpec& s) {
    if (!s.prepare.skeleton_first) {
        return;
    }
    if (s.protocol == packing::Protocol::Swift) {
        v.error(
            "E207", v.place(),
            fmt::format("{} makes its skeleton first, and protocol \"swift\" pushes all grains together", v.title()),
            "take protocol = \"faithful\", or leave `skeleton_first` out"
        );
    }
    if (s.void_ratio) {
        v.error(
            "E207", v.place(),
            fmt::format("{} makes its skeleton first, which leaves the `void_ratio` to the fines content", v.title()),
            "specify the `intergranular_void_ratio` of the skeleton instead"
        );
    }
    if (s.prepared_as) {
        v.error(
            "E207", v.place(), fmt::format("{} has both `skeleton_first` and `prepared_as`", v.title()),
            "keep one of them: they are two ways to keep a skeleton"
        );
    }
}

void check_skeleton_first(Writer&, const packing::CompactSpec&) {}

void check_shear_stresses(Reader& v, const packing::CompactSpec& s) {
    if (s.shear_released && s.protocol == packing::Protocol::Slow) {
        v.error(
            "E207", v.place(),
            fmt::format("{} releases shear stresses, and the servo of protocol \"slow\" cannot", v.title()),
            "take protocol = \"faithful\", or settle with shear_stresses = \"released\" afterwards"
        );
    }
}

void check_shear_stresses(Reader& v, const dem::SettleSpec& s) {
    if (!s.loading.shear_released || cell::releases_shear(s.loading)) {
        return;
    }
    const bool is_inertial = s.loading.servo.kind == cell::ServoKind::Inertial;
    v.error(
        "E207", v.place(),
        fmt::format(
            "{} releases shear stresses, {}", v.title(),
            is_inertial ? "and its inertial servo cannot" : "but holds no stress"
        ),
        is_inertial ? "leave the kind of the servo out: secant" : "give `pressure` or `stress`, or remove the key"
    );
}

} // namespace suffuse::casefile
