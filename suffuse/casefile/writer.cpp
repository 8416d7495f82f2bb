#include "suffuse/casefile/writer.hpp"

#include "suffuse/base/error.hpp"

#include <fmt/format.h>

namespace suffuse::casefile {

const Key& Writer::key_of(std::string_view key) const {
    for (const std::string& pattern : patterns_) {
        if (const Key* found = find_key(pattern, key)) {
            return *found;
        }
    }
    throw Bug(fmt::format("the schema has no key {} in {}", key, patterns_.front()));
}

std::vector<std::string> Writer::inner_patterns(std::string_view key) const {
    const std::string& table = key_of(key).table;
    return {table.empty() ? std::string(key) : fmt::format("{}.{}", table, key)};
}

Node Writer::number(std::string_view key, double value) const {
    const Key& known = key_of(key);
    if (known.kind != ValueKind::Quantity) {
        return make_node(Scalar(value));
    }
    return make_node(Scalar(print_quantity(value, known.dimension)));
}

Node Writer::vector(std::string_view key, const Vec3& value) const {
    return make_array({number(key, value.x), number(key, value.y), number(key, value.z)});
}

void Writer::field(std::string_view key, double value) {
    set(key, number(key, value));
}

void Writer::field(std::string_view key, const std::optional<double>& value) {
    if (value) {
        set(key, number(key, *value));
    }
}

void Writer::field(std::string_view key, std::int64_t value) {
    set(key, make_node(Scalar(value)));
}

void Writer::field(std::string_view key, const std::optional<std::int64_t>& value) {
    if (value) {
        set(key, make_node(Scalar(*value)));
    }
}

void Writer::field(std::string_view key, std::uint64_t value) {
    set(key, make_node(Scalar(static_cast<std::int64_t>(value))));
}

void Writer::field(std::string_view key, int value) {
    set(key, make_node(Scalar(std::int64_t{value})));
}

void Writer::field(std::string_view key, bool value) {
    set(key, make_node(Scalar(value)));
}

void Writer::field(std::string_view key, const std::string& value) {
    if (!value.empty()) {
        set(key, make_node(Scalar(value)));
    }
}

void Writer::field(std::string_view key, const std::vector<double>& value) {
    std::vector<Node> items;
    for (const double one : value) {
        items.push_back(number(key, one));
    }
    set(key, make_array(std::move(items)));
}

void Writer::field(std::string_view key, const std::vector<std::string>& value) {
    std::vector<Node> items;
    for (const std::string& one : value) {
        items.push_back(make_node(Scalar(one)));
    }
    set(key, make_array(std::move(items)));
}

void Writer::direction(const Vec3& value, std::string_view key) {
    for (int a = 0; a < 3; ++a) {
        Vec3 axis;
        axis[a] = 1;
        const std::string name(1, "xyz"[a]);
        if (value == axis) {
            return set(key, make_node(Scalar(name)));
        }
        if (value == -axis) {
            return set(key, make_node(Scalar("-" + name)));
        }
    }
    set(key, vector(key, value));
}

void Writer::time_step(double value) {
    set("time_step", value == 0 ? make_node("computed") : number("time_step", value));
}

} // namespace suffuse::casefile
