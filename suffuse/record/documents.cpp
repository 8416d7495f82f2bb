#include "suffuse/record/documents.hpp"

namespace suffuse::record {
namespace {

using nlohmann::json;

constexpr int deepest = 64; // levels; ours have ten

/// Hears a document without keeping it, and stops where it is nested too deep.
struct Depth final : nlohmann::json_sax<json> {
    int levels = 0;

    bool enter() { return ++levels <= deepest; }

    bool leave() {
        --levels;
        return true;
    }

    bool start_object(std::size_t) override { return enter(); }

    bool end_object() override { return leave(); }

    bool start_array(std::size_t) override { return enter(); }

    bool end_array() override { return leave(); }

    bool key(string_t&) override { return true; }

    bool null() override { return true; }

    bool boolean(bool) override { return true; }

    bool number_integer(number_integer_t) override { return true; }

    bool number_unsigned(number_unsigned_t) override { return true; }

    bool number_float(number_float_t, const string_t&) override { return true; }

    bool string(string_t&) override { return true; }

    bool binary(binary_t&) override { return true; }

    bool parse_error(std::size_t, const std::string&, const json::exception&) override { return false; }
};

template <class Bytes>
bool is_shallow(const Bytes& bytes, json::input_format_t format) {
    Depth depth;
    return json::sax_parse(bytes, &depth, format);
}

} // namespace

json parse_json(std::string_view text) {
    return is_shallow(text, json::input_format_t::json) ? json::parse(text, nullptr, false)
                                                        : json(json::value_t::discarded);
}

json parse_cbor(std::span<const std::uint8_t> bytes) {
    return is_shallow(bytes, json::input_format_t::cbor) ? json::from_cbor(bytes, true, false)
                                                         : json(json::value_t::discarded);
}

} // namespace suffuse::record
