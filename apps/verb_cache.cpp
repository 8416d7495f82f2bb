// cache: what the cache of stages holds.

#include "suffuse/base/amounts.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/base/spelling.hpp"
#include "suffuse/job/run_folder.hpp"
#include "suffuse/record/stage_cache.hpp"

#include <fmt/format.h>

#include "apps/exit_code.hpp"
#include "apps/json_text.hpp"
#include "apps/verb.hpp"
#include "apps/verbs.hpp"
#include <cstdint>
#include <memory>
#include <numeric>
#include <optional>
#include <vector>

namespace suffuse::apps {
namespace {

struct CacheVerb final : Verb {
    CacheVerb()
        : Verb("cache", "show the cache of stages; limit or empty it", "suffuse cache runs/suffuse-cache --limit 50") {}

    std::string given;
    std::optional<double> new_limit; ///< [GB]
    bool clears = false;

    void add_to(Options& options) override {
        options.argument("DIR", given, "folder of the cache; runs/suffuse-cache unless given");
        const Option limit = options.value("--limit", new_limit, "maximum size from now on, in GB; initially 10")
                                 .type("GB")
                                 .not_negative();
        options.flag("--clear", clears, "empty the cache").excludes(limit);
    }

    [[nodiscard]] int act(const CommandLine&, const Console& console) const override;
};

int CacheVerb::act(const CommandLine&, const Console& console) const {
    constexpr double gigabyte = 1e9;
    const std::filesystem::path folder = given.empty() ? job::cache_next_to("runs/any") : std::filesystem::path(given);
    if (!std::filesystem::is_directory(folder)) {
        throw UsageError(fmt::format(
            "{} is not a folder; a run creates its cache next to its own folder, suffuse run --cache DIR in DIR",
            shown(folder.string())
        ));
    }
    record::StageCache cache(folder, record::Owners::Anybody);
    if (!cache.is_one()) {
        throw UsageError(fmt::format(
            "{} is not a cache: it holds files but no cache.json of suffuse; give the cache folder named by a run",
            shown(folder.string())
        ));
    }
    if (new_limit) {
        cache.set_limit(static_cast<std::int64_t>(*new_limit * gigabyte));
    }
    int dropped = 0;
    if (clears || new_limit) {
        dropped = clears ? cache.clear() : cache.shrink(cache.limit());
    }
    const std::vector<record::CacheEntry> entries = cache.entries();
    const auto sum = [&](auto number) {
        return std::accumulate(
            entries.begin(), entries.end(), 0.0,
            [&](double so_far, const record::CacheEntry& entry) { return so_far + static_cast<double>(number(entry)); }
        );
    };
    const double bytes = sum([](const auto& entry) { return entry.bytes; });
    const double seconds = sum([](const auto& entry) { return entry.wall_seconds; });
    console.result(fmt::format(
        "{}   {}, {} of at most {}, {} of computing", folder.string(), plural(std::ssize(entries), "stage"),
        size_text(bytes), size_text(static_cast<double>(cache.limit())), duration_text(seconds)
    ));
    if (dropped > 0) {
        console.result(fmt::format("{} dropped", plural(dropped, "stage")));
    }
    nlohmann::json list = nlohmann::json::array();
    for (const record::CacheEntry& entry : entries) {
        console.detail(fmt::format(
            "{:40} {:>10}  {:>12}  {}", entry.made_as, size_text(static_cast<double>(entry.bytes)),
            duration_text(entry.wall_seconds), entry.folder.filename().string()
        ));
        list.push_back(
            {{"made_as", entry.made_as},
             {"folder", entry.folder.string()},
             {"bytes", entry.bytes},
             {"wall_seconds", entry.wall_seconds}}
        );
    }
    console.document(json_text(
        {{"folder", folder.string()},
         {"bytes", bytes},
         {"limit_bytes", cache.limit()},
         {"wall_seconds", seconds},
         {"dropped", dropped},
         {"entries", list}}
    ));
    return Done;
}

} // namespace

MadeVerb make_cache_verb() {
    return std::make_unique<CacheVerb>();
}

} // namespace suffuse::apps
