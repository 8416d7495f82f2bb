#include "suffuse/record/ending_json.hpp"

#include "suffuse/record/or_null.hpp"

#include <nlohmann/json.hpp>

#include <type_traits>
#include <utility>

namespace suffuse::erosion {

NLOHMANN_JSON_SERIALIZE_ENUM(
    ErodedTarget::Of, {{ErodedTarget::Of::Fines, name_of(ErodedTarget::Of::Fines)},
                       {ErodedTarget::Of::Solids, name_of(ErodedTarget::Of::Solids)}}
)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SkeletonDoubt, coarse, width)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SkeletonFailed, most_strain)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SkeletonRestless, steps, carried)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(NoneToRemove, pass, passes)

void to_json(nlohmann::json& json, const TargetReached& reached) {
    json = {{"share", reached.share}, {"asked", reached.specified}, {"of", reached.of}, {"doubt", reached.doubt}};
}

void from_json(const nlohmann::json& json, TargetReached& reached) {
    json.at("share").get_to(reached.share);
    json.at("asked").get_to(reached.specified);
    json.at("of").get_to(reached.of);
    json.at("doubt").get_to(reached.doubt);
}

namespace {

// The names of `why`.
constexpr const char* name_of(const NothingLeaves&) {
    return "nothing leaves";
}

constexpr const char* name_of(const NoiseDecides&) {
    return "noise decides";
}

constexpr const char* name_of(const SkeletonDoubt&) {
    return "skeleton doubt";
}

constexpr const char* name_of(const SkeletonFailed&) {
    return "skeleton failed";
}

constexpr const char* name_of(const SkeletonRestless&) {
    return "skeleton restless";
}

constexpr const char* name_of(const TargetReached&) {
    return "target reached";
}

constexpr const char* name_of(const NoneToRemove&) {
    return "none to remove";
}

constexpr const char* name_of(const OtherWording&) {
    return "told otherwise";
}

/// OtherWording has a sentence alone, which is next to `ended`.
template <class Why>
constexpr bool has_numbers = !std::is_empty_v<Why> && !std::is_same_v<Why, OtherWording>;

template <std::size_t... Each>
Ending ending_named(const nlohmann::json& json, std::index_sequence<Each...>) {
    const std::string name = json.at("why");
    Ending ending{OtherWording{}};
    const auto take = [&]<class Why>(Why why) {
        if (name == name_of(why)) {
            if constexpr (has_numbers<Why>) {
                json.get_to(why);
            }
            ending = {std::move(why)};
        }
    };
    (take(std::variant_alternative_t<Each + 1, decltype(ending.why)>()), ...); // the first is no ending
    return ending;
}

} // namespace

void to_json(nlohmann::json& json, const Ending& ending) {
    json = nullptr;
    std::visit(
        [&]<class Why>(const Why& why) {
            if constexpr (!std::is_same_v<Why, std::monostate>) {
                if constexpr (has_numbers<Why>) {
                    json = why;
                }
                json["why"] = name_of(why);
            }
        },
        ending.why
    );
}

void from_json(const nlohmann::json& json, Ending& ending) {
    constexpr std::size_t count = std::variant_size_v<decltype(ending.why)>;
    ending = json.is_null() ? Ending{} : ending_named(json, std::make_index_sequence<count - 1>());
}

} // namespace suffuse::erosion
