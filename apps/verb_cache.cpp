// cache: what the cache of stages holds.

#include "suffuse/base/amounts.hpp"
#include "suffuse/base/spelling.hpp"
#include "suffuse/job/run_folder.hpp"
#include "suffuse/record/stage_cache.hpp"

#include <fmt/format.h>

#include "apps/exit_code.hpp"
#include "apps/verbs.hpp"
#include "apps/wording.hpp"
#include <numeric>

namespace suffuse::apps {

int cache_verb(const CommandLine& line, const Console& console) {
    constexpr double gigabyte = 1e9;
    const std::filesystem::path folder =
        line.subject.empty() ? job::cache_beside("runs/any") : std::filesystem::path(line.subject);
    if (!std::filesystem::is_directory(folder)) {
        throw UsageError(fmt::format(
            "{} is no folder; a run makes its cache beside its own folder, and suffuse run --cache DIR in DIR",
            shown(folder.string())
        ));
    }
    record::StageCache cache(folder);
    if (line.cache_limit) {
        cache.set_limit(static_cast<std::int64_t>(*line.cache_limit * gigabyte));
    }
    int dropped = 0;
    if (line.clear || line.cache_limit) {
        dropped = line.clear ? cache.clear() : cache.shrink(cache.limit());
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

} // namespace suffuse::apps
